"""Motion time over real time: exact where nothing is slowed, smooth and rising where something is."""

import numpy as np

from ropsim.motion import NominalTime
from ropsim.motion.testing import WORK, greatest_nearby, motion_time, rounded, timed, unslowed

SMOOTH = 1e-5  # of steps of 1e-6 s with changes of rate below 10 / s


def dip() -> NominalTime:
    """Return 2 s of motion with a rate of 1 - 0.9·sin⁴(π·φ/2)."""
    places = np.linspace(0.0, 2.0, 201)
    sine, cosine = np.sin(np.pi * places / 2.0), np.cos(np.pi * places / 2.0)
    rates = 1.0 - 0.9 * sine**4
    return motion_time(places, rates, rates * -1.8 * np.pi * sine**3 * cosine)


def test_a_motion_that_is_not_slowed_has_its_own_time_bit_by_bit() -> None:
    times = np.random.default_rng(1).uniform(0.0, 3.3, 1000)
    phi, rates, changes = unslowed(3.3).at(times)
    assert phi.tolist() == times.tolist()
    assert set(rates) == {1.0}
    assert set(changes) == {0.0}


def test_rate_is_the_derivative_of_motion_time_and_change_that_of_the_rate() -> None:
    clock, step = dip(), 1e-6
    times = np.linspace(0.1, clock.duration - 0.1, 4001)
    before, here, after = (clock.at(times + shift) for shift in (-step, 0.0, step))
    assert np.abs((after[0] - before[0]) / (2.0 * step) - here[1]).max() < SMOOTH
    assert np.abs((after[1] - before[1]) / (2.0 * step) - here[2]).max() < SMOOTH * 10.0


def test_duration_is_the_integral_of_one_over_the_rate() -> None:
    places = np.linspace(0.0, 2.0, 200_001)
    integral = float(np.trapezoid(1.0 / (1.0 - 0.9 * np.sin(np.pi * places / 2.0) ** 4), places))
    assert abs(dip().duration - integral) < 1e-6 * integral  # cells of 10 ms, error of fourth order


def test_rates_between_knots_stay_above_0_and_at_most_1() -> None:
    random = np.random.default_rng(2)
    places = np.cumsum(random.uniform(0.001, 0.01, 500))
    clock = motion_time(places - places[0], random.uniform(0.01, 1.0, 500), random.normal(size=500) * 1e3)
    phi, rates, _ = clock.at(np.linspace(0.0, clock.duration, 50_001))
    assert rates.min() > 0.0
    assert rates.max() <= 1.5  # no rate near 1 changes so steeply; there it is kept, see the laws
    assert np.diff(phi).min() >= 0.0


def test_times_outside_count_as_the_ends() -> None:
    clock = dip()
    assert clock.at(np.array([-1.0, clock.duration, clock.duration + 1.0]))[0].tolist() == [0.0, 2.0, 2.0]


def test_each_time_is_told_as_it_is_alone_whatever_is_asked_with_it() -> None:
    clock = dip()
    times = np.random.default_rng(3).uniform(-0.1, clock.duration + 0.1, 500)
    times[:30] = clock.times[:30]
    alone = np.hstack([clock.at(times[k : k + 1]) for k in range(500)])
    assert (clock.at(times) == alone).all()
    order = np.argsort(times)
    assert (clock.at(times[order]) == alone[:, order]).all()


def test_slower_by_a_share_scales_rates_and_their_changes() -> None:
    clock = dip()
    times = np.linspace(0.0, clock.duration, 101)
    fast, slow = clock.at(times), clock.slower(0.5).at(2.0 * times)
    for power in range(3):
        assert np.abs(slow[power] - fast[power] * 0.5**power).max() < 1e-12


def test_a_rounded_course_is_nowhere_above_and_1_beyond_two_windows() -> None:
    sigma = np.linspace(0.0, 30.0, 1501)
    rates = np.where((sigma > 14.0) & (sigma < 16.0), 0.3, 1.0)
    smooth, slopes = np.empty((2, 1501))
    rounded(sigma, rates, np.empty((WORK, 1503)), smooth, slopes)
    assert (smooth <= rates + 1e-5).all()  # the second mean is over a line between places of the first
    assert set(smooth[(sigma < 11.9) | (sigma > 18.1)]) == {1.0}
    assert abs(smooth[750] - 0.3) < 1e-12
    assert np.abs(np.diff(slopes)).max() < 0.05  # a step of 0.7 in windows of 2, places 0.02 apart


def test_the_greatest_nearby_value_is_that_of_a_search() -> None:
    random = np.random.default_rng(3)
    sigma, values = np.cumsum(random.uniform(0.01, 0.6, 300)), random.normal(size=300)
    found, queue = np.empty((2, 300))
    greatest_nearby(sigma, values, queue, found)
    for k in range(300):
        inside = np.flatnonzero(np.abs(sigma - sigma[k]) <= 1.0)
        around = values[max(inside[0] - 1, 0) : inside[-1] + 2]
        assert found[k] == around.max()


def test_times_of_knots_are_those_of_whole_columns() -> None:
    """With changes brought down where they would lead a rate out of ]0, 1], column by column."""
    random, m = np.random.default_rng(4), 400
    places = np.cumsum(random.uniform(0.001, 0.01, m))
    rates, asked = random.uniform(0.01, 1.0, m), random.normal(size=m) * 100.0
    way, mean = np.diff(places), (rates[1:] + rates[:-1]) / 2.0
    step = way / mean
    left, right = np.append(step[:1], step), np.append(step, step[-1:])
    above, below = 3.0 * (1.0 - rates), 3.0 * 0.9 * rates * 1.1 / 2.0
    up, down = np.minimum(above / right, below / left), np.minimum(above / left, below / right)
    changes = np.clip(asked, -down, up)
    root = np.sqrt(np.maximum(mean**2 + (changes[:-1] - changes[1:]) / 3.0 * way, 0.0))
    times = np.empty(m)
    timed(places, rates, asked, times)
    assert np.abs(asked - changes).max() <= 1e-12 * np.abs(changes).max()
    assert np.abs(np.diff(times) / (2.0 * way / (mean + root)) - 1.0).max() < 1e-9
