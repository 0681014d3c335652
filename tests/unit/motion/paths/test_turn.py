"""Turns of the tool: least angle about a fixed axis, and the drive transform of Paul."""

import math

import numpy as np
import pytest

from ropsim.motion import OrientationMode, plan_turn
from ropsim.spatial import Array, Pose

ROUNDING = 1e-12
DRIVE = OrientationMode.DRIVE_TRANSFORM
SHARES: Array = np.linspace(0.0, 1.0, 21)


def pose(w: float, x: float, y: float, z: float) -> Pose:
    return Pose(np.zeros(3), np.array([w, x, y, z]))


START, GOAL = pose(0.9, 0.1, -0.3, 0.2), pose(0.2, -0.5, 0.4, 0.7)


@pytest.mark.parametrize("mode", OrientationMode)
def test_a_turn_begins_at_the_start_and_ends_at_the_goal(mode: OrientationMode) -> None:
    ends = START.rotation() @ plan_turn(START, GOAL, mode).rotations(np.array([0.0, 1.0]))
    assert np.abs(ends[0] - START.rotation()).max() < ROUNDING
    assert np.abs(ends[1] - GOAL.rotation()).max() < ROUNDING


def test_the_drive_transform_swings_the_approach_vector_in_one_plane() -> None:
    turn = plan_turn(START, GOAL, DRIVE)
    approach = turn.rotations(SHARES)[:, :, 2]
    assert np.abs(approach @ turn.axis).max() < ROUNDING
    angles = np.arccos(np.clip(approach[:, 2], -1.0, 1.0))
    assert angles == pytest.approx(SHARES * turn.angle, abs=1e-7)  # arccos is coarse near 0


def test_the_fixed_axis_needs_the_least_angle() -> None:
    least = plan_turn(START, GOAL, OrientationMode.FIXED_AXIS)
    assert math.cos(least.size) == pytest.approx(
        (np.trace(START.rotation().T @ GOAL.rotation()) - 1.0) / 2.0, abs=ROUNDING
    )
    assert least.size <= plan_turn(START, GOAL, DRIVE).size


def test_both_modes_agree_where_the_tool_only_swings_or_only_rolls() -> None:
    swing, roll = pose(math.cos(0.4), math.sin(0.4), 0.0, 0.0), pose(math.cos(0.4), 0.0, 0.0, math.sin(0.4))
    for goal in (swing, roll):
        turns = [plan_turn(Pose(), goal, mode).rotations(SHARES) for mode in OrientationMode]
        assert np.abs(turns[0] - turns[1]).max() < ROUNDING


def test_the_fixed_axis_turns_the_short_way() -> None:
    there, here = pose(math.cos(1.5), 0.0, 0.0, math.sin(1.5)), pose(math.cos(-1.5), 0.0, 0.0, math.sin(-1.5))
    assert plan_turn(there, here, OrientationMode.FIXED_AXIS).angle == pytest.approx(2.0 * math.pi - 6.0)


def test_swing_and_roll_of_a_known_turn_are_found() -> None:
    # Rot(y, 1.1)·Rot(z, -0.7)
    swung, rolled = (
        pose(math.cos(0.55), 0.0, math.sin(0.55), 0.0),
        pose(math.cos(0.35), 0, 0, -math.sin(0.35)),
    )
    turn = plan_turn(Pose(), swung @ rolled, DRIVE)
    assert (turn.angle, turn.roll) == pytest.approx((1.1, -0.7), abs=ROUNDING)
    assert turn.axis.tolist() == pytest.approx([0.0, 1.0, 0.0], abs=ROUNDING)
    assert turn.size == pytest.approx(math.hypot(1.1, 0.7), rel=ROUNDING)


@pytest.mark.parametrize("mode", OrientationMode)
@pytest.mark.parametrize(
    "goal", [pose(0, 1, 0, 0), pose(0, 0, 1, 0), pose(0, 0, 0, 1), pose(0, 1, 1, 0), pose(1, 0, 0, 0)]
)
def test_half_turns_and_no_turn_are_reached_too(mode: OrientationMode, goal: Pose) -> None:
    end = plan_turn(Pose(), goal, mode).rotations(np.ones(1))[0]
    assert np.abs(end - goal.rotation()).max() < ROUNDING


def test_the_size_of_a_drive_transform_is_what_the_angular_speed_adds_up_to() -> None:
    turn, step = plan_turn(START, GOAL, DRIVE), 1e-6
    before, after = turn.rotations(SHARES - step), turn.rotations(SHARES + step)
    between = np.swapaxes(before, 1, 2) @ after
    skew = (
        np.array(
            [
                between[:, 2, 1] - between[:, 1, 2],
                between[:, 0, 2] - between[:, 2, 0],
                between[:, 1, 0] - between[:, 0, 1],
            ]
        )
        / 2.0
    )
    assert np.linalg.norm(skew, axis=0) / (2.0 * step) == pytest.approx(np.full(21, turn.size), rel=1e-8)
