"""Inverse kinematics of robots with external axes: those stand still, the arm is solved in its moved base."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import (
    ArrayShapeError,
    IkOptions,
    IkStatus,
    Limits,
    NotFiniteError,
    forward,
    forward_batch,
    inverse,
    inverse_batch,
    inverse_path,
    posture,
    singular_distances,
    solver_of,
)
from ropsim.model import Coupling, MechanismError, RobotModel, beside, on_track
from ropsim.spatial import Pose, frozen
from support.arms import random_arm

PUMA = robots.load("puma560")
TABLE = robots.turntable(0.8)
FAR = Pose(np.array([1.5, 0.4, 0.0]))
ARMS = [PUMA, robots.load("palletizer"), robots.load("scara"), random_arm(3, "RRRRRR")]
ROUNDING = 1e-9


def station(arm: RobotModel) -> RobotModel:
    return beside(on_track(replace(arm, drives=()), robots.linear_track(4.0)), TABLE, FAR)


@pytest.mark.parametrize("arm", ARMS, ids=lambda arm: str(arm.name))
def test_the_answers_are_those_of_the_arm_with_the_external_axes_beside_them(arm: RobotModel) -> None:
    whole = station(arm)
    q = np.array([*(arm.home + 0.02), 0.7, -0.4])
    found = inverse(whole, forward(whole, q), IkOptions(Limits.IGNORE, near=frozen(q)))
    alone = inverse(arm, forward(arm, q[:-2]), IkOptions(Limits.IGNORE, near=frozen(q[:-2])))
    assert found.status is IkStatus.FOUND
    assert (found.postures, found.names) == (alone.postures, alone.names)
    np.testing.assert_allclose(found.solutions[:, :-2], alone.solutions, rtol=0, atol=1e-7)
    assert (found.solutions[:, -2:] == q[-2:]).all()
    assert solver_of(whole).name == solver_of(arm).name
    assert posture(whole, q) == posture(arm, q[:-2])
    reached = forward_batch(whole, found.solutions)
    np.testing.assert_allclose(reached[0], forward(whole, q).matrix(), rtol=0, atol=1e-5)


def test_without_a_place_to_hold_them_external_axes_are_at_home() -> None:
    whole = replace(station(PUMA), home=frozen([*PUMA.home, 0.3, 0.1]))
    found = inverse(whole, forward(whole, whole.home))
    assert np.abs(found.solutions - whole.home).max(axis=1).min() < ROUNDING
    rows = inverse_batch(whole, forward_batch(whole, whole.home[np.newaxis]))[0]
    assert np.nanmin(np.abs(rows - whole.home).max(axis=1)) < ROUNDING


def test_many_poses_are_solved_where_the_external_axes_stand() -> None:
    whole = station(PUMA)
    Q = np.tile([*PUMA.home, 0.7, -0.4], (5, 1))
    Q[:, 0] = np.linspace(-0.5, 0.5, 5)
    rows = inverse_batch(whole, forward_batch(whole, Q), Q[0])
    assert rows.shape == (5, 8, 8)
    apart = rows - Q[:, np.newaxis]
    apart -= 2.0 * np.pi * np.round(apart / (2.0 * np.pi))
    assert np.nanmin(np.abs(apart).max(axis=2), axis=1).max() < ROUNDING
    assert (np.isnan(rows[..., 6]) == np.isnan(rows[..., 0])).all()


def test_many_poses_are_solved_where_the_external_axes_are_at_each_of_them() -> None:
    whole = station(PUMA)
    Q = np.tile([*PUMA.home, 0.7, -0.4], (5, 1))
    Q[:, 0], Q[:, 6], Q[:, 7] = np.linspace(-0.5, 0.5, 5), np.linspace(0.1, 0.9, 5), np.linspace(-2.0, 2.0, 5)
    rows = inverse_batch(whole, forward_batch(whole, Q), Q)
    apart = rows - Q[:, np.newaxis]
    apart -= 2.0 * np.pi * np.round(apart / (2.0 * np.pi))
    assert np.nanmin(np.abs(apart).max(axis=2), axis=1).max() < ROUNDING
    present = ~np.isnan(rows[..., 0])
    assert (rows[..., 6:] == Q[:, np.newaxis, 6:])[present].all()
    with pytest.raises(ArrayShapeError):
        inverse_batch(whole, forward_batch(whole, Q), Q[:, :7])
    with pytest.raises(NotFiniteError):
        inverse_batch(whole, forward_batch(whole, Q), np.full(Q.shape, np.nan))


def test_a_path_is_followed_with_the_track_moving() -> None:
    whole = station(PUMA)
    Q = np.tile([*PUMA.home, 0.7, -0.4], (50, 1))
    Q[:, :6] += np.linspace(0.0, 0.2, 50)[:, np.newaxis]
    Q[:, 6:] += np.linspace(0.0, 0.5, 50)[:, np.newaxis]
    found = inverse_path(whole, forward_batch(whole, Q[1:]), Q[0], Q[1:])
    np.testing.assert_allclose(found, Q[1:], rtol=0, atol=1e-8)
    assert (found[:, 6:] == Q[1:, 6:]).all()


def test_a_path_is_followed_with_the_track_standing_still() -> None:
    whole = station(PUMA)
    Q = np.tile([*PUMA.home, 0.7, -0.4], (50, 1))
    Q[:, :6] += np.linspace(0.0, 0.2, 50)[:, np.newaxis]
    found = inverse_path(whole, forward_batch(whole, Q[1:]), Q[0])
    np.testing.assert_allclose(found, Q[1:], rtol=0, atol=1e-8)


def test_limits_are_told_of_the_axis_of_the_station_that_has_them() -> None:
    whole = station(PUMA)
    beyond = np.array([*PUMA.home, 0.7, 0.0])
    beyond[2] += -0.9
    found = inverse(whole, forward(whole, beyond), IkOptions(near=frozen(beyond)))
    alone = inverse(PUMA, forward(PUMA, beyond[:6]), IkOptions(near=frozen(beyond[:6])))
    assert found.status is alone.status is IkStatus.OUT_OF_LIMITS
    assert [one.name for one in found.violations] == [one.name for one in alone.violations]
    assert all(whole.axis_joints[one.joint].name == one.name for one in found.violations)


def test_singularities_are_those_of_the_arm() -> None:
    whole = station(PUMA)
    assert singular_distances(whole, [*PUMA.home, 0.7, -0.4]) == singular_distances(PUMA, PUMA.home)


def test_a_joint_that_follows_track_and_arm_is_refused() -> None:
    whole = station(PUMA)
    last = len(whole.joints)  # a rod that follows both
    rod = replace(whole.joints[-1], name="rod", parent=last - 1)
    mixed = replace(
        whole,
        joints=(*whole.joints, rod),
        links=(*whole.links, whole.links[-1]),
        couplings=(Coupling(last - 1, ((0, 1.0), (1, 1.0))),),
    )
    with pytest.raises(MechanismError, match="X829"):
        inverse(mixed, forward(mixed, mixed.home))


def test_an_arm_on_a_table_on_a_track_is_solved_where_its_base_is() -> None:
    turning = on_track(PUMA, TABLE, Pose(np.array([0.3, 0.1, 0.0])))
    whole = on_track(turning, robots.linear_track(4.0))
    assert [joint.name for joint in whole.axis_joints][6:] == ["E1", "E2"]
    q = np.array([*PUMA.home, 1.1, 0.8])
    found = inverse(whole, forward(whole, q), IkOptions(near=frozen(q)))
    assert np.abs(found.solutions - q).max(axis=1).min() < ROUNDING
    rows = inverse_batch(whole, forward_batch(whole, q[np.newaxis]), q)[0]
    reached = forward_batch(whole, rows[~np.isnan(rows[:, 0])])
    expected = np.tile(forward(whole, q).matrix(), (len(reached), 1, 1))
    np.testing.assert_allclose(reached, expected, rtol=0, atol=ROUNDING)
