"""Points of graphic elements: circles, arcs, closed polygons, rounded outlines and ends."""

from collections.abc import Sequence
from math import cos, pi, sin

from ropsim.model.geometry.elements import Point2, Point3, Polyline, Revolve

_CHORDS = 48
"""Chords of a full turn: a circle of 100 mm radius is drawn 0.2 mm true."""


def circle(radius: float) -> Polyline:
    """Return a circle of `radius` [m] about z in the plane z = 0."""
    return arc(radius, 0.0, 2.0 * pi)


def arc(radius: float, start: float, end: float) -> Polyline:
    """Return an arc about z in the plane z = 0, from one angle to the other [rad], counted from x."""
    steps = max(1, round(abs(end - start) / (2.0 * pi) * _CHORDS))
    angles = [start + (end - start) * k / steps for k in range(steps + 1)]
    return Polyline(tuple((radius * cos(angle), radius * sin(angle), 0.0) for angle in angles))


def polygon(points: Sequence[Point3]) -> Polyline:
    """Return the closed line through `points` [m]."""
    return Polyline((*points, points[0]))


def capsule(radius: float, length: float) -> Revolve:
    """Return a cylinder with round ends about z, centred at the origin.

    Args:
        radius: [m].
        length: from the middle of one end to that of the other [m]; 0 is a sphere.
    """
    quarter = [0.5 * pi * k / (_CHORDS // 4) for k in range(_CHORDS // 4 + 1)]
    half = 0.5 * length
    upper = [(radius * cos(angle), half + radius * sin(angle)) for angle in quarter[:-1]]
    top = [*upper, (0.0, half + radius)]
    return Revolve(tuple([(r, -z) for r, z in reversed(top)] + top))


def around(circles: Sequence[tuple[float, float, float]]) -> tuple[Point2, ...]:
    """Return the tight outline around circles, as a belt around pulleys: outline of a `Prism`.

    Args:
        circles: (x, y, radius) [m]; radius 0 is a sharp corner.

    Returns:
        The convex hull, counter-clockwise [m] (Andrew's monotone chain, 1979).
    """
    points = sorted(
        {
            (x + radius * cos(2.0 * pi * k / _CHORDS), y + radius * sin(2.0 * pi * k / _CHORDS))
            for x, y, radius in circles
            for k in range(_CHORDS if radius > 0.0 else 1)
        }
    )
    return (*_lower_chain(points)[:-1], *_lower_chain(points[::-1])[:-1])


def _lower_chain(points: Sequence[Point2]) -> list[Point2]:
    chain: list[Point2] = []
    for point in points:
        while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0.0:
            chain.pop()
        chain.append(point)
    return chain


def _turn(a: Point2, b: Point2, c: Point2) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
