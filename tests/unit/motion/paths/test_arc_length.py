"""The arc length of curves of polynomials, against their polynomials and quadrature of another library."""

import numpy as np
import pytest
from numpy.polynomial import Polynomial
from scipy.integrate import quad

from ropsim.motion.testing import arc_length, arc_length_in_steps, speed_range
from ropsim.spatial import Array

ROUNDING = 1e-13
QUADRATURE = 1e-9  # of the way, with five points in each of the steps
STEPS = 128


def segments(seed: int, count: int) -> Array:
    """Return coefficients of polynomials that go ahead everywhere, shape (count, 6, 6)."""
    rng = np.random.default_rng(seed)
    made = rng.normal(size=(count, 6, 6)) * np.array([1.0, 0.3, 0.1, 0.05, 0.03, 0.02])[:, np.newaxis]
    made[:, 1, 0] += 2.0
    return np.ascontiguousarray(made)


def speed(coefficients: Array, t: Array) -> Array:
    """Return |p'| of a segment."""
    rates = [Polynomial(coefficients[:, k]).deriv()(t) for k in range(3)]
    return np.asarray(np.sqrt(np.square(rates).sum(axis=0)))


@pytest.mark.parametrize("count", [1, 3])
@pytest.mark.parametrize("steps", [5, 64])
def test_the_range_of_speeds_is_that_of_the_polynomials_at_all_steps(count: int, steps: int) -> None:
    coefficients, out = segments(1, count), np.empty((count, 2))
    speed_range(coefficients, steps, np.empty(2 * steps + 2), out)
    for one, (least, greatest) in zip(coefficients, out, strict=True):
        wanted = speed(one, np.arange(steps + 1) / steps)
        assert (least, greatest) == pytest.approx((wanted.min(), wanted.max()), rel=ROUNDING)


@pytest.mark.parametrize("seed", range(4))
def test_ways_and_their_inverse_are_those_of_the_polynomials(seed: int) -> None:
    coefficients = segments(seed, 3)
    way = arc_length_in_steps(coefficients, STEPS)
    for segment, one in enumerate(coefficients):
        begin = segment * STEPS
        for step in (0, 17, STEPS - 1):
            low, high = step / STEPS, (step + 1) / STEPS
            gone = way.ends[begin + step + 1] - way.ends[begin + step]
            assert gone == pytest.approx(quad(lambda t, c=one: speed(c, t), low, high)[0], rel=QUADRATURE)
            shares = Polynomial(way.inverse[begin + step])
            for share, t in ((0.0, low), (1.0, high)):
                assert shares(share) == pytest.approx(t, abs=ROUNDING)
                slope = gone / speed(one, np.array([t]))[0]
                assert shares.deriv()(share) == pytest.approx(slope, rel=1e-11)
                later = gone / speed(one, np.array([t + 1e-6, t - 1e-6]))
                bend = (later[0] - later[1]) / 2e-6 * slope
                assert shares.deriv(2)(share) == pytest.approx(bend, rel=1e-5, abs=1e-11)


def test_a_curve_that_all_but_stands_or_is_no_number_has_no_way() -> None:
    coefficients = segments(2, 2)
    assert arc_length(coefficients, STEPS, np.full(2, 1e-3)) is not None
    assert arc_length(coefficients, STEPS, np.array([1e-3, 10.0])) is None
    coefficients[0, 3, 1] = np.nan
    assert arc_length(coefficients, STEPS, np.full(2, 1e-3)) is None


def test_steps_of_an_uneven_curve_are_four_times_as_fine() -> None:
    coefficients = segments(3, 1)
    coefficients[0, 2, 0] = 4.0
    way = arc_length(coefficients, STEPS, np.array([1e-3]))
    assert way is not None
    assert way.steps == 4 * STEPS
