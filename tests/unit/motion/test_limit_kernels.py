"""Compiled loops of slowed motions give what whole columns give."""

import numpy as np
import pytest

from ropsim.motion.testing import (
    LEAST_RATE,
    creeping,
    divide,
    greatest_nearby,
    motion_time,
    parts_by_joints,
    parts_by_rate,
    timing_below,
    windows_last,
)
from ropsim.spatial import Array


@pytest.mark.parametrize("seed", range(5))
def test_ways_are_divided_by_the_lowest_rate_on_them_and_beside_them(seed: int) -> None:
    random = np.random.default_rng(seed)
    places, phi = np.linspace(0.0, 1.0, 21), np.sort(random.uniform(0.0, 1.0, 30))
    rates = 1.0 / 10.0 ** random.uniform(0.0, 2.5, 30)
    slow = np.ones(21)
    for place in range(21):
        near = (phi >= places[max(place - 1, 0)]) & (phi < places[min(place + 1, 20)])
        slow[place] = rates[near].min(initial=1.0)
    expected = np.minimum(np.ceil(1.0 / (1.03 * np.minimum(slow[1:], slow[:-1]))), 64.0)
    parts = np.empty(20)
    parts_by_rate(places, phi, rates, parts)
    assert (parts == expected).all()
    divided = np.empty(int(parts.sum()) + 1)
    divide(places, parts, divided)
    cells = [np.linspace(a, b, int(n) + 1)[:-1] for a, b, n in zip(places, places[1:], parts, strict=False)]
    assert divided == pytest.approx(np.append(np.concatenate(cells), 1.0), abs=1e-15)
    assert set(places) <= set(divided)


@pytest.mark.parametrize("seed", range(5))
def test_ways_are_divided_by_joints_that_go_far_and_bounds_that_change(seed: int) -> None:
    random = np.random.default_rng(seed)
    places = np.cumsum(10.0 ** random.uniform(-8.0, -2.0, 40))
    q, d1, speed = (
        random.normal(size=(40, 3)) * 0.05,
        random.normal(size=(40, 3)),
        random.uniform(0.5, 2.0, 3),
    )
    lasts = np.max(np.abs(np.diff(q, axis=0)) / speed, axis=1)
    allowed = 1.0 / np.maximum(np.max(np.abs(d1) / speed, axis=1), 1.0)
    steep = np.abs(np.diff(np.log(allowed)))
    expected = np.clip(np.ceil(np.maximum(lasts / (1.5 * 4e-3), steep / 0.4)), 1.0, 64.0)
    expected[np.diff(places) < 1e-4 * 4e-3] = 1.0
    parts = np.empty(39)
    parts_by_joints(places, q, d1, speed, 4e-3, parts)
    assert (parts == expected).all()


def test_creeping_joints_have_at_most_their_share_of_speed() -> None:
    d1, speed = np.random.default_rng(6).normal(size=(50, 3)) * 0.5, np.array([0.1, 1.0, np.inf])
    d1[:, 1] = 0.0  # a joint that rests has no share
    d1[20] *= 1e-6
    most = np.minimum(speed, np.abs(d1).max(axis=0))
    slow = np.array([max(0.02, np.max(np.abs(row[[0, 2]]) / most[[0, 2]])) for row in d1])
    found = np.empty((50, 3))
    creeping(d1, speed, found)
    assert found == pytest.approx(d1 * (0.02 / slow)[:, None], rel=1e-14)


def mean_within(sigma: Array, values: Array, half: float) -> tuple[Array, Array]:
    """Return the means of what is linear between places within ±half of each, and their slopes."""
    until = np.concatenate(([0.0], np.cumsum(np.diff(sigma) * (values[1:] + values[:-1]) / 2.0)))
    ends, areas = [], []
    for place in (sigma - half, sigma + half):
        k = np.clip(np.searchsorted(sigma, place, "right") - 1, 0, len(sigma) - 2)
        past = place - sigma[k]
        end = values[k] + past * (values[k + 1] - values[k]) / (sigma[k + 1] - sigma[k])
        ends.append(end)
        areas.append(until[k] + past * (values[k] + end) / 2.0)
    return (areas[1] - areas[0]) / (2.0 * half), (ends[1] - ends[0]) / (2.0 * half)


@pytest.mark.parametrize("seed", range(5))
def test_a_smooth_course_is_that_of_whole_columns(seed: int) -> None:
    random, m = np.random.default_rng(seed), 300
    steps = random.uniform(0.001, 0.01, m - 1)
    places = np.concatenate(([0.0], np.cumsum(steps)))
    x = np.clip(1.2 + np.cumsum(random.normal(size=m)) * 0.1, 1e-9, 1.0)
    lasting, width = random.uniform(0.01, 0.2, m), random.uniform(1.0, 3.0, m)
    rates = np.maximum(np.sqrt(x), LEAST_RATE)
    cells = np.maximum(np.append(steps, 0.0), np.append(0.0, steps))
    widths = np.maximum(lasting * rates, 5.0 * cells) * width
    way = np.abs(places[:, None] - places)
    widths = np.maximum((widths + 0.6 * way).min(axis=1), cells)
    sigma = np.concatenate(([0.0], np.cumsum(steps * (1.0 / widths[1:] + 1.0 / widths[:-1]) / 2.0)))
    padded = np.concatenate(([-3.0], sigma, [sigma[-1] + 3.0]))
    lack, (room, most) = np.pad(1.0 - rates, 1, mode="edge"), np.empty((2, m + 2))
    greatest_nearby(padded, lack, room, most)
    mean, slope = mean_within(padded, mean_within(padded, most, 2.0 / 3.0)[0], 1.0 / 3.0)
    smooth = 1.0 - mean[1:-1]
    expected = motion_time(places, smooth, -smooth * slope[1:-1] / widths)
    found_sigma, clock = timing_below(places, x, lasting, width)
    assert found_sigma == pytest.approx(sigma, rel=1e-12)
    assert clock.rates == pytest.approx(expected.rates, rel=1e-9)
    assert clock.times == pytest.approx(expected.times, rel=1e-9)
    assert clock.changes == pytest.approx(expected.changes, abs=1e-9 * np.abs(expected.changes).max())
    assert (clock.rates <= rates * (1.0 + 1e-2)).all()  # places are few for their windows here


@pytest.mark.parametrize("seed", range(5))
def test_windows_last_as_long_as_jerk_needs_to_swing_acceleration(seed: int) -> None:
    random = np.random.default_rng(seed)
    first, most, jerk = random.normal(size=(30, 3)), *random.uniform(1.0, 9.0, (2, 30, 3))
    way, lasting, same = np.abs(first), *np.empty((2, 30))
    expected = 0.5 * np.minimum((most / way).min(axis=1) * (way / jerk).max(axis=1), 0.7)
    windows_last(first, most, jerk, 0.9, 0.7, lasting)
    assert lasting == pytest.approx(expected, rel=1e-12)
    windows_last(first, most[:1].copy(), jerk[:1].copy(), 0.9, 0.7, same)
    windows_last(first, np.tile(most[:1], (30, 1)), np.tile(jerk[:1], (30, 1)), 0.9, 0.7, lasting)
    assert (same == lasting).all()
