"""A planned motion slowed where it asks too much: hand-made cases, causes, refusals, bad input."""

import numpy as np
import pytest

from ropsim.motion import (
    Infeasible,
    JointBounds,
    JointPoints,
    PathMotion,
    ProfileError,
    ProfileLimits,
    Quantity,
    RetimedTrajectory,
    evaluate,
    no_path_motion,
    plan_profile,
    retime,
)
from ropsim.spatial import Array
from support.motions import Passing

TICK = 1e-3
ENDLESS = np.inf


class Profiled:
    """One joint on a jerk-limited profile."""

    def __init__(self, distance: float, limits: ProfileLimits) -> None:
        self._profile = plan_profile(distance, limits)
        self.duration = self._profile.duration

    def at(self, phi: Array) -> JointPoints:
        return JointPoints(*(each[:, None] for each in evaluate(self._profile, phi)))

    def path_motion(self, phi: Array) -> PathMotion:
        return no_path_motion(len(phi))


def one(speed: float, acceleration: float, jerk: float, effort: float | None = None) -> JointBounds:
    torque = None if effort is None else np.array([effort])
    return JointBounds(np.array([speed]), np.array([acceleration]), np.array([jerk]), torque)


def kept(found: RetimedTrajectory | Infeasible) -> RetimedTrajectory:
    assert isinstance(found, RetimedTrajectory), found
    return found


MOTION = Profiled(3.0, ProfileLimits(2.0, 8.0, 80.0))


def test_a_plan_on_its_very_limits_is_left_as_it_is_bit_by_bit() -> None:
    found = kept(retime(MOTION, one(2.0, 8.0, 80.0), None, TICK))
    times = np.random.default_rng(1).uniform(0.0, MOTION.duration, 1000)
    assert found.slowed == ()
    assert found.clock.at(times)[0].tolist() == times.tolist()
    assert found.clock.duration == MOTION.duration


def test_rows_are_the_motion_at_all_control_ticks() -> None:
    found = kept(retime(MOTION, one(1.5, 8.0, 80.0), None, TICK))
    ticks = np.asarray(np.arange(len(found.rows.q)) * TICK, dtype=np.float64)
    assert ticks[-2] < found.clock.duration <= ticks[-1]
    assert found.phi.tolist() == found.clock.at(ticks)[0].tolist()
    phi, rates, changes = found.clock.at(ticks)
    points = MOTION.at(phi)
    assert found.rows.q.tolist() == points.q.tolist()
    assert np.abs(found.rows.d1[:, 0] - points.d1[:, 0] * rates).max() < 1e-12
    assert np.abs(found.rows.d2[:, 0] - points.d2[:, 0] * rates**2 - points.d1[:, 0] * changes).max() < 1e-12


def test_a_slower_joint_reaches_its_limit_and_the_part_is_told() -> None:
    found = kept(retime(MOTION, one(1.5, 8.0, 80.0), None, TICK))
    assert found.rows.d1.max() == pytest.approx(1.5, rel=1e-6)
    (part,) = found.slowed
    assert (part.joint, part.quantity) == (0, Quantity.SPEED)
    assert part.share == pytest.approx(0.75, rel=1e-6)
    assert 0.0 < part.start < part.end < MOTION.duration
    best = plan_profile(3.0, ProfileLimits(1.5, 8.0, 80.0)).duration
    assert best <= found.clock.duration <= 1.03 * best  # measured: 1.4 % above


@pytest.mark.parametrize(
    ("bounds", "quantity"),
    [
        (one(ENDLESS, 4.0, ENDLESS), Quantity.ACCELERATION),
        (one(ENDLESS, ENDLESS, 40.0), Quantity.JERK),
        (one(1.0, 8.0, 80.0), Quantity.SPEED),
    ],
)
def test_the_quantity_that_binds_is_named(bounds: JointBounds, quantity: Quantity) -> None:
    found = kept(retime(MOTION, bounds, None, TICK))
    assert {part.quantity for part in found.slowed} == {quantity}


def test_a_pendulum_with_little_torque_is_slowed_where_it_must_lift() -> None:
    """m·l²·qdd + m·g·l·sin(q): up through the horizontal, where gravity takes 9.81 of 10.5 N m."""

    def effort(q: Array, _qd: Array, qdd: Array) -> Array:
        return np.asarray(qdd + 9.81 * np.sin(q))

    lift = Profiled(0.9 * np.pi, ProfileLimits(4.0, 9.0, 90.0))
    bounds = one(5.0, 50.0, 1000.0, 10.5)
    found = kept(retime(lift, bounds, effort, TICK))
    torque = effort(found.rows.q, found.rows.d1, found.rows.d2)
    assert np.abs(torque).max() <= 10.5 * (1.0 + 1e-9)
    assert np.abs(torque).max() >= 10.5 * 0.97
    assert {part.quantity for part in found.slowed} == {Quantity.TORQUE}
    assert found.slowed[0].start > 0.0  # it starts as planned: at the bottom gravity takes nothing


def test_what_gravity_alone_forbids_is_refused_at_the_first_place() -> None:
    def effort(q: Array, _qd: Array, qdd: Array) -> Array:
        return np.asarray(qdd + 9.81 * np.sin(q))

    found = retime(
        Profiled(np.pi / 2.0, ProfileLimits(2.0, 8.0, 80.0)), one(5.0, 50.0, 1000.0, 9.0), effort, TICK
    )
    assert isinstance(found, Infeasible)
    assert (found.joint, found.quantity, found.limit) == (0, Quantity.TORQUE, 9.0)
    place = Profiled(np.pi / 2.0, ProfileLimits(2.0, 8.0, 80.0)).at(np.array([found.phi])).q[0, 0]
    assert 9.81 * np.sin(place) == pytest.approx(9.0, abs=9.81 * 2.0 * 4e-3)  # first place of the grid behind
    assert found.value == pytest.approx(9.81 * np.sin(place), rel=1e-9)


@pytest.mark.parametrize("width", [0.2, 0.05, 0.01, 0.002])
def test_half_a_turn_within_a_short_way_is_gone_slowly_and_only_there(width: float) -> None:
    motion = Passing(3.0, width)
    bounds = JointBounds(np.array([2.0, 3.0]), np.array([10.0, 30.0]), np.array([100.0, 300.0]))
    found = kept(retime(motion, bounds, None, TICK))
    (part,) = found.slowed
    assert part.joint == 1
    assert part.share == pytest.approx(3.0 * width / (140.0 / 64.0), rel=0.02)  # speed limit midway
    assert found.clock.at(np.array([0.2, found.clock.duration - 0.2]))[1].tolist() == [1.0, 1.0]


def test_torque_that_only_braking_takes_is_kept_where_another_limit_slows_the_motion() -> None:
    """The plan takes little torque; to turn the other joint around, the first one is braked."""

    def effort(_q: Array, _qd: Array, qdd: Array) -> Array:
        return np.asarray(qdd * np.array([1.0, 0.0]))

    motion, limits = Passing(3.0, 0.05), (np.array([2.0, 3.0]), np.array([60.0, 300.0]), np.full(2, 3e3))
    plain = np.abs(motion.at(np.linspace(0.0, motion.duration, 3000)).d2[:, 0]).max()
    torque = np.array([1.05 * plain, 1.0])
    free = kept(retime(motion, JointBounds(*limits), effort, TICK))
    assert np.abs(free.rows.d2[:, 0]).max() > 1.5 * torque[0]
    found = kept(retime(motion, JointBounds(*limits, torque), effort, TICK))
    assert np.abs(found.rows.d2[:, 0]).max() <= torque[0] * (1.0 + 1e-9)
    assert found.clock.duration > free.clock.duration


def test_a_motion_that_would_take_minutes_longer_is_refused() -> None:
    found = retime(MOTION, one(0.004, 8.0, 80.0), None, TICK)
    assert isinstance(found, Infeasible)
    assert (found.joint, found.quantity, found.limit) == (0, Quantity.SPEED, 0.004)


class Wound:
    """A joint that turns quickly on the middle of a straight path, which is walked within its own limits."""

    limits = ProfileLimits(0.5, 2.0, 20.0)

    def __init__(self) -> None:
        self._profile = plan_profile(1.0, self.limits)
        self.duration = self._profile.duration

    def at(self, phi: Array) -> JointPoints:
        s, v, a = (each[:, None] for each in evaluate(self._profile, phi))
        z = np.tanh((s - 0.5) / 0.05)
        d1, d2 = 1.0 + 8.0 * (1.0 - z**2), -16.0 / 0.05 * z * (1.0 - z**2)
        return JointPoints(s + 0.4 * z, d1 * v, d2 * v**2 + d1 * a)

    def path_motion(self, phi: Array) -> PathMotion:
        _, v, a = evaluate(self._profile, phi)
        most = (np.full((len(phi), 1), each) for each in (self.limits.acceleration, self.limits.jerk))
        return PathMotion(v[:, None], a[:, None], *most)


def test_a_path_keeps_its_own_limits_where_a_joint_slows_it() -> None:
    motion = Wound()
    found = kept(retime(motion, one(1.5, 30.0, 1000.0), None, TICK))
    (part,) = found.slowed
    assert part.share < 0.4
    ways = motion.path_motion(found.phi)
    times: Array = TICK * np.arange(float(len(found.phi)))
    _, w, c = found.clock.at(times)
    acceleration = ways.accelerations[:, 0] * w**2 + ways.speeds[:, 0] * c
    assert np.abs(acceleration).max() <= motion.limits.acceleration * (1.0 + 1e-9)
    assert np.abs(np.diff(acceleration)).max() / TICK <= motion.limits.jerk * (1.0 + 1e-9)
    assert np.abs(found.rows.d1).max() <= 1.5 * (1.0 + 1e-9)


class Broken:
    """A motion that is no number from a place on."""

    duration = 1.0

    def at(self, phi: Array) -> JointPoints:
        q = np.where(phi < 0.5, 0.0, np.nan)[:, None]
        return JointPoints(q, q, q)

    def path_motion(self, phi: Array) -> PathMotion:
        return no_path_motion(len(phi))


def test_bad_input_is_refused_in_words() -> None:
    with pytest.raises(ProfileError, match=r"at tick 500, allowed are finite"):
        retime(Broken(), one(1.0, 1.0, 1.0), None, TICK)
    with pytest.raises(ProfileError, match="control tick 0 s"):
        retime(MOTION, one(1.0, 1.0, 1.0), None, 0.0)
    with pytest.raises(ProfileError, match="grid nan s"):
        retime(MOTION, one(1.0, 1.0, 1.0), None, TICK, float("nan"))
    still = Profiled(0.0, ProfileLimits(1.0, 1.0, 1.0))
    with pytest.raises(ProfileError, match="duration is 0 s"):
        retime(still, one(1.0, 1.0, 1.0), None, TICK)
    with pytest.raises(ProfileError, match="the same numbers"):
        retime(Passing(1.0, 0.1), one(1.0, 1.0, 1.0), None, TICK)
    with pytest.raises(ProfileError, match="torques are"):
        retime(MOTION, one(1.0, 1.0, 1.0, 1.0), lambda q, _qd, _qdd: np.full_like(q, np.nan), TICK)


@pytest.mark.parametrize("value", [0.0, -1.0, float("nan")])
def test_bounds_that_are_not_above_0_are_refused(value: float) -> None:
    with pytest.raises(ProfileError, match="bounds of jerk"):
        one(1.0, 1.0, value)
