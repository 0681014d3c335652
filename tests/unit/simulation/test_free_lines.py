"""A two-link robot on cylinders goes round squares by position only, in task text and in neutral code."""

import math
from pathlib import Path

import numpy as np
import pytest

from ropsim.flow import Fidelity, MoveEvent, Recording
from ropsim.simulation import RunOptions
from ropsim.spatial import Array
from ropsim.views import summarize
from ropsim.views.testing import station_views
from ropsim.workbench import open_project
from support.two_link_hydraulic import NEUTRAL, TASK, two_link_project

ON_LINE = 1e-9
"""Largest distance of a commanded TCP from the square [m]."""


def run_of(folder: Path, name: str, program: str, fidelity: Fidelity) -> Recording:
    """Return the run of a program in a new project."""
    opened = open_project(two_link_project(folder, name, program))
    return opened.simulate(options=RunOptions(fidelity=fidelity))


def away_from_square(points: Array, x: float, z: float) -> Array:
    """Return how far points (k, 3) are from the square of 0.1 m at x and z in the plane y = 0 [m]."""
    u, w = points[:, 0] - x - 0.05, points[:, 2] - z - 0.05
    inner = np.maximum(np.abs(u), np.abs(w)) - 0.05
    outer = np.hypot(np.maximum(np.abs(u) - 0.05, 0.0), np.maximum(np.abs(w) - 0.05, 0.0))
    return np.asarray(np.hypot(np.where(inner < 0.0, inner, outer), points[:, 1]))


@pytest.mark.parametrize(
    ("name", "program", "lines"), [("main.task", TASK, 8), ("main.icr", NEUTRAL, 2)], ids=["task", "icr"]
)
def test_commands_are_on_the_squares(tmp_path: Path, name: str, program: str, lines: int) -> None:
    recording = run_of(tmp_path / "p", name, program, Fidelity.KINEMATIC)
    assert not [one for one in recording.findings if one.is_error]
    moves = [event for event in recording.events if isinstance(event, MoveEvent) and event.motion == "LIN"]
    assert len(moves) == lines
    assert all(event.free_orientation for event in moves)
    (station,) = station_views(recording)
    at, number = station.matrix("command_position", 3), station.ordinals()
    for event in moves:
        place = (0.7, 0.6) if event.target[0] < 1.0 else (1.3, 1.0)
        rows = at[number == event.ordinal]
        assert len(rows) > 20
        assert away_from_square(rows, *place).max() < ON_LINE


def test_cylinders_follow_and_the_report_has_no_error_of_orientation(tmp_path: Path) -> None:
    recording = run_of(tmp_path / "p", "main.task", TASK, Fidelity.DYNAMIC)
    assert not [one for one in recording.findings if one.is_error]
    path = summarize(recording).path
    assert len(path.moves) == 8
    assert 1e-7 < path.max_error < 1e-4  # the arm errs, and its law knows it
    assert all(math.isnan(move.max_angle) for move in path.moves)
    assert path.worst_angle is None
