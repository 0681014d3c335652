"""Hulls of many points: another library's corners, and a margin that holds where corners are few."""

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from ropsim.collision import bounded_hull
from ropsim.spatial import Array

RANDOM = np.random.default_rng(3)
FINE = 1e-8
"""Of the size: below this a corner is none."""
MOST = 60


def test_corners_are_those_that_another_library_finds() -> None:
    points = RANDOM.uniform(-1.0, 1.0, size=(1000, 3))
    corners, margin = bounded_hull(points)
    theirs = points[ConvexHull(points).vertices]
    assert np.array(sorted(map(tuple, corners))) == pytest.approx(np.array(sorted(map(tuple, theirs))))
    assert margin < FINE


def test_a_box_of_many_points_has_eight_corners() -> None:
    grid = np.stack(np.meshgrid(*[np.linspace(0.0, 1.0, 9)] * 3), axis=-1).reshape(-1, 3)
    corners, margin = bounded_hull(grid)
    assert sorted(map(tuple, corners)) == [
        (x, y, z) for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)
    ]
    assert margin < FINE


def test_with_few_corners_the_margin_holds_all_points() -> None:
    points = RANDOM.normal(size=(3000, 3))
    points /= np.linalg.norm(points, axis=1)[:, np.newaxis]
    corners, margin = bounded_hull(points, MOST)
    assert len(corners) == MOST
    directions = RANDOM.normal(size=(500, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, np.newaxis]
    lack = (points @ directions.T).max(axis=0) - (corners @ directions.T).max(axis=0)
    assert 0.0 < lack.max() <= margin < 0.2


@pytest.mark.parametrize(
    "points",
    [
        RANDOM.normal(size=(200, 3)) * [1.0, 1.0, 0.0],
        np.outer(np.linspace(0.0, 1.0, 50), [1.0, 2.0, 3.0]),
        np.ones((20, 3)),
    ],
    ids=["flat", "straight", "one point"],
)
def test_flat_points_have_a_hull_that_reaches_as_far(points: Array) -> None:
    corners, margin = bounded_hull(points)
    directions = RANDOM.normal(size=(200, 3))
    reach = [(some @ directions.T).max(axis=0) for some in (points, corners)]
    assert np.abs(reach[0] - reach[1]).max() <= 1e-5
    assert margin < 1e-5
