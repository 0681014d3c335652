"""Words of other robot languages get the word of this one, not the nearest spelling."""

import pytest

from ropsim.language.syntax.other_languages import HINTS
from support.tasks import compiled, only

REPLACED = {
    "MoveL": "lin",
    "movel": "lin",
    "MOVES": "lin",
    "SLIN": "lin",
    "MoveJ": "mov",
    "movej": "mov",
    "PTP": "mov",
    "SPTP": "mov",
}
SAID = {
    "MoveAbsJ": "`mov joints(…)`",
    "MoveC": "`circ via a to b`",
    "movec": "`circ via a to b`",
    "SCIRC": "`circ via a to b`",
    "TriggIO": "`lin p at 3 mm after start do set NAME on`",
    "TriggL": "`lin p at 3 mm after start do set NAME on`",
    "TriggJ": "`lin p at 3 mm after start do set NAME on`",
    "TRIGGER": "`lin p at 3 mm after start do set NAME on`",
    "SearchL": "`lin p until NAME store q`",
    "SearchJ": "`lin p until NAME store q`",
    "SetDO": "`set NAME on`",
    "SetGO": "`set NAME on`",
    "SetAO": "`set NAME = value`",
    "set_digital_out": "`set NAME on`",
    "set_standard_digital_out": "`set NAME on`",
    "Reset": "`set NAME off`",
    "WaitDI": "`wait until NAME`",
    "WaitUntil": "`wait until NAME`",
    "WaitTime": "`wait 0.5 s`",
    "sleep": "`wait 0.5 s`",
}


def test_every_word_of_the_table_is_tested() -> None:
    assert {word.lower() for word in (*REPLACED, *SAID)} == set(HINTS)


@pytest.mark.parametrize(("word", "here"), REPLACED.items())
def test_a_move_of_another_language_is_the_move_of_the_same_kind(word: str, here: str) -> None:
    found = only(f"{word} infeed")
    assert (found.code, found.hint) == ("N201", f"did you mean `{here}`?")
    assert found.fix is not None
    assert found.fix.replacement == here
    assert not compiled(f"{found.fix.replacement} infeed").diagnostics


@pytest.mark.parametrize(("word", "said"), SAID.items())
def test_a_word_without_a_like_one_says_what_to_write(word: str, said: str) -> None:
    found = only(f"{word} infeed, 1")
    assert found.code == "N201"
    assert said in found.hint
    assert found.fix is None


def test_wait_for_is_wait_until() -> None:
    found = only("WAIT FOR part_ok")
    assert found.code == "L101"
    assert "`wait until NAME`" in found.hint
    assert not compiled("wait until part_ok").diagnostics


def test_a_task_of_the_same_name_in_another_case_is_nearer() -> None:
    assert only("task ptp\n open\nendp\nPTP").hint == "did you mean `ptp`?"
