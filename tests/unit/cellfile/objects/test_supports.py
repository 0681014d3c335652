"""Supports in the cell file: limits, and parts that lie on nothing when a run starts."""

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.model import Cell

ROBOT = '[robot]\nmodel = "puma560"\n'
TABLE = ROBOT + '[[objects]]\nname = "table"\nposition = [500, 0, 700]\nsize = [400, 400, 30]\n'
PART = '[[parts]]\nname = "box"\nsize = [60, 60, 40]\nmass = 0.5\n'
LENGTH = 1e-12


def read(text: str) -> tuple[Cell | None, tuple[Diagnostic, ...]]:
    return read_cell(SourceText("cell.toml", text), "folder")


def one(text: str) -> Diagnostic:
    _, (found,) = read(text)
    return found


@pytest.mark.parametrize("z", [740, 744, 738, 40])
def test_a_part_on_the_table_or_the_floor_is_well(z: float) -> None:
    x = 500 if z > 100 else 2000
    assert read(TABLE + PART + f"position = [{x}, 0, {z}]\n")[1] == ()


def test_a_part_in_the_air_is_a_warning_at_its_position() -> None:
    cell, (found,) = read(TABLE + PART + "position = [500, 0, 760]\n")
    assert cell is not None
    assert (found.code, found.is_error) == ("X819", False)
    assert found.message == "part `box` lies in the air at the start"
    assert found.hint.startswith("a part counts as lying on what is at most 5 mm below it: ")
    assert found.span is not None
    assert found.span.line == 11


def test_a_grid_is_noted_once() -> None:
    grid = "position = [500, 0, 740]\ngrid = { counts = [3, 2], step = [[100, 0, 0], [0, 0, 60]] }\n"
    found = one(TABLE + PART + grid)
    assert found.message == "part `box_4` and 2 more of its table lies in the air at the start"


def test_the_first_part_of_a_supply_is_looked_at() -> None:
    supply = PART.replace("parts", "supplies") + "position = [500, 0, 800]\ncount = 3\n"
    assert one(TABLE + supply).message == "part `box_1` lies in the air at the start"


def test_without_objects_nothing_is_said() -> None:
    assert read(ROBOT + PART + "position = [500, 0, 760]\n")[1] == ()
    mesh = '[[objects]]\nname = "m"\nposition = [0, 0, 0]\nshapes = [{ mesh = "m.stl" }]\n'
    assert read(TABLE + mesh + PART + "position = [500, 0, 760]\n")[1] == ()


def test_the_limits_are_read_in_the_units_of_the_file() -> None:
    cell, findings = read(TABLE + "[supports]\ngap = 25\ndepth = 1\n" + PART + "position = [500, 0, 760]\n")
    assert findings == ()
    assert cell is not None
    assert (cell.supports.gap, cell.supports.depth) == pytest.approx((0.025, 0.001), abs=LENGTH)


@pytest.mark.parametrize(
    ("line", "code"),
    [("gap = -1", "X806"), ("depth = nan", "X807"), ('gap = "a"', "X804"), ("gab = 1", "X802")],
)
def test_wrong_limits_are_answered(line: str, code: str) -> None:
    found = one(TABLE + f"[supports]\n{line}\n")
    assert found.code == code
    assert found.span is not None
    assert found.span.line == 8
