"""Forward and inverse kinematics of the PUMA 560."""

from dataclasses import replace
from time import perf_counter
from typing import Any

import numpy as np
from measuring import Measure

import ropsim
from ropsim.kinematics.solvers.spherical_wrist import SphericalWristSolver, closed_form
from ropsim.spatial import Pose

ROBOT = ropsim.robots.load("puma560")
RNG = np.random.default_rng(1)
JOINTS = RNG.uniform(ROBOT.lower_limits, ROBOT.upper_limits, (10_000, 6))


def test_inverse_batch(benchmark: Any) -> None:
    measure = Measure(benchmark)
    targets = ropsim.kinematics.forward_batch(ROBOT, JOINTS)
    found, time = measure(lambda: ropsim.kinematics.inverse_batch(ROBOT, targets), rounds=20)
    assert found.shape == (10_000, 8, 6)
    measure.figure("us per pose, all branches", 1e6 * time.best / len(JOINTS))


def bare_call() -> float:
    """Return the best time of a call of the compiled closed form for one pose, nothing around it [s]."""
    solver = ropsim.kinematics.solver_of(ROBOT)
    assert isinstance(solver, SphericalWristSolver)
    T = ropsim.kinematics.forward_batch(ROBOT, [ROBOT.home])
    solve, room, out = closed_form(solver), np.zeros(30), np.empty((1, 8, 6))
    best = float("inf")
    for _ in range(2000):
        start = perf_counter()
        solve(room, T, out)
        best = min(best, perf_counter() - start)
    return best


def test_inverse_of_one_pose(benchmark: Any) -> None:
    """The rest beside two bare calls of compiled code is what Python adds: matrix, result, turns."""
    measure = Measure(benchmark)
    pose = ropsim.kinematics.forward(ROBOT, ROBOT.home)
    found, time = measure(lambda: ropsim.kinematics.inverse(ROBOT, pose), rounds=2000, warmup=100)
    assert len(found.solutions) > 0
    measure.figure("us per pose, from Python", 1e6 * time.median)
    measure.figure("us per pose, from Python, best", 1e6 * time.best)
    measure.figure("bare calls of the kernel in that time", time.best / bare_call(), most=8.0)


def test_inverse_near_to_where_the_arm_stands(benchmark: Any) -> None:
    measure = Measure(benchmark)
    pose = ropsim.kinematics.forward(ROBOT, ROBOT.home)
    options = ropsim.kinematics.IkOptions(near=ROBOT.home)
    _, time = measure(lambda: ropsim.kinematics.inverse(ROBOT, pose, options), rounds=2000, warmup=100)
    measure.figure("us per pose, from Python, with `near`", 1e6 * time.median)


def test_inverse_of_a_chain_without_closed_form(benchmark: Any) -> None:
    """The PUMA with axis 6 beside the point where axes 4 and 5 meet."""
    measure = Measure(benchmark)
    beside = replace(ROBOT.joints[5], placement=ROBOT.joints[5].placement @ Pose(np.array([0.05, 0.0, 0.0])))
    robot = replace(ROBOT, joints=(*ROBOT.joints[:5], beside))
    assert ropsim.kinematics.solver_of(robot).name == "general six-axis"
    pose = ropsim.kinematics.forward(robot, ROBOT.home)
    found, time = measure(lambda: ropsim.kinematics.inverse(robot, pose), rounds=50)
    assert len(found.branches) > 0
    measure.figure("us per pose, algebraic", 1e6 * time.median)


def test_forward_batch(benchmark: Any) -> None:
    measure = Measure(benchmark)
    _, time = measure(lambda: ropsim.kinematics.forward_batch(ROBOT, JOINTS), rounds=20)
    measure.figure("us per pose", 1e6 * time.best / len(JOINTS))
