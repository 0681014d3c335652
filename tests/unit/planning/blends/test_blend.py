"""Corners: zones are clipped at half of both moves, and the arm stops where there is no way round."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.flow import ModalState, MoveInstruction, PoseSetpoints
from ropsim.kinematics import forward_batch
from ropsim.model import LookAhead
from ropsim.motion import ToolPath
from ropsim.planning.testing import (
    Blend,
    CartesianBlend,
    JointSpaceBlend,
    PlannedMove,
    Stop,
    blend_between,
    planned_move_of,
)
from ropsim.spatial import Array, Pose
from support.motion import CELL, CHAIN, PUMA, START, interface_pose, lin, ptp, shifted

PARAMETER = 1e-9  # [m] zones are found to that on all paths
# of differences of samples at the end of a traced path; at 0.25 m/s the bend makes 1e-3 rad/s²
SLOPE, BEND = 5e-6, 1.5e-2  # [rad/m], [rad/m²]
HERE = interface_pose(START)
FIRST, SECOND = shifted(HERE, -0.1, 0.1, 0.0), shifted(HERE, -0.1, 0.1, 0.06)


def legs(one: MoveInstruction, other: MoveInstruction) -> tuple[PlannedMove, PlannedMove]:
    before = planned_move_of(CHAIN, one, START)
    assert isinstance(before, PlannedMove)
    behind = planned_move_of(CHAIN, other, before.q_end)
    assert isinstance(behind, PlannedMove)
    return before, behind


def between(one: MoveInstruction, other: MoveInstruction, zone: float) -> Blend | Stop:
    one = replace(one, modal=replace(one.modal, zone=zone))
    return blend_between(CHAIN, *legs(one, other))


def achieved(one: MoveInstruction, other: MoveInstruction, zone: float) -> Blend:
    found = between(one, other, zone)
    assert not isinstance(found, Stop)
    return found


def rounded(one: MoveInstruction, other: MoveInstruction, zone: float) -> CartesianBlend:
    found = between(one, other, zone)
    assert isinstance(found, CartesianBlend)
    return found


def place_of(leg: PlannedMove, s: float) -> Array:
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
    found = achieved(one, other, 0.02)
    assert found.zone == pytest.approx(0.02, abs=PARAMETER)
    for leg, place in ((before, found.leave), (behind, found.enter)):
        assert np.linalg.norm(place_of(leg, place) - FIRST.position) == pytest.approx(0.02, abs=PARAMETER)


def test_the_way_round_goes_on_from_its_neighbours_with_both_derivatives() -> None:
    before, behind = legs(lin(FIRST), lin(SECOND))
    found = rounded(lin(FIRST), lin(SECOND), 0.02)
    for s, leg, place in ((0.0, before, found.leave), (found.joints.length, behind, found.enter)):
        assert leg.joints is not None
        here, there = found.joints.joints(np.array([s])), leg.joints.joints(np.array([place]))
        assert np.abs(here.q - there.q).max() < 1e-9
        assert np.abs(here.d1 - there.d1).max() < SLOPE
        assert np.abs(here.d2 - there.d2).max() < BEND


def test_a_corner_of_two_lines_is_one_of_the_tool_and_stays_within_its_zone() -> None:
    found = rounded(lin(FIRST), lin(SECOND), 0.02)
    assert found.tool is not None
    s = np.linspace(0.0, found.tool.length, 201)
    assert np.linalg.norm(found.tool.positions(s) - FIRST.position, axis=1).max() <= 0.02 + PARAMETER
    joints = forward_batch(PUMA, found.joints.joints(s).q)[:, :3, 3]
    assert np.abs(joints - found.tool.positions(s)).max() < 1e-8


@pytest.mark.parametrize("kinds", ["PTP to PTP", "PTP to LIN", "LIN to PTP"])
def test_motions_overlap_where_one_of_them_is_pose_to_pose(kinds: str) -> None:
    one, other = (make(goal) for make, goal in zip(KINDS[kinds], (FIRST, SECOND), strict=True))
    assert isinstance(between(one, other, 0.02), JointSpaceBlend)


def test_lines_of_two_tools_overlap() -> None:
    X_MT = CELL.first.tools["gripper"].X_MT
    other = lin(shifted(FIRST @ X_MT, 0.0, 0.0, 0.06), ModalState(tool="gripper"))
    assert isinstance(between(lin(FIRST), other, 0.02), JointSpaceBlend)


@pytest.mark.parametrize("kinds", KINDS)
def test_a_zone_takes_at_most_half_of_either_move(kinds: str) -> None:
    one, other = (make(goal) for make, goal in zip(KINDS[kinds], (FIRST, SECOND), strict=True))
    before, behind = legs(one, other)
    found = achieved(one, other, 1.0)
    assert before.joints is not None
    assert behind.joints is not None
    assert found.leave >= before.joints.length / 2.0 * (1.0 - 1e-9)
    assert found.enter <= behind.joints.length / 2.0 * (1.0 + 1e-9)
    ends = (before, found.leave), (behind, found.enter)
    away = [np.linalg.norm(place_of(leg, place) - FIRST.position) for leg, place in ends]
    assert found.zone == pytest.approx(max(away), abs=PARAMETER)
    if isinstance(found, JointSpaceBlend):
        assert found.shorter == pytest.approx(min(away), abs=PARAMETER)
    if kinds == "LIN to LIN":
        assert away == pytest.approx([0.03, 0.03], abs=PARAMETER)  # half of the second line
    else:
        assert found.leave == pytest.approx(before.joints.length / 2.0)
        assert found.enter == pytest.approx(behind.joints.length / 2.0)


def test_a_line_back_on_itself_is_a_stop() -> None:
    assert between(lin(FIRST), lin(shifted(FIRST, 0.05, -0.05, 0.0)), 0.01) is Stop.TURNS_BACK


def test_a_tool_that_only_turns_on_one_side_of_two_lines_is_a_stop() -> None:
    turned = Pose(FIRST.position, (FIRST @ Pose(orientation=np.array([0.99, 0.0, 0.0, 0.1]))).orientation)
    assert between(lin(FIRST), lin(turned), 0.01) is Stop.STANDS
    overlap = between(ptp(FIRST), lin(turned), 0.01)
    assert isinstance(overlap, JointSpaceBlend)
    assert overlap.zone == pytest.approx(0.01)  # what only turns has no zone to be cut


def test_there_is_no_way_round_where_a_move_leads_nowhere() -> None:
    assert between(lin(FIRST), lin(FIRST), 0.01) is Stop.NO_WAY_ON
    assert between(lin(HERE), lin(FIRST), 0.01) is Stop.NO_WAY_TO


@pytest.mark.parametrize("zone", [1e-300, 1e-160, 1e-18, 1e-12, 0.9e-6])
@pytest.mark.parametrize("kinds", KINDS)
def test_a_zone_below_a_micrometre_is_a_stop(kinds: str, zone: float) -> None:
    one, other = (make(goal) for make, goal in zip(KINDS[kinds], (FIRST, SECOND), strict=True))
    assert between(one, other, zone) is Stop.TOO_SMALL


def test_a_controller_that_does_not_look_ahead_stops() -> None:
    short = replace(CHAIN, controller=replace(CHAIN.controller, look_ahead=LookAhead(0, 0.0)))
    move = lin(FIRST, ModalState(zone=0.01))
    assert blend_between(short, *legs(move, lin(SECOND))) is Stop.NO_LOOK_AHEAD


def test_a_corner_that_the_arm_cannot_follow_is_a_stop() -> None:
    class Refusing:
        """An interpolator that samples nothing."""

        def sample(self, path: ToolPath, density: int) -> PoseSetpoints:
            """Raise."""
            raise ValueError(path, density)

    before, behind = legs(lin(FIRST, ModalState(zone=0.02)), lin(SECOND))
    chain = replace(CHAIN, interpolator=Refusing())
    assert blend_between(chain, before, behind) is Stop.UNREACHABLE


def test_a_line_that_goes_on_straight_is_rounded_on_the_line() -> None:
    found = rounded(lin(FIRST), lin(shifted(FIRST, -0.05, 0.05, 0.0)), 0.02)
    assert found.tool is not None
    way = (FIRST.position - HERE.position) / np.linalg.norm(FIRST.position - HERE.position)
    offsets = np.cross(found.tool.positions(np.linspace(0.0, found.tool.length, 50)) - HERE.position, way)
    assert np.abs(offsets).max() < 1e-12
    assert found.tool.length == pytest.approx(0.04, abs=1e-9)
