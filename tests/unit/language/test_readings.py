"""Numbers without a unit next to readings of sensors: T313 and T316 follow where a number comes from."""

from dataclasses import replace

import pytest

from ropsim.language import LineCache, compile
from ropsim.program import SignalUse, ValueType
from support.tasks import CELL, codes, only

SENSED = replace(
    CELL,
    signals={**CELL.signals, "gap": SignalUse("gap", is_input=True, type=ValueType.REAL)},
    measured={"gap": "length"},
)
UNITS = "program p\nunits mm, deg, s\n"
UNTIL = "lin infeed until gap < {}"
TASK = "task T(h: {})\n  lin infeed until gap < h\nendp\n"


@pytest.mark.parametrize(
    "text",
    [
        f"h = 150\nlin infeed above h\n{UNTIL.format('h')}",
        f"h = 150.0\n{UNTIL.format('h')}",
        f"const k = 15\nh = k\ng = h * 2\n{UNTIL.format('g')}",
        f"var g: num = 150.0\ntask U\n  {UNTIL.format('g')}\nendp\nU",
        f"h = gap + 5\n{UNTIL.format('h')}",
        f"h = gap\nif part_ok\n  h = 5.0\nendif\n{UNTIL.format('h')}",
        f"h = gap\nif part_ok then h = 5.0\n{UNTIL.format('h')}",
        f"task Far -> num\n  return 150.0\nendp\nh = Far()\n{UNTIL.format('h')}",
        f"task Same(x: num) -> num\n  return x\nendp\nh = Same(150.0)\n{UNTIL.format('h')}",
        "h = 150\nwait until gap < h",
        "h = 150\nif h > gap then open",
        "h = 150\nlin infeed track gap = h",
        "h = gap\nif gap - h < 5 then open",
        "h = gap\nlimit = 5\nif gap - h < limit then open",
        f"{TASK.format('num')}T 150.0",
        f"{TASK.format('int')}T 150",
        f"{TASK.format('num')}h = 150.0\nT h",
        f"{TASK.format('num')}task U(k: num)\n  T(k * 2)\nendp\nU 150.0",
    ],
)
def test_a_number_without_a_unit_is_followed_to_the_reading_that_it_is_compared_with(text: str) -> None:
    found = only(UNITS + text, SENSED)
    assert (found.code, found.is_error) == ("T313", False)


@pytest.mark.parametrize(
    "text",
    [
        f"h = 150 mm\nlin infeed above h\n{UNTIL.format('h')}",
        f"h = gap\n{UNTIL.format('h')}",
        f"h = 2 * gap\n{UNTIL.format('h / 2')}",
        "h = 0\nlin infeed until gap > h",
        f"d = 3 mm\nh = d / 1 m\n{UNTIL.format('h')}",
        f"h = 150.0\nh = gap\n{UNTIL.format('h')}",
        f"{TASK.format('length')}T 150",
        f"{TASK.format('num')}h = gap\nT h",
        "n = 3\nprint n\nlin infeed above n",
    ],
)
def test_quantities_readings_and_what_is_worked_out_of_them_are_no_mistakes(text: str) -> None:
    assert codes(UNITS + text, SENSED) == []


@pytest.mark.parametrize(
    "lines", [("lin infeed above h", UNTIL.format("h")), (UNTIL.format("h"), "lin infeed above h")]
)
def test_a_parameter_that_counts_in_two_units_is_told_at_the_second_place(lines: tuple[str, str]) -> None:
    found = only("{}task T(h: int)\n  {}\n  {}\nendp\nk = round(gap)\nT k".format(UNITS, *lines), SENSED)
    assert (found.code, found.span and found.span.line) == ("T316", 5)
    assert "in mm at one place and in m at another" in found.message


def test_a_reading_that_counts_in_the_unit_of_the_text_is_told() -> None:
    assert codes(f"{UNITS}n = round(gap)\nlin infeed above n", SENSED) == ["T316"]


def test_in_metres_numbers_are_what_they_seem() -> None:
    text = f"program p\nunits m, deg, s\nh = 1\nlin infeed above h\n{UNTIL.format('h')}"
    assert codes(text, SENSED) == []


def test_what_a_task_tells_of_its_parameters_is_told_anew_when_the_task_is_edited() -> None:
    cache = LineCache()
    before = f"{UNITS}{TASK.format('num')}T 150.0"
    for text in (before, before.replace("gap < h", "gap < 5 mm"), before):
        found = [one.code for one in compile(text, SENSED, "t.task", cache).diagnostics]
        assert found == codes(text, SENSED)
