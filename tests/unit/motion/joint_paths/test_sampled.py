"""Traced paths: through every row, twice smooth, exact for polynomials, of high order for others."""

import numpy as np
import pytest

from ropsim.motion import SampledPath
from ropsim.spatial import Array
from support.paths import inner_places, joint_differences

ROUNDING = 1e-12


def wave(s: Array) -> Array:
    """Return three joints along a way of 2, shape (k, 3)."""
    return np.stack((np.sin(2.0 * s), np.cos(3.0 * s), np.exp(-s)), axis=1)


def wave_d2(s: Array) -> Array:
    return np.stack((-4.0 * np.sin(2.0 * s), -9.0 * np.cos(3.0 * s), np.exp(-s)), axis=1)


def traced(count: int) -> SampledPath:
    return SampledPath(2.0, wave(np.linspace(0.0, 2.0, count)))


@pytest.mark.parametrize("count", [2, 3, 6, 7, 8, 9, 20])
def test_every_row_is_passed(count: int) -> None:
    path = traced(count)
    s = np.linspace(0.0, 2.0, count)
    assert np.abs(path.joints(s).q - wave(s)).max() < ROUNDING


@pytest.mark.parametrize("count", [2, 3, 6, 8, 9, 20])
def test_derivatives_are_those_of_the_coordinates(count: int) -> None:
    path, s = traced(count), inner_places(2.0, 36)  # none of them at a row
    d1, d2 = joint_differences(path, s, 1e-4)
    assert np.abs(path.joints(s).d1 - d1).max() < 1e-8
    assert np.abs(path.joints(s).d2 - d2).max() < 1e-8


def test_second_derivatives_go_over_from_piece_to_piece() -> None:
    path, rows = traced(20), np.linspace(0.0, 2.0, 20)[1:-1]
    before, after = path.joints(rows - 1e-12), path.joints(rows + 1e-12)
    assert np.abs(before.d1 - after.d1).max() < 1e-10
    assert np.abs(before.d2 - after.d2).max() < 1e-8


@pytest.mark.parametrize("count", range(2, 12))
def test_polynomials_up_to_degree_five_are_exact(count: int) -> None:
    coefficients = np.random.default_rng(count).normal(size=min(count, 6))
    polynomial = np.polynomial.Polynomial(coefficients)
    path = SampledPath(2.0, polynomial(np.linspace(0.0, 2.0, count))[:, None])
    s = np.linspace(0.0, 2.0, 50)
    size = np.abs(coefficients) @ 2.0 ** np.arange(len(coefficients))
    assert np.abs(path.joints(s).q[:, 0] - polynomial(s)).max() < 1e-13 * size
    assert np.abs(path.joints(s).d2[:, 0] - polynomial.deriv(2)(s)).max() < 1e-10 * size


def test_values_are_of_order_six_and_second_derivatives_of_order_four() -> None:
    s = np.linspace(0.0, 2.0, 1001)
    coarse, fine = (
        (np.abs(path.joints(s).q - wave(s)).max(), np.abs(path.joints(s).d2 - wave_d2(s)).max())
        for path in (traced(30), traced(60))
    )
    assert np.log2(coarse[0] / fine[0]) > 5.5
    assert np.log2(coarse[1] / fine[1]) > 3.5


def test_sixty_rows_of_a_smooth_way_are_exact_to_a_nanometre() -> None:
    s = np.linspace(0.0, 2.0, 1001)
    assert np.abs(traced(60).joints(s).q - wave(s)).max() < 1e-9


def test_records_of_equal_rows_are_equal() -> None:
    assert traced(12) == traced(12)
    assert traced(12) != traced(13)
