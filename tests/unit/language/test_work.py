"""How much work a text is, counted in calls of functions: in proportion to it, and little for an edit."""

import sys
from collections.abc import Callable, Sequence
from types import FrameType
from typing import Any

import pytest

from ropsim import language
from ropsim.language.testing import assignments, chunks, motions

MODERN = """\
task T{k}(a1: loc, dz: length = {k} mm)
  x = dz * 3 - 20 mm / 2
  repeat 3
    mov a1 above dz
    lin (100, {k}, 300; rpy 180 0 10) speed 150 mm/s
    if x > 40 mm then x = x - 1 mm
  endr
endp
T{k} (400, 0, {k}), {k}
"""
FLAT = """\
x{k} = {k} mm * 3 - 20 mm / 2
lin (100, {k}, 300; rpy 180 0 10) speed 150 mm/s acc 2 m/s2
if x{k} > 40 mm then print x{k}
mov (400, 0, x{k})
"""
CLASSIC = """\
task t{k}
  x = a
  repeat a
    mov (x, 3, {k})
    x = x + b
  endr
endp
t{k} 5, {k}
"""
WRONG = """\
task W{k}(a1: loc)
  mov a1 abvoe 20
  x = {k} kgm
endp
"""
MOST = 2.2
"""Times the work of half of the text: in proportion, and a little for the logarithms of sorting."""


def text_of(unit: str, count: int) -> str:
    head = "" if unit is CLASSIC else "program p\nunits mm, deg\n"
    return head + "".join(unit.format(k=k + 1) for k in range(count))


def work(text: str, cache: language.LineCache | None = None) -> int:
    """Return how many functions are called, those of Python and those of C, while a text is compiled."""
    count = 0

    def called(_: FrameType, event: str, __: object) -> None:
        nonlocal count
        count += event in ("call", "c_call")

    before = sys.getprofile()
    sys.setprofile(called)
    try:
        language.compile(text, cache=cache)
    finally:
        sys.setprofile(before)
    return count


@pytest.mark.parametrize("unit", [MODERN, FLAT, CLASSIC, WRONG], ids=["modern", "flat", "classic", "wrong"])
def test_work_is_in_proportion_to_the_text(unit: str) -> None:
    small, large = work(text_of(unit, 40)), work(text_of(unit, 80))
    assert small > 1000
    assert large <= MOST * small


def test_an_edit_of_a_task_is_a_small_part_of_the_work() -> None:
    cache = language.LineCache()
    text = text_of(MODERN, 60)
    whole = work(text, cache)
    assert work(text.replace("(100, 30, 300", "(100, 31, 300"), cache) < 0.2 * whole


def steps(lines: Sequence[str]) -> int:
    """Return how many lines of Python run while a text is cut, each pass of a loop for itself."""
    count = 0

    def step(_: FrameType, event: str, __: Any) -> Any:
        nonlocal count
        count += event == "line"
        return step

    before = sys.gettrace()
    sys.settrace(step)
    try:
        list(chunks(lines))
    finally:
        sys.settrace(before)
    return count


@pytest.mark.parametrize("head", ["if x", "while x", "repeat 3"])
@pytest.mark.parametrize("tail", ["endif", "endw", "until x", "end"])
def test_looking_where_to_cut_is_in_proportion_whatever_is_not_closed(head: str, tail: str) -> None:
    """Lines are new in each text, so that nothing is known of them."""
    small, large = (
        steps([f"{head} # {count}"] * count + [f"{tail} # {count}"] * count) for count in (200, 400)
    )
    assert small > 400
    assert large <= MOST * small


def looked_at(text: str) -> tuple[int, int]:
    """Return how many motions a text has, and how often one is checked while it is compiled."""
    return text.count("mov ") + text.count("lin "), checks(text, motions.motion)


def checks(text: str, function: Callable[..., object]) -> int:
    """Return how often a statement of one kind is checked while a text is compiled."""
    checked = 0

    def called(frame: FrameType, event: str, _: object) -> None:
        nonlocal checked
        checked += event == "call" and frame.f_code is function.__code__

    before = sys.getprofile()
    sys.setprofile(called)
    try:
        language.compile(text)
    finally:
        sys.setprofile(before)
    return checked


@pytest.mark.parametrize("unit", [MODERN, FLAT], ids=["modern", "flat"])
def test_a_motion_whose_names_have_types_is_looked_at_once(unit: str) -> None:
    there, checked = looked_at(text_of(unit, 20))
    assert checked == there


OPEN = """\
n = 1
mov (40, 0, n)
print n
mov (40, 0, n)
"""


def test_a_motion_that_tells_a_type_is_looked_at_twice_and_no_other() -> None:
    """In a classic text; in a modern one the first value has told it."""
    assert looked_at(OPEN) == (2, 3)
    assert looked_at("program p\nunits cm\n" + OPEN) == (2, 2)


def test_an_assignment_that_tells_its_type_is_looked_at_once() -> None:
    assert checks(text_of(FLAT, 20), assignments.assign) == 20


@pytest.mark.parametrize("line", ["y = 1", "T 3", "total = 4", "n = total"])
def test_an_assignment_beside_a_line_whose_types_are_told_elsewhere_is_looked_at_again(line: str) -> None:
    text = f"program p\nunits mm, deg\nvar total\ntask T(k: int)\n  print k\nendp\nx = 3 mm\n{line}\n"
    assert checks(text, assignments.assign) > 1 + (" = " in line)


def test_a_part_before_the_first_joints_of_a_text_knows_how_many_they_are() -> None:
    """Its types are found while nobody knows that yet; what is wrong in it is told all the same."""
    lines = "\n".join(f"lin (400, {k}, 300)\na{k} = {k} mm" for k in range(60))
    text = f"program p\nunits mm, deg\n{lines}\nmov joints(1, 2, 3)\n{lines}\nmov joints(1, 2)\n"
    found = language.compile(text).diagnostics
    assert [one.message for one in found] == ["`joints(…)` has 2 coordinates, 3 are needed"]
