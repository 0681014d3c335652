"""Convex parts of outlines: convex, inside, and of the same area."""

import random
from math import cos, pi, sin

import pytest

from ropsim.collision.convex_parts import convex_parts
from ropsim.model import Point2
from support.examples import examples

U = ((0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (2.0, 2.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0))
L = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0))


def area(points: tuple[Point2, ...]) -> float:
    pairs = zip(points, (*points[1:], points[0]), strict=True)
    return sum(ax * by - bx * ay for (ax, ay), (bx, by) in pairs) / 2.0


def is_convex(points: tuple[Point2, ...]) -> bool:
    count = len(points)
    corners = ((points[k - 1], points[k], points[(k + 1) % count]) for k in range(count))
    return all(
        (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) >= -1e-12 for (ax, ay), (bx, by), (cx, cy) in corners
    )


def holds(points: tuple[Point2, ...], x: float, y: float) -> bool:
    """Return whether a point is in a polygon, by the crossings of a ray."""
    found = False
    for (ax, ay), (bx, by) in zip(points, (*points[1:], points[0]), strict=True):
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            found = not found
    return found


def star(seed: int) -> tuple[Point2, ...]:
    """Return a random outline of 4 to 40 corners that goes round the origin once."""
    chance = random.Random(seed)
    count = chance.randint(4, 40)
    turns = [2.0 * pi * (k + chance.uniform(0.0, 0.9)) / count for k in range(count)]
    radii = [chance.uniform(0.2, 1.0) for _ in turns]
    return tuple((r * cos(turn), r * sin(turn)) for r, turn in zip(radii, turns, strict=True))


@pytest.mark.parametrize(("outline", "count"), [(U, 3), (L, 2), (U[:3], 1), (U[:2] + U[7:], 1)])
def test_plain_outlines_have_few_parts(outline: tuple[Point2, ...], count: int) -> None:
    assert len(convex_parts(outline)) == count


@pytest.mark.parametrize("seed", range(examples(60)))
def test_parts_are_convex_and_fill_the_outline(seed: int) -> None:
    outline = star(seed)
    parts = convex_parts(outline)
    assert all(is_convex(part) for part in parts)
    assert sum(map(area, parts)) == pytest.approx(area(outline), rel=1e-9)
    chance = random.Random(seed)
    for _ in range(50):
        x, y = chance.uniform(-1.0, 1.0), chance.uniform(-1.0, 1.0)
        assert holds(outline, x, y) == any(holds(part, x, y) for part in parts)


KEYHOLE = ((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (0.0, 0.0), (1.0, 1.0), (1.0, 3.0), (3.0, 3.0),
           (3.0, 1.0), (1.0, 1.0))  # fmt: skip
SPIKE = ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.5, 1.0), (0.5, 2.0), (0.5, 1.0), (0.0, 1.0))
STRAIGHT = (
    (0.0, 0.0),
    (1.0, 0.0),
    (2.0, 0.0),
    (2.0, 1.0),
    (1.5, 1.0),
    (1.0, 1.0),
    (1.0, 1.5),
    (1.0, 2.0),
    (0.0, 2.0),
)


@pytest.mark.parametrize(("outline", "whole"), [(KEYHOLE, 12.0), (SPIKE, 1.0), (STRAIGHT, 3.0)])
def test_slits_spikes_and_straight_corners_change_nothing(outline: tuple[Point2, ...], whole: float) -> None:
    parts = convex_parts(outline)
    assert all(is_convex(part) for part in parts)
    assert sum(map(area, parts)) == pytest.approx(whole, rel=1e-12)


def test_an_outline_that_crosses_itself_stays_whole() -> None:
    crossed = ((0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0))
    assert convex_parts(crossed) == (crossed,)
