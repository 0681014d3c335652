"""What an edit reaches: a task is checked again only where its text, or what it names, has changed."""

from functools import partial
from importlib import import_module

import pytest

from ropsim import icr, language
from ropsim.language.testing import END, START, of_task
from ropsim.query import Database, Outcome
from support.tasks import CELL

TEXT = """program p
units mm, deg
loc rack = (400, 100, 50)
loc bin = (300, -200, 50)
const clear = 40 mm
var total: int = 0
frame plate = (100, 0, 0)

# takes a part
task Pick(part: loc, above_it: length = 60 mm)
  mov part above above_it
  lin part speed 150 mm/s
  close
endp

task Count(by: int)
  step = by + 1
  total = total + step
endp

task Fetch
  Pick rack
  Count 2
  mov bin above clear
  open
endp

repeat 3
  Fetch
endr
Count 1
mov home
"""


class Editor:
    """A text that is edited, and which bodies the compiler worked on at the last edit."""

    def __init__(self, text: str = TEXT) -> None:
        self.cache = language.LineCache()
        self.db = self.cache.database(CELL, "t.task")
        self.db.events = []
        self.result = language.compile(text, CELL, "t.task", self.cache)
        assert self.result.diagnostics == ()

    def edited(self, text: str) -> language.Compiled:
        """Compile the text as it is now."""
        assert self.db.events is not None
        self.db.events.clear()
        self.result = language.compile(text, CELL, "t.task", self.cache)
        fresh = language.compile(text, CELL, "t.task")
        assert self.result.diagnostics == fresh.diagnostics
        assert self.result.icr == fresh.icr
        return self.result

    def ran(self, function: str) -> set[object]:
        """Return for which tasks, or parts of the control statements, a function was called."""
        events = self.db.events or []
        called = [one for one in events if one.function == function and one.outcome is not Outcome.REUSED]
        return {one.arguments[0] for one in called if one.arguments[0] not in {START, END}}

    def checked(self) -> set[object]:
        """Return the bodies that were checked again, `main` for control statements."""
        return self.ran("checked") | {"main" for _ in self.ran("checked_part")}

    def lowered(self) -> set[object]:
        """Return the bodies of which code was made again, `main` for control statements."""
        return self.ran("lowered") | {"main" for _ in self.ran("lowered_part")}


def test_at_first_all_is_worked_out_once() -> None:
    editor = Editor()
    assert editor.checked() == editor.lowered() == {"Pick", "Count", "Fetch", "main"}


@pytest.mark.parametrize(
    ("old", "new", "checked", "lowered"),
    [
        ("# takes a part", "# takes one part,\n# from above", set(), set()),
        ("\n\ntask Count", "\n\n\n\n\ntask Count", set(), set()),
        ("  close\nendp", "  # hold it\n\n  close\nendp", set(), set()),
        ("  close\nendp", "  close   # hold it\nendp", {"Pick"}, set()),
        ("repeat 3", "# three parts\nrepeat 3", set(), set()),
        ("step", "further", {"Count"}, {"Count"}),
        ("speed 150", "speed 120", {"Pick"}, {"Pick"}),
        ("= 60 mm", "= 70 mm", {"Pick", "Fetch"}, {"Fetch"}),
        ("above_it", "height", {"Pick", "Fetch"}, {"Pick", "Fetch"}),
        ("(300, -200, 50)", "(300, -210, 50)", {"Fetch"}, {"Fetch"}),
        ("clear = 40", "clear = 45", {"Fetch"}, {"Fetch"}),
        ("plate = (100", "plate = (110", set(), set()),
        ("repeat 3", "repeat 4", {"main"}, {"main"}),
        ("var total: int = 0", "var total: int = 1", {"main"}, {"main"}),
    ],
)
def test_an_edit_reaches_what_depends_on_it(old: str, new: str, checked: set[str], lowered: set[str]) -> None:
    editor = Editor()
    assert TEXT.count(old) >= 1
    editor.edited(TEXT.replace(old, new))
    assert editor.checked() == checked
    assert editor.lowered() == lowered


def test_a_task_that_is_written_reaches_no_other_one() -> None:
    editor = Editor()
    editor.edited(TEXT.replace("task Fetch", "task Park\n  mov home\nendp\n\ntask Fetch"))
    assert editor.checked() == {"Park"}


def test_a_task_that_is_moved_is_not_checked_again() -> None:
    editor = Editor()
    first, rest = TEXT.split("task Count", 1)
    count, rest = rest.split("endp\n", 1)
    identity = icr.program_id(editor.result.icr) if editor.result.icr else ""
    moved = f"{first}{rest}\ntask Count{count}endp\n"
    result = editor.edited(moved)
    assert editor.checked() == set()
    assert result.icr is not None
    assert icr.program_id(result.icr) == identity


def test_a_mistake_in_a_task_is_told_of_that_task_alone() -> None:
    editor = Editor()
    result = editor.edited(TEXT.replace("lin part", "lin prt"))
    assert [one.code for one in result.diagnostics] == ["N202"]
    assert editor.checked() == {"Pick"}


def test_the_types_of_a_modern_task_do_not_come_from_its_callers() -> None:
    editor = Editor()
    editor.edited(TEXT.replace("Count 1\n", "Count 5\nCount 2\n"))
    assert editor.ran("walked") == set()


@pytest.mark.parametrize(
    "body",
    [
        "  reapet 3\n    open\n  endr\n",
        "  needs the gripper to be\n  reapet 3\n",
        "  open\n  reapet 3\n",
        "  x = reapet(3)\n",
    ],
)
def test_a_line_is_read_anew_where_its_first_word_becomes_a_task(body: str) -> None:
    without = f"task T\n{body}endp\n\nT\n"
    given = f"task reapet(n: int)\n  wait n\nendp\n{without}"
    cache = language.LineCache()
    for text in (without, given, without, given):
        kept = language.compile(text, CELL, "t.task", cache)
        fresh = language.compile(text, CELL, "t.task")
        assert kept.diagnostics == fresh.diagnostics
        assert kept.icr == fresh.icr
    assert language.compile(without).diagnostics != language.compile(given).diagnostics


def test_what_depends_on_a_name_is_found_by_name() -> None:
    editor = Editor()
    editor.edited(TEXT.replace("loc bin", "loc box"))
    assert editor.checked() == {"Fetch"}
    editor.edited(TEXT)
    assert editor.checked() == {"Fetch"}
    editor.edited(f"{TEXT}const part = 3 mm\n")
    assert editor.checked() == {"Pick"}  # whose parameter hides that constant


FLAT = "program p\nunits mm, deg\ncount = 0\nhigh = 50 mm\n" + "".join(
    f"lin (400, {k}, 300) speed {k + 1} mm/s\nif count > {k} then print count\ncount = count + 1\n"
    f"x{k} = high + {k} mm\nmov (300, 0, x{k})\nrepeat 2\n  lin (400, {k}, high)\nendr\n"
    for k in range(60)
)


@pytest.mark.parametrize(
    ("old", "new", "checked", "lowered"),
    [
        ("lin (400, 30, 300)", "lin (400, 30, 310)", 1, 1),  # one line
        ("lin (400, 30, 300)", "\n# a note\nlin (400, 30, 300)", 0, 0),
        ("mov (300, 0, x30)", "open\nmov (300, 0, x30)", 1, 1),  # a new line: all below move
        ("mov (300, 0, x30)\n", "", 1, 1),
        ("mov (300, 0, x30)", "y = 3 mm\nmov (300, 0, x30 + y)", 1, 1),  # a new variable
        ("lin (400, 30, 300)", "lin (400, 30, x29)", 1, 1),  # one of another line
        ("lin (400, 30, 300)", "count = 7\nlin (400, 30, 300)", 1, 1),
    ],
)
def test_an_edit_of_a_text_without_tasks_reaches_the_lines_around_it(
    old: str, new: str, checked: int, lowered: int
) -> None:
    editor = Editor(FLAT)
    parts = len(editor.ran("checked_part"))
    assert parts > 5
    assert FLAT.count(old) == 1
    editor.edited(FLAT.replace(old, new))
    assert len(editor.ran("checked_part")) <= checked
    assert len(editor.ran("inferred_part")) <= checked
    assert len(editor.ran("lowered_part")) <= lowered
    assert len(editor.ran("parsed")) <= 1


def test_a_line_that_is_being_written_reaches_the_lines_around_it() -> None:
    editor = Editor(FLAT)
    result = editor.edited(FLAT.replace("lin (400, 30, 300)", "lin (400, 30, 300) sped"))
    assert [one.code for one in result.diagnostics] == ["L101"]
    assert len(editor.ran("checked_part")) == len(editor.ran("inferred_part")) == 1


def test_a_type_reaches_all_lines_that_read_the_variable() -> None:
    editor = Editor(FLAT)
    parts = len(editor.ran("checked_part"))
    editor.edited(FLAT.replace("count = 0", "count = 0.5"))
    assert len(editor.ran("checked_part")) > parts // 2


def test_a_frame_reaches_the_lines_below_it_alone() -> None:
    editor = Editor(FLAT)
    parts = len(editor.ran("checked_part"))
    editor.edited(FLAT.replace("lin (400, 20, 300)", "set frame pallet\nlin (400, 20, 300)"))
    assert parts // 3 < len(editor.ran("checked_part")) < parts * 2 // 3


def test_what_lies_where_it_lay_is_not_compared_again() -> None:
    cache = language.LineCache()
    first = language.compile(TEXT, CELL, cache=cache).places.units
    then = language.compile(TEXT.replace("by + 1", "by + 2"), CELL, cache=cache).places.units
    assert all(then[of_task(name)] is first[of_task(name)] for name in ("Pick", "Count", "Fetch"))


def test_a_text_with_more_answers_than_are_kept_is_worked_out_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropsim.language.cache.Database", partial(Database, 10))
    editor = Editor(FLAT)
    assert len(editor.ran("checked_part")) > 5
    editor.edited(FLAT.replace("lin (400, 30, 300)", "lin (400, 30, 310)"))
    assert len(editor.ran("checked_part")) == 1
    assert len(editor.ran("parsed")) == 1


def test_contracts_are_followed_again_in_the_task_of_an_edit_alone() -> None:
    editor = Editor(TEXT.replace("length = 60 mm)\n", "length = 60 mm)\n  needs gripper open\n"))
    assert editor.ran("task_passage") == {"Pick", "Count", "Fetch"}
    editor.edited(TEXT.replace("length = 60 mm)\n", "length = 60 mm)\n  needs gripper open\n  open\n"))
    assert editor.ran("task_passage") == {"Pick"}
    assert editor.ran("part_passage") == set()


def test_names_to_choose_from_are_told_anew_where_a_variable_came_far_above(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(import_module("ropsim.language.questions.groups"), "MOST", 2)
    editor = Editor(FLAT)
    wrong = FLAT.replace("mov (300, 0, x50)", "mov (300, 0, way)")
    assert [one.code for one in editor.edited(wrong).diagnostics] == ["N202"]
    editor.edited(wrong.replace("high = 50 mm", "high = 50 mm\nd = 1 mm"))  # as one that is compiled alone
