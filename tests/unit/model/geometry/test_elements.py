"""Outlines, circles and rods have the measures that they were asked for."""

from itertools import pairwise

import numpy as np
import pytest

from ropsim.model import Cylinder, Point2, arc, around, circle, polygon, rod

ROUNDING = 1e-12  # [m], of a few additions


def area(points: tuple[Point2, ...]) -> float:
    pairs = pairwise((*points, points[0]))
    return 0.5 * sum(x1 * y2 - x2 * y1 for (x1, y1), (x2, y2) in pairs)


def test_an_outline_around_two_circles_has_the_area_of_a_belt() -> None:
    # Equal radii r at distance d: a disc and a rectangle 2 r d; 48 chords take 0.3 % off the disc.
    outline = around(((0.0, 0.0, 0.1), (0.5, 0.0, 0.1)))
    assert area(outline) == pytest.approx(np.pi * 0.01 + 0.1, rel=3e-3)


def test_an_outline_turns_left_at_every_corner() -> None:
    points = np.array(
        around(((-0.09, 0.0, 0.092), (0.0, 0.02, 0.118), (0.4318, 0.0, 0.076), (0.1, 0.3, 0.0)))
    )
    edges = np.roll(points, -1, axis=0) - points
    after = np.roll(edges, -1, axis=0)
    assert (edges[:, 0] * after[:, 1] - edges[:, 1] * after[:, 0] > 0.0).all()


def test_a_circle_of_radius_zero_is_a_corner_of_the_outline() -> None:
    assert set(around(((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))) == {(0, 0), (1, 0), (0, 1)}


def test_a_circle_is_closed_and_keeps_its_radius() -> None:
    points = np.array(circle(0.25).points)
    assert np.linalg.norm(points, axis=1) == pytest.approx(np.full(len(points), 0.25), abs=ROUNDING)
    assert points[0] == pytest.approx(points[-1], abs=ROUNDING)


def test_an_arc_runs_from_its_first_to_its_last_angle() -> None:
    points = arc(2.0, np.pi / 2, 0.0).points
    assert points[0] == pytest.approx((0.0, 2.0, 0.0), abs=ROUNDING)
    assert points[-1] == pytest.approx((2.0, 0.0, 0.0), abs=ROUNDING)
    assert all(y >= -ROUNDING for _, y, _ in points)


def test_a_polygon_comes_back_to_its_first_point() -> None:
    corners = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 1.0))
    assert polygon(corners).points == (*corners, corners[0])


@pytest.mark.parametrize(
    "end", [(0, 0, 1), (0, 0, -1), (1, 0, 0), (0, -2, 0), (0.3, -0.4, 0.5), (1e-9, 0, -1)], ids=str
)
def test_a_rod_reaches_from_its_start_to_its_end(end: tuple[float, float, float]) -> None:
    start = np.array([0.1, 0.2, 0.3])
    shape = rod(start, start + end, 0.05, 0.02)
    assert isinstance(shape.solid, Cylinder)
    faces = [(shape.pose.matrix() @ [0.0, 0.0, side * shape.solid.length / 2, 1.0])[:3] for side in (-1, 1)]
    assert faces[0] == pytest.approx(start, abs=2e-9)
    assert faces[1] == pytest.approx(start + end, abs=2e-9)
    assert (shape.solid.radius, shape.solid.top_radius) == (0.05, 0.02)
