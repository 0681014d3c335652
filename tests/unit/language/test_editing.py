"""What the compiler keeps for editors: parsed lines, the outline of a text, how tasks are called."""

from dataclasses import replace

import pytest

from ropsim import language
from ropsim.core import SourceText
from ropsim.language import LineCache, TaskSignature
from support.tasks import CELL

TEXT = """task A(q: loc)
  x = 1
  mov q
endp
var total: int = 0
once = 2
task B
  load (u, v, w), (1, 2, 3)
  total = 3
  open
A (1, 2, 3)
"""


@pytest.mark.parametrize("text", [TEXT, TEXT.replace("mov q", "mvo q"), "lin (1,\n 2\nmov home", ""])
def test_kept_lines_change_no_result(text: str) -> None:
    cache = LineCache()
    language.compile(TEXT, cache=cache)
    kept, fresh = language.compile(text, cache=cache), language.compile(text)
    assert kept.diagnostics == fresh.diagnostics
    assert kept.program == fresh.program
    assert kept.icr == fresh.icr
    assert kept.tasks == fresh.tasks


def outline() -> language.Outline:
    return language.outline(SourceText("t", TEXT), LineCache())


def test_a_task_without_end_reaches_to_the_next_or_the_end() -> None:
    assert [(t.definition.name, t.span.line, t.span.end_line) for t in outline().tasks] == [
        ("A", 1, 4),
        ("B", 7, 11),
    ]


def test_tasks_tell_how_they_are_called_also_in_a_wrong_text() -> None:
    compiled = language.compile("units mm\ntask T(a, d: length = 3)\n  mov a above d\nendp\nlin\n")
    assert not compiled.ok
    assert str(compiled.tasks["T"]) == "T(a: loc, d: length [mm] = 3)"


def test_a_default_is_told_as_it_is_written() -> None:
    head = "task T(q: loc, a = gap, b: loc = (1, 2, 3; down), t = \\\n  3 s)\n"
    task = f"{head}  mov q above a\n  mov b\n  wait t\nendp\n"
    compiled = language.compile(f"program p\nunits mm\nconst gap = 3 mm\n{task}T (1, 2, 3)\n")
    told = "T(q: loc, a: length [mm] = gap, b: loc = (1, 2, 3; down), t: time [s] = 3 s)"
    assert (str(compiled.tasks["T"]), compiled.diagnostics) == (told, ())


def test_a_task_of_a_library_has_no_places_of_a_deleted_one_of_its_name() -> None:
    library = language.compile("task Other\n print 2\nendp\nOther\n", CELL, "lib.task").program
    assert library is not None
    environment = replace(CELL, tasks={one.name: TaskSignature(one) for one in library.tasks})
    lines = language.LineCache()
    own = "program p\nunits mm, deg, s\n\n\n\ntask Other\n\n\n print 1\nendp\nOther\n"
    for text in (own, "program p\nunits mm, deg, s\nOther\n"):
        again = language.compile(text, environment, "p", lines)
        clean = language.compile(text, environment, "p")
        assert again.icr is not None
        assert clean.icr is not None
        assert [one.lines for one in again.icr.procedures] == [one.lines for one in clean.icr.procedures]
