"""Lines of blocks without `then` or `do`, with a statement behind them, or with ends in two words."""

import pytest

from ropsim.core import Diagnostic
from support.tasks import codes, compiled, only

HEAD = "program p\nunits mm, deg, s\nloc a = (300, 0, 100)\ntask Foo(q: loc)\n  lin q\nendp\nFoo a\n"
BEHIND = "loc late = (300, 0, 50)\nlin late\n"


def applied(text: str, found: Diagnostic) -> str:
    """Return a text with the fix of a finding."""
    fix = found.fix
    assert fix is not None
    lines = text.splitlines(keepends=True)
    line = lines[fix.span.line - 1]
    lines[fix.span.line - 1] = line[: fix.span.column - 1] + fix.replacement + line[fix.span.end_column - 1 :]
    return "".join(lines)


@pytest.mark.parametrize(
    ("line", "fix"),
    [
        ("if part_ok print 1", "then print"),
        ("if part_ok x = 3", "then x"),
        ("if part_ok and not part_ok lin a", "then lin"),
        ("if 1 == 1 print 1", "then print"),
    ],
)
def test_a_statement_behind_a_condition_lacks_then(line: str, fix: str) -> None:
    text = f"{HEAD}{line}\n{BEHIND}"
    found = only(text)
    assert (found.code, found.hint, found.span and found.span.line) == ("L101", "write `then`", 8)
    assert found.fix is not None
    assert found.fix.replacement == fix
    assert not [one for one in compiled(applied(text, found)).diagnostics if one.is_error]


@pytest.mark.parametrize("word", ["do", "than", "thne"])
def test_another_word_in_the_place_of_then_keeps_the_block(word: str) -> None:
    text = f"{HEAD}if part_ok {word}\n  lin a\nendif\n{BEHIND}"
    found = only(text)
    assert "`then`" in found.hint
    assert codes(applied(text, found)) == []


@pytest.mark.parametrize("line", ["if part_ok Foo a", "if 1 = 1 Foo a", "if part_ok Foo(a)"])
def test_a_call_of_a_task_with_a_capital_letter_lacks_then(line: str) -> None:
    text = f"{HEAD}{line}\n{BEHIND}"
    found = only(text)
    assert found.hint == "write `then`"
    assert codes(applied(text, found)) == []


@pytest.mark.parametrize(("word", "sign"), [("EQ", "="), ("equals", "="), ("gt", ">"), ("NE", "<>")])
def test_comparisons_are_signs(word: str, sign: str) -> None:
    text = f"{HEAD}k = 3\nif k {word} 3 then\n  lin a\nendif\n{BEHIND}"
    found = only(text)
    assert found.hint == f"write `{sign}`"
    assert codes(applied(text, found)) == []


@pytest.mark.parametrize("line", ["if part_ok foo a", "if 1 = 1 foo a"])
def test_a_call_behind_a_condition_lacks_then(line: str) -> None:
    found = only(f"{HEAD}{line}\n{BEHIND}")
    assert "stands behind `then`" in found.hint


@pytest.mark.parametrize(
    ("header", "closer", "missing"),
    [
        ("while part_ok", "endw", "do"),
        ("for i = 1 to 3", "endf", "do"),
        ("for each b in g", "endf", "do"),
        ("repeat 3", "endr", ""),
        ("repeat", "endr", ""),
        ("with speed 30 mm/s", "endwith", ""),
        ("while part_ok do", "endw", ""),
        ("for i = 1 to 3 do", "endf", ""),
    ],
)
@pytest.mark.parametrize("is_closed", [True, False])
def test_a_statement_behind_the_header_of_a_loop_belongs_below(
    header: str, closer: str, missing: str, is_closed: bool
) -> None:
    pattern = "pattern g = grid 2 x 2 from (0, 0, 0) step (1, 0, 0), (0, 1, 0)\n"
    end = f"  close\n{closer}\n" if is_closed else ""
    text = f"{HEAD}{pattern}{header} lin a\n{end}{BEHIND}"
    found = only(text)
    assert (found.code, found.span and found.span.line) == ("L101", 9)
    assert (f"write `{missing}`" if missing else "line of its own") in found.hint
    whole = applied(text, found)
    assert "T337" in codes(whole) if header == "repeat" else codes(whole) == []


@pytest.mark.parametrize(
    ("lines", "mended"),
    [
        ("repeat 3 open", "repeat 3\n  open\nendr"),
        ("repeat 3  open # now", "repeat 3\n  open\nendr # now"),
        ("while part_ok open", "while part_ok do\n  open\nendw"),
        ("for i = 1 to 3 print i", "for i = 1 to 3 do\n  print i\nendf"),
        ("repeat 3 open\nendr", "repeat 3\n  open\nendr"),
        ("while part_ok\n  repeat 3 open\nendw", "while part_ok\n  repeat 3\n    open\n  endr\nendw"),
    ],
)
def test_a_loop_without_an_end_of_its_own_is_ended_by_the_fix(lines: str, mended: str) -> None:
    text = f"{HEAD}{lines}\n{BEHIND}"
    (found,) = (one for one in compiled(text).diagnostics if one.is_error)
    assert applied(text, found) == f"{HEAD}{mended}\n{BEHIND}"
    assert not [one for one in compiled(applied(text, found)).diagnostics if one.is_error]


@pytest.mark.parametrize("lines", ["repeat 3 open\n  close", "repeat 3 while part_ok open"])
def test_a_loop_whose_end_may_be_meant_in_more_places_has_no_fix(lines: str) -> None:
    (found,) = (one for one in compiled(f"{HEAD}{lines}\n{BEHIND}").diagnostics if one.is_error)
    assert found.fix is None


@pytest.mark.parametrize("closer", ["endr", "endw", "end"])
def test_a_repeat_while_is_a_while(closer: str) -> None:
    text = f"{HEAD}repeat while part_ok\n  lin a\n{closer}\n{BEHIND}"
    found = only(text)
    assert found.fix is None
    assert found.hint == "write `while part_ok`, and `endw` at the end of the loop"


@pytest.mark.parametrize(
    ("line", "mended"),
    [
        ("if part_ok then open end if", "if part_ok then open"),
        ("if part_ok then open endif", "if part_ok then open"),
        ("if part_ok then print 1 endif # c", "if part_ok then print 1 # c"),
        ("if part_ok then\n  open\nendif if", "if part_ok then\n  open\nendif"),
        ("while part_ok\n  lin a\nendw while", "while part_ok\n  lin a\nendw"),
    ],
)
def test_an_end_too_many_on_a_line_is_taken_away(line: str, mended: str) -> None:
    text = f"{HEAD}{line}\n{BEHIND}"
    found = only(text)
    assert (found.code, found.hint[:9]) == ("L101", "remove it")
    assert applied(text, found) == f"{HEAD}{mended}\n{BEHIND}"
    assert not [one for one in compiled(applied(text, found)).diagnostics if one.is_error]


def test_statements_behind_branches_belong_below() -> None:
    text = f"{HEAD}if part_ok then\n  open\nelseif not part_ok then close\nelse print 1\nendif\n{BEHIND}"
    first, second = compiled(text).diagnostics
    assert (first.code, second.code) == ("L101", "L101")
    assert codes(applied(applied(text, second), first)) == []


@pytest.mark.parametrize("word", ["times", "do", "loop"])
def test_a_count_has_no_word_behind_it(word: str) -> None:
    text = f"{HEAD}repeat 3 {word}\n  lin a\nendr\n{BEHIND}"
    found = only(text)
    assert found.hint == f"leave the `{word}` out"
    assert codes(applied(text, found)) == []


@pytest.mark.parametrize(
    ("opener", "end", "closer"),
    [
        ("if part_ok then", "end if", "endif"),
        ("while part_ok", "end while", "endw"),
        ("for i = 1 to 3", "End For", "endf"),
        ("repeat 3", "end repeat", "endr"),
        ("repeat 3", "end loop", "end"),
        ("with speed 20 mm/s", "end with", "endwith"),
        ("if part_ok then", "end switch", "endif"),
    ],
)
def test_an_end_in_two_words_ends_its_block(opener: str, end: str, closer: str) -> None:
    text = f"{HEAD}{opener}\n  lin a\n{end}\n{BEHIND}"
    found = only(text)
    assert (found.code, found.span and found.span.line) == ("L101", 10)
    assert f"`{closer}`" in found.hint
    assert codes(applied(text, found)) == []


@pytest.mark.parametrize("end", ["end task", "end proc", "end function"])
def test_an_end_in_two_words_ends_its_task(end: str) -> None:
    text = f"{HEAD}task G()\n  lin a\n{end}\nG\n{BEHIND}"
    found = only(text)
    assert "`endp`" in found.hint
    assert codes(applied(text, found)) == []


@pytest.mark.parametrize("opener", ["if part_ok", "while part_ok", "repeat 3", "with speed 20 mm/s"])
@pytest.mark.parametrize("body", ["", "  open\n  close\n", "open\nclose\n"])
def test_a_block_without_end_takes_in_no_declaration(opener: str, body: str) -> None:
    assert codes(f"{HEAD}{opener}\n{body}{BEHIND}") == ["L106"]


def test_an_end_further_left_ends_the_outer_block() -> None:
    assert codes(f"{HEAD}repeat 3\n  while part_ok lin a\nend\n{BEHIND}") == ["L101"]
    assert codes(f"{HEAD}if part_ok then\n  if part_ok than\nendif\n{BEHIND}") == ["L101"]


def test_a_condition_with_lines_below_it_is_a_block_though_a_statement_stands_behind_it() -> None:
    inner = "  if part_ok print 1\n  else\n    open\n  endif\n"
    assert codes(f"{HEAD}if part_ok then\n{inner}endif\n{BEHIND}") == ["L101"]
    assert codes(f"{HEAD}if part_ok print 1\n  open\nendif\n{BEHIND}") == ["L101"]


@pytest.mark.parametrize(
    "line", ["wait until part_ok timeout 3 else", "wait until part_ok timeout 3 else # no"]
)
def test_a_statement_stands_behind_else(line: str) -> None:
    found = only(f"{HEAD}{line}")
    assert (found.code, found.hint) == ("L101", "a statement stands behind `else`")
    assert found.span is not None
    assert found.span.column >= len("wait until part_ok timeout 3 else")


@pytest.mark.parametrize(
    "text",
    [
        "task T() -> length\n  while part_ok return 3 mm\n  endw\nendp\nx = T()\nprint x",
        "repeat 3 q = infeed\nendr\nlin q",
        "if part_ok q = infeed\nlin infeed",
    ],
)
def test_what_a_statement_on_the_line_of_a_header_makes_is_not_missed(text: str) -> None:
    assert codes(f"{HEAD}{text}") == ["L101"]


def test_implicit_parameters_that_a_wrong_line_may_name_are_not_missed() -> None:
    task = "task Twice\n  repeat 2 lin l\n  endr\nendp\n"
    assert codes(f"{task}Twice infeed\n") == ["L101"]
