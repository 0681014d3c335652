"""Locations with values of external axes: how they are written, and that they go where the location goes."""

import math
from dataclasses import replace

import pytest

from ropsim.flow import MoveInstruction
from ropsim.icr import disassemble, run
from ropsim.language import Environment
from ropsim.spatial import quaternion
from support.tasks import CELL, codes, compiled, only

HERE = (0.4, 0.3, 0.1, 0.0, 1.0, 0.0, 0.0)
TRACK = replace(CELL, external=("length",))
TABLE = replace(CELL, external=("length", "angle"), locations={**CELL.locations, "stock": (*HERE, 0.8, 1.5)})
UNITS = "program p\nunits mm, deg, s\n"


def moves(text: str, environment: Environment = TABLE) -> list[MoveInstruction]:
    result = compiled(UNITS + text, environment)
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    return list(run(result.icr).moves)


def external(text: str, environment: Environment = TABLE) -> list[tuple[float, ...]]:
    """Return the values that each move is given."""
    return [one.external for one in moves(text, environment)]


@pytest.mark.parametrize(
    "written",
    [
        "mov infeed external (800, 90)",
        "MOV infeed EXTERNAL(800 mm, 90 deg)",
        "mov infeed external (0.5 m + 30 cm, 45 * 2) speed 50 %",
        "lin infeed external (1, 2) external (800, 90)",
        "loc q = infeed external (800, 90)\nmov q",
        "q = infeed external (800, 90)\nmov q",
        "x = 800 mm\nmov infeed external (x, 90)",
        "task Go(q: loc)\nmov q\nendp\nGo infeed external (800, 90)",
        "task Go(q: loc, n: int)\nmov q\nendp\nGo(infeed external (800, 90), 2)",
        "task Go(q: loc)\nmov q\nendp\nGo ((400, 300, 100) external (800, 90))",
        "mov infeed external (\n800,\n90)",
    ],
)
def test_values_are_written_behind_a_location(written: str) -> None:
    (move,) = moves(written)
    assert move.external == pytest.approx((0.8, math.pi / 2.0))
    assert move.target == moves("mov infeed")[0].target


@pytest.mark.parametrize(
    "written",
    [
        "mov stock",
        "mov stock above 80",
        "mov stock offset (0, 10, 0)",
        "mov stock rel (0, 0, -10; rz 20)",
        "mov stock in pallet",
        "set frame pallet\nmov stock",
        "with frame pallet\nmov stock offset (1, 2, 3)\nendwith",
        "q = stock\nq.x = q.x + 10\nmov q",
        "with frame pallet\nq = stock\nq.rz = 10\nmov q\nendwith",
        "q = stock\nmov q above 5 offset (1, 2, 3) in pallet rel (1, 0, 0)",
        "pattern row = grid 1 from stock step (70, 0, 0)\nfor each q in row\nmov q\nendf",
        "task Go(q: loc) -> loc\nreturn q above 5\nendp\nq = Go(stock)\nmov q",
        "mov infeed rel stock",
    ],
)
def test_values_go_where_the_location_goes(written: str) -> None:
    assert external(written) == [(0.8, 1.5)]


@pytest.mark.parametrize(
    "written",
    [
        "mov infeed",
        "mov (300, 0, 100; like stock)",
        "load (x, y, z), stock\nmov (x, y, z)",
        "mov stock\nmov infeed\nmov here",
    ],
)
def test_a_location_of_its_own_has_no_values(written: str) -> None:
    assert external(written)[-1] == ()


def test_here_is_where_the_external_axes_were_sent() -> None:
    assert external("mov stock\nlin here offset (0, 0, 50)") == [(0.8, 1.5), (0.8, 1.5)]


def test_moving_a_location_keeps_its_own_values_and_not_those_of_the_way() -> None:
    assert external("mov infeed external (1, 2) rel stock") == [pytest.approx((0.001, math.radians(2.0)))]


def test_computed_and_constant_values_are_the_same() -> None:
    constant, computed = (
        "mov infeed above 30 external (800, 90)",
        "q = infeed\nx = 800\ny = 90\nmov q above 30 ",
    )
    (first,), (second,) = moves(constant), moves(computed + "external (x * 1 mm, y * 1 deg)")
    assert (first.target, first.external) == (second.target, second.external)


def test_bare_numbers_take_the_unit_of_their_axis() -> None:
    assert external("mov infeed external (800)", TRACK) == [(0.8,)]
    turned = replace(CELL, external=("angle",))
    assert external("mov infeed external (90)", turned) == [pytest.approx((math.pi / 2.0,))]
    assert external("mov infeed external (90, 5 mm)", CELL) == [pytest.approx((math.pi / 2.0, 0.005))]
    classic = compiled("mov infeed external (80, 90)", TABLE)
    assert classic.icr is not None
    assert run(classic.icr).moves[0].external == pytest.approx((0.8, math.pi / 2.0))


def test_printing_a_location_shows_its_values() -> None:
    result = compiled(UNITS + "print stock", TABLE)
    assert result.icr is not None
    assert run(result.icr).messages == ("(0.4, 0.3, 0.1, 3.14159, 0, 0) external (0.8, 1.5)",)


def test_locations_of_the_cell_bring_their_values_into_any_work_frame() -> None:
    frame = (0.5, 0.0, 0.2, *quaternion.from_zyx(0.5, 0.0, 0.0))
    for environment in (TABLE, replace(TABLE, frames={"work": frame}, frame="work")):
        assert external("mov stock\nset tool jaws\nmov stock", environment) == [(0.8, 1.5)] * 2


@pytest.mark.parametrize(
    ("written", "code", "words"),
    [
        ("mov infeed external (800 deg, 90)", "T302", "external axis E1 must be a length, found an angle"),
        ("mov infeed external (800, 90 mm)", "T302", "external axis E2 must be an angle, found a length"),
        ("mov infeed external (800, part_ok)", "T301", "external axis E2 must be an angle"),
        ("mov joints(0, 0) external (800)", "T301", "a location on its left, found a joint target"),
        ("mov infeed speed 50 % external (800)", "T301", "a location on its left, found a share"),
        ("mov infeed external (" + ", ".join("1" * 13) + ")", "T301", "up to 12 values"),
        ("mov infeed external 800", "L101", "expected `(`, found `800`"),
        ("mov infeed external ()", "L101", "expected a value"),
        ("mov infeed external", "L101", "expected `(`, found the end of the line"),
        ("mov infeed rel ((0, 0, 16; rz 0) external (1, 2))", "T301", "the step of `rel` has no values"),
        ("frame f = (1, 2, 3) external (800, 90)", "T301", "a frame has no values of external axes"),
        ("tool t = stock", "T301", "a tool has no values of external axes"),
    ],
)
def test_what_cannot_be_is_told(written: str, code: str, words: str) -> None:
    found = only(UNITS + written, TABLE)
    assert found.code == code
    assert words in found.message


def test_the_word_may_still_be_a_name() -> None:
    assert codes(UNITS + "external = 5 mm\nmov infeed above external\nprint external") == []


def test_a_misread_task_finds_the_names_in_the_values() -> None:
    text = "task Go\nmov l external (a, b)\nendp\nGo infeed, 3 cm, 4 deg"
    result = compiled(text, TABLE)
    assert result.icr is not None, [str(one) for one in result.diagnostics]
    assert run(result.icr).moves[0].external == pytest.approx((0.03, math.radians(4.0)))


def test_a_program_with_values_says_what_it_needs() -> None:
    with_values, without = compiled(UNITS + "mov stock", TABLE), compiled(UNITS + "mov infeed", TABLE)
    assert with_values.icr is not None
    assert without.icr is not None
    assert "REQUIRE CAP EXT PTP\n" in disassemble(with_values.icr)
    assert "EXT" not in disassemble(without.icr)
