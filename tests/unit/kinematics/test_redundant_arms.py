"""Arms of seven joints: all branches for what a pose leaves free, held where it is or where limits allow."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from ropsim.kinematics import (
    IkOptions,
    IkStatus,
    Limits,
    Method,
    RedundantSolver,
    classes_missed,
    forward,
    forward_batch,
    inverse,
    inverse_batch,
    joint_frames,
    posture,
    redundant_solver_of,
    solver_of,
)
from ropsim.kinematics.testing import SwivelSolver
from ropsim.model import RobotModel
from ropsim.robots import load
from ropsim.spatial import Array, Pose, quaternion
from support.arms import random_arm
from support.published_arms import published_arm, random_joints

REACHED = 1e-9  # m, entries of the rotation matrix: what is promised
SAME = 1e-9  # rad
NEAR_SINGULAR = 1e-5  # rad: rounding by 1e-16 moves joints by its square root

SIA20, IIWA, PANDA = (
    published_arm(name) for name in ("motoman_sia20d", "kuka_lbr_iiwa_14_r820", "franka_panda")
)


def tilted() -> RobotModel:
    """Return the SIA20 with its elbow beside the line from shoulder to wrist, on a tilted base."""
    joints = list(SIA20.joints)
    aside = Pose(np.array([0.05, 0.02, -0.03]), np.array([0.9, 0.1, 0.2, -0.1]))
    joints[0] = replace(joints[0], placement=aside @ joints[0].placement, offset=0.3)
    joints[3] = replace(
        joints[3], placement=joints[3].placement @ Pose(np.array([0.04, 0.03, 0.02])), offset=-0.2
    )
    back = Pose(np.array([-0.03, 0.05, 0.01]), np.array(quaternion.from_zyx(0.2, 0.0, 0.0)))
    joints[4] = replace(joints[4], placement=back @ joints[4].placement)
    return replace(SIA20, name="tilted", joints=tuple(joints))


ARMS = {"sia20": SIA20, "tilted": tilted(), "iiwa": IIWA, "panda": PANDA, "random": random_arm(3, "RRRRRRR")}
SWIVEL = {name: ARMS[name] for name in ("sia20", "tilted")}
by_arm = pytest.mark.parametrize("robot", ARMS.values(), ids=ARMS.keys())
by_swivel_arm = pytest.mark.parametrize("robot", SWIVEL.values(), ids=SWIVEL.keys())


def apart(q: Array, other: Array) -> Array:
    return np.asarray(np.abs((q - other + pi) % (2.0 * pi) - pi).max(axis=-1))


def redundant(robot: RobotModel) -> RedundantSolver:
    solver = redundant_solver_of(robot)
    assert solver is not None
    return solver


def test_the_classes_are_recognised() -> None:
    assert {solver_of(robot).name for robot in SWIVEL.values()} == {"S-R-S"}
    assert {solver_of(robot).name for robot in (IIWA, PANDA)} == {"general seven-axis"}
    assert (solver_of(SIA20).method, solver_of(PANDA).method) == (Method.CLOSED_FORM, Method.ALGEBRAIC)
    assert classes_missed(PANDA)["S-R-S"] == "axes 5, 6 and 7 do not meet in one point"
    assert classes_missed(IIWA)["S-R-S"] == "axes 1, 2 and 3 do not meet in one point"  # its file has 0.4 mm
    assert redundant_solver_of(load("puma560")) is None


@by_arm
def test_each_pose_with_its_own_value_has_the_configuration_itself_among_its_branches(
    robot: RobotModel,
) -> None:
    solver, Q = redundant(robot), random_joints(robot, 30, seed=1)
    T = forward_batch(robot, Q)
    branches = inverse_batch(robot, T, Q)
    present = ~np.isnan(branches[:, :, 0])
    reached = forward_batch(robot, branches[present])
    np.testing.assert_allclose(reached, np.repeat(T, present.sum(axis=1), axis=0), rtol=0.0, atol=REACHED)
    assert np.nanmin(apart(branches, Q[:, None]), axis=1).max() < SAME
    for q, rows in zip(Q, branches, strict=True):
        values = [solver.free(row).value - solver.free(q).value for row in rows if row[0] == row[0]]
        assert np.abs((np.array(values) + pi) % (2.0 * pi) - pi).max() < SAME


@by_swivel_arm
def test_an_arm_with_a_swivel_angle_has_eight_named_branches(robot: RobotModel) -> None:
    names = solver_of(robot).postures
    for rows in inverse_batch(robot, forward_batch(robot, Q := random_joints(robot, 50, seed=2)), Q):
        assert [posture(robot, q) for q in rows] == list(names)
        assert min(apart(np.delete(rows, k, axis=0), q).min() for k, q in enumerate(rows)) > 1e-3


def test_the_swivel_angle_turns_the_elbow_about_the_line_from_shoulder_to_wrist() -> None:
    (q,) = random_joints(SIA20, 1, seed=3)
    S, W = (joint_frames(SIA20, q)[k, :3, 3] for k in (1, 5))
    line = (W - S) / np.linalg.norm(W - S)
    level = np.cross([0.0, 0.0, 1.0], line)
    up = np.cross(line, level) / np.linalg.norm(level)
    for angle in (-2.0, 0.0, 0.5, 3.0):
        found = inverse(SIA20, forward(SIA20, q), IkOptions(Limits.IGNORE, free=angle))
        assert found.free is not None
        assert (found.free.name, found.free.value) == ("swivel angle", angle)
        assert found.reaching == 8
        for row in found.branches:
            elbow = joint_frames(SIA20, row)[3, :3, 3] - S
            out = elbow - (elbow @ line) * line
            expected = np.cos(angle) * up + np.sin(angle) * np.cross(line, up)
            np.testing.assert_allclose(out / np.linalg.norm(out), expected, atol=1e-9)


@by_arm
def test_what_is_free_stays_where_the_arm_stands(robot: RobotModel) -> None:
    solver = redundant(robot)
    for q in random_joints(robot, 3, seed=4):
        found = inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE, near=q))
        assert found.free is not None
        assert abs(found.free.value - solver.free(q).value) < SAME
        assert apart(found.solutions, q).min() < SAME


@by_swivel_arm
@pytest.mark.parametrize("joint", [1, 3, 5])
def test_a_singular_arm_may_stay_where_it_is(robot: RobotModel, joint: int) -> None:
    """Axes 1 and 3 or 5 and 7 in line, or the arm stretched."""
    for q in random_joints(robot, 10, seed=5):
        solver = solver_of(robot)
        assert isinstance(solver, SwivelSolver)
        q[joint] = -solver.arm.zeros[joint]
        found = inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE, near=q))
        assert apart(found.solutions, q).min() < NEAR_SINGULAR


@pytest.mark.parametrize("robot", [SIA20, PANDA], ids=["sia20", "panda"])
def test_where_limits_shut_a_value_out_the_nearest_other_one_is_taken(robot: RobotModel) -> None:
    solver, moved = redundant(robot), 0
    for q in random_joints(robot, 12, seed=6):
        here, pose = robot.home, forward(robot, q)
        found = inverse(robot, pose, IkOptions(near=here))
        held = inverse(robot, pose, IkOptions(near=here, free=solver.free(here).value))
        assert held.free == solver.free(here)
        if found.status is not IkStatus.FOUND or held.status is IkStatus.FOUND:
            continue
        moved += 1
        assert found.free is not None
        inside = (found.solutions >= robot.lower_limits) & (found.solutions <= robot.upper_limits)
        assert inside.all()
        step = (found.free.value - solver.free(here).value + pi) % (2.0 * pi) - pi
        nearer = solver.free(here).value + step * (1.0 - 0.02 / abs(step))
        assert inverse(robot, pose, IkOptions(near=here, free=nearer)).status is not IkStatus.FOUND
    assert moved >= 2


def test_a_pose_beyond_the_stretched_arm_is_told_by_its_distance() -> None:
    found = inverse(SIA20, Pose(np.array([1.5, 0.0, 0.4])))
    assert found.status is IkStatus.OUT_OF_REACH
    assert found.reach is not None
    assert found.reach.point == "centre of the wrist"
    assert found.reach.longest == pytest.approx(0.49 + 0.42)
    far = inverse(PANDA, Pose(np.array([2.0, 0.0, 0.4])))
    assert far.status is IkStatus.OUT_OF_REACH
    assert far.shortfall is not None
    assert far.shortfall.miss is not None
    assert 0.8 < far.shortfall.miss.distance < 1.4


def test_the_wrist_gets_as_near_and_as_far_as_the_elbow_lets_it() -> None:
    """The elbow lies beside the line from shoulder to wrist, and only joint 4 changes the distance."""
    robot = ARMS["tilted"]
    Q = np.zeros((2001, 7))
    Q[:, 3] = np.linspace(-pi, pi, len(Q))
    reaches = [redundant(robot).shortfall(X).reach for X in forward_batch(robot, Q)]
    found = [(one.distance, one.shortest, one.longest) for one in reaches if one is not None]
    distances, shortest, longest = np.array(found).T
    assert longest.tolist() == pytest.approx([distances.max()] * len(Q), abs=1e-6)
    assert shortest.tolist() == pytest.approx([distances.min()] * len(Q), abs=1e-4)


def test_arms_with_other_joints_are_told_what_they_miss() -> None:
    missed = classes_missed(random_arm(1, "RRRRRRP"))
    assert missed["S-R-S"] == missed["general seven-axis"] == "joint `7` is prismatic"
    assert classes_missed(random_arm(1, "RRRRRRR"))["S-R-S"] == "axis 2 is not perpendicular to axis 1"
