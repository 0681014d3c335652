"""The surface of a convex body: its points that press on others, and the planes that bound its inside."""

from itertools import pairwise
from math import ceil, hypot, pi

import numpy as np

from ropsim.collision.contact.hull_faces import hull_faces
from ropsim.collision.convex import Convex, hull_of
from ropsim.spatial import Array, Pose, frozen, record

EDGE_STEP = 2e-3
"""Greatest distance of points on an edge [m]."""
LEAST_STEPS = 8
"""Least number of steps along an edge."""
RIM = 96
"""Points on a rim; it is 0.05 % of its radius wider than the polygon through them."""
MANY = 6
"""A body of more circles has half as many points on each."""
_HALF_WAY = 24
_FLOOR = 100.0  # [m]


@record
class Surface:
    """Surface of a convex body, in its own frame.

    Attributes:
        points: x, y, z [m] and weight of each, shape (k, 4); the weights of a flat face add up to 1 with
            those of its edges.
        edges: both ends [m], number of steps, and weight of a point, shape (e, 8).
        planes: nx, ny, nz and offset [m] of each; of a round body those of its profile: nr, nz, 0, offset;
            shape (m, 4).
        outer: how many points, the first ones, are corners or on a rim; the others lie within faces.
        is_round: whether the planes are those of a profile about z.
    """

    points: Array
    edges: Array
    planes: Array
    outer: int = 0
    is_round: bool = False

    def __post_init__(self) -> None:
        for name in ("points", "edges", "planes"):
            object.__setattr__(self, name, frozen(getattr(self, name)))


NO_EDGES = np.empty((0, 8))
FLOOR = hull_of(
    [(x, y, z) for x in (-_FLOOR, _FLOOR) for y in (-_FLOOR, _FLOOR) for z in (-1.0, 0.0)], Pose()
)
"""The floor: all below z = 0 of the world."""
FLOOR_SURFACE = Surface(np.empty((0, 4)), NO_EDGES, np.array([[0.0, 0.0, 1.0, 0.0]]))


def surface_of(convex: Convex) -> Surface:
    """Return the surface of a convex body; a ball has neither points nor planes, its centre is its hull.

    Args:
        convex: hull of corners or of circles.
    """
    if convex.is_round:
        return _round(convex)
    if len(convex.points) == 1:
        return Surface(np.empty((0, 4)), NO_EDGES, np.empty((0, 4)))
    return _flat(convex)


def _flat(convex: Convex) -> Surface:
    """Return the surface of a hull of corners.

    Of each face the corners have half of the weight, its edges a quarter, and points half way to its middle
    and the middle one eighth each; corners and edges are counted for each face on which they lie.
    """
    corners = np.asarray(convex.points)
    faces, lines = hull_faces(corners)
    rows = [(*corner, 0.125) for corner in corners.tolist()]
    for face in faces:
        middle = face.corners.mean(axis=0)
        share = 0.125 / len(face.corners)
        rows += [(*point, share) for point in (0.5 * (face.corners + middle)).tolist()]
        rows.append((*middle.tolist(), 0.125))
    edges = []
    for start, end in lines:
        steps = max(LEAST_STEPS, ceil(float(np.linalg.norm(end - start)) / EDGE_STEP))
        edges.append((*start.tolist(), *end.tolist(), steps, 0.0625 / (steps - 1)))
    planes = [(*face.normal.tolist(), face.offset + convex.margin) for face in faces]
    return Surface(
        np.array(rows), np.array(edges).reshape(-1, 8), np.array(planes).reshape(-1, 4), len(corners)
    )


def _round(convex: Convex) -> Surface:
    """Return the surface of a hull of circles: their rims, and of flat ends the half of it and the middle."""
    outline = _outline(convex.points[:, :2])
    count = RIM if len(outline) <= MANY else RIM // 2
    rows: list[tuple[float, ...]] = []
    for radius, height in outline:
        rows += _circle(radius, height, count, 0.8) if radius > 0.0 else [(0.0, 0.0, height, 0.125)]
    outer = len(rows)
    for radius, height in (outline[0], outline[-1]):
        if radius > 0.0:
            rows += [*_circle(0.5 * radius, height, _HALF_WAY, 0.1), (0.0, 0.0, height, 0.1)]
    bottom, top = outline[0][1], outline[-1][1]
    ring = [(0.0, bottom), *outline, (0.0, top)]
    planes = []
    for (r0, z0), (r1, z1) in pairwise(ring):
        length = hypot(r1 - r0, z1 - z0)
        if length > 0.0:
            across, along = (z1 - z0) / length, (r0 - r1) / length
            planes.append((across, along, 0.0, across * r0 + along * z0 + convex.margin))
    return Surface(np.array(rows), NO_EDGES, np.array(planes).reshape(-1, 4), outer, is_round=True)


def _circle(radius: float, height: float, count: int, weight: float) -> list[tuple[float, ...]]:
    angles = 2.0 * pi / count * np.arange(count)
    share = weight / count
    return [
        (x, y, height, share) for x, y in zip(radius * np.cos(angles), radius * np.sin(angles), strict=True)
    ]


def _outline(points: Array) -> list[tuple[float, float]]:
    """Return the (radius, height) of the circles on the hull, from the lower to the upper end."""
    rows = sorted({(float(z), float(r)) for r, z in points})
    lowest, highest = rows[0][0], rows[-1][0]
    kept: list[tuple[float, float]] = []
    for z, r in rows:
        if z in (lowest, highest) and any(other > r for height, other in rows if height == z):
            continue
        while len(kept) > 1 and _bends_in(kept[-2], kept[-1], (z, r)):
            kept.pop()
        kept.append((z, r))
    return [(r, z) for z, r in kept]


def _bends_in(one: tuple[float, float], two: tuple[float, float], three: tuple[float, float]) -> bool:
    """Return whether the middle one of three (height, radius) lies on or below the line of the others."""
    return (two[1] - one[1]) * (three[0] - one[0]) <= (three[1] - one[1]) * (two[0] - one[0])
