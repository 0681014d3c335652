"""Where names are used, and what they mean there."""

from pathlib import Path

import pytest

from ropsim.core import SourceText
from ropsim.language import Act, LineCache, Role, Space, Uses, uses_of

HEAD = "program p\nunits mm, deg, s\n"
ROOT = Path(__file__).parents[4]


def uses(text: str, *outside: str) -> Uses:
    return uses_of(SourceText("x.task", text), LineCache(), frozenset(outside))


def places(found: Uses, line: int, column: int) -> list[tuple[int, int, str]]:
    """Return line, column and act of all uses of what stands at a place."""
    use = found.at(line, column)
    assert use is not None
    return [(one.span.line, one.span.column, one.act.value) for one in found.of(use.meaning)]


def test_the_variables_of_two_tasks_are_two() -> None:
    text = HEAD + "task A(d: length)\n  x = d\n  print x\nendp\ntask B(d: length)\n  x = d\n  print x\nendp\n"
    assert places(uses(text), 5, 9) == [(4, 3, "defines"), (5, 9, "reads")]
    assert places(uses(text), 8, 7) == [(7, 8, "defines"), (8, 7, "reads")]


def test_a_declared_variable_is_one_for_all_tasks_wherever_it_stands() -> None:
    text = HEAD + "task A()\n  n = n + 1\nendp\nA\nvar n: int = 0\nprint n\n"
    assert places(uses(text), 7, 5) == [(4, 3, "writes"), (4, 7, "reads"), (7, 5, "defines"), (8, 7, "reads")]


def test_a_loop_has_a_variable_of_its_own_unless_there_is_one() -> None:
    first = "for i = 1 to 3\n  print i\nendf\n"
    nested = "for i = 1 to 2\n  for i = 1 to 4\n    print i\n  endf\nendf\n"
    text = HEAD + first + "i = 7\n" + nested
    found = uses(text)
    assert places(found, 4, 9) == [(3, 5, "defines"), (4, 9, "reads")]
    assert places(found, 6, 1) == [(6, 1, "defines"), (7, 5, "writes")]
    assert places(found, 9, 11) == [(8, 7, "defines"), (9, 11, "reads")]


def test_the_places_of_a_pattern_are_a_variable_of_that_loop() -> None:
    text = HEAD + (
        "pattern slots = grid 2 x 2 from (0, 0, 40) step (70, 0, 0), (0, 90, 0)\n"
        "s = 3\nfor each s in slots\n  lin s above s.row\nendf\nprint s\n"
    )
    found = uses(text)
    assert places(found, 8, 7) == [(4, 1, "defines"), (8, 7, "reads")]
    assert places(found, 6, 7) == [(5, 10, "defines"), (6, 7, "reads"), (6, 15, "reads")]
    assert [line for line, _, _ in places(found, 3, 10)] == [3, 5]


def test_a_variable_that_a_line_above_reads_is_that_of_the_task() -> None:
    text = HEAD + "repeat 2\n  if false then print last\n  last = 4\nendr\n"
    assert [act for _, _, act in places(uses(text), 4, 24)] == ["reads", "defines"]


@pytest.mark.parametrize("call", ["Pick (0, 0, 9), clear = 5", "n = Pick((0, 0, 9), clear = 5)"])
def test_an_argument_by_name_is_a_use_of_the_parameter(call: str) -> None:
    text = HEAD + f"task Pick(q: loc, clear: length) -> int\n  lin q above clear\n  return 1\nendp\n{call}\n"
    at = [(line, act) for line, _, act in places(uses(text), 3, 19)]
    assert at == [(3, "defines"), (4, "reads"), (7, "reads")]


def test_frames_tools_and_other_names_do_not_meet() -> None:
    text = HEAD + "frame a = (1, 2, 3)\ntool a = (0, 0, 9)\nloc a = (4, 5, 6) in a\nset tool a\nlin a in a\n"
    found = uses(text)
    assert [line for line, _, _ in places(found, 3, 7)] == [3, 5, 7]
    assert [line for line, _, _ in places(found, 4, 6)] == [4, 6]
    assert [line for line, _, _ in places(found, 5, 5)] == [5, 7]


def test_names_of_the_cell_have_no_definition_and_one_meaning() -> None:
    text = HEAD + "task A()\n  lin infeed\nendp\nA\nlin infeed in table\n"
    found = uses(text, "infeed")
    use = found.at(4, 7)
    assert use is not None
    assert (use.meaning.role, use.meaning.definition) == (None, None)
    assert [line for line, _, _ in places(found, 4, 7)] == [4, 7]
    frame = found.at(7, 16)
    assert frame is not None
    assert frame.meaning.space is Space.FRAME


def test_what_a_classic_task_reads_first_is_a_parameter_of_that_task_alone() -> None:
    text = "task A\n  mov l above a\nendp\ntask B\n  mov l above a\nendp\n"
    found = uses(text)
    use = found.at(2, 15)
    assert use is not None
    assert use.meaning.is_implicit
    assert [line for line, _, _ in places(found, 2, 15)] == [2]
    known = uses(text, "a").at(2, 15)
    assert known is not None
    assert known.meaning.role is None


def test_the_words_of_a_contract_are_no_names() -> None:
    text = "task A\n  assumes the gripper is open and\n  the part lies still.\n  mov l\nendp\nA (1, 2, 3)\n"
    assert {one.meaning.name for one in uses(text).found} == {"A", "l"}


def test_a_declaration_that_cannot_be_read_still_defines_its_name() -> None:
    found = uses(HEAD + "loc corner = (1, 2\nlin corner\n")
    assert places(found, 4, 5) == [(3, 5, "defines"), (4, 5, "reads")]
    assert [one.line for one in found.broken] == [3]


@pytest.mark.parametrize("path", sorted(ROOT.glob("examples/*/programs/*.task")), ids=lambda p: p.parts[-3])
def test_every_use_stands_where_its_name_stands(path: Path) -> None:
    text = path.read_text("utf-8")
    lines = text.split("\n")
    found = uses(text)
    assert len(found.found) > 5
    for one in found.found:
        written = lines[one.span.line - 1][one.span.column - 1 : one.span.end_column - 1]
        assert written == one.meaning.name
        if one.act is Act.DEFINES:
            assert one.meaning.role is not Role.TASK or one.span == one.meaning.definition


@pytest.mark.parametrize("call", ["    T(2, n = n or b)", "k = T(2, n = n or b)", "k = T(2, n := n or b)"])
def test_a_name_before_the_value_of_an_argument_is_the_parameter_in_every_call(call: str) -> None:
    text = HEAD + f"task T(x: num, n: bool) -> num\n  return x\nendp\nn = true\nb = true\n{call}\n"
    found = uses(text)
    assert [line for line, _, _ in places(found, 3, 16)] == [3, 8]
    assert [line for line, _, _ in places(found, 6, 1)] == [6, 8]
