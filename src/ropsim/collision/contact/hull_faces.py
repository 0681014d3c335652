"""Faces and edges of the convex hull of corners, triangles in one plane joined."""

import numpy as np

from ropsim.collision.quick_hull import triangles_of_hull
from ropsim.collision.solid_bodies import Rows
from ropsim.spatial import Array, frozen, record

SAME = 1e-7
"""Triangles whose normals differ by no more are one face."""


@record
class HullFace:
    """A flat face.

    Attributes:
        normal: outward unit vector, shape (3,).
        offset: of its plane from the origin along the normal [m].
        corners: of its triangles, each once [m], shape (k, 3).
    """

    normal: Array
    offset: float
    corners: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "normal", frozen(self.normal))
        object.__setattr__(self, "corners", frozen(self.corners))


def hull_faces(points: Array) -> tuple[tuple[HullFace, ...], Array]:
    """Return the faces of a hull, and its edges as pairs of points [m], shape (e, 2, 3).

    Both are empty where the points lie in one plane: such a body has no inside.

    Args:
        points: [m], shape (k, 3).
    """
    triangles = triangles_of_hull(points)
    if not len(triangles):
        return (), np.empty((0, 2, 3))
    corners = points[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    normals /= np.where(lengths > 0.0, lengths, 1.0)[:, np.newaxis]
    order = np.argsort(-lengths, kind="stable")
    groups: list[int] = []
    face_of = np.empty(len(triangles), dtype=np.intp)
    for k in order.tolist():
        near = [n for n, one in enumerate(groups) if np.abs(normals[one] - normals[k]).max() <= SAME]
        if not near:
            groups.append(k)
        face_of[k] = near[0] if near else len(groups) - 1
    faces = []
    for number, first in enumerate(groups):
        used = sorted({int(row) for row in triangles[face_of == number].ravel()})
        offset = float((points[used] @ normals[first]).max())
        faces.append(HullFace(normals[first], offset, points[used]))
    return tuple(faces), _edges(points, triangles, face_of)


def _edges(points: Array, triangles: Rows, face_of: Rows) -> Array:
    """Return the edges at which two faces meet, in the order of their corners."""
    faces: dict[tuple[int, int], set[int]] = {}
    for corners, face in zip(triangles.tolist(), face_of.tolist(), strict=True):
        for one, other in zip(corners, (*corners[1:], corners[0]), strict=True):
            faces.setdefault((min(one, other), max(one, other)), set()).add(face)
    between = sorted(edge for edge, two in faces.items() if len(two) > 1)
    return np.asarray(points[np.array(between, dtype=np.intp).reshape(-1, 2)])
