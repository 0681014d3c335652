"""Shapes as plain values for the page, and the boxes around them."""

from collections.abc import Mapping

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model import Box, Cylinder, Mesh, Point3, Polyline, Prism, Revolve, Shape, Solid, Sphere
from ropsim.spatial import Array, Pose


@frozen_dataclass
class MeshSource:
    """Where the page finds the triangles of a mesh.

    Attributes:
        address: SHA-256 of its GLB bytes; empty where it cannot be had.
        missing: why it cannot be had, in words.
        low: least x, y, z of its points [m].
        high: greatest x, y, z [m].
    """

    address: str
    missing: str = ""
    low: Point3 = (0.0, 0.0, 0.0)
    high: Point3 = (0.0, 0.0, 0.0)


NOT_READ = MeshSource("", "the file has not been read")
"""Points of meshes if no mesh was read."""


_CORNERS = np.array([[(k >> axis) & 1 for axis in range(3)] for k in range(8)], dtype=np.bool_)


def plain_shape(shape: Shape, meshes: Mapping[Mesh, MeshSource]) -> dict[str, object]:
    """Return a shape as plain values, meshes by their address."""
    values = _plain(shape.solid)
    if isinstance(shape.solid, Mesh):
        source = meshes.get(shape.solid, NOT_READ)
        values |= {"mesh": source.address, "missing": source.missing}
    look = {"colour": shape.colour, "opacity": shape.opacity, "material": shape.material.value}
    return {**values, "pose": plain_pose(shape.pose), **look}


def plain_pose(pose: Pose) -> list[float]:
    """Return x, y, z [m] and the unit quaternion w, x, y, z."""
    return list(pose.as_tuple())


def corners(shape: Shape, meshes: Mapping[Mesh, MeshSource]) -> Array:
    """Return the corners of a box around a shape, in the frame of its body [m], shape (8, 3)."""
    low, high = _bounds(shape.solid, meshes)
    local = np.where(_CORNERS, high, low)
    return np.asarray(local @ shape.pose.rotation().T + shape.pose.position)


def _plain(solid: Solid) -> dict[str, object]:
    match solid:
        case Box(size):
            return {"kind": "box", "size": list(size)}
        case Cylinder(radius, length):
            return {"kind": "cylinder", "radius": radius, "top": solid.top_radius, "length": length}
        case Sphere(radius):
            return {"kind": "sphere", "radius": radius}
        case Revolve(profile):
            return {"kind": "revolve", "profile": [list(point) for point in profile]}
        case Prism(outline, length):
            return {"kind": "prism", "outline": [list(point) for point in outline], "length": length}
        case Polyline(points):
            return {"kind": "line", "points": [list(point) for point in points]}
        case Mesh(file):
            return {"kind": "mesh", "file": file}


def _bounds(solid: Solid, meshes: Mapping[Mesh, MeshSource]) -> tuple[Array, Array]:
    """Return the least and greatest x, y, z of a solid in its own frame [m], shape (3,) each."""
    match solid:
        case Box(size):
            half = np.array(size) / 2.0
            return -half, half
        case Cylinder(radius, length):
            widest = max(radius, solid.top_radius)
            half = np.array([widest, widest, length / 2.0])
            return -half, half
        case Sphere(radius):
            half = np.full(3, radius)
            return -half, half
        case Revolve(profile):
            widest, heights = max(r for r, _ in profile), [z for _, z in profile]
            return np.array([-widest, -widest, min(heights)]), np.array([widest, widest, max(heights)])
        case Prism(outline, length):
            flat = np.array(outline)
            return np.array([*flat.min(axis=0), 0.0]), np.array([*flat.max(axis=0), length])
        case Polyline(points):
            line = np.array(points)
            return line.min(axis=0), line.max(axis=0)
        case Mesh():
            source = meshes.get(solid, NOT_READ)
            return np.array(source.low), np.array(source.high)
