"""What the editor offers to do, and that it changes nothing that is done."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from ropsim import icr, language
from ropsim.flow import Origin
from ropsim.language.testing import Parsed, Shapes, parse_line
from ropsim.workbench import new_project
from support.editors import Editor, applied, place, uri_of

BARE = "file:///nowhere-at-all/x.task"
TEXT = """program p
units mm, deg
frame table = (300, 0, 100)
# Goes there.
task Go(part, clear, n = 2) -> int
  gap = clear + 5 mm
  for k = 1 to n
    lin part above gap speed 100 mm/s
    lin (0, 10, 20) in table
    print k
  endf
  with frame table
    lin (1, 2, 3)
  endwith
  total = n + 1
  return total
endp
m = Go((400, 0, 300), 20 mm)
repeat m
  lin (400, 1, 300) offset (0, 0, 5)
endr
"""


def offered(text: str, first: tuple[int, int], last: tuple[int, int], **context: Any) -> list[dict[str, Any]]:
    editor = Editor()
    editor.open(BARE, text)
    span = {"start": place(*first), "end": place(*last)}
    about = {"textDocument": {"uri": BARE}, "range": span, "context": {"diagnostics": [], **context}}
    found: list[dict[str, Any]] = editor.ask("textDocument/codeAction", **about)
    return found


def after(text: str, action: dict[str, Any]) -> str:
    (edits,) = action["edit"]["changes"].values()
    return applied(text, edits)


def done(text: str) -> list[Any]:
    """Return all that a dry run hands out, whoever calls for it."""
    compiled = language.compile(text)
    assert compiled.icr is not None, compiled.diagnostics
    run = icr.run(compiled.icr)
    assert run.trap is None
    return [_anonymous(one) for one in run.instructions]


def _anonymous(one: Any) -> Any:
    """Return an instruction without the place that it comes from, where it tells one."""
    return replace(one, origin=Origin()) if hasattr(one, "origin") else one


def named(actions: list[dict[str, Any]], title: str) -> dict[str, Any]:
    (found,) = [one for one in actions if one["title"].startswith(title)]
    return found


def test_types_are_written_into_the_header_and_the_code_stays() -> None:
    action = named(offered(TEXT, (4, 8), (4, 8)), "write the types of `Go`")
    changed = after(TEXT, action)
    assert "task Go(part: loc, clear: length, n: int = 2) -> int\n" in changed
    assert action["kind"] == "refactor.rewrite"
    before, now = language.compile(TEXT), language.compile(changed)
    assert before.icr is not None
    assert now.icr is not None
    assert icr.disassemble(now.icr) == icr.disassemble(before.icr)
    assert not [one for one in offered(changed, (4, 8), (4, 8)) if one["title"].startswith("write")]


@pytest.mark.parametrize(
    ("line", "column", "literal"),
    [(8, 10, "(0, 10, 20) in table"), (17, 9, "(400, 0, 300)"), (19, 8, "(400, 1, 300)")],
)
def test_a_named_location_leaves_the_code_as_it_is(line: int, column: int, literal: str) -> None:
    action = named(offered(TEXT, (line, column), (line, column)), "name this location")
    changed = after(TEXT, action)
    assert changed.split("\n")[3] == f"loc place1 = {literal}"
    assert changed.count(literal) == 1
    assert changed.count("place1") == 2
    assert done(changed) == done(TEXT)


@pytest.mark.parametrize(("line", "column"), [(12, 10), (19, 30)])
def test_a_literal_that_would_not_be_the_same_elsewhere_is_left_with_a_reason(line: int, column: int) -> None:
    action = named(offered(TEXT, (line, column), (line, column)), "name this location")
    assert "edit" not in action
    assert "would not be the same" in action["disabled"]["reason"]


def test_for_what_is_offered_only_new_lines_are_read(monkeypatch: pytest.MonkeyPatch) -> None:
    text = "".join(f"lin (300, {k}, 200)\n" for k in range(300))
    editor = Editor()
    editor.open(BARE, f"program p\nunits mm, deg\n{text}")
    about = {"range": {"start": place(9, 9), "end": place(9, 9)}, "context": {"diagnostics": []}}
    read: list[str] = []

    def counted(_: Shapes, line: str) -> Parsed:
        read.append(line)
        return parse_line(line)

    monkeypatch.setattr(Shapes, "parsed", counted)
    action = named(editor.ask("textDocument/codeAction", textDocument={"uri": BARE}, **about), "name this")
    assert "edit" in action
    assert read == ["loc place1 = (300, 7, 200)", "lin place1", "mov (300, 7, 200)"]


def test_a_new_name_is_free() -> None:
    text = TEXT.replace("m = Go", "place1 = 3\nprint place1\nm = Go")
    action = named(offered(text, (19, 9), (19, 9)), "name this location")
    assert action["title"] == "name this location `place2`"


@pytest.mark.parametrize(
    ("first", "last", "header", "call"),
    [
        (7, 8, "task Task1(part: loc, gap: length)", "    Task1 part, gap"),
        (6, 10, "task Task1(n: int, part: loc, gap: length)", "  Task1 n, part, gap"),
        (5, 5, "task Task1(clear: length) -> length", "  gap = Task1(clear)"),
        (14, 14, "task Task1(n: int) -> int", "  total = Task1(n)"),
        (11, 13, "task Task1()", "  Task1"),
        (9, 9, "task Task1(k: int)", "    Task1 k"),
        (19, 19, "task Task1()", "  Task1"),
        (18, 20, "task Task1(m: int)", "Task1 m"),
    ],
)
def test_lines_become_a_task_and_the_same_is_done(first: int, last: int, header: str, call: str) -> None:
    width = len(TEXT.split("\n")[last])
    action = named(offered(TEXT, (first, 0), (last, width)), "make a task")
    changed = after(TEXT, action)
    lines = changed.split("\n")
    assert header in lines
    assert call in lines
    assert done(changed) == done(TEXT)
    body = changed[changed.index(header) : changed.index("endp", changed.index(header))]
    moved = [line.strip() for line in TEXT.split("\n")[first : last + 1]]
    assert [line.strip() for line in body.split("\n")[1:] if line.strip() and "return" not in line] == moved


def test_a_selection_that_ends_at_the_start_of_a_line_is_that_of_the_lines_before() -> None:
    assert "Task1 part, gap" in after(TEXT, named(offered(TEXT, (7, 0), (9, 0)), "make a task"))


@pytest.mark.parametrize(
    ("first", "last", "reason"),
    [
        (6, 7, "would not be complete"),
        (16, 16, "`return` has to stay"),
        (2, 2, "`frame` has to stay"),
        (4, 16, "`task` has to stay"),
        (5, 14, "they give values to `gap` and `total`"),
    ],
)
def test_lines_that_cannot_be_a_task_are_told_why(first: int, last: int, reason: str) -> None:
    text = TEXT.replace("  return total", "  print gap\n  return total")
    action = named(offered(text, (first, 0), (last, 99)), "make a task")
    assert "edit" not in action
    assert reason in action["disabled"]["reason"]


@pytest.mark.parametrize(
    "lines",
    [
        ("x = x + 1", "print x"),
        ("if i == 1", "  x = 5", "endif", "print x"),
        ("if i == 1 then x = 5", "print x"),
        ("if i == 1", "  y = 5", "endif", "print y"),
        ("print x", "x = i"),
        ("x = (1 +", "  x)", "print x"),
    ],
)
@pytest.mark.parametrize("condition", ["part_ok", "1 == 1"])
def test_what_a_loop_carries_into_its_next_pass_stays_in_it(lines: tuple[str, ...], condition: str) -> None:
    head = ["program p", "signal part_ok = input 1", "x = 1", "y = 1", f"if {condition}", "for i = 1 to 3"]
    text = "\n".join([*head, *lines, "endf", "endif", ""])
    action = named(offered(text, (6, 0), (5 + len(lines), 99)), "make a task")
    assert "for its next pass" in action["disabled"]["reason"]


def test_a_parameter_that_a_loop_changes_stays_in_it() -> None:
    text = "program p\ntask T(a: int)\n  for i = 1 to 3\n    a = a + 5\n    print a\n  endf\nendp\nT 1\n"
    assert "`a`" in named(offered(text, (3, 0), (4, 99)), "make a task")["disabled"]["reason"]


@pytest.mark.parametrize("behind", ["print x", "wait 0 s"])
def test_what_a_pass_gives_anew_or_hands_back_may_be_a_task(behind: str) -> None:
    for lines in (["x = i", "x = x + 1", "print x"], *([["x = x + 1", "print x"]] * (behind == "print x"))):
        text = "\n".join(["program p", "x = 1", "for i = 1 to 3", *lines, behind, "endf", ""])
        changed = after(text, named(offered(text, (3, 0), (2 + len(lines), 99)), "make a task"))
        assert done(changed) == done(text)


def test_a_component_that_only_a_loop_has_keeps_its_lines() -> None:
    grid = "pattern slots = grid 2 x 2 from (400, 0, 300) step (70, 0, 0), (0, 90, 0)\n"
    text = f"program p\nunits mm\n{grid}for each s in slots\n  lin s\n  print s.row\nendf\n"
    assert "disabled" in named(offered(text, (5, 0), (5, 13)), "make a task")
    assert done(after(text, named(offered(text, (4, 0), (4, 7)), "make a task"))) == done(text)


MOVES = "units mm, deg\nloc p1 = (400, 0, 300)\nmov p1\n  LIN p1 above 5 mm\nlin p1 speed 100 mm/s\n"


@pytest.mark.parametrize(
    ("line", "title", "written"),
    [(2, "make it a line (`lin`)", "lin p1"), (3, "make it a joint move (`mov`)", "  mov p1 above 5 mm")],
)
def test_a_move_is_made_one_of_the_other_kind(line: int, title: str, written: str) -> None:
    changed = after(MOVES, named(offered(MOVES, (line, 4), (line, 4)), title))
    lines = MOVES.splitlines()
    lines[line] = written
    assert changed.splitlines() == lines


def test_a_move_with_a_speed_of_its_tool_stays_a_line() -> None:
    assert not [one for one in offered(MOVES, (4, 0), (4, 0)) if "make it" in one["title"]]


def test_new_lines_end_as_those_of_the_document_do() -> None:
    text = TEXT.replace("\n", "\r\n")
    changed = after(text, named(offered(text, (7, 0), (8, 99)), "make a task"))
    assert "Task1 part, gap" in changed
    assert "\n" not in changed.replace("\r\n", "")


def test_a_cursor_selects_no_lines() -> None:
    assert not [one for one in offered(TEXT, (7, 2), (7, 2)) if one["title"].startswith("make a task")]


def test_only_the_kinds_that_are_asked_for_are_offered() -> None:
    kinds = {one["kind"] for one in offered(TEXT, (4, 0), (8, 99))}
    assert {"refactor.rewrite", "refactor.extract"} <= kinds
    assert {one["kind"] for one in offered(TEXT, (4, 0), (8, 99), only=["refactor.rewrite"])} == {
        "refactor.rewrite"
    }
    assert offered(TEXT, (4, 0), (8, 99), only=["source"]) == []


def test_a_wrong_text_is_mended_first() -> None:
    text = TEXT.replace("print k", "pritn k")
    assert {one["kind"] for one in offered(text, (4, 0), (9, 9))} == {"quickfix"}


def test_a_task_in_a_project_takes_locations_of_the_cell_as_they_are(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    program = folder / "programs" / "main.task"
    text = program.read_text("utf-8")
    editor = Editor()
    editor.open(uri_of(program), text)
    span = {"start": place(23, 0), "end": place(24, 99)}
    about = {"textDocument": {"uri": uri_of(program)}, "range": span}
    action = named(editor.ask("textDocument/codeAction", **about), "make a task")
    changed = after(text, action)
    assert "task Task1(slot: loc)\n  Pick infeed\n  Place slot in pallet\nendp\n\nfor each" in changed
