"""Corners: zones are clipped at half of both moves, and the arm stops where there is no way round."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.controller.corners import Rounding, Stop, rounding
from ropsim.controller.leg import Leg, leg_of
from ropsim.flow import ModalState, MoveInstruction
from ropsim.kinematics import forward_batch
from ropsim.spatial import Array, Pose
from support.motion import CELL, CHAIN, PUMA, START, interface_pose, lin, ptp, shifted

PLACE = 1e-9  # [m] zones are found to that on all paths
HERE = interface_pose(START)
FIRST, SECOND = shifted(HERE, -0.1, 0.1, 0.0), shifted(HERE, -0.1, 0.1, 0.06)


def legs(one: MoveInstruction, other: MoveInstruction) -> tuple[Leg, Leg]:
    before = leg_of(CHAIN, one, START)
    assert isinstance(before, Leg)
    behind = leg_of(CHAIN, other, before.q_end)
    assert isinstance(behind, Leg)
    return before, behind


def rounded(one: MoveInstruction, other: MoveInstruction, zone: float) -> Rounding:
    found = rounding(CHAIN, *legs(one, other), zone)
    assert isinstance(found, Rounding), found
    return found


def place_of(leg: Leg, s: float) -> Array:
    assert leg.joints is not None
    return np.asarray(forward_batch(PUMA, leg.joints.joints(np.array([s])).q)[0, :3, 3])


KINDS = {
    "PTP to PTP": (ptp, ptp),
    "LIN to LIN": (lin, lin),
    "PTP to LIN": (ptp, lin),
    "LIN to PTP": (lin, ptp),
}


@pytest.mark.parametrize("kinds", KINDS)
def test_the_path_leaves_and_enters_its_moves_at_the_distance_of_the_zone(kinds: str) -> None:
    one, other = (make(goal) for make, goal in zip(KINDS[kinds], (FIRST, SECOND), strict=True))
    before, behind = legs(one, other)
    found = rounded(one, other, 0.02)
    assert found.zone == 0.02
    for leg, place in ((before, found.leave), (behind, found.enter)):
        assert np.linalg.norm(place_of(leg, place) - FIRST.position) == pytest.approx(0.02, abs=PLACE)


@pytest.mark.parametrize("kinds", KINDS)
def test_the_way_round_goes_on_from_its_neighbours_in_position_speed_and_acceleration(kinds: str) -> None:
    one, other = (make(goal) for make, goal in zip(KINDS[kinds], (FIRST, SECOND), strict=True))
    before, behind = legs(one, other)
    found = rounded(one, other, 0.02)
    assert before.joints is not None
    assert behind.joints is not None
    # with the place on the neighbour moving at 1/s and not accelerated, and that of the way round accordingly
    start, end = (found.joints.joints(np.array([s])) for s in (0.0, found.joints.length))
    left = before.joints.joints(np.array([found.leave]))
    entered = behind.joints.joints(np.array([found.enter]))
    for here, there, rate in ((start, left, found.before), (end, entered, 1.0 / found.behind)):
        assert np.abs(here.q - there.q).max() < 1e-9
        assert np.abs(here.d1 * rate - there.d1).max() < 1e-6
        assert np.abs(here.d2 * rate**2 - there.d2).max() < 2e-3  # of differences of samples on lines


def test_a_corner_of_two_lines_is_one_of_the_tool_and_stays_within_its_zone() -> None:
    found = rounded(lin(FIRST), lin(SECOND), 0.02)
    assert found.tool is not None
    s = np.linspace(0.0, found.tool.length, 201)
    assert np.linalg.norm(found.tool.positions(s) - FIRST.position, axis=1).max() <= 0.02 + PLACE
    joints = forward_batch(PUMA, found.joints.joints(s).q)[:, :3, 3]
    assert np.abs(joints - found.tool.positions(s)).max() < 1e-8


def test_corners_with_a_pose_to_pose_move_are_rounded_in_joint_space() -> None:
    for kinds in ("PTP to PTP", "PTP to LIN", "LIN to PTP"):
        one, other = (make(goal) for make, goal in zip(KINDS[kinds], (FIRST, SECOND), strict=True))
        assert rounded(one, other, 0.02).tool is None


def test_lines_of_two_tools_are_joined_in_joint_space() -> None:
    gripper = ModalState(tool="gripper")
    X_MT = CELL.first.tools["gripper"].X_MT
    assert rounded(lin(FIRST), lin(shifted(FIRST @ X_MT, 0.0, 0.0, 0.06), gripper), 0.02).tool is None


@pytest.mark.parametrize("kinds", KINDS)
def test_a_zone_takes_at_most_half_of_either_move(kinds: str) -> None:
    one, other = (make(goal) for make, goal in zip(KINDS[kinds], (FIRST, SECOND), strict=True))
    before, behind = legs(one, other)
    found = rounded(one, other, 1.0)
    assert before.joints is not None
    assert behind.joints is not None
    assert found.leave >= before.joints.length / 2.0 * (1.0 - 1e-9)
    assert found.enter <= behind.joints.length / 2.0 * (1.0 + 1e-9)
    assert found.zone == pytest.approx(
        np.linalg.norm(place_of(behind, found.enter) - FIRST.position), abs=PLACE
    )
    if kinds == "LIN to LIN":
        assert found.zone == pytest.approx(0.03, abs=PLACE)  # half of the second line


def test_a_line_back_on_itself_is_a_stop() -> None:
    assert rounding(CHAIN, *legs(lin(FIRST), lin(shifted(FIRST, 0.05, -0.05, 0.0))), 0.01) is Stop.TURNS_BACK


def test_a_tool_that_only_turns_on_one_side_is_a_stop() -> None:
    turned = Pose(FIRST.position, (FIRST @ Pose(orientation=np.array([0.99, 0.0, 0.0, 0.1]))).orientation)
    assert rounding(CHAIN, *legs(lin(FIRST), lin(turned)), 0.01) is Stop.STANDS
    assert rounding(CHAIN, *legs(ptp(FIRST), lin(turned)), 0.01) is Stop.STANDS


@pytest.mark.parametrize("zone", [1e-300, 1e-160, 1e-18, 1e-12, 0.9e-6])
def test_a_zone_below_a_micrometre_is_a_stop(zone: float) -> None:
    for kinds in KINDS.values():
        one, other = (make(goal) for make, goal in zip(kinds, (FIRST, SECOND), strict=True))
        assert rounding(CHAIN, *legs(one, other), zone) is Stop.TOO_SMALL


def test_a_corner_that_the_arm_cannot_follow_is_a_stop() -> None:
    class Refusing:
        """An interpolator that samples lines only from the start of a move."""

        def sample(self, path: object, density: int) -> object:
            """Raise."""
            raise ValueError(path, density)

    before, behind = legs(lin(FIRST), lin(SECOND))
    chain = replace(CHAIN, interpolator=Refusing())  # type: ignore[arg-type]
    assert rounding(chain, before, behind, 0.02) is Stop.UNREACHABLE


def test_a_line_that_goes_on_straight_is_rounded_on_the_line() -> None:
    found = rounded(lin(FIRST), lin(shifted(FIRST, -0.05, 0.05, 0.0)), 0.02)
    assert found.tool is not None
    way = (FIRST.position - HERE.position) / np.linalg.norm(FIRST.position - HERE.position)
    offsets = np.cross(found.tool.positions(np.linspace(0.0, found.tool.length, 50)) - HERE.position, way)
    assert np.abs(offsets).max() < 1e-12
    assert found.tool.length == pytest.approx(0.04, abs=1e-9)
