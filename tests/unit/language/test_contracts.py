"""Where a contract ends: nothing that stands below it, or behind it, is left out silently."""

import pytest

from ropsim.flow import MoveInstruction
from ropsim.icr import run
from support.tasks import codes, compiled, only

HEADERS = ["program p\ntask T(l: loc)\n", "strict\ntask T(l: loc)\n", "task T(l: loc)\n"]
"""A task with a parameter list, or in a modern text."""


def test_in_a_classic_task_prose_runs_on_to_the_first_statement() -> None:
    text = "task T\nneeds one location and\na part that\nlies flat\nmov l\nendp\nT infeed"
    result = compiled(text)
    assert result.diagnostics == ()
    assert result.program is not None
    assert result.program.tasks[0].contracts[0].text == "needs one location and a part that lies flat"


@pytest.mark.parametrize("header", [*HEADERS, "program p\ntask T\n"])
@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("gobble infeed", "N201"),
        ("mvo infeed", "N201"),
        ("and a part", "L105"),
        ("Approach it slowly", "L101"),
    ],
)
def test_elsewhere_a_contract_ends_with_its_line(header: str, line: str, code: str) -> None:
    found = only(f"{header}needs gripper open\n{line}\nopen\nendp\n{'T infeed' if '(' in header else 'T'}")
    assert (found.code, found.span and found.span.line) == (code, header.count("\n") + 2)
    assert code == "N201" or found.hint.startswith("a contract ends with its line")


def test_a_classic_text_with_a_program_line_reads_prose_as_before() -> None:
    assert codes("program p\nclassic\ntask T\nneeds a location and\na part\nmov l\nendp\nT infeed") == []


@pytest.mark.parametrize("header", [*HEADERS, "task T\n"])
@pytest.mark.parametrize("statement", ["mov l", "n = 3", "close", "MOV l above 5", "T2"])
def test_a_statement_behind_a_contract_on_its_line_is_an_error(header: str, statement: str) -> None:
    text = f"{header}needs gripper open. {statement}\nmov l\nendp\ntask T2\nopen\nendp\nT infeed"
    found = [one for one in compiled(text).diagnostics if one.code == "L120"]
    assert [(one.is_error, one.span and one.span.column) for one in found] == [(True, 21)]


@pytest.mark.parametrize(
    "words", ["needs care. Open it before", "needs 2.5 kg. then some", "needs a. # mov l"]
)
def test_sentences_numbers_and_comments_are_no_statements(words: str) -> None:
    assert codes(f"task T\n{words}\nmov l\nendp\nT infeed") == []


@pytest.mark.parametrize(
    "line", ["approach l above 20", "grasp (1, 2, 3)", "mvo l speed 20 %", "twist l, n = 3", "a part. mov l"]
)
def test_a_statement_in_the_prose_of_a_classic_task_is_told(line: str) -> None:
    found = compiled(f"task T\nneeds one location and\n{line}\nmov l\nendp\nT infeed").diagnostics
    assert [one.code for one in found if one.span and one.span.line == 3] in (["L112"], ["L120"])


def test_the_statements_below_a_contract_are_carried_out() -> None:
    head = "program p\nunits mm\ntask T(l: loc)\nneeds gripper open\nassumes a part\n"
    code = compiled(head + "lin l above 5\nlin l\nendp\nT infeed").icr
    assert code is not None
    assert len([one for one in run(code).instructions if isinstance(one, MoveInstruction)]) == 2


def test_a_wrong_assignment_below_a_contract_is_no_prose() -> None:
    assert codes("task T\nneeds one location and\nq.x := 3 mm +\nmov l\nendp\nT infeed")[0] == "L101"


def test_a_line_told_as_prose_drops_no_call_of_its_task() -> None:
    text = "task T\nneeds one location and\nmvo l speed 20 %\nmov l\nendp\nT infeed"
    result = compiled(text)
    assert [one.code for one in result.diagnostics] == ["L112"]
    assert result.icr is not None
    assert len(run(result.icr).moves) == 1
