"""Closed chains against MuJoCo: accelerations by its masses and Jacobians, motions by its constraints."""

from functools import cache
from itertools import count, islice

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.dynamics import compiled, free_motion
from ropsim.kinematics import joint_motion, loop_freedom, loop_gaps
from ropsim.model import JointType, Mechanism, RobotModel, first_coordinates, passive_coordinates
from ropsim.spatial import Array
from support.closed_arms import delta, five_bar
from support.linkages import FOUR_BAR, SLIDER_CRANK
from support.mujoco_loops import MujocoLoops, swung
from support.mujoco_tree import mjcf_of_tree
from support.random_loops import random_loop

EXACT = 1e-9
"""Of two formulations, relative to the largest acceleration; found 2e-14."""
KEPT = 1e-7
"""What MuJoCo keeps of its constraints and its steps over a swing [rad]; found 4e-7."""
LINKAGES = {"four-bar": FOUR_BAR, "slider-crank": SLIDER_CRANK}


def apart(mechanism: Mechanism, seed: int) -> float:
    """Return how far accelerations of the axes are from those of MuJoCo in a random state."""
    random = np.random.default_rng(seed)
    q, qd, tau = random.uniform((-0.05,), (0.05,), mechanism.n), *random.uniform(-2.0, 2.0, (2, mechanism.n))
    q = mechanism.home + (q if loop_gaps(mechanism, mechanism.home + q[np.newaxis])[0] < EXACT else 0.0)
    motion = joint_motion(mechanism, [q], [qd])
    efforts, first = np.zeros(motion.position.shape[1]), first_coordinates(mechanism.joints)
    axes = [first[axis] for axis in mechanism.axes]
    efforts[axes] = tau
    expected = MujocoLoops(mechanism).accelerations(motion.position[0], motion.speed[0], efforts)
    found = np.empty(mechanism.n)
    compiled(mechanism, None, Engine.PYTHON).forward(q, qd, tau, found)
    assert np.abs(expected).max() > 1e-3
    return float(np.abs(found - expected[axes]).max() / np.abs(expected).max())


@cache
def free_loops(kind: JointType) -> list[int]:
    """Return the seeds of the first 25 loops that hold none of their axes."""
    found = (seed for seed in count() if not loop_freedom(random_loop(seed, kind)))
    return list(islice(found, 25))


@pytest.mark.parametrize("robot", [FOUR_BAR, SLIDER_CRANK, five_bar(), delta()], ids=lambda one: one.name)
def test_accelerations_of_linkages_are_those_of_mujoco(robot: RobotModel) -> None:
    assert max(apart(robot, seed) for seed in range(3)) < EXACT


@pytest.mark.parametrize("kind", [JointType.SPHERICAL, JointType.REVOLUTE], ids=lambda one: one.value)
@pytest.mark.parametrize("first", range(0, 25, 5))
def test_accelerations_of_random_loops_are_those_of_mujoco(kind: JointType, first: int) -> None:
    for seed in free_loops(kind)[first : first + 5]:
        assert apart(random_loop(seed, kind), seed) < EXACT, seed


@pytest.mark.parametrize("name", LINKAGES)
def test_a_linkage_swings_as_with_the_constraints_of_mujoco(name: str) -> None:
    """With the stiffest constraints that its steps bear, in steps of 0.1 ms over 0.5 s."""
    robot, step, steps = LINKAGES[name], 1e-4, 5000
    start = joint_motion(robot, [[0.4]], [[6.0]])
    ends = swung(mjcf_of_tree(robot), robot.cuts, (start.position[0], start.speed[0]), step, steps)
    places = [0, *passive_coordinates(robot)]
    y, yd = start.position[0][places], start.speed[0][places]
    found = np.empty(len(places))
    found[places] = free_motion(robot, y, yd, 1e-3, 500, every=500).y[-1]
    assert abs(found[0] - 0.4) > 0.5
    assert np.abs(turned(found - ends)).max() < KEPT


def turned(differences: Array) -> Array:
    return np.asarray(differences - 2.0 * np.pi * np.round(differences / (2.0 * np.pi)))
