"""The example with a peg: its hole is found from all directions with little force, and mistakes are told."""

import math
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.core import Severity
from ropsim.flow import Fidelity, MessageEvent, Recording
from ropsim.model import Cell, FixedObject, JointSensors
from ropsim.simulation import RunOptions, run
from ropsim.spatial import Pose
from ropsim.workbench import Project, environment_of
from support.cells import with_station
from support.printed import si_numbers

EXAMPLE = Path(__file__).parents[2] / "examples" / "peg_in_hole"
BELIEVED = np.array([0.45, 0.1])
"""Where the program looks for the hole first [m]."""
CLEARANCE = 0.25e-3
"""Between peg and hole, to each side [m]."""
GIVING_WAY = 0.1e-3
"""How far peg and plate give way to each other and the arm to both: 20 N over 200 N/mm [m]."""
DEPTH = 0.02
MOST = 40.0
"""Force at which the program stops to push [N]."""


@cache
def project() -> Project:
    return ropsim.open(EXAMPLE)


def with_hole_at(x: float, y: float, cell: Cell | None = None) -> Cell:
    """Return the cell with its hole beside the place where the program believes it to be [m]."""
    here = cell or project().cell
    assert here is not None
    moved = [_moved(one, x, y) if one.name == "plate" else one for one in here.objects]
    return replace(here, objects=tuple(moved))


def _moved(plate: FixedObject, x: float, y: float) -> FixedObject:
    height = plate.X_PO.position[2]
    return replace(plate, X_PO=Pose(np.array([BELIEVED[0] + x, BELIEVED[1] + y, height])))


def made(cell: Cell, fidelity: Fidelity = Fidelity.DYNAMIC) -> Recording:
    text = (EXAMPLE / "programs" / "main.task").read_text("utf-8")
    compiled = ropsim.language.compile(text, environment_of(cell), "main")
    assert compiled.icr is not None
    return run(cell, {"robot": compiled.icr}, RunOptions(fidelity))


def told(recording: Recording) -> str:
    (said,) = recording.events_of(MessageEvent)
    return said.text


def greatest_force(recording: Recording) -> float:
    return float(np.linalg.norm(recording.rows("contact_wrench")[:, :3], axis=1).max())


def check_inserted(recording: Recording, x: float, y: float) -> None:
    said = told(recording)
    assert said.startswith("the peg is in")
    depth, along_x, along_y = si_numbers(said)
    assert depth == pytest.approx(DEPTH, abs=1e-4)
    assert abs(along_x - x) < CLEARANCE + GIVING_WAY
    assert abs(along_y - y) < CLEARANCE + GIVING_WAY
    assert greatest_force(recording) < 1.5 * MOST
    assert not [one for one in recording.findings if one.severity is not Severity.HINT]


def test_the_peg_goes_in_as_shipped() -> None:
    check_inserted(made(with_hole_at(1.2e-3, 0.9e-3)), 1.2e-3, 0.9e-3)


@pytest.mark.slow
@pytest.mark.parametrize("degrees", range(0, 360, 30))
def test_the_hole_is_found_from_all_directions(degrees: int) -> None:
    x, y = 1.5e-3 * math.cos(math.radians(degrees)), 1.5e-3 * math.sin(math.radians(degrees))
    check_inserted(made(with_hole_at(x, y)), x, y)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(1, 5))
def test_other_noise_does_not_matter(seed: int) -> None:
    cell = with_hole_at(-0.7e-3, 1.1e-3)
    controller = replace(cell.first.controller, sensors=JointSensors(seed=seed))
    check_inserted(made(with_station(cell, controller=controller)), -0.7e-3, 1.1e-3)


def test_a_hole_that_is_too_far_is_not_found_and_said_so() -> None:
    recording = made(with_hole_at(6e-3, 0.0), Fidelity.KINEMATIC)
    assert told(recording).startswith("no hole within 2.2 mm")


def test_without_a_plate_nothing_pushes_back() -> None:
    cell = with_hole_at(0.0, 0.0)
    gone = [one for one in cell.objects if one.name != "plate"]
    recording = made(replace(cell, objects=tuple(gone), contacts=()), Fidelity.KINEMATIC)
    assert told(recording).startswith("no plate below the peg")


def test_a_hole_that_is_blocked_is_told_with_its_depth() -> None:
    cell = with_hole_at(1.2e-3, 0.9e-3)
    (block,) = (one for one in cell.objects if one.name == "block")
    raised = replace(block, X_PO=Pose(block.X_PO.position + np.array([0.0, 0.0, 0.015])))
    contact = replace(cell.contacts[0], standing=("plate", "block"))
    objects = tuple(raised if one.name == "block" else one for one in cell.objects)
    recording = made(replace(cell, objects=objects, contacts=(contact,)), Fidelity.KINEMATIC)
    assert told(recording).startswith("the peg is stuck at a depth of")
    assert si_numbers(told(recording))[0] == pytest.approx(0.01, abs=5e-4)
