"""Nothing of the arm comes near what stands in the cells of the examples, from first to last frame."""

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.flow import Recording
from ropsim.kinematics import posture, singular_distances
from ropsim.model import Cell
from ropsim.spatial import Pose
from support.clearance import Clearances, too_near

EXAMPLES = Path(__file__).parents[2] / "examples"
#: The printed program of fig5 takes pins 1 mm apart without approach moves: only the links can keep clear.
KEPT = {"fig5": Clearances(gripper=-0.01, part=-0.05)}
NAMES = ["first_cell", "fig5", "operator", "palletizing"]


@cache
def run_of(name: str) -> tuple[Cell, Recording]:
    project = ropsim.open(EXAMPLES / name)
    assert project.cell is not None
    return project.cell, project.checked(project.simulate())


def raised(cell: Cell, name: str, height: float) -> Cell:
    up = Pose(np.array([0.0, 0.0, height]))
    objects = [replace(one, X_PO=up @ one.X_PO) if one.name == name else one for one in cell.objects]
    return replace(cell, objects=tuple(objects))


@pytest.mark.parametrize("name", NAMES)
def test_arm_gripper_and_part_keep_clear_of_everything(name: str) -> None:
    cell, recording = run_of(name)
    assert too_near(cell, recording, KEPT.get(name)) == []


def test_a_pallet_that_is_raised_is_met_by_the_gripper() -> None:
    cell, recording = run_of("palletizing")
    met = too_near(raised(cell, "pallet", 0.1), recording)
    assert {("gripper", "pallet")} <= {(one.one, one.other) for one in met}


def test_links_that_come_near_are_told() -> None:
    cell, recording = run_of("first_cell")
    met = too_near(raised(cell, "stand_left", 0.22), recording)
    assert {"link 6"} <= {one.one for one in met}


@pytest.mark.parametrize("name", NAMES)
def test_no_example_has_anything_to_find_fault_with(name: str) -> None:
    assert [str(found) for found in run_of(name)[1].findings] == []


@pytest.mark.parametrize("name", NAMES)
def test_the_arm_works_elbow_up_in_one_posture_far_from_limits_and_singularities(name: str) -> None:
    cell, recording = run_of(name)
    rows = recording.channels["q"].values[::25]
    assert {posture(cell.first.robot, q) for q in rows} == {posture(cell.first.robot, cell.first.robot.home)}
    assert "up" in posture(cell.first.robot, cell.first.robot.home).words
    margin = np.minimum(rows - cell.first.robot.lower_limits, cell.first.robot.upper_limits - rows)
    assert np.degrees(margin.min()) >= 10.0
    distances = [one for q in rows if (one := singular_distances(cell.first.robot, q))]
    assert len(distances) == len(rows)
    assert min(one.shoulder for one in distances) > 0.2
    assert np.degrees(min(min(one.elbow, one.wrist) for one in distances)) > 20.0
