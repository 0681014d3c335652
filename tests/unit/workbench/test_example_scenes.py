"""The examples look like work cells: nothing floats, and every file of theirs is at hand."""

from pathlib import Path

import numpy as np
import pytest

from ropsim.meshes import load_meshes
from ropsim.model import Box, Cell
from ropsim.spatial import Array, Pose
from ropsim.userfiles import example_names
from ropsim.workbench import open_project

EXAMPLES = Path(__file__).parents[3] / "examples"
CONTACT = 0.5e-3  # [m], less than anybody sees


def cell_of(name: str) -> Cell:
    cell = open_project(EXAMPLES / name).cell
    assert cell is not None
    return cell


def rests(cell: Cell, bottom: Array) -> bool:
    """Return whether the top face of a box of some object carries a point [m]."""
    for thing in cell.objects:
        for shape in thing.shapes:
            if isinstance(shape.solid, Box):
                half = np.array(shape.solid.size) / 2.0
                x, y, z = ((thing.X_PO @ shape.pose).inverse() @ Pose(bottom)).position
                if abs(x) <= half[0] and abs(y) <= half[1] and abs(z - half[2]) <= CONTACT:
                    return True
    return False


@pytest.mark.parametrize("name", ["first_cell", "operator", "palletizing", "track_and_table"])
def test_every_part_lies_on_something(name: str) -> None:
    cell = cell_of(name)
    floating = [
        part.name
        for part in cell.parts
        if not rests(cell, (part.X_WO @ Pose(np.array([0.0, 0.0, -part.size[2]]))).position)
    ]
    assert floating == []


def test_the_goal_of_the_first_cell_is_carried() -> None:
    cell = cell_of("first_cell")
    assert rests(cell, cell.locations["set_down"].position - np.array([0.0, 0.0, cell.parts[0].size[2]]))


def test_every_place_of_the_pallet_is_carried_at_some_of_its_corners() -> None:
    cell = cell_of("palletizing")
    half = cell.parts[0].size / 2.0
    corners = [np.array([i * half[0], j * half[1], 0.0]) for i in (-1, 1) for j in (-1, 1)]
    for row in range(6):
        for column in range(6):
            place = (cell.frames["pallet"].X_PK @ Pose(np.array([0.075 * column, 0.075 * row, 0.0]))).position
            assert sum(rests(cell, place + corner) for corner in corners) >= 2


def test_the_pins_of_fig5_stand_in_their_magazine() -> None:
    cell = cell_of("fig5")
    (magazine,) = [thing for thing in cell.objects if thing.name == "magazine"]
    (shape,) = magazine.shapes
    assert isinstance(shape.solid, Box)
    centre = (magazine.X_PO @ shape.pose).position
    for part in cell.parts:
        bottom = part.X_WO.position - np.array([0.0, 0.0, part.size[2]])
        assert (np.abs(bottom - centre) < np.array(shape.solid.size) / 2.0).all()


@pytest.mark.parametrize("name", example_names())
def test_the_meshes_of_an_example_can_be_read(name: str) -> None:
    assert load_meshes(EXAMPLES / name, cell_of(name)).diagnostics == ()


@pytest.mark.parametrize("name", example_names())
def test_nothing_is_drawn_below_the_floor(name: str) -> None:
    cell = cell_of(name)
    for thing in cell.objects:
        for shape in thing.shapes:
            if isinstance(shape.solid, Box):
                bottom = (thing.X_PO @ shape.pose).position[2] - shape.solid.size[2] / 2.0
                assert bottom > -CONTACT
