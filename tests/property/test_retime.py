"""Laws of slowing: no limit exceeded at any tick, never faster than planned, near the best."""

from functools import cache

import numpy as np
import pytest

from ropsim.motion import (
    Effort,
    Infeasible,
    JointBounds,
    NominalTime,
    RetimedTrajectory,
    retime,
    time_optimal,
)
from ropsim.spatial import Array
from support.examples import examples
from support.motions import Waves, body, most_of

SEEDS = range(examples(40))
ROUNDING = 1e-9  # relative; what counts as within a limit
TICK = 1e-3


def case(seed: int, wider: float = 1.0) -> tuple[Waves, JointBounds, Effort | None]:
    """Return a motion, bounds around what it asks, and torques in two of three cases."""
    random = np.random.default_rng(seed)
    n = int(random.integers(1, 7))
    motion = Waves(random, n, random.uniform(0.5, 3.0), 0.4, random.uniform(0.5, 1.5))
    factors = [random.uniform(*between, n) for between in ((0.5, 1.5), (0.4, 1.5), (0.6, 2.0))]
    speed, acceleration, jerk = (factor * most for factor, most in zip(factors, most_of(motion), strict=True))
    effort, torque = None, None
    if seed % 3:
        effort = body(random, n)
        points = motion.at(np.linspace(0.0, motion.duration, 500))
        creeping = np.abs(effort(points.q, points.d1 * 0.05, 0.0 * points.d2)).max(axis=0)
        going = np.abs(effort(points.q, points.d1, points.d2)).max(axis=0)
        torque = wider * np.maximum(going * random.uniform(0.6, 1.2, n), 1.3 * creeping)
    return motion, JointBounds(wider * speed, wider * acceleration, wider * jerk, torque), effort


@cache
def slowed(seed: int, wider: float = 1.0) -> RetimedTrajectory | Infeasible:
    motion, bounds, effort = case(seed, wider)
    return retime(motion, bounds, effort, TICK)


def clock_of(seed: int, wider: float = 1.0) -> NominalTime:
    found = slowed(seed, wider)
    assert isinstance(found, RetimedTrajectory), found
    return found.clock


@pytest.mark.parametrize("seed", SEEDS)
def test_no_limit_is_exceeded_at_any_control_tick(seed: int) -> None:
    motion, bounds, effort = case(seed)
    clock = clock_of(seed)
    ticks = np.asarray(np.arange(int(clock.duration / TICK) + 2) * TICK, dtype=np.float64)
    phi, rates, changes = clock.at(ticks)
    points = motion.at(phi)
    qd = points.d1 * rates[:, None]
    qdd = points.d2 * rates[:, None] ** 2 + points.d1 * changes[:, None]
    jerk = np.diff(np.vstack((0.0 * qdd[:1], qdd, 0.0 * qdd[:1])), axis=0) / TICK
    over = 1.0 + ROUNDING
    assert (np.abs(qd) <= bounds.speed * over).all()
    assert (np.abs(qdd) <= bounds.acceleration * over).all()
    assert (np.abs(jerk) <= bounds.jerk * over).all()
    if effort is not None and bounds.effort is not None:
        assert (np.abs(effort(points.q, qd, qdd)) <= bounds.effort * over).all()


@pytest.mark.parametrize("seed", SEEDS)
def test_motion_time_rises_from_0_to_the_end_and_never_faster_than_planned(seed: int) -> None:
    motion, clock = case(seed)[0], clock_of(seed)
    step = clock.duration / 50_000.0
    phi, rates, changes = clock.at(np.linspace(0.0, clock.duration, 50_001))
    assert (phi[0], phi[-1]) == (0.0, motion.duration)
    assert (np.diff(phi) >= 0.0).all()
    assert rates.min() > 0.0
    assert rates.max() <= 1.0 + 1e-12
    assert clock.duration >= motion.duration
    jumps = np.abs(
        np.diff(rates) - (changes[1:] + changes[:-1]) / 2.0 * step
    )  # of the rate, beside its slope
    assert jumps.max() <= 1e-9 + step * np.abs(np.diff(changes)).max()


@pytest.mark.parametrize("seed", SEEDS)
def test_wider_limits_never_cost_more_than_a_little(seed: int) -> None:
    assert clock_of(seed, 1.25).duration <= clock_of(seed).duration * (
        1.0 + 0.01
    )  # rounding differs by windows


@pytest.mark.parametrize("seed", SEEDS)
def test_slowed_parts_hold_all_that_is_slowed(seed: int) -> None:
    found = slowed(seed)
    assert isinstance(found, RetimedTrajectory)
    phi = np.linspace(0.0, case(seed)[0].duration, 3001)
    inside = np.zeros(len(phi), dtype=bool)
    for part in found.slowed:
        inside |= (phi >= part.start) & (phi <= part.end)
        assert 0.0 < part.share < 1.0
    rates = np.interp(phi, found.clock.phi, found.clock.rates)
    assert (rates[~inside] == 1.0).all()
    assert bool(found.slowed) == bool((rates < 1.0).any())


@pytest.mark.parametrize("seed", SEEDS)
def test_duration_is_near_that_of_the_fastest_motion_without_jerk_limits(seed: int) -> None:
    """At most the plan's rate and without jerk: a bound from below that no jerk-limited motion reaches."""
    motion, bounds, effort = case(seed)
    s = np.linspace(0.0, motion.duration, 4001)
    speeds = np.minimum(fastest(motion, bounds, effort, s), 1.0)
    best = float(np.sum(2.0 * s[1] / (speeds[1:] + speeds[:-1])[1:-1]))
    assert clock_of(seed).duration <= 1.15 * max(best, motion.duration)


def fastest(motion: Waves, bounds: JointBounds, effort: Effort | None, s: Array) -> Array:
    """Return the rates of the fastest motion, from rest to rest in motion time too, shape (m,)."""
    found = time_optimal(motion.at(s), s[1], bounds, effort)
    assert not isinstance(found, Infeasible)
    return found


def test_one_bad_place_does_not_slow_a_long_motion_elsewhere() -> None:
    """The same dip in a motion of 4 s and in one of 40 s costs the same time."""
    costs = []
    for duration in (4.0, 40.0):
        random = np.random.default_rng(7)
        motion = Waves(random, 3, duration, 0.2, 0.2)
        speed, acceleration, jerk = most_of(motion)
        bounds = JointBounds(speed * 0.9, acceleration * 2.0, jerk * 4.0)
        found = retime(motion, bounds, None, TICK)
        assert isinstance(found, RetimedTrajectory)
        costs.append((found.clock.duration - duration, sum(part.end - part.start for part in found.slowed)))
    for delay, length in costs:
        assert 0.0 < delay < 0.15 * length
