"""A convex polytope that grows point by point, by its triangles."""

from dataclasses import dataclass, field
from math import hypot

import numpy as np

from ropsim.spatial import Array

FLAT = 1e-10
"""Distance from the plane of a face within which a point counts as in it, as a share of the size."""
SLIGHT = 1e-6
"""Least thickness as a share of the size; thinner bodies are thickened."""


@dataclass(frozen=True, slots=True)
class Face:
    """A triangle of a polytope, counter-clockwise from outside.

    Attributes:
        corners: places in the points of the polytope.
        normal: outward unit vector, shape (3,).
        offset: distance of its plane from the origin along the normal [m].
    """

    corners: tuple[int, int, int]
    normal: Array
    offset: float

    @property
    def edges(self) -> tuple[tuple[int, int], ...]:
        """Return its edges in order."""
        i, j, k = self.corners
        return (i, j), (j, k), (k, i)


@dataclass(slots=True)
class Polytope:
    """A polytope under construction.

    Attributes:
        points: all corners that were added [m].
        flat: distance from a plane that counts as in it [m].
        faces: by number; a number is never used again.
        face_of_edge: number of the face to the left of an edge.
        made: how many faces there have been.
    """

    points: list[Array]
    flat: float
    faces: dict[int, Face] = field(default_factory=dict)
    face_of_edge: dict[tuple[int, int], int] = field(default_factory=dict)
    made: int = 0

    @classmethod
    def within(cls, points: Array) -> "Polytope":
        """Return a tetrahedron of far points; flat points get a slight thickness.

        Args:
            points: [m], shape (k, 3).
        """
        size = float(np.ptp(points, axis=0).max()) or 1.0
        corners = far_points(points)
        if _thickness(corners) < SLIGHT * size:
            bump = SLIGHT * size * np.vstack([np.eye(3), -np.eye(3)])
            corners = far_points(np.vstack([points, points.mean(axis=0) + bump]))
        made = cls(list(corners), FLAT * size)
        p0, p1, p2, p3 = corners
        inward = np.dot(np.cross(p1 - p0, p2 - p0), p3 - p0) > 0.0
        for i, j, k in ((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)):
            made.put((i, k, j) if inward else (i, j, k))
        return made

    def put(self, corners: tuple[int, int, int]) -> int:
        """Add a face and return its number."""
        (x, y, z), one, other = (self.points[k].tolist() for k in corners)
        a, b, c = one[0] - x, one[1] - y, one[2] - z
        d, e, f = other[0] - x, other[1] - y, other[2] - z
        across = b * f - c * e, c * d - a * f, a * e - b * d
        length = hypot(*across) or 1.0
        u, v, w = across[0] / length, across[1] / length, across[2] / length
        face = Face(corners, np.array([u, v, w]), u * x + v * y + w * z)
        number, self.made = self.made, self.made + 1
        self.faces[number] = face
        self.face_of_edge.update(dict.fromkeys(face.edges, number))
        return number

    def add(self, point: Array, seen: int) -> tuple[list[int], list[int]]:
        """Take a point in; return the numbers of the faces that were removed, and of the new ones.

        Faces that see the point, or whose plane contains it, are removed; the rim of the hole is joined to it
        (Barber, Dobkin & Huhdanpaa 1996). Nothing is done where the rim is no simple ring, for rounding.

        Args:
            point: outside of a face [m], shape (3,).
            seen: number of that face.
        """
        visible, waiting = {seen}, [seen]
        rim: list[tuple[int, int]] = []
        while waiting:
            for i, j in self.faces[waiting.pop()].edges:
                number = self.face_of_edge[j, i]
                face = self.faces[number]
                if number in visible:
                    continue
                if float(face.normal @ point) - face.offset > -self.flat:
                    visible.add(number)
                    waiting.append(number)
        for number in visible:
            rim += [
                edge
                for edge in self.faces[number].edges
                if self.face_of_edge[edge[1], edge[0]] not in visible
            ]
        if not rim or len({start for start, _ in rim}) < len(rim):
            return [], []
        gone = sorted(visible)
        for number in gone:
            for edge in self.faces.pop(number).edges:
                del self.face_of_edge[edge]
        self.points.append(point)
        return gone, [self.put((i, j, len(self.points) - 1)) for i, j in sorted(rim)]


def far_points(points: Array) -> Array:
    """Return four points that span much: far from each other, from their line and from their plane."""
    first = points[int(np.argmin(points[:, int(np.argmax(np.ptp(points, axis=0)))]))]
    second = points[int(np.argmax(np.linalg.norm(points - first, axis=1)))]
    third = points[int(np.argmax(np.linalg.norm(np.cross(points - first, second - first), axis=1)))]
    normal = np.cross(second - first, third - first)
    return np.array([first, second, third, points[int(np.argmax(np.abs((points - first) @ normal)))]])


def _thickness(corners: Array) -> float:
    """Return the least height of a tetrahedron over its largest face [m]; 0 where it is flat."""
    one, other, last = corners[1:] - corners[0]
    normal = np.cross(one, other)
    area = float(np.linalg.norm(normal))
    wide = float(np.linalg.norm(one))
    return min(abs(float(normal @ last)) / area, area / wide) if area > 0.0 else 0.0
