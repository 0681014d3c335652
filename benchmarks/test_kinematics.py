"""Forward and inverse kinematics: the PUMA 560, and arms of other makers with 10,000 poses each."""

from dataclasses import replace
from time import perf_counter
from typing import Any

import numpy as np
import pytest
from measuring import Measure

import ropsim
from ropsim.kinematics.testing import SphericalWristSolver, closed_form
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose
from support.published_arms import published_arm

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
    solve, room, out = closed_form(solver), np.zeros(ropsim.kinematics.ROOM_OF_ROWS), np.empty((1, 8, 6))
    best = float("inf")
    for _ in range(2000):
        start = perf_counter()
        solve(room, T, out)
        best = min(best, perf_counter() - start)
    return best


def test_inverse_of_one_pose(benchmark: Any) -> None:
    """The rest beside two calls of compiled code is what Python adds: matrix, result, turns."""
    measure = Measure(benchmark)
    pose = ropsim.kinematics.forward(ROBOT, ROBOT.home)
    found, time = measure(lambda: ropsim.kinematics.inverse(ROBOT, pose), rounds=2000, warmup=100)
    assert len(found.solutions) > 0
    measure.figure("us per pose, from Python", 1e6 * time.median)
    measure.figure("us per pose, from Python, best", 1e6 * time.best)
    measure.figure("bare calls of the kernel in that time", time.best / bare_call(), most=7.0)


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
    """A quiet core does five million poses in a second and more; the bound lets a busy one pass."""
    measure = Measure(benchmark)
    _, time = measure(lambda: ropsim.kinematics.forward_batch(ROBOT, JOINTS), rounds=50)
    measure.figure("us per pose", 1e6 * time.best / len(JOINTS))
    measure.figure("million poses per second", 1e-6 * len(JOINTS) / time.best, least=1.0)


EXACT = ("puma560", "abb_irb120_3_58", "abb_irb4600_60_205", "fanuc_lrmate200id", "staubli_tx60")
ROUNDED = ("ur5e_robot", "kr6_r900_2")
"""Their files give right angles with nine digits, and answers are polished on the model as it is."""
ALGEBRAIC = ("crx5ia", "crx10ia_l", "motoman_hc10", "fanuc_m430ia2p", "abb_crb15000_5_95")
MOST = dict.fromkeys(EXACT, 10.0) | dict.fromkeys(ROUNDED, 40.0) | dict.fromkeys(ALGEBRAIC, 2e4)
"""Microseconds for all branches of a pose, ten times and more what a quiet core takes."""


def farthest(robot: RobotModel, Q: Array, own: Array) -> float:
    """Return the largest of distances own (k,) [rad] of configurations Q not next to singular ones."""
    far = np.flatnonzero(own > 1e-9)
    least = [np.linalg.svd(ropsim.kinematics.jacobian(robot, q), compute_uv=False)[-1] for q in Q[far]]
    return float(max([own[own <= 1e-9].max(), *own[far][np.array(least) > 1e-6]]))


@pytest.mark.parametrize("name", MOST)
def test_all_branches_of_ten_thousand_poses(benchmark: Any, name: str) -> None:
    """Each pose is solved, each answer reaches it, and one is the configuration that made the pose."""
    measure = Measure(benchmark)
    robot = ROBOT if name == ROBOT.name else published_arm(name)
    Q = np.random.default_rng(1).uniform(robot.lower_limits, robot.upper_limits, (10_000, 6))
    T = ropsim.kinematics.forward_batch(robot, Q)
    rounds = 1 if name in ALGEBRAIC else 10
    branches, time = measure(lambda: ropsim.kinematics.inverse_batch(robot, T), rounds=rounds, warmup=1)
    measure.figure("us per pose, all branches", 1e6 * time.best / len(Q), most=MOST[name])
    present = ~np.isnan(branches[:, :, 0])
    measure.figure("% of poses solved", 100.0 * present.any(axis=1).mean(), least=100.0)
    apart = np.abs((branches - Q[:, None] + np.pi) % (2.0 * np.pi) - np.pi).max(axis=2)
    own = np.where(present, apart, np.inf).min(axis=1)
    measure.figure("% with the configuration itself to 1e-9 rad", 100.0 * (own < 1e-9).mean(), least=99.9)
    measure.figure("farthest outside of singularities [rad]", farthest(robot, Q, own), most=1e-7)
    reached = ropsim.kinematics.forward_batch(robot, branches[present])
    miss = np.linalg.norm((reached - np.repeat(T, present.sum(axis=1), axis=0))[:, :3, 3], axis=1)
    measure.figure("largest error of a position [m]", miss.max(), most=1e-9)


@pytest.mark.parametrize("name", [*EXACT, *ROUNDED])
def test_inverse_of_single_poses(benchmark: Any, name: str) -> None:
    """A quiet core takes less than 20 µs for all branches, postures and turns; a busy one twice that."""
    measure = Measure(benchmark)
    robot = ROBOT if name == ROBOT.name else published_arm(name)
    Q = np.random.default_rng(2).uniform(robot.lower_limits, robot.upper_limits, (30, 6))
    poses = [ropsim.kinematics.forward(robot, q) for q in Q]
    found, time = measure(
        lambda: [ropsim.kinematics.inverse(robot, one) for one in poses], rounds=200, warmup=2
    )
    assert all(len(one.solutions) for one in found)
    measure.figure("us per pose, from Python, best", 1e6 * time.best / len(poses), most=40.0)


@pytest.mark.parametrize("name", ["motoman_sia20d", "franka_panda"])
def test_all_branches_of_arms_with_seven_joints(benchmark: Any, name: str) -> None:
    measure = Measure(benchmark)
    robot = published_arm(name)
    Q = np.random.default_rng(1).uniform(robot.lower_limits, robot.upper_limits, (1000, 7))
    T = ropsim.kinematics.forward_batch(robot, Q)
    branches, time = measure(lambda: ropsim.kinematics.inverse_batch(robot, T, Q), rounds=1, warmup=1)
    measure.figure("us per pose, all branches", 1e6 * time.best / len(Q))
    apart = np.abs((branches - Q[:, None] + np.pi) % (2.0 * np.pi) - np.pi).max(axis=2)
    own = np.where(np.isnan(apart), np.inf, apart).min(axis=1)
    measure.figure("% with the configuration itself to 1e-9 rad", 100.0 * (own < 1e-9).mean(), least=99.0)
