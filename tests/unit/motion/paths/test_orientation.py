"""Orientation along a path: the turn of the tool with its angular velocity and acceleration."""

import math

import numpy as np
import pytest

from ropsim.motion import OrientationMode, ToolTurn, Turn, plan_turn, tool_turn
from ropsim.spatial import Array
from support.paths import random_pose

ROUNDING = 1e-12
SHARES: Array = np.linspace(0.0, 1.0, 21)


@pytest.mark.parametrize("mode", OrientationMode)
def test_orientations_are_those_of_the_turn(mode: OrientationMode) -> None:
    rng = np.random.default_rng(5)
    start, end = random_pose(rng), random_pose(rng)
    wanted = start.rotation() @ plan_turn(start, end, mode).rotations(SHARES)
    assert np.abs(tool_turn(start, end, mode).at(SHARES).rotations - wanted).max() < ROUNDING


@pytest.mark.parametrize("mode", OrientationMode)
def test_the_angular_speed_is_the_size_of_the_turn(mode: OrientationMode) -> None:
    rng = np.random.default_rng(6)
    start, end = random_pose(rng), random_pose(rng)
    speeds = np.linalg.norm(tool_turn(start, end, mode).at(SHARES).d1, axis=1)
    assert speeds == pytest.approx(np.full(21, plan_turn(start, end, mode).size), rel=ROUNDING)


def test_angular_velocity_of_swing_and_roll_is_that_of_the_two_axes() -> None:
    # swing 0.8 about y, roll 0.5 about the approach vector (sin 0.8r, 0, cos 0.8r)
    points = ToolTurn(np.eye(3), Turn(np.array([0.0, 1.0, 0.0]), 0.8, 0.5)).at(SHARES)
    sines, cosines = np.sin(0.8 * SHARES), np.cos(0.8 * SHARES)
    assert points.d1 == pytest.approx(
        np.stack((0.5 * sines, np.full(21, 0.8), 0.5 * cosines), axis=1), abs=ROUNDING
    )
    assert points.d2 == pytest.approx(
        np.stack((0.4 * cosines, np.zeros(21), -0.4 * sines), axis=1), abs=ROUNDING
    )


def test_a_turn_may_go_round_more_than_once() -> None:
    points = ToolTurn(np.eye(3), Turn(np.array([0.0, 0.0, 1.0]), 5.0 * math.pi)).at(np.array([0.5, 1.0]))
    assert points.rotations[0] == pytest.approx(np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]]), abs=ROUNDING)
    assert points.rotations[1] == pytest.approx(np.diag([-1.0, -1.0, 1.0]), abs=ROUNDING)
    assert points.d1[:, 2] == pytest.approx([5.0 * math.pi] * 2, rel=ROUNDING)
