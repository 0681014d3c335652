"""Laws of the compiler: it answers every text, points into it, and keeps findings local."""

from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.core import Span
from ropsim.language import Compiled
from support.characters import ANY
from support.examples import examples
from support.tasks import CELL, compiled

FIG5 = (Path(__file__).parents[1] / "golden" / "task" / "fig5.task").read_text(encoding="utf-8")
MODERN = (Path(__file__).parents[1] / "golden" / "task" / "everything.task").read_text(encoding="utf-8")
SIGNS = {"(", ")", ",", ";", ".", '"', "\\", "1e999", "endr", "\t", "#"}
MOTIONS = (Path(__file__).parents[1] / "golden" / "task" / "motions.task").read_text(encoding="utf-8")
EXTERNAL = (Path(__file__).parents[1] / "golden" / "task" / "external.task").read_text(encoding="utf-8")
WORDS = sorted(set((FIG5 + MODERN + EXTERNAL + MOTIONS).split()) | SIGNS)
TASKS = """program p
units mm, deg, s
task Pick(part: loc, clear: length = 60 mm)
  mov part above clear
  repeat 2
    lin part speed 150 mm/s
  endr
  close
endp
task Place(slot: loc)
  n = 3
  while n > 0
    n = n - 1
  endw
  lin slot
  open
endp
"""
EXAMPLES = settings(max_examples=examples(60), derandomize=True)


def assert_answers(text: str) -> Compiled:
    """Compile; every finding must point into the text."""
    result = compiled(text)
    for finding in result.diagnostics:
        assert finding.span is not None
        assert_inside(finding.span, result)
    assert result.ok or result.icr is None
    return result


def assert_inside(span: Span, result: Compiled) -> None:
    lines = result.source.lines
    assert 1 <= span.line <= span.end_line <= len(lines)
    assert 1 <= span.column <= max(len(lines[span.line - 1]), 1)
    assert span.end_column <= max(len(lines[span.end_line - 1]), 1) + 1
    assert (span.line, span.column) < (span.end_line, span.end_column)


@EXAMPLES
@given(st.text(ANY, max_size=400))
def test_any_text_is_answered(text: str) -> None:
    assert_answers(text)


@EXAMPLES
@given(st.binary(max_size=400))
def test_any_bytes_are_answered(content: bytes) -> None:
    assert_answers(content.decode("utf-8", "replace"))


@EXAMPLES
@given(st.lists(st.lists(st.sampled_from(WORDS), max_size=8), max_size=25))
def test_any_words_of_the_language_are_answered(lines: list[list[str]]) -> None:
    assert_answers("\n".join(" ".join(line) for line in lines))


@EXAMPLES
@given(st.sampled_from([FIG5, MODERN, EXTERNAL, MOTIONS]), st.data())
def test_mutations_of_right_programs_are_answered(program: str, data: st.DataObject) -> None:
    start = data.draw(st.integers(0, len(program)))
    length = data.draw(st.integers(0, 30))
    inserted = data.draw(st.one_of(st.text(ANY, max_size=5), st.sampled_from(WORDS)))
    assert_answers(program[:start] + inserted + program[start + length :])


@EXAMPLES
@given(st.integers(2, 8), st.sampled_from(["", "mov", "5 +", "lin part speed 3 s", "x = = 2", "gobble part"]))
def test_a_change_inside_one_task_brings_no_finding_to_another(index: int, replacement: str) -> None:
    lines = TASKS.split("\n")
    changed = [*lines[:index], replacement, *lines[index + 1 :]]
    other = next(k for k, line in enumerate(lines) if line.startswith("task Place")) + 1
    found = assert_answers("\n".join(changed)).diagnostics
    assert all(d.span is not None and d.span.line < other for d in found if d.code != "L111")


@EXAMPLES
@given(st.integers(1, 12))
def test_empty_lines_before_a_program_move_findings_and_nothing_else(count: int) -> None:
    text = TASKS + "Pick nowhere\nPlace 3 s\n"
    plain = compiled(text).diagnostics
    moved = compiled("\n" * count + text).diagnostics
    assert [(d.code, d.message) for d in moved] == [(d.code, d.message) for d in plain]
    lines = [(d.span.line, m.span.line) for d, m in zip(plain, moved, strict=True) if d.span and m.span]
    assert all(later == earlier + count for earlier, later in lines)


def test_the_cell_of_the_tests_is_not_changed_by_compiling() -> None:
    before = repr(CELL)
    compiled(MODERN)
    assert repr(CELL) == before
