"""Redundant arms find an answer within their limits wherever there is one."""

import os
from math import radians

import numpy as np
import pytest

from ropsim.kinematics import (
    IkOptions,
    IkStatus,
    forward,
    forward_batch,
    inverse,
)
from ropsim.model import RobotModel
from ropsim.spatial import Array
from support.axis_chains import chain
from support.redundant_poses import awkward_joints, seven_axis_arms

REACHED = 1e-9  # m, entries of the rotation matrix: what is promised
ARMS = seven_axis_arms()
POSES = int(os.environ.get("ROPSIM_POSES", "25"))
"""Poses of each arm in the slow test; 500 take eleven minutes."""
FEW = 6


def lost(robot: RobotModel, count: int, seed: int) -> list[tuple[Array, IkStatus]]:
    """Return the configurations whose poses `inverse` does not reach within the limits.

    Every second one is solved near to the zeros, the others near to a random configuration.
    """
    rng = np.random.default_rng(seed)
    found: list[tuple[Array, IkStatus]] = []
    for number, q in enumerate(awkward_joints(robot, count, seed)):
        near = rng.uniform(robot.lower_limits, robot.upper_limits) if number % 2 else None
        result = inverse(robot, forward(robot, q), IkOptions(near=near))
        if result.status is not IkStatus.FOUND:
            found.append((q, result.status))
            continue
        rows = result.solutions
        assert ((rows >= robot.lower_limits) & (rows <= robot.upper_limits)).all()
        np.testing.assert_allclose(
            forward_batch(robot, rows), [forward(robot, q).matrix()] * len(rows), rtol=0.0, atol=REACHED
        )
    return found


@pytest.mark.parametrize("name", ["iiwa14", "panda", "motoman_sia10d", "kinova_gen3", "narrow 5"])
def test_poses_of_configurations_within_the_limits_are_reached_within_them(name: str) -> None:
    assert lost(ARMS[name], FEW, seed=1) == []


@pytest.mark.slow
@pytest.mark.parametrize("name", ARMS)
def test_no_pose_of_many_is_lost(name: str) -> None:
    assert lost(ARMS[name], POSES, seed=2) == []


NARROW_ELBOW = chain(
    "zxyzxyx",
    (
        (0.0, 0.14, 0.0),
        (0.0, 0.0, 0.0),
        (0.02, 0.0, -0.27),
        (-0.02, 0.0, -0.26),
        (0.0, 0.0, 0.0),
        (0.0, 0.0, 0.0),
        (0.0, 0.02, -0.12),
    ),
    ((0, 165), (-140, 140), (-135, 0), (-145, 145), (-80, 80), (-40, 40), (-60, 0)),
)
POSED = (0.7817, 1.8554, -2.2049, 0.9069, 1.0335, -0.3807, -0.1095)
"""A configuration whose pose it reaches with joint 3 between -126.5° and -123.6° only."""


@pytest.mark.parametrize("seed", [None, 1, 2, 3])
def test_a_pose_that_is_reached_within_three_degrees_of_the_held_joint_is_found(seed: int | None) -> None:
    robot = NARROW_ELBOW
    near = (
        None if seed is None else np.random.default_rng(seed).uniform(robot.lower_limits, robot.upper_limits)
    )
    found = inverse(robot, forward(robot, POSED), IkOptions(near=near))
    assert found.status is IkStatus.FOUND
    assert found.free is not None
    assert found.free.name == "joint 3"
    assert radians(-126.6) < found.free.value < radians(-123.5)
    first = forward(robot, found.solutions[0]).matrix()
    np.testing.assert_allclose(first, forward(robot, POSED).matrix(), rtol=0.0, atol=REACHED)


def test_a_pose_of_an_almost_stretched_arm_is_found_from_everywhere() -> None:
    """Its two curves of answers, elbow forth and back, are 1e-4 apart: one was followed into the other."""
    robot = ARMS["barrett_wam"]
    q = np.array((0.63662383, -1.97222205, -1.36773906, 0.2304621, -2.44084695, -1.4173713, -0.13656867))
    for seed in (None, 1, 2, 3):
        rng = np.random.default_rng(seed)
        near = None if seed is None else rng.uniform(robot.lower_limits, robot.upper_limits)
        assert inverse(robot, forward(robot, q), IkOptions(near=near)).status is IkStatus.FOUND


def test_a_pose_that_is_reached_beyond_the_limits_only_is_not_out_of_reach() -> None:
    """At the held joint's present value there is no answer at all; elsewhere joint 7 is beyond its limit."""
    robot = NARROW_ELBOW
    q = np.array(POSED)
    q[6] = 0.5
    assert inverse(robot, forward(robot, q), IkOptions(free=0.0)).status is IkStatus.OUT_OF_REACH
    found = inverse(robot, forward(robot, q))
    assert found.status is IkStatus.OUT_OF_LIMITS
    assert found.violations
    assert found.reaching > 0
