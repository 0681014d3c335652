"""Contacts of bodies that are made of several shapes: each pair acts, and the warning counts them."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from ropsim.flow import Recording
from ropsim.model import FLOOR, Box, Cell, Cylinder, FixedObject, MeantContact, Shape, Sphere, Tool
from ropsim.simulation import RunOptions, run
from ropsim.simulation.testing import COVERED, shapes_at_once
from ropsim.spatial import Pose
from support.compiled import code_of
from support.pressed import BLOCK, pressed_cell, springs

LOOSE = springs(np.zeros(2), np.zeros(2))
"""No effort at all: what hangs falls."""
EDGE, START = 0.02, 0.011
CUBE = (Shape(Box((EDGE, EDGE, EDGE))),)
DAMPING = 2e-3
"""In the stiffness [s], as without the key."""
LEAST = 2.0 * 2.0 / 1e-3 / (DAMPING + 0.5e-3)
"""Stiffness of n shapes in all that the 2 kg of the gantry do not follow at 1 kHz [N/m]."""


def row(count: int, size: tuple[float, float, float], gap: float = 1e-3) -> tuple[Shape, ...]:
    """Return boxes side by side along x."""
    places = (np.arange(count) - (count - 1) / 2.0) * (size[0] + gap)
    return tuple(Shape(Box(size), Pose(np.array([x, 0.0, 0.0]))) for x in places)


def blocks(*groups: Sequence[Shape]) -> tuple[FixedObject, ...]:
    """Return objects whose boxes have their tops at z = 0."""
    below = Pose(np.array([0.0, 0.0, -0.05]))
    return tuple(FixedObject(f"block{k}", below, tuple(shapes)) for k, shapes in enumerate(groups))


def cell_of(
    tip: Sequence[Shape],
    objects: tuple[FixedObject, ...] = (BLOCK,),
    stiffness: float = 1e5,
    on: tuple[str, ...] = (),
) -> Cell:
    names = on or tuple(one.name for one in objects)
    contact = MeantContact("press", "tip", names, stiffness, DAMPING * stiffness, 0.0, 5e-2)
    cell = pressed_cell(contact, start=(0.0, START), objects=objects)
    station = replace(cell.first, tools={"tip": Tool("tip", shapes=tuple(tip))})
    return replace(cell, stations={station.name: station})


def dropped(cell: Cell) -> Recording:
    options = RunOptions(laws={"robot": LOOSE}, record_hz=1000)
    return run(cell, {"robot": code_of(cell, "wait 0.3 s")}, options)


@pytest.mark.parametrize("count", [1, 8])
def test_a_row_of_boxes_is_told_before_it_is_thrown_back(count: int) -> None:
    """Each box on the block has the stiffness of the contact, so n of them follow a share of 1/n of it."""
    tip = row(count, (EDGE, EDGE, EDGE))
    for share, codes in ((0.97, []), (1.5, ["S775"])):
        recording = dropped(cell_of(tip, stiffness=share * LEAST / count))
        assert [one.code for one in recording.findings] == codes
        highest = recording.rows("q")[50:, 1].max()
        assert highest > 2.0 * START if codes else highest < START


def test_a_row_of_surroundings_is_told_as_one_of_the_tool_is() -> None:
    """A long bar on five blocks side by side is as stiff as all of them."""
    cell = cell_of(row(1, (1.0, 0.05, EDGE)), blocks(row(5, (0.2, 0.2, 0.1))), LEAST / 4.0)
    recording = dropped(cell)
    assert [one.code for one in recording.findings] == ["S775"]
    assert "for as much as 5 pairs of shapes" in recording.findings[0].message
    assert recording.rows("q")[50:, 1].max() > 2.0 * START


@pytest.mark.parametrize(
    ("tip", "objects", "on", "count"),
    [
        ((Shape(Sphere(0.01)),), (BLOCK,), (), 1.0),
        (CUBE, (BLOCK,), (), 1.0),
        (CUBE, blocks(CUBE), (), COVERED),
        (CUBE, blocks(row(9, (0.2, 0.2, 0.1), 0.0)), (), 3.0),  # one and both that adjoin it
        (CUBE, blocks(row(9, (0.2, 0.2, 0.1), 0.1)), (), 1.0),  # too far from each other for it
        (CUBE, (BLOCK,), (FLOOR,), 1.0),
        (row(3, (EDGE, EDGE, EDGE)), (BLOCK,), ("block", FLOOR), 6.0),
        ((Shape(Cylinder(0.01, 0.5)),), blocks(row(2, (0.2, 0.2, 0.1)), row(1, (0.2, 0.2, 0.1))), (), 3.0),
    ],
    ids=["ball", "cube", "covered", "adjoining", "apart", "floor", "both", "two objects"],
)
def test_pairs_that_can_touch_at_once_are_counted(
    tip: tuple[Shape, ...], objects: tuple[FixedObject, ...], on: tuple[str, ...], count: float
) -> None:
    cell = cell_of(tip, objects, on=on)
    assert shapes_at_once(cell, cell.contacts[0], cell.first) == pytest.approx(count)
