"""Positions stand outside of meaning: what moves about, and names of local variables, change no code."""

from dataclasses import replace
from pathlib import Path

import pytest

from ropsim import icr, language
from ropsim.core import Span
from ropsim.icr import disassemble, program_id
from support.tasks import CELL, compiled

FOLDER = Path(__file__).parents[2] / "golden" / "task"
PROGRAMS = {
    name: (FOLDER / f"{name}.task").read_text(encoding="utf-8")
    for name in ("everything", "contract", "motions")
}
TASK = "task Unused(spot: loc)\n  mov spot\n  if part_ok then mov spot above 20 mm\nendp\n"


def meaning(result: language.Compiled) -> tuple[str, str]:
    """Return what a program is, without its lines."""
    assert result.icr is not None
    bare = tuple(replace(one, lines=()) for one in result.icr.procedures)
    return disassemble(replace(result.icr, procedures=bare, source="")), program_id(result.icr)


def lines_of(result: language.Compiled) -> list[str]:
    """Return the words of the source line of each instruction."""
    assert result.icr is not None
    numbers = [line for one in result.icr.procedures for line in one.lines]
    return [" ".join(result.source.line(line).split("#")[0].split()) if line else "" for line in numbers]


def every_line(text: str, before: str) -> str:
    """Return a text with lines before each of its lines, as far as no statement goes on there."""
    return "".join(before + line for line in text.splitlines(keepends=True))


@pytest.mark.parametrize("name", PROGRAMS)
@pytest.mark.parametrize("before", ["\n", "# note\n", "\n   // note\n\n"])
def test_blank_lines_and_comments_change_no_meaning(name: str, before: str) -> None:
    text = PROGRAMS[name]
    moved = (
        compiled(every_line(text, before))
        if "\\\n" not in text and "(\n" not in text
        else compiled(before + text)
    )
    first = compiled(text)
    assert meaning(moved) == meaning(first)
    assert lines_of(moved) == lines_of(first)
    assert moved.program == first.program


@pytest.mark.parametrize("name", PROGRAMS)
def test_a_task_above_changes_no_other_one(name: str) -> None:
    first, moved = compiled(PROGRAMS[name]), compiled(TASK + PROGRAMS[name])
    assert meaning(moved) == meaning(first)
    assert lines_of(moved) == lines_of(first)
    assert first.program is not None
    assert moved.program is not None
    assert moved.program.tasks[1:] == first.program.tasks
    assert moved.program.main == first.program.main


def test_a_local_variable_may_have_any_name() -> None:
    loop = "  {0} = n\n  while {0} > 0\n    {0} = {0} - 1\n  endw\n"
    text = f"program p\nunits mm\ntask T(n: int)\n{loop}endp\nT 3\n"
    one, other = compiled(text.format("k")), compiled(text.format("zebra"))
    assert one.icr is not None
    assert other.icr is not None
    assert program_id(one.icr) == program_id(other.icr)
    assert one.icr != other.icr  # whoever looks at variables sees their names


def test_variables_without_a_value_may_have_any_name() -> None:
    branch = "  if n > 2\n    {0} = 1\n    {1} = 2\n  endif\n"
    text = f"program p\ntask T(n: int)\n{branch}  x = {{0}} + {{1}}\n  print x\nendp\nT 3\n"
    one, other = compiled(text.format("a", "b")), compiled(text.format("z", "y"))
    assert one.icr is not None
    assert other.icr is not None
    assert program_id(one.icr) == program_id(other.icr)
    assert icr.verify(other.icr) == ()


@pytest.mark.parametrize("above", ["", "\n\n", "# a\n", TASK, "mov home\n\ntask X\n  open\nendp\n\n"])
def test_findings_point_at_their_line_wherever_it_lies(above: str) -> None:
    task = "task T(q: loc)\n\n  # up\n  mov q above qq\n\n  T2 3,\nendp\n"
    text = f"program p\n{above}units mm\n{task}T (1, 2,\n   3)\nmov nowhere\n"
    result = language.compile(text, CELL, "t.task")
    marked = [
        result.source.line(one.span.line)[one.span.column - 1 : one.span.end_column - 1]
        for one in result.diagnostics
        if one.span is not None and one.is_error
    ]
    assert "qq" in marked
    assert "nowhere" in marked
    assert any(word.startswith("T2") or word == "," for word in marked)


def test_the_line_of_a_statement_below_one_of_several_lines_is_right() -> None:
    text = "program p\nunits mm\ntask T\n  lin (1, 2,\n    3)\n\n  open\nendp\n\nmov home\nT\n"
    result = compiled(text)
    assert result.icr is not None
    code = result.icr.procedure("T")
    assert code is not None
    assert [line for step, line in zip(code.code, code.lines, strict=True) if step.mnemonic == "GRIP"] == [7]


def test_a_variable_that_a_called_task_reads_without_a_value_is_told_at_the_call() -> None:
    head = "program p\nunits mm, deg, s\nvar q: loc\ntask T()\n  lin q\nendp\n"
    (found,) = compiled(head + "if part_ok\n  call T   # where to?\nendif\n").diagnostics
    assert found.code == "T392"
    assert found.span == Span("t.task", 8, 3, 8, 9)
