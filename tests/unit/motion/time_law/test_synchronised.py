"""Time-synchronised PTP: one time for all joints, a profile for each."""

import math
from types import FunctionType

import numpy as np
import pytest

from ropsim.motion import (
    JointMotionLimits,
    JointPath,
    ProfileError,
    ProfileLimits,
    SynchronisedJoints,
    durations,
    evaluate,
    plan_profile,
)
from ropsim.motion.testing import synchronised_kernel
from support.in_python import in_python

ROUNDING = 1e-12  # [rad], of coordinates of a few rad
LIMITS = JointMotionLimits(
    np.array([1.0, 2.0, 1.5]), np.array([4.0, 8.0, 2.0]), np.array([40.0, 80.0, 300.0])
)
START, END = np.array([0.1, -0.7, 0.4]), np.array([2.3, 1.1, 0.4])
MOVE = SynchronisedJoints(START, END, LIMITS)


def test_the_slowest_joint_gives_the_time() -> None:
    slowest = plan_profile(2.2, ProfileLimits(1.0, 4.0, 40.0))
    assert plan_profile(1.8, ProfileLimits(2.0, 8.0, 80.0)).duration < slowest.duration
    assert MOVE.length == pytest.approx(slowest.duration, rel=ROUNDING)


@pytest.mark.parametrize(("joint", "distance"), [(0, 2.2), (1, 1.8)])
def test_each_joint_follows_its_own_profile_stretched_to_the_time(joint: int, distance: float) -> None:
    own = ProfileLimits(LIMITS.speed[joint], LIMITS.acceleration[joint], LIMITS.jerk[joint])
    profile = plan_profile(distance, own)
    rate = profile.duration / MOVE.length
    t = np.linspace(0.0, MOVE.length, 101)
    points, (way, speed, acceleration) = MOVE.joints(t), evaluate(profile, rate * t)
    assert points.q[:, joint] == pytest.approx(START[joint] + way, abs=ROUNDING)
    assert points.d1[:, joint] == pytest.approx(rate * speed, abs=ROUNDING)
    inside = np.abs(t - MOVE.length / 2.0) > 1e-9  # there, a profile without constant speed turns over
    assert points.d2[inside, joint] == pytest.approx(rate**2 * acceleration[inside], abs=10.0 * ROUNDING)


def test_a_joint_that_is_where_it_should_be_stands_still() -> None:
    points = MOVE.joints(np.linspace(0.0, MOVE.length, 50))
    assert (points.q[:, 2] == 0.4).all()
    assert not points.d1[:, 2].any()
    assert not points.d2[:, 2].any()


def test_start_and_end_are_exact_and_at_rest_and_hold_outside() -> None:
    points = MOVE.joints(np.array([-1.0, 0.0, MOVE.length, MOVE.length + 1.0]))
    assert points.q.tolist() == [START.tolist()] * 2 + [END.tolist()] * 2
    assert not points.d1.any()
    assert not points.d2.any()


def test_its_time_law_walks_it_at_speed_one() -> None:
    t = np.linspace(0.0, MOVE.length, 7)
    rows = MOVE.own_law.at(t)
    assert MOVE.own_law.duration == MOVE.length
    assert rows.parameters.tolist() == t.tolist()
    assert rows.speeds[:-1].tolist() == [1.0] * 6
    assert MOVE.own_law.times_of(0, t).tolist() == t.tolist()


def test_derivatives_are_those_of_the_joint_coordinates() -> None:
    t, step = np.linspace(0.05, MOVE.length - 0.05, 40), 1e-5
    before, now, after = (MOVE.joints(t + shift) for shift in (-step, 0.0, step))
    assert now.d1 == pytest.approx((after.q - before.q) / (2.0 * step), abs=1e-7)
    assert now.d2 == pytest.approx((after.d1 - before.d1) / (2.0 * step), abs=1e-3)


def test_the_way_is_no_longer_in_time_than_with_one_profile_for_all_joints() -> None:
    assert MOVE.length <= durations(START, END[None], LIMITS)[0]


@pytest.mark.parametrize("way", [0.0, 5e-10])
def test_a_move_of_no_way_takes_no_time(way: float) -> None:
    move = SynchronisedJoints(START, START + way, LIMITS)
    assert move.length == 0.0
    assert move.joints(np.zeros(1)).q.tolist() == [START.tolist()]


def test_moves_with_the_same_content_are_equal() -> None:
    path: JointPath = SynchronisedJoints(START.copy(), END.copy(), LIMITS)
    assert path == MOVE
    assert path != SynchronisedJoints(END, START, LIMITS)


@pytest.mark.parametrize("value", [math.nan, math.inf])
def test_a_coordinate_that_is_no_number_is_refused(value: float) -> None:
    with pytest.raises(ProfileError, match="joint 1 has distance"):
        SynchronisedJoints(START, np.array([0.0, value, 0.0]), LIMITS)


@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
def test_a_limit_that_no_joint_can_have_is_refused(value: float) -> None:
    wrong = JointMotionLimits(np.array([1.0, value, 1.0]), LIMITS.acceleration, LIMITS.jerk)
    with pytest.raises(ProfileError, match="joint 1 has distance"):
        SynchronisedJoints(START, END, wrong)


@pytest.mark.parametrize("count", [2, 4])
def test_limits_of_another_number_of_joints_are_refused(count: int) -> None:
    ones = np.ones(count)
    with pytest.raises(ProfileError, match="one number of them"):
        SynchronisedJoints(START, END, JointMotionLimits(ones, ones, ones))


def test_compiled_or_not_the_motion_is_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    t = np.linspace(0.0, MOVE.length, 50)
    compiled = MOVE.joints(t)
    for module, name in ((synchronised_kernel, "plan_together"), (synchronised_kernel, "joint_rows")):
        plain = in_python(getattr(module, name))
        assert isinstance(plain, FunctionType)
        monkeypatch.setattr(module, name, plain)
    move = SynchronisedJoints(START, END, LIMITS)
    np.testing.assert_allclose(move.shapes, MOVE.shapes, rtol=ROUNDING)
    for found, expected in zip(
        (move.joints(t).q, move.joints(t).d1, move.joints(t).d2),
        (compiled.q, compiled.d1, compiled.d2),
        strict=True,
    ):
        np.testing.assert_allclose(found, expected, rtol=0.0, atol=ROUNDING)
