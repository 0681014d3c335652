from dataclasses import replace
from functools import partial
from math import pi, radians

import numpy as np
import pytest

from ropsim import kinematics, robots
from ropsim.kinematics import IkOptions, IkStatus, Limits, branch, inverse, inverse_batch, posture, solver_of
from ropsim.kinematics.testing import EightRows, SphericalWristSolver, spherical_wrist_kernel
from ropsim.spatial import Array, Pose
from support.in_python import in_python

PUMA = robots.load("puma560")
POSE_TOLERANCE = 1e-9
"""What the inverse kinematics promises [m, entries of the rotation matrix]."""
REACHED = kinematics.forward(PUMA, PUMA.home)


def beside(x: float, y: float, z: float) -> Pose:
    """Return a pose at (x, y, z) with the tool straight down."""
    return Pose(np.array([x, y, z]), np.array([0.0, 1.0, 0.0, 0.0]))


def reaches(q: Array, pose: Pose) -> bool:
    return bool(np.abs(kinematics.forward(PUMA, q).matrix() - pose.matrix()).max() < POSE_TOLERANCE)


def test_solutions_reach_the_pose_within_the_limits() -> None:
    result = inverse(PUMA, REACHED)
    assert result.status is IkStatus.FOUND
    for q in result.solutions:
        assert reaches(q, REACHED)
        assert (PUMA.lower_limits <= q).all()
        assert (q <= PUMA.upper_limits).all()


def test_one_solution_is_the_configuration_that_made_the_pose() -> None:
    result = inverse(PUMA, REACHED)
    assert np.abs(result.solutions - PUMA.home).max(axis=1).min() < 1e-9


def test_postures_belong_to_the_solutions() -> None:
    result = inverse(PUMA, REACHED)
    assert len(result.postures) == len(result.turns) == len(result.solutions) > 0
    assert tuple(posture(PUMA, q) for q in result.solutions) == result.postures


def test_a_branch_is_found_by_its_posture() -> None:
    result = inverse(PUMA, REACHED)
    q = branch(result, result.postures[0])
    assert q is not None
    np.testing.assert_allclose(q, result.solutions[0])


def test_turns_are_further_ways_within_the_limits() -> None:
    """Only joint 6 of the PUMA, which turns by ±266°, reaches angles beyond 94° in a second turn."""
    q = np.array([0.2, 1.2, -2.8, radians(120.0), -0.8, radians(-100.0)])
    pose = kinematics.forward(PUMA, q)
    result = inverse(PUMA, pose, IkOptions())
    (row,) = [i for i, found in enumerate(result.solutions) if np.abs(found - q).max() < 1e-9]
    expected = q + 2.0 * pi * np.array([[0, 0, 0, 0, 0, 1]])
    np.testing.assert_allclose(result.turns[row], expected, atol=1e-9)
    assert all(reaches(turned, pose) for turned in result.turns[row])


def test_an_angle_is_turned_where_only_another_turn_is_within_the_limits() -> None:
    joints = list(PUMA.joints)
    joints[3] = replace(joints[3], lower=pi, upper=3.0 * pi)
    robot = replace(PUMA, joints=tuple(joints))
    result = inverse(robot, REACHED)
    assert result.status is IkStatus.FOUND
    assert ((result.solutions[:, 3] >= pi) & (result.solutions[:, 3] <= 3.0 * pi)).all()
    assert all(reaches(q, REACHED) for q in result.solutions)


@pytest.mark.parametrize("rounding", [-1e-10, 1e-10])
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_coordinate_on_its_limit_is_a_solution_whatever_its_rounding(side: float, rounding: float) -> None:
    q = np.array([side * radians(160.0) + rounding, 1.0, -2.8, 0.2, -0.8, 0.1])
    result = inverse(PUMA, kinematics.forward(PUMA, q))
    nearest = result.solutions[np.abs(result.solutions - q).max(axis=1).argmin()]
    np.testing.assert_allclose(nearest, q, atol=1e-9)
    assert PUMA.lower_limits[0] <= nearest[0] <= PUMA.upper_limits[0]


def test_ignored_limits_give_all_branches_and_no_turns() -> None:
    result = inverse(PUMA, REACHED, IkOptions(limits=Limits.IGNORE))
    assert result.postures == result.names == solver_of(PUMA).postures
    assert all(turns.shape == (0, 6) for turns in result.turns)
    np.testing.assert_array_equal(result.solutions, result.branches)


def test_a_pose_too_far_away_says_how_far() -> None:
    result = inverse(PUMA, beside(1.0, 0.0, 0.67183))
    assert result.status is IkStatus.OUT_OF_REACH
    assert result.solutions.shape == (0, 6)
    assert result.reach is not None
    assert result.reach.axis == "2"
    assert result.reach.distance == pytest.approx(np.sqrt(1.0 - 0.15005**2))
    assert result.reach.longest == pytest.approx(0.864077, abs=5e-7)


def test_a_pose_inside_the_lateral_offset_is_out_of_reach_of_axis_1() -> None:
    result = inverse(PUMA, beside(0.1, 0.0, 1.0))
    assert result.status is IkStatus.OUT_OF_REACH
    assert result.reach is not None
    assert result.reach.axis == "1"
    assert result.reach.distance == pytest.approx(0.1)
    assert result.reach.shortest == pytest.approx(0.15005)


def test_out_of_limits_names_the_joints_of_the_nearest_branch() -> None:
    pose = kinematics.forward(PUMA, [radians(165.0), -0.5, -3.5, 0.2, -0.8, 0.1])
    result = inverse(PUMA, pose)
    assert result.status is IkStatus.OUT_OF_LIMITS
    assert result.reaching == 8
    violation = result.violations[0]
    assert (violation.joint, violation.name) == (0, "1")
    assert violation.value == pytest.approx(radians(165.0))
    assert violation.limit == pytest.approx(radians(160.0))
    assert violation.excess == pytest.approx(radians(5.0))


def test_violations_are_listed_worst_first() -> None:
    q = [radians(-170.0), -1.0, -3.8, 0.2, -0.8, 0.1]
    result = inverse(PUMA, kinematics.forward(PUMA, q))
    assert result.status is IkStatus.OUT_OF_LIMITS
    excesses = [violation.excess for violation in result.violations]
    assert excesses == sorted(excesses, reverse=True)
    assert len(excesses) >= 2


def test_batch_rows_are_the_branches_of_single_poses() -> None:
    Q = np.random.default_rng(3).uniform(-2.0, 2.0, (5, 6))
    T = kinematics.forward_batch(PUMA, Q)
    batch = kinematics.inverse_batch(PUMA, T)
    for matrix, rows in zip(T, batch, strict=True):
        single = inverse(PUMA, Pose.from_matrix(matrix)).branches
        np.testing.assert_allclose(single, rows, atol=1e-7)


def test_poses_out_of_reach_are_nan_and_leave_their_neighbours_alone() -> None:
    T = np.stack(
        [REACHED.matrix(), beside(3.0, 0.0, 0.0).matrix(), np.full((4, 4), np.nan), REACHED.matrix()]
    )
    rows = kinematics.inverse_batch(PUMA, T)
    assert np.isnan(rows[1:3]).all()
    assert np.isfinite(rows[[0, 3]]).all()


@pytest.mark.parametrize("broken", ["scaled", "mirrored"])
def test_matrices_that_are_no_poses_have_no_branches(broken: str) -> None:
    T = REACHED.matrix()
    T[:3, :3] *= 1.01 if broken == "scaled" else -1.0
    assert np.isnan(kinematics.inverse_batch(PUMA, T[np.newaxis])).all()


def test_no_poses_give_no_rows() -> None:
    assert kinematics.inverse_batch(PUMA, np.empty((0, 4, 4))).shape == (0, 8, 6)


def test_a_single_matrix_is_no_batch() -> None:
    with pytest.raises(
        kinematics.ArrayShapeError, match=r"`T` has the shape \(4, 4\), allowed is \(k, 4, 4\)"
    ):
        kinematics.inverse_batch(PUMA, np.eye(4))


def test_near_must_have_one_coordinate_per_joint() -> None:
    with pytest.raises(kinematics.ArrayShapeError):
        inverse(PUMA, REACHED, IkOptions(near=np.zeros(5)))


def test_the_kernel_does_the_same_without_numba() -> None:
    solver, T, near = solver_of(PUMA), REACHED.matrix()[np.newaxis], np.zeros(6)
    assert isinstance(solver, SphericalWristSolver)
    rows = spherical_wrist_kernel.inverse_rows
    function = partial(in_python(rows), solver.strict)
    plain = EightRows(solver.chain, function, function, None, spherical_wrist_kernel.ROOM_OF_ROWS)
    one = np.empty((1, 8, 6))
    plain.solving(T, one)(near)
    np.testing.assert_array_equal(one, plain.branches(T, near))
    np.testing.assert_allclose(one, inverse_batch(PUMA, T), atol=1e-12)


def test_later_calls_leave_the_answers_of_earlier_ones_as_they_were() -> None:
    """One pose is solved where the one before it was: what is returned is nobody else's."""
    q = np.array([0.2, 1.2, -2.8, radians(120.0), -0.8, radians(-100.0)])
    first = inverse(PUMA, kinematics.forward(PUMA, q))
    arrays = (first.branches, first.solutions, *first.turns)
    assert any(len(turns) for turns in first.turns)
    before = [one.copy() for one in arrays]
    for other in (REACHED, beside(0.4, 0.1, 0.2), beside(9.0, 0.0, 0.0)):
        inverse(PUMA, other)
    for one, was in zip(arrays, before, strict=True):
        np.testing.assert_array_equal(one, was)
