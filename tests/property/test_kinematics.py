"""Laws of kinematics: forward after inverse is identity, the Jacobian a derivative, rows have names."""

from itertools import pairwise, product
from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim import kinematics
from ropsim.kinematics import IkOptions, Limits, posture, solver_of
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose
from support.examples import examples
from support.wrist_arms import all_arms

POSE_TOLERANCE = 1e-9
"""What the inverse kinematics promises [m, entries of the rotation matrix]."""
BRANCH_TOLERANCE = 1e-6
"""Near singularities rounding of 1e-16 moves angles by its square root [rad]."""
DIFFERENCE = 1e-6
"""Step of the central difference [rad]; its error is of the order of the square."""
SLOPE_TOLERANCE = 1e-8

ARMS = all_arms()
SIGNED_AXES = [
    np.array(matrix)
    for matrix in product(*[[sign * row for row in np.eye(3) for sign in (1.0, -1.0)]] * 3)
    if abs(np.linalg.det(np.array(matrix)) - 1.0) < 1e-12
]
MODEST = settings(max_examples=examples(60), derandomize=True)

arms = st.sampled_from(ARMS)
angles = st.lists(st.floats(-pi, pi), min_size=6, max_size=6).map(np.array)
round_angles = st.lists(st.integers(-4, 4), min_size=6, max_size=6).map(lambda k: np.array(k) * pi / 4)


def apart(q: Array, other: Array) -> Array:
    return np.asarray(np.abs((q - other + pi) % (2.0 * pi) - pi).max(axis=-1))


def assert_branches_reach(robot: RobotModel, T: Array) -> Array:
    """Check all branches of the poses T (k, 4, 4) by forward kinematics; return them."""
    branches = kinematics.inverse_batch(robot, T)
    present = ~np.isnan(branches).any(axis=2)
    reached = kinematics.forward_batch(robot, branches[present])
    np.testing.assert_allclose(
        reached, np.repeat(T, present.sum(axis=1), axis=0), rtol=0.0, atol=POSE_TOLERANCE
    )
    assert (branches[present] > -pi).all()
    assert (branches[present] <= pi).all()
    return branches


@MODEST
@given(arms, angles)
def test_forward_after_inverse_is_identity(robot: RobotModel, q: Array) -> None:
    assert_branches_reach(robot, kinematics.forward_batch(robot, [q]))


@MODEST
@given(arms, st.one_of(angles, round_angles))
def test_some_branch_is_the_configuration_itself_or_the_pose_is_singular(robot: RobotModel, q: Array) -> None:
    branches = assert_branches_reach(robot, kinematics.forward_batch(robot, [q]))[0]
    smallest = np.linalg.svd(kinematics.jacobian(robot, q), compute_uv=False)[-1]
    assert np.nanmin(apart(branches, q)) < BRANCH_TOLERANCE or smallest < BRANCH_TOLERANCE
    assert not np.isnan(branches[:, 0]).all()


@MODEST
@given(arms, angles)
def test_rows_of_the_inverse_are_named_by_their_postures(robot: RobotModel, q: Array) -> None:
    branches = kinematics.inverse_batch(robot, kinematics.forward_batch(robot, [q]))[0]
    for row, found in enumerate(branches):
        singular = np.isnan(found).any() or (apart(np.delete(branches, row, axis=0), found) < 1e-3).any()
        assert singular or posture(robot, found) == solver_of(robot).postures[row]


@MODEST
@given(arms, st.one_of(angles, round_angles))
def test_jacobian_is_the_derivative_of_the_pose(robot: RobotModel, q: Array) -> None:
    X_MT = Pose(np.array([0.1, -0.2, 0.3]), np.array([0.5, 0.5, -0.5, 0.5]))
    slopes = np.empty((6, robot.n))
    for i in range(robot.n):
        step = np.eye(robot.n)[i] * DIFFERENCE
        ahead, behind = ((kinematics.forward(robot, q + s) @ X_MT).matrix() for s in (step, -step))
        rate = (ahead - behind) / (2.0 * DIFFERENCE)
        turn = rate[:3, :3] @ (kinematics.forward(robot, q) @ X_MT).rotation().T
        slopes[:, i] = [*rate[:3, 3], turn[2, 1], turn[0, 2], turn[1, 0]]
    np.testing.assert_allclose(kinematics.jacobian_at(robot, q, X_MT), slopes, rtol=0.0, atol=SLOPE_TOLERANCE)


@pytest.mark.parametrize("robot", ARMS, ids=["puma560", "industrial", "backward"])
def test_every_axis_aligned_pose_in_reach_is_solved(robot: RobotModel) -> None:
    """Poses with axes along the base axes are what programs use, and often singular."""
    wrist = np.random.default_rng(5).uniform(-0.35, 0.35, (40, 3))
    centre = kinematics.joint_frames(robot, np.zeros(6))[1, :3, 3]
    w_M = (
        kinematics.forward(robot, np.zeros(6)).inverse().matrix()
        @ kinematics.joint_frames(robot, np.zeros(6))[4]
    )
    T = np.tile(np.eye(4), (len(SIGNED_AXES) * len(wrist), 1, 1))
    for row, (R_BM, p) in enumerate(product(SIGNED_AXES, wrist)):
        T[row, :3, :3] = R_BM
        T[row, :3, 3] = centre + p - R_BM @ w_M[:3, 3]
    branches = assert_branches_reach(robot, T)
    reachable = [reaches(robot, centre + p) for _, p in product(SIGNED_AXES, wrist)]
    assert (~np.isnan(branches[:, :, 0]).all(axis=1)).tolist() == reachable
    assert sum(reachable) > len(T) / 2


def reaches(robot: RobotModel, point: Array) -> bool:
    """Return whether the wrist centre can be at a point, by the lengths of the arm only."""
    frames = kinematics.joint_frames(robot, np.zeros(6))
    X_J = frames[0]  # axis 1 with joint 1 at zero
    u = X_J[:3, :3].T @ frames[1, :3, 2]
    points = [
        X_J[:3, :3].T @ (p - X_J[:3, 3])
        for p in (frames[1, :3, 3], frames[2, :3, 3], frames[4, :3, 3], point)
    ]
    side = points[2] @ u
    x = np.sqrt(max(points[3][0] ** 2 + points[3][1] ** 2 - side**2, 0.0))
    if points[3][0] ** 2 + points[3][1] ** 2 < side**2:
        return False
    across = np.eye(3) - np.outer(u, u)
    upper, fore = (float(np.linalg.norm(across @ (b - a))) for a, b in pairwise(points[:3]))
    e_x = np.cross([0.0, 0.0, 1.0], u)
    spans = [np.hypot(s * x - points[0] @ e_x, points[3][2] - points[0][2]) for s in (1.0, -1.0)]
    return any(abs(upper - fore) <= span <= upper + fore for span in spans)


@pytest.mark.parametrize("joint_5", [0.0, pi])
def test_straight_wrists_are_solved(joint_5: float) -> None:
    Q = np.random.default_rng(7).uniform(-pi, pi, (500, 6))
    Q[:, 4] = joint_5
    branches = assert_branches_reach(ARMS[0], kinematics.forward_batch(ARMS[0], Q))
    assert (np.nanmin(apart(branches[:, :, :3], Q[:, np.newaxis, :3]), axis=1) < BRANCH_TOLERANCE).all()


@pytest.mark.parametrize("nearly", [0.0, 1e-12, 1e-9, 1e-7, 1e-4])
def test_stretched_elbows_and_nearly_straight_wrists_are_solved(nearly: float) -> None:
    stretched = -np.arctan2(0.4318, 0.0203)
    Q = np.random.default_rng(9).uniform(-pi, pi, (500, 6))
    Q[:, 2] = stretched + nearly
    Q[::2, 4] = nearly
    branches = assert_branches_reach(ARMS[0], kinematics.forward_batch(ARMS[0], Q))
    assert (~np.isnan(branches[:, :, 0])).any(axis=1).all()


def test_near_decides_the_joint_that_a_straight_wrist_leaves_free() -> None:
    robot = ARMS[0]
    q = np.array([0.3, 0.9, -2.8, 0.7, 0.0, -0.4])
    result = kinematics.inverse(robot, kinematics.forward(robot, q), IkOptions(near=q))
    assert apart(result.solutions, q).min() < BRANCH_TOLERANCE


def test_coinciding_branches_are_listed_once_and_fill_both_rows() -> None:
    robot = ARMS[0]
    q = np.array([0.3, -0.9, 0.2, 0.0, 0.0, -0.4])
    result = kinematics.inverse(robot, kinematics.forward(robot, q), IkOptions(limits=Limits.IGNORE))
    assert result.reaching == 8
    assert len(result.solutions) == 7
    np.testing.assert_array_equal(result.branches[6], result.branches[7])
