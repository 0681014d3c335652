"""The example with four squares: two laws of a hydraulic arm, a wrong model, and the same in neutral code."""

from functools import cache
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.controller import law_of
from ropsim.dynamics import gravity, mass_matrix
from ropsim.flow import MoveEvent, Recording
from ropsim.kinematics import forward
from ropsim.model import Cell, ControllerKind, Payload
from ropsim.robots import controller_under
from ropsim.simulation import RunOptions, linear_loop, margins, mounted_load
from ropsim.spatial import Array
from ropsim.views import summarize
from ropsim.views.testing import ContourFigures
from ropsim.workbench import Project
from support.hydraulic_arm import SQUARES, angles, mistaken

EXAMPLE = Path(__file__).parents[2] / "examples" / "four_squares"
ROOM = 1e-9


@cache
def project() -> Project:
    return ropsim.open(EXAMPLE)


def cell() -> Cell:
    found = project().cell
    assert found is not None
    return found


def load() -> Payload:
    station = cell().first
    return mounted_load(station.tools[station.default_tool])


@cache
def run(kind: ControllerKind, *, wrong: bool = False) -> Recording:
    """Run the program under a law, which may believe in another arm."""
    robot, own = cell().first.robot, cell().first.controller
    controller = controller_under(robot, own.rates, kind)
    law = law_of(controller, mistaken(robot) if wrong else robot)
    return project().simulate(options=RunOptions(laws={cell().first.name: law}))


def contours(recording: Recording) -> tuple[ContourFigures, ...]:
    (station,) = summarize(recording).stations
    return station.contours


def test_the_example_has_nothing_to_find_fault_with_and_draws_to_a_tenth_of_a_millimetre() -> None:
    recording = project().simulate()
    assert recording.ok
    assert [str(found) for found in recording.findings] == []
    assert [one.moves for one in contours(recording)] == [4, 4, 4, 4]
    assert max(one.path_max for one in contours(recording)) < 1e-4


def test_parallel_pi_loops_err_by_5_to_9_mm_and_most_where_the_arm_is_far_out() -> None:
    found = contours(run(ControllerKind.PARALLEL_PI))
    near_low, far_low, far_high, near_high = (one.path_max for one in found)
    assert 5e-3 < min(near_low, near_high) < max(near_low, near_high) < min(far_low, far_high) < 9.5e-3
    for one in found:
        assert 5.0 < one.tracking_max / one.path_max < 9.0


@pytest.mark.slow
def test_with_a_wrong_model_the_other_law_has_a_quarter_of_that_at_each_place() -> None:
    better = contours(run(ControllerKind.FLOW_LOAD_DAMPING, wrong=True))
    for one, baseline in zip(better, contours(run(ControllerKind.PARALLEL_PI)), strict=True):
        assert one.path_max < 0.25 * baseline.path_max
        assert one.tracking_end < 1e-3


@pytest.mark.slow
@pytest.mark.parametrize("kind", [ControllerKind.FLOW_LOAD_DAMPING, ControllerKind.PARALLEL_PI])
def test_loops_have_their_margins_at_all_corners(kind: ControllerKind) -> None:
    robot, own = cell().first.robot, cell().first.controller
    controller = controller_under(robot, own.rates, kind)
    least, most = (2.0, 2.0) if kind is ControllerKind.FLOW_LOAD_DAMPING else (2.4, 1.7)
    for corner in SQUARES.values():
        for x in (0.0, 0.1):
            for z in (0.0, 0.1):
                loop = linear_loop(robot, controller, angles(np.array(corner) + np.array([x, z])), load())
                for found in (margins(loop, axis) for axis in range(robot.n)):
                    assert found.stable
                    assert found.gain >= least
                    assert found.sensitivity <= most


def ends(recording: Recording) -> Array:
    return np.array([move.target for move in recording.events_of(MoveEvent) if move.target])


@pytest.mark.slow
def test_the_neutral_code_says_what_the_task_text_says() -> None:
    """Lengths of the text are millimetres, so they may differ in the last bit."""
    text, code = (project().simulate(name) for name in ("main", "squares"))
    assert code.duration == pytest.approx(text.duration, abs=ROOM)
    assert ends(code) == pytest.approx(ends(text), abs=ROOM)
    assert code.channels["q_ref"].values == pytest.approx(text.channels["q_ref"].values, abs=1e-6)


def test_the_neutral_model_is_that_of_the_robot_file() -> None:
    """Placements of a robot file come from its table; those of the model are as written, to rounding."""
    own = cell().first.robot
    neutral = ropsim.load_robot(EXAMPLE / "robots" / "two_link_hydraulic.stp")
    assert neutral.drives == own.drives
    assert [link.mass for link in neutral.links] == [link.mass for link in own.links]
    for q in np.radians([[45.0, -132.5], [24.5, -67.0], [81.5, -130.5]]):
        assert forward(neutral, q).matrix() == pytest.approx(forward(own, q).matrix(), abs=1e-12)
        assert gravity(neutral, q) == pytest.approx(gravity(own, q), rel=1e-12)
        assert mass_matrix(neutral, q) == pytest.approx(mass_matrix(own, q), rel=1e-12)
