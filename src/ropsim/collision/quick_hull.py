"""The convex hull of many points, of bounded size: what is left out of it is told by a margin.

Quickhull (Barber, Dobkin & Huhdanpaa 1996): always the point that lies farthest outside is added, so that
few corners come near to the hull of a million points. Each point that is still outside belongs to a face from
which it can be seen, and its distance from that triangle bounds its distance from the hull.
"""

from heapq import heappop, heappush

import numpy as np
import numpy.typing as npt

from ropsim.collision.polytope import Polytope
from ropsim.spatial import Array

MOST = 400
"""Corners of a hull."""
FINE = 1e-9
"""What lies nearer to a face than this share of the size is in it."""


def bounded_hull(points: npt.ArrayLike, most: int = MOST) -> tuple[Array, float]:
    """Return corners of a hull [m], shape (c, 3), and how far at most a point lies outside of it [m].

    Args:
        points: [m], shape (k, 3), k > 0.
        most: corners.
    """
    every = np.asarray(points, dtype=np.float64)
    if len(every) <= 8:
        return every, 0.0
    middle = every.mean(axis=0)
    local = every - middle
    growing = _Growing(local, FINE * float(np.ptp(local, axis=0).max()))
    while len(growing.polytope.points) < most and growing.grow():
        pass
    used = sorted({corner for face in growing.polytope.faces.values() for corner in face.corners})
    corners = np.array([growing.polytope.points[k] for k in used]) + middle
    return corners, growing.margin() + growing.fine


class _Growing:
    """A hull and the points outside of it, by the face that sees them."""

    def __init__(self, points: Array, fine: float) -> None:
        self.points, self.fine = points, fine
        self.polytope = Polytope.within(points)
        self.outside: dict[int, npt.NDArray[np.intp]] = {}
        self.order: list[tuple[float, int, int]] = []
        self._deal(np.arange(len(points)), list(self.polytope.faces))

    def grow(self) -> bool:
        """Add the point that is farthest outside; return False where none is."""
        while self.order:
            _, face, farthest = heappop(self.order)
            if face not in self.polytope.faces:
                continue
            gone, new = self.polytope.add(self.points[farthest], face)
            if new:
                self._deal(
                    np.concatenate([self.outside.pop(one) for one in gone if one in self.outside]), new
                )
                return True
        return False

    def margin(self) -> float:
        """Return how far a point may still be outside [m]."""
        rest = [(face, rows) for face, rows in self.outside.items() if len(rows)]
        return max((self._from_triangle(face, rows) for face, rows in rest), default=0.0)

    def _deal(self, rows: npt.NDArray[np.intp], faces: list[int]) -> None:
        """Give each point to the face above which it is highest; one that is above none is inside."""
        planes = [self.polytope.faces[number] for number in faces]
        heights = self.points[rows] @ np.array([face.normal for face in planes]).T
        heights -= [face.offset for face in planes]
        best, own = heights.argmax(axis=1), heights.max(axis=1)
        for place, number in enumerate(faces):
            mine = np.flatnonzero((best == place) & (own > self.fine))
            if len(mine):
                self.outside[number] = rows[mine]
                top = mine[int(np.argmax(own[mine]))]
                heappush(self.order, (-float(own[top]), number, int(rows[top])))

    def _from_triangle(self, number: int, rows: npt.NDArray[np.intp]) -> float:
        """Return the greatest distance of points from a face that sees them [m]."""
        face = self.polytope.faces[number]
        points = self.points[rows]
        corners = [self.polytope.points[k] for k in face.corners]
        heights = points @ face.normal - face.offset
        inside = np.ones(len(rows), dtype=np.bool_)
        nearest = np.full(len(rows), np.inf)
        for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
            along = end - start
            inside &= (points - start) @ np.cross(face.normal, along) >= 0.0
            share = np.clip((points - start) @ along / float(along @ along), 0.0, 1.0)
            foot = start + share[:, np.newaxis] * along
            nearest = np.minimum(nearest, np.linalg.norm(points - foot, axis=1))
        return float(np.where(inside, heights, nearest).max())
