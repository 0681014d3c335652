"""Hulls of many points: another library's corners, and a margin that holds where corners are few."""

import numpy as np
import pytest
from scipy.optimize import nnls
from scipy.spatial import ConvexHull

from ropsim.collision import bounded_hull
from ropsim.collision.polytope import Polytope
from ropsim.spatial import Array

RANDOM = np.random.default_rng(3)
FINE = 1e-8
"""Of the size: below this a corner is none."""
MOST = 60


ROUNDING = 1e-12
"""Of the size: what the other engine leaves uncertain."""


def sphere(count: int) -> Array:
    points = RANDOM.normal(size=(count, 3))
    return np.asarray(points / np.linalg.norm(points, axis=1)[:, np.newaxis])


def disc(count: int) -> Array:
    angles = np.arange(count) * 2.0 * np.pi / count
    return np.column_stack([np.cos(angles), np.sin(angles), 0.0 * angles])


def sheet(*out: float) -> Array:
    """Return random points of a square sheet with one point over it."""
    flat = np.column_stack([RANDOM.uniform(-1.0, 1.0, (300, 2)), np.zeros(300)])
    return np.vstack([flat, [[0.2, 0.1, *out]]])


SLENDER = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.3, 1e-6, 0.0]])
BODIES = {
    "disc": disc(150),
    "large disc": disc(1000),
    "coin": np.vstack([disc(200), disc(200) + np.array([0.0, 0.0, 1e-6])]),
    "thin sphere": sphere(500) * [1.0, 1.0, 1e-3],
    "thinner sphere": sphere(500) * [1.0, 1.0, 1e-6],
    "needle": sphere(500) * [1e-4, 2e-4, 1.0],
    "slender triangle": np.vstack([SLENDER, RANDOM.dirichlet(np.ones(3), 100) @ SLENDER]),
    "sheet with a point out": sheet(1e-3),
    "disc with a point out": np.vstack([disc(300), [[0.1, 0.2, 1e-5]]]),
    "same points": np.repeat(RANDOM.normal(size=(12, 3)), 9, axis=0),
    "cloud": RANDOM.normal(size=(400, 3)),
    "line": np.outer(np.linspace(0.0, 1.0, 50), [1.0, 2.0, 3.0]),
    **{f"{count} points": RANDOM.normal(size=(count, 3)) for count in range(1, 6)},
}
"""Of about 1 m."""


def farthest_out(points: Array, corners: Array) -> float:
    """Return how far points are from a hull at most [m]: least squares whose shares are not negative.

    Looked at are the points that reach farthest along some directions.
    """
    size = float(np.ptp(points, axis=0).max()) or 1.0
    directions = sphere(60)
    middle = corners.mean(axis=0)
    inside, every = (corners - middle) / size, (points - middle) / size
    lack = (every @ directions.T).max(axis=0) - (inside @ directions.T).max(axis=0)
    rows = {int(np.argmax(every @ one)) for one in directions[lack > 0.0]}
    system = np.vstack([inside.T, np.full(len(inside), 1e3)])
    out = 0.0
    for row in rows:
        shares = nnls(system, np.append(every[row], 1e3), maxiter=10 * len(inside))[0]
        out = max(out, float(np.linalg.norm(inside.T @ (shares / shares.sum()) - every[row])))
    return out * size


@pytest.mark.parametrize("scale", [1e-4, 1.0, 1e3])
@pytest.mark.parametrize("name", BODIES)
def test_no_point_of_thin_flat_and_round_bodies_is_farther_outside_than_the_margin_says(
    name: str, scale: float
) -> None:
    turn = np.linalg.qr(RANDOM.normal(size=(3, 3)))[0]
    points = BODIES[name] @ turn.T * scale + RANDOM.normal(size=3) * scale
    corners, margin = bounded_hull(points, MOST)
    size = float(np.ptp(points, axis=0).max())
    assert {*map(tuple, corners)} <= {*map(tuple, points)}
    assert farthest_out(points, corners) <= margin + ROUNDING * size
    assert margin <= 0.02 * size + 1e-9 * scale or name == "cloud"  # 60 corners


def test_a_mesh_without_thickness_keeps_the_points_beside_its_plane_within_the_margin() -> None:
    bump = 0.9e-9 * 2.0
    points = np.vstack([disc(40), [[0.1, 0.2, bump]]])
    corners, margin = bounded_hull(points)
    assert np.abs(corners[:, 2]).max() == 0.0 < bump <= margin


def test_links_of_many_points_stand_outside_by_less_than_a_hundredth_of_their_size() -> None:
    angles, heights = RANDOM.uniform(0.0, 2.0 * np.pi, 20000), RANDOM.uniform(-0.4, 0.4, 20000)
    radii = np.where(heights > 0.2, 0.12, 0.08)
    link = np.column_stack([radii * np.cos(angles), radii * np.sin(angles), heights])
    assert bounded_hull(link)[1] < 1e-3
    assert bounded_hull(sphere(5000))[1] < 0.01 * 2.0


def test_a_corner_that_a_new_point_in_the_plane_of_its_face_hides_is_none_any_more() -> None:
    corners = np.array([[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.3, 1.0]])
    polytope = Polytope.within(corners)
    new = np.array([1.0, 3.0, 0.0])
    seen = next(k for k, face in polytope.faces.items() if face.normal @ new - face.offset > 0.1)
    assert polytope.add(new, seen)[1]
    left = {corner for face in polytope.faces.values() for corner in face.corners}
    assert corners[2].tolist() not in [polytope.points[k].tolist() for k in left]


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
