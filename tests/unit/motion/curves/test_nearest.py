"""Distances of points from curves: what a search everywhere finds, and exact."""

import numpy as np
import pytest
from scipy.spatial import KDTree

from ropsim.motion.testing import distances
from ropsim.spatial import Array

ROUNDING = 1e-12


def helix(t: Array) -> tuple[Array, Array, Array]:
    """Return a helix of radius 1 [m] that climbs by 0.1 m per radian, with its derivatives."""
    c, s, one, zero = np.cos(t), np.sin(t), np.ones(len(t)), np.zeros(len(t))
    return (
        np.stack((c, s, 0.1 * t), axis=1),
        np.stack((-s, c, 0.1 * one), axis=1),
        np.stack((-c, -s, zero), axis=1),
    )


@pytest.mark.parametrize("turns", [0.3, 1.0, 40.0])
def test_distances_from_a_helix_agree_with_a_fine_search(turns: float) -> None:
    rng = np.random.default_rng(13)
    grid = np.linspace(0.0, 2.0 * np.pi * turns, 2 + int(16 * turns))
    # nearer to a turn than to the axis and to the next turn, where two places are as far
    points = helix(rng.uniform(-0.3, grid[-1] + 0.3, 300))[0] + rng.uniform(-0.2, 0.2, (300, 3))
    dense = np.linspace(grid[0], grid[-1], 400_001)
    brute = KDTree(helix(dense)[0]).query(points)[0]
    step = (dense[1] - dense[0]) * 1.1
    found = distances(points, helix, grid)
    assert (found <= brute + ROUNDING).all()
    # between two places of the search the distance is at most that of the triangle less
    assert (found >= np.sqrt(np.maximum(np.square(brute) - step * step, 0.0)) - step * step).all()


def test_points_on_the_curve_have_no_distance() -> None:
    t = np.random.default_rng(14).uniform(0.0, 100.0, 500)
    assert distances(helix(t)[0], helix, np.linspace(0.0, 100.0, 300)).max() < ROUNDING


def test_the_ends_are_the_nearest_places_of_what_lies_beyond_them() -> None:
    grid = np.linspace(0.0, 1.0, 9)
    ends, tangents, _ = helix(np.array([0.0, 1.0]))
    beyond = ends + tangents * [[-0.2], [0.2]]
    assert distances(beyond, helix, grid) == pytest.approx(0.2 * np.sqrt(1.01) * np.ones(2), rel=ROUNDING)


def test_no_points_have_no_distances() -> None:
    assert distances(np.empty((0, 3)), helix, np.linspace(0.0, 1.0, 9)).shape == (0,)


def test_points_before_a_short_segment_are_found_on_the_long_one() -> None:
    """The derivative by the parameter jumps to a 400th, and Newton's method steps over the junction."""

    def uneven(t: Array) -> tuple[Array, Array, Array]:
        is_long, nothing = t < 1.0, np.zeros(len(t))
        x = np.where(is_long, 0.2 * t**2, 0.2 + 0.001 * (t - 1.0)), np.where(is_long, 0.4 * t, 0.001)
        rows = [np.stack((one, nothing, nothing), axis=1) for one in (*x, np.where(is_long, 0.4, 0.0))]
        return rows[0], rows[1], rows[2]

    points = uneven(np.linspace(0.96, 1.2, 500))[0]
    assert distances(points, uneven, np.linspace(0.0, 2.0, 33)).max() < ROUNDING
