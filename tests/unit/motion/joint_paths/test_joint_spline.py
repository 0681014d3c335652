"""Joints through given values: on them, smooth, and never back between two of them."""

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

from ropsim.motion import JointSpline, monotone
from ropsim.spatial import Array

ROUNDING = 1e-12
SEEDS = range(8)


def drawn(seed: int) -> tuple[Array, Array]:
    """Return places with parts of very different length, and values that go to and fro, or stay."""
    random = np.random.default_rng(seed)
    count = int(random.integers(3, 9))
    places = np.append(0.0, np.cumsum(10.0 ** random.uniform(-2.0, 0.0, count - 1)))
    q = np.cumsum(random.normal(size=(count, 4)) * 10.0 ** random.uniform(-3.0, 0.5, (count, 4)), axis=0)
    q[1:, 3] = q[0, 3]
    q[count // 2 :, 2] = q[count // 2, 2]
    return places, q


def inside(spline: JointSpline, share: Array) -> Array:
    """Return places at shares of each part, shape (k - 1, m)."""
    return spline.knots[:-1, None] + np.diff(spline.knots)[:, None] * share


@pytest.mark.parametrize("seed", SEEDS)
def test_it_goes_through_the_values(seed: int) -> None:
    places, q = drawn(seed)
    spline = monotone(places, q)
    assert spline.length == places[-1]
    np.testing.assert_allclose(spline.joints(places).q, q, rtol=0, atol=ROUNDING)


@pytest.mark.parametrize("seed", SEEDS)
def test_between_two_values_it_never_turns_back(seed: int) -> None:
    spline = monotone(*drawn(seed))
    places = inside(spline, np.linspace(0.0, 1.0, 501))
    for row, (begin, end) in enumerate(zip(places[:, 0], places[:, -1], strict=True)):
        q = spline.joints(np.clip(places[row], begin, end)).q
        back = np.diff(q, axis=0) * np.sign(q[-1] - q[0])
        assert back.min() >= -ROUNDING


@pytest.mark.parametrize("seed", SEEDS)
def test_it_is_twice_continuously_differentiable(seed: int) -> None:
    places, q = drawn(seed)
    spline = monotone(places, q)
    before, behind = (spline.joints(np.nextafter(places[1:-1], side)) for side in (-1.0, 100.0))
    sizes = np.abs(np.diff(q, axis=0)).max() / np.diff(places).min() ** np.array([1.0, 2.0])
    np.testing.assert_allclose(before.d1, behind.d1, rtol=0, atol=1e-11 * sizes[0])
    np.testing.assert_allclose(before.d2, behind.d2, rtol=0, atol=1e-11 * sizes[1])


@pytest.mark.parametrize("seed", SEEDS)
def test_its_derivatives_are_those_of_its_values(seed: int) -> None:
    spline = monotone(*drawn(seed))
    parts = np.diff(spline.knots)
    for part, places in zip(parts, inside(spline, np.array([0.2, 0.5, 0.7])), strict=True):
        h = 1e-4 * part
        before, here, behind = (spline.joints(places + step) for step in (-h, 0.0, h))
        most = max(1e-9, float(np.abs(here.d1).max() * part), float(np.abs(here.d2).max() * part**2))
        np.testing.assert_allclose((behind.q - before.q) / 2e-4, here.d1 * part, rtol=0, atol=1e-5 * most)
        np.testing.assert_allclose(
            (behind.d1 - before.d1) / 2e-4, here.d2 * part, rtol=0, atol=1e-5 * most / part
        )


def test_between_two_values_it_is_even() -> None:
    spline = monotone(np.array([0.0, 0.4]), np.array([[0.3, -1.0], [0.5, 1.0]]))
    points = spline.joints(np.array([0.0, 0.1, 0.4]))
    np.testing.assert_allclose(points.q, [[0.3, -1.0], [0.35, -0.5], [0.5, 1.0]], rtol=0, atol=ROUNDING)
    np.testing.assert_allclose(points.d1, np.tile([0.5, 5.0], (3, 1)), rtol=0, atol=1e-11)
    assert np.abs(points.d2).max() <= 1e-10


@pytest.mark.parametrize("seed", SEEDS)
def test_where_values_rise_gently_slopes_and_bends_are_those_of_the_natural_cubic_spline(seed: int) -> None:
    random = np.random.default_rng(seed)
    places = np.append(0.0, np.cumsum(random.uniform(0.9, 1.1, 6)))
    q = np.cumsum(random.uniform(0.95, 1.05, (7, 3)), axis=0) * np.array([1.0, -2.0, 0.1])
    natural, at = CubicSpline(places, q, bc_type="natural"), monotone(places, q).joints(places)
    np.testing.assert_allclose(at.d1, natural(places, 1), rtol=0, atol=1e-11)
    np.testing.assert_allclose(at.d2, natural(places, 2), rtol=0, atol=1e-11)


def test_a_value_that_stays_stands_between_its_places() -> None:
    spline = monotone(np.array([0.0, 1.0, 2.0, 3.0]), np.array([[0.0], [1.0], [1.0], [3.0]]))
    points = spline.joints(np.linspace(1.0, 2.0, 11))
    np.testing.assert_allclose(points.q, 1.0, rtol=0, atol=ROUNDING)
    np.testing.assert_allclose(points.d1, 0.0, rtol=0, atol=ROUNDING)


def test_it_is_the_same_backwards() -> None:
    places, q = drawn(4)
    s = np.linspace(0.0, places[-1], 57)
    there, back = monotone(places, q), monotone(places[-1] - places[::-1], q[::-1])
    np.testing.assert_allclose(there.joints(s).q, back.joints(places[-1] - s).q, rtol=0, atol=1e-10)
