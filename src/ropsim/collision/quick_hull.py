"""The convex hull of many points, of bounded size: omitted points lie within a margin.

Quickhull (Barber, Dobkin & Huhdanpaa 1996): always the point that lies farthest outside is added, so that few
corners come near to the hull of a million points. It grows among points stretched to unit extent, so that
thin bodies are no slivers; which point is next, and the margin, are measured by true distances. Each point
that is still outside belongs to a face from which it can be seen, and its distance from that triangle bounds
its distance from the hull.
"""

from heapq import heappop, heappush

import numpy as np
import numpy.typing as npt

from ropsim.collision.polytope import Polytope
from ropsim.collision.shortfall import from_triangles, shortfall
from ropsim.collision.unit_points import FINE, UnitPoints, unit_points
from ropsim.spatial import Array

MOST = 400
"""Corners of a hull."""
ROUNDING = 1e-13
"""Points above a face by less than this share of the size count as in its plane."""


def bounded_hull(points: npt.ArrayLike, most: int = MOST) -> tuple[Array, float]:
    """Return corners of a hull [m], shape (c, 3), and how far at most a point lies outside of it [m].

    Args:
        points: [m], shape (k, 3), k > 0.
        most: corners, 4 or more.
    """
    every = np.asarray(points, dtype=np.float64)
    if len(every) <= 8:
        return every, 0.0
    unit = unit_points(every)
    if unit is None:
        return every[:1], 0.0
    growing = _Growing(unit)
    while len(growing.rows) - len(unit.points) + unit.given < most and growing.grow():
        pass
    corners = every[growing.corners()]
    rows, triangles = growing.left()
    rest = every[rows]
    middle = corners.mean(axis=0)  # far from the origin distances would lose digits
    bounds = from_triangles(rest, every[triangles])
    open_ = bounds > FINE * unit.size
    margin = shortfall(corners - middle, rest[open_] - middle, bounds[open_])
    return corners, margin + FINE * unit.size


def triangles_of_hull(points: Array) -> npt.NDArray[np.intp]:
    """Return the triangles of the hull of points as their rows, counter-clockwise from outside, shape (t, 3).

    None where the points lie in one plane.

    Args:
        points: [m], shape (k, 3), k > 0.
    """
    unit = unit_points(points)
    if unit is None or len(unit.points) > unit.given:
        return np.empty((0, 3), np.intp)
    growing = _Growing(unit)
    while growing.grow():
        pass
    faces = growing.polytope.faces.values()
    rows = [[growing.rows[corner] for corner in face.corners] for face in faces]
    return np.array(sorted(rows), np.intp)


class _Growing:
    """A hull and the points outside of it, by the face that sees them."""

    def __init__(self, unit: UnitPoints) -> None:
        self.unit = unit
        self.polytope = Polytope.within(unit.points)
        self.rows = [int(np.argmin(np.abs(unit.points - one).max(axis=1))) for one in self.polytope.points]
        """Which point each corner of the polytope is."""
        self.outside: dict[int, npt.NDArray[np.intp]] = {}
        self.order: list[tuple[float, int, int]] = []
        self._deal(np.arange(len(unit.points)), list(self.polytope.faces))

    def grow(self) -> bool:
        """Add the point that is farthest outside; return False where none is."""
        while self.order:
            _, face, farthest = heappop(self.order)
            if face not in self.polytope.faces:
                continue
            gone, new = self.polytope.add(self.unit.points[farthest], face)
            if new:
                self.rows.append(farthest)
                self._deal(
                    np.concatenate([self.outside.pop(one) for one in gone if one in self.outside]), new
                )
                return True
        return False

    def corners(self) -> list[int]:
        """Return which of the points that were given are corners, ascending."""
        used = {corner for face in self.polytope.faces.values() for corner in face.corners}
        return sorted(row for row in {self.rows[corner] for corner in used} if row < self.unit.given)

    def left(self) -> tuple[npt.NDArray[np.intp], npt.NDArray[np.intp]]:
        """Return the points that are still outside, and of each the corners of its face.

        Apexes are no corners: the others of the face stand in for them.
        """
        rows, triangles = [np.empty(0, np.intp)], [np.empty((0, 3), np.intp)]
        for number, seen in self.outside.items():
            real = [self.rows[k] for k in self.polytope.faces[number].corners]
            real = [row for row in real if row < self.unit.given]
            rows.append(seen[seen < self.unit.given])
            triangles.append(np.tile((real * 3)[:3] if len(real) < 3 else real, (len(rows[-1]), 1)))
        return np.concatenate(rows), np.concatenate(triangles)

    def _deal(self, rows: npt.NDArray[np.intp], faces: list[int]) -> None:
        """Assign each point to the face above which it is highest; one that is above none is inside."""
        planes = [self.polytope.faces[number] for number in faces]
        normals = np.array([face.normal for face in planes])
        heights = self.unit.points[rows] @ normals.T - [face.offset for face in planes]
        heights /= np.linalg.norm(normals / self.unit.scale, axis=1)
        best, own = heights.argmax(axis=1), heights.max(axis=1)
        for place, number in enumerate(faces):
            mine = np.flatnonzero((best == place) & (own > ROUNDING * self.unit.size))
            if len(mine):
                self.outside[number] = rows[mine]
                top = mine[int(np.argmax(own[mine]))]
                if own[top] > FINE * self.unit.size:
                    heappush(self.order, (-float(own[top]), number, int(rows[top])))
