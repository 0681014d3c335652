"""What courses lack at their places, and what is given up for it, against whole columns and dense cubics."""

import numpy as np
import pytest

from ropsim.motion.testing import (
    RATE,
    SWING,
    WINDOW,
    WORK_ROWS,
    Derivatives,
    PointLimits,
    TimedPoints,
    give_up,
    lacks_at,
)
from ropsim.spatial import Array

MORE = 0.01
ALLOWED = 1.0 + 1e-9


def told(
    first: Array,
    second: Array,
    course: tuple[Array, Array, Array, Array],
    limits: tuple[Array, Array, Array],
) -> tuple[Array, bool]:
    """Return the lacks, and whether there are any."""
    lacks, count = np.full((4, len(first)), np.nan), np.empty(1)
    speed, swing, jerk = limits
    work = np.full((WORK_ROWS, first.shape[1]), np.nan)
    unlimited = np.append(speed, np.full(first.shape[1] - len(speed), np.inf))
    path, most = Derivatives(first, second), PointLimits(unlimited, swing, jerk)
    lacks_at(path, TimedPoints(*course), most, ALLOWED, MORE, work, lacks, count)
    return lacks, bool(count[0] > 0.0)


def walk(seed: int, m: int = 50) -> tuple[Array, Array, tuple[Array, Array, Array, Array]]:
    """Return derivatives of two joints and one path, and a course with places, times, rates and changes."""
    random = np.random.default_rng(seed)
    times, places = np.cumsum(random.uniform(1e-3, 9e-3, (2, m)), axis=1)
    course = places, times, random.uniform(0.1, 1.0, m), random.normal(size=m)
    return random.normal(size=(m, 3)), random.normal(size=(m, 3)), course


@pytest.mark.parametrize("seed", range(5))
def test_speeds_and_accelerations_that_are_too_much_are_lacks_of_their_own(seed: int) -> None:
    first, second, course = walk(seed)
    rates, changes = course[2][:, None], course[3][:, None]
    swing = np.random.default_rng(seed + 9).uniform(0.5, 2.0, (50, 3))
    found, some = told(first, second, course, (np.array([0.5, 0.7]), swing, np.full((50, 3), np.inf)))
    fast = np.max(np.abs(first * rates)[:, :2] / [0.5, 0.7], axis=1)
    swung = np.max(np.abs(second * rates**2 + first * changes) / swing, axis=1)
    for row, share in (RATE, fast), (SWING, swung):
        expected = np.where(share > 1.0, np.log(np.minimum(share, 2.0)) + MORE, 0.0)
        assert found[row] == pytest.approx(expected, abs=1e-12)
    assert some
    assert not found[WINDOW:].any()


@pytest.mark.parametrize("seed", range(20))
def test_jerk_is_that_of_the_cubic_rate_at_both_ends_of_a_way(seed: int) -> None:
    first, second, course = walk(seed, 2)
    first[1], second[1] = first[0], second[0]  # the path itself is even: all comes from the course
    _, times, rates, changes = course
    span = times[1] - times[0]
    rate = np.polynomial.Polynomial(
        np.linalg.solve(
            [[1, 0, 0, 0], [0, 1, 0, 0], [1, span, span**2, span**3], [0, 1, 2 * span, 3 * span**2]],
            [rates[0], changes[0], rates[1], changes[1]],
        )
    )
    squares = (rates[1] ** 2 - rates[0] ** 2) / span
    slopes = np.array([rate.deriv(2)(0.0), rate.deriv(2)(span)])
    whole = second[0] * squares + np.outer(slopes, first[0])
    most = np.abs(whole).max()
    free = np.array([np.inf, np.inf]), np.full((1, 3), np.inf)
    assert not told(first, second, course, (*free, np.full((1, 3), most * (1.0 + 1e-8))))[1]
    found, some = told(first, second, course, (*free, np.full((1, 3), most / 1.5)))
    assert some
    bend, change = np.abs(second[0] * (rates[1] ** 2 - rates[0] ** 2)), np.abs(first[0] * np.diff(changes))
    worst = np.abs(whole).max(axis=0) * 1.5 / most
    lacks = np.where(worst > 1.0, np.log(np.minimum(worst, 2.0)) + MORE, 0.0)
    assert found[WINDOW] == pytest.approx(np.max(lacks * change / (bend + change)), rel=1e-6)
    assert found[SWING] == pytest.approx(np.max(lacks * (bend + 0.2 * change) / (bend + change)), rel=1e-6)
    assert not found[RATE].any()


@pytest.mark.parametrize("share", [0.1, 0.5, 0.9])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_jerk_that_changes_on_a_way_counts_as_those_of_the_ways_beside_it(
    share: float, sign: float
) -> None:
    """Jerk goes over from 0 to 1 on the third way; at its end it is 1, whatever its mean is."""
    rate = np.full(6, 0.8)
    course = 0.8 * np.arange(6.0), np.arange(6.0), rate, np.zeros(6)
    first, second = np.zeros((6, 1)), sign * 0.8 * np.cumsum([0.0, 0.0, 0.0, share, 1.0, 1.0])[:, None]
    free, jerk = (np.full(1, np.inf), np.full((1, 1), np.inf)), 0.8**3
    found, _ = told(first, second, course, (*free, np.full((1, 1), jerk / 1.5)))
    lack = (np.log(1.5) + MORE) / 3.0
    assert found[RATE] == pytest.approx(lack * np.array([0.0, 0.0, 1.0, 1.0, 1.0, 1.0]), rel=1e-9)
    assert not told(first, second, course, (*free, np.full((1, 1), jerk * (1.0 + 1e-8))))[1]


def test_a_jerk_above_those_beside_it_is_no_mixture_of_them() -> None:
    second = np.cumsum([0.0, 0.0, 0.0, 1.0, 0.5, 0.5])[:, None]
    course = np.arange(6.0), np.arange(6.0), np.ones(6), np.zeros(6)
    free = np.full(1, np.inf), np.full((1, 1), np.inf), np.full((1, 1), 0.8)
    found, _ = told(np.zeros((6, 1)), second, course, free)
    assert (found[RATE] > 0.0).tolist() == [False, False, True, True, False, False]


def test_what_is_no_number_lacks_nothing_here() -> None:
    first, second, course = walk(3)
    assert not told(first * np.nan, second, course, (np.ones(2), np.ones((1, 3)), np.ones((1, 3))))[1]


@pytest.mark.parametrize("seed", range(5))
def test_shares_give_up_the_greatest_lack_in_the_windows_around_places(seed: int) -> None:
    random, m = np.random.default_rng(seed), 80
    sigma = np.cumsum(random.uniform(0.05, 0.4, m))
    lacks = np.where(random.uniform(size=(4, m)) < 0.1, random.uniform(size=(4, m)), 0.0)
    lacks[0] = 0.0
    before = random.uniform(0.5, 1.0, (4, m))
    before[WINDOW] *= 8.0
    shares = before.copy()
    give_up(sigma, lacks, np.empty((2, m)), shares)
    inner = np.abs(sigma[:, None] - sigma) <= 1.0
    reach = (
        inner
        | np.roll(inner, 1, axis=1) & (sigma > sigma[:, None])
        | np.roll(inner, -1, axis=1) & (sigma < sigma[:, None])
    )
    nearby = np.max(np.where(reach, lacks[:, None, :], 0.0), axis=2)
    expected = before / np.exp(nearby)
    expected[WINDOW] = np.where(nearby[WINDOW] > 0.0, np.minimum(before * np.exp(nearby), 8.0), before)[
        WINDOW
    ]
    assert shares == pytest.approx(expected, rel=1e-12)
