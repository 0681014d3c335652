"""What carries a part where a task leaves it: a table, another part, or nothing."""

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.tasks import Point
from ropsim.workbench import CellGeometry

CELL = """\
[cell]
name = "small"
[units]
length = "mm"
angle = "deg"
[robot]
model = "puma560"
tool = "jaws"
[tools.jaws]
position = [0, 0, 145]
gripper = {}
[locations]
s1 = { position = [400, 100, -200], rpy = [180, 0, 0] }
s2 = { position = [400, -100, -200], rpy = [180, 0, 0] }
[[parts]]
name = "bolt"
size = [20, 20, 20]
mass = 0.1
position = [400, 100, -200]
[[parts]]
name = "nut"
size = [20, 20, 20]
mass = 0.1
position = [400, -100, -200]
"""
TABLE = """\
[[objects]]
name = "table"
position = [0, 0, -220]
shapes = [{ box = [1200, 1200, 20], position = [0, 0, -10] }]
"""
#: Positions of the cell file through a few products of matrices [m].
EXACT = 1e-12


@pytest.fixture(scope="module")
def room() -> CellGeometry:
    return geometry(CELL + TABLE)


def geometry(text: str) -> CellGeometry:
    cell, findings = read_cell(SourceText("cell.toml", text), "c")
    assert cell is not None, findings
    return CellGeometry(cell)


@pytest.mark.parametrize(
    ("at", "height", "below"),
    [
        ((500.0, 0.0, -200.0), None, ""),
        ((500.0, 0.0, -195.5), None, ""),  # supports reach 5 mm
        ((500.0, 0.0, -194.5), 0.0055, "`table`"),
        ((500.0, 0.0, -100.0), 0.1, "`table`"),
        ((405.0, -95.0, -180.0), None, ""),  # on the nut
        ((405.0, -95.0, -150.0), 0.03, "`nut`"),
        ((405.0, 105.0, -180.0), 0.02, "`table`"),  # where the bolt itself lay
        ("s2 rel (0, 0, -50)", 0.03, "`nut`"),
        ("nowhere", None, ""),
    ],
)
def test_a_part_lies_on_what_is_near_below_it(
    room: CellGeometry, at: Point, height: float | None, below: str
) -> None:
    found = room.in_the_air("arm", "bolt", at, {"nut": "s2"})
    assert (found and found.below) == (below or None)
    if found is not None:
        assert found.height == pytest.approx(height, abs=EXACT)
        assert found.words == "a part counts as lying on what is at most 5 mm below it"


def test_other_parts_carry_where_they_are_known_to_lie_and_nowhere_else(room: CellGeometry) -> None:
    there = (500.0, 0.0, -200.0)
    for nut, is_carried in ((there, True), ("s2", False)):
        found = room.in_the_air("arm", "bolt", (500.0, 0.0, -180.0), {"nut": nut})
        assert (found is None) is is_carried
    assert room.in_the_air("arm", "bolt", (400.0, -100.0, -180.0), {}) is not None  # the nut is taken


def test_nothing_is_said_where_it_is_not_known_what_stands_around(room: CellGeometry) -> None:
    bare = geometry(CELL)
    assert bare.in_the_air("arm", "bolt", (500.0, 0.0, 100.0), {}) is None
    loose = geometry(CELL + TABLE.replace("-220", "-420"))
    assert loose.in_the_air("arm", "bolt", "s2", {}) is not None
    assert (
        loose.in_the_air("arm", "bolt", "s1", {}) is None
    )  # where it lies at the start: the cell file tells
    assert room.in_the_air("arm", "thing", (500.0, 0.0, 100.0), {}) is None
    assert room.in_the_air("other", "bolt", (500.0, 0.0, 100.0), {}) is None
