"""Compiled loops of slowed motions give what whole columns give."""

import numpy as np
import pytest

from ropsim.motion.limits.demand_kernel import creeping
from ropsim.motion.limits.grid_kernel import divide, parts_by_joints, parts_by_rate


@pytest.mark.parametrize("seed", range(5))
def test_ways_are_divided_by_the_lowest_rate_on_them_and_beside_them(seed: int) -> None:
    random = np.random.default_rng(seed)
    places, phi = np.linspace(0.0, 1.0, 21), np.sort(random.uniform(0.0, 1.0, 30))
    rates = 1.0 / 10.0 ** random.uniform(0.0, 2.5, 30)
    slow = np.ones(21)
    for place in range(21):
        near = (phi >= places[max(place - 1, 0)]) & (phi < places[min(place + 1, 20)])
        slow[place] = rates[near].min(initial=1.0)
    expected = np.minimum(np.ceil(1.0 / np.minimum(slow[1:], slow[:-1])), 64.0)
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
