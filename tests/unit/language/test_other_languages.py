"""Words of other robot languages get the word of this one, not the nearest spelling."""

import pytest

from ropsim import language
from ropsim.language.testing import HINTS
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
    "go": "mov",
    **dict.fromkeys(("linear", "MoveP", "lmove", "moveline"), "lin"),
    **dict.fromkeys(("moveto", "joint", "jmove", "movejoint"), "mov"),
}
SAID = {
    "Move": "a straight line is `lin p`",
    "Jump": "`lin here above 60`, `mov p above 60`, `lin p`",
    "MoveAbsJ": "`mov joints(…)`",
    "MoveC": "`circ via a to b`",
    "movec": "`circ via a to b`",
    "SCIRC": "`circ via a to b`",
    **dict.fromkeys(("circular", "circle"), "`circ via a to b`"),
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
    "Delay": "`wait 0.5 s`",
    "Pause": "`wait 0.5 s`",
    "arc": "`circ via a to b`",
    "gripper": "`open` and `close`",
    "grasp": "`open` and `close`",
    **dict.fromkeys(("def", "PROC", "procedure", "function", "func", "Sub"), "`task Name(parameter: type)`"),
    **dict.fromkeys(("ENDMODULE", "endprogram"), "leave this one out"),
    "BEGIN": "leave `begin` out",
    "next": "`endf`",
    **dict.fromkeys(("speed", "vel", "acc", "accel", "blend", "zone"), "`set speed 500 mm/s`"),
    "end": "`endif`, `endw`, `endr`",
    "loop": "`repeat 3 … endr`",
    "foreach": "`for each b in PATTERN`",
    "goto": "there are no jumps",
    "switch": "`if … elseif … else … endif`",
    "case": "`if … elseif … else … endif`",
    **dict.fromkeys(("halt", "exit", "quit"), "the end of a program is `stop`"),
    **dict.fromkeys(("int", "real", "float", "num", "bool", "string", "DECL", "let", "dim"), "`var x: type`"),
}

MODAL = "settings stand behind `set` or a target: `set speed 500 mm/s`, `lin p speed 500 mm/s`"
COMMA = "a location is written in parentheses, `(x, y, z)`; what follows it stands without a comma"
STEPS = "(1, 0, 0), (0, 1, 0), (0, 0, 1)"


def test_every_word_of_the_table_is_tested() -> None:
    assert {word.lower() for word in (*REPLACED, *SAID)} == set(HINTS)


@pytest.mark.parametrize(("word", "here"), REPLACED.items())
def test_a_move_of_another_language_is_the_move_of_the_same_kind(word: str, here: str) -> None:
    found = only(f"{word} infeed")
    assert found.code == "N201"
    assert found.hint.startswith(f"did you mean `{here}`? speed and zone stand behind the target")
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


@pytest.mark.parametrize(
    ("line", "code", "hint"),
    [
        ("lin infeed abov 30", "L101", "did you mean `above`?"),
        ("lin infeed speeed 30 mm/s", "L101", "did you mean `speed`?"),
        ("set speeed 30 %", "L101", "did you mean `speed`?"),
        ("if part_ok\nelse if not part_ok\nendif", "L101", "write it as one word: `elseif CONDITION`"),
        ("wait part_ok", "T301", "signals are read by name: write `wait until part_ok`"),
        ("wait not part_ok", "L101", "a wait for a condition is written `wait until CONDITION`"),
        ("wait part_ok timeout 3 s", "L101", "a wait for a condition is written `wait until CONDITION`"),
        ("wait part_ok and part_ok", "L101", "a wait for a condition is written `wait until CONDITION`"),
        ("wait untill part_ok", "L101", "did you mean `until`?"),
        ("if !part_ok then open", "L102", "write `not`"),
        ("! the first part", "L102", "a comment begins with `#`"),
        ("' the first part", "L102", "a comment begins with `#`"),
        ("open ! the first part", "L102", "a comment begins with `#`; in a condition write `not`"),
        ("; the first part", "L105", "a comment begins with `#`"),
        ("-- the first part", "L105", "a comment begins with `#`"),
        ("- the first part", "L105", "start with a statement word, a task or a variable"),
        ("Fetch infeed part_ok", "L101", "a comma stands between arguments: `Name a, b`"),
        ("Fetch(infeed part_ok)", "L101", "a comma stands between values: `(a, b)`"),
        ("mov (500, 0 300)", "L101", "a comma stands between values: `(a, b)`"),
        ("wait 3 sec", "L101", "write `s`"),
        ("wait 500 milliseconds", "L101", "write `ms`"),
        ("mov infeed speed=30 %", "L101", "what follows a word such as `speed` stands without `=`"),
        ("mov infeed above 30;", "L101", "each statement stands on a line of its own, without `;`"),
        ("while part_ok:\nendw", "L101", "leave the `:` out"),
        ("for i in 1 to 3\nendf", "L101", "write `for i = FIRST to LAST`, or `for each b in PATTERN`"),
        ("for i = 1, 3\nendf", "L101", "write `for i = FIRST to LAST`, or `for each b in PATTERN`"),
        ("for ech b in g\nendf", "L101", "did you mean `each`?"),
        ("x = 3 ** 2", "L101", "there is no power: write `x * x`"),
        ("x = 3 ^ 2", "L102", "there is no power: write `x * x`"),
        ("wait 0,5 s", "L101", "decimals are written with a point: `0.5 s`"),
        ("x = 12,75", "L101", "decimals are written with a point: `12.75`"),
        ("x = 12, 75", "L101", COMMA),
        ("lin infeed z10", "L101", "write `blend 10 mm`"),
        ("lin infeed v500", "L101", "write `speed 500 mm/s`"),
        ("lin infeed speed v500", "N202", "write `speed 500 mm/s`"),
        ("speed v500", "N201", MODAL),
        ("next", "N201", "a `for` ends with `endf`"),
        ("pattern q = grid 2x4 from (0, 0, 0) step (1, 0, 0), (0, 1, 0)", "L101", "write blanks: `2 x 4`"),
        (f"pattern q = grid 2x4x3 from (0, 0, 0) step {STEPS}", "L101", "write blanks: `2 x 4 x 3`"),
        ("int x = 3 3", "L101", "a variable is made by its first value, `x = 3`, or by `var x: type`"),
    ],
)
def test_signs_and_words_of_other_languages_say_what_to_write(line: str, code: str, hint: str) -> None:
    found = only(line)
    assert (found.code, found.hint) == (code, hint)


@pytest.mark.parametrize("line", ["x++", "x += 1", "x--", "x -= 2"])
def test_a_step_of_a_variable_is_an_assignment(line: str) -> None:
    found = only(line)
    assert (found.code, found.hint.split(":")[0]) == ("L101", "write `x = x + 1`")


def test_a_task_of_the_program_is_no_word_of_another_language() -> None:
    text = "program p\ntask Loop(n: int)\n open\nendp\nLoop 3 3"
    assert only(text).hint == ""
    assert only("end = 3 3").hint == ""


@pytest.mark.parametrize(
    ("line", "mended"),
    [
        ("wait part_ok", "wait until part_ok"),
        ("wait force", "wait until force > 0"),
        ("wait not part_ok", "wait until not part_ok"),
        ("wait part_ok timeout 3 s", "wait until part_ok timeout 3 s"),
        ("wait part_ok and not part_ok", "wait until part_ok and not part_ok"),
        ("if part_ok then wait part_ok is on", "if part_ok then wait until part_ok is on"),
        ("MoveJ infeed", "mov infeed"),
    ],
)
def test_a_condition_that_is_waited_for_is_mended_by_until(line: str, mended: str) -> None:
    head = "signal force = analog input 3\n"
    (found,) = compiled(head + line).diagnostics
    assert found.fix is not None
    span = found.fix.span
    assert line[: span.column - 1] + found.fix.replacement + line[span.end_column - 1 :] == mended
    assert compiled(head + mended).diagnostics == ()


@pytest.mark.parametrize(
    ("line", "mended"),
    [
        ("MoveL infeed, v500, z10", "lin infeed speed 500 mm/s blend 10 mm"),
        ("MoveL infeed above 30, v500, fine, jaws", "lin infeed above 30 speed 500 mm/s fine tool jaws"),
        ("movej(infeed, z10)", "mov infeed blend 10 mm"),
        ("if part_ok then MoveL infeed, fine", "if part_ok then lin infeed fine"),
        ("SetDO glue, 1", "set glue on"),
        ("set_digital_out(glue, 0)", "set glue off"),
        ("Reset glue", "set glue off"),
        ("WaitDI part_ok, 0", "wait until not part_ok"),
        ("WaitUntil part_ok", "wait until part_ok"),
        ("WaitTime 0.5", "wait 0.5 s"),
        ("sleep(0.5)", "wait 0.5 s"),
        ("delay 500 ms", "wait 500 ms"),
        ("speed 500 mm/s", "set speed 500 mm/s"),
        ("zone 10 mm", "set blend 10 mm"),
        ("exit", "stop"),
    ],
)
def test_a_simple_line_of_another_language_is_written_anew(line: str, mended: str) -> None:
    head = "program p\nunits mm\nsignal glue = output 1\n"
    first, second = language.each_place(compiled(f"{head}{line}\n{line}").diagnostics)
    for found, number in ((first, 4), (second, 5)):
        assert found.fix is not None
        span = found.fix.span
        assert (found.code, span.line) == ("N201", number)
        assert line[: span.column - 1] + found.fix.replacement + line[span.end_column - 1 :] == mended
    assert compiled(f"{head}{mended}").diagnostics == ()


@pytest.mark.parametrize(
    "line",
    [
        "SetDO part_ok, 1",
        "SetDO nowhere, 1",
        "delay 500",
        "x = sleep(3)",
        "WaitTime 3 mm",
        "exit 3",
        "Reset glue, 1",
    ],
)
def test_a_line_that_tells_too_little_has_no_fix(line: str) -> None:
    found = next(one for one in compiled(f"program p\nunits mm\n{line}").diagnostics if one.code[0] == "N")
    assert found.fix is None
