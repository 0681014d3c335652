"""Rotation vectors: their functions agree with another library and with differences."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from ropsim.motion.testing import exponentials, logarithms, rates, turning
from ropsim.spatial import Array
from support.paths import difference

ROUNDING = 1e-12


def vectors(size: float) -> Array:
    """Return rotation vectors of one length [rad], shape (20, 3)."""
    rng = np.random.default_rng(7)
    directions = rng.normal(size=(20, 3))
    return np.asarray(directions / np.linalg.norm(directions, axis=1, keepdims=True) * size)


@pytest.mark.parametrize("size", [0.0, 1e-12, 1e-6, 0.3, 3.0, 6.2])
def test_exponentials_agree_with_scipy(size: float) -> None:
    assert (
        np.abs(exponentials(vectors(size)) - Rotation.from_rotvec(vectors(size)).as_matrix()).max() < ROUNDING
    )


@pytest.mark.parametrize("size", [0.0, 1e-12, 1e-6, 0.3, 3.0, np.pi - 1e-9])
def test_logarithms_undo_exponentials(size: float) -> None:
    assert np.abs(logarithms(exponentials(vectors(size))) - vectors(size)).max() < ROUNDING


@pytest.mark.parametrize("size", [1e-6, 0.5, 2.0, 5.0])
def test_angular_velocities_are_those_of_the_rotations(size: float) -> None:
    start, d1, d2 = vectors(size), vectors(1.3)[::-1], vectors(0.7)[::-1] * [1.0, -1.0, 1.0]

    def at(t: float) -> Array:
        return start + t * d1 + 0.5 * t * t * d2

    def speed(t: Array) -> Array:
        return turning(at(t[0]), d1 + t[0] * d2, d2)[1]

    def turned(t: Array) -> Array:
        relative = exponentials(at(t[0])) @ np.swapaxes(exponentials(start), 1, 2)
        return np.asarray(Rotation.from_matrix(relative).as_rotvec())

    now = np.zeros(1)
    assert speed(now) == pytest.approx(difference(turned, now, 1e-3), abs=1e-9)
    assert turning(start, d1, d2)[2] == pytest.approx(difference(speed, now, 1e-3), abs=1e-9)


@pytest.mark.parametrize("size", [0.0, 1e-6, 0.5, 3.0])
def test_rates_are_those_that_angular_velocities_come_from(size: float) -> None:
    d1, d2 = vectors(1.3)[::-1], vectors(0.7)[::-1]
    found = rates(vectors(size), *turning(vectors(size), d1, d2)[1:])
    assert np.abs(found[0] - d1).max() < ROUNDING
    assert np.abs(found[1] - d2).max() < 10.0 * ROUNDING
