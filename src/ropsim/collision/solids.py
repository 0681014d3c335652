"""From shapes to convex bodies: some are exact, others are replaced by their convex hull."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise, product
from types import MappingProxyType

import numpy as np

from ropsim.collision.convex import Convex, hull_of, turned
from ropsim.collision.convex_parts import convex_parts
from ropsim.collision.quick_hull import bounded_hull
from ropsim.model import Box, Cylinder, Mesh, Point2, Polyline, Prism, Revolve, Shape, Sphere
from ropsim.spatial import Array, Pose

MeshPoints = Mapping[Mesh, Array]
"""Points of meshes [m], shape (k, 3) each; a mesh without them is not checked."""
NO_MESHES: MeshPoints = MappingProxyType({})


def readable(meshes: MeshPoints) -> MeshPoints:
    """Return the meshes that have points, all of them finite."""
    return {mesh: points for mesh, points in meshes.items() if len(points) and np.isfinite(points).all()}


def convexes(shape: Shape, meshes: MeshPoints = NO_MESHES) -> tuple[Convex, ...]:
    """Return the convex bodies of a shape; a line, and a mesh without points, has none.

    Boxes, cylinders, cones, spheres and prisms are exact. A body of revolution is cut where its profile bends
    inward, and exact where its profile goes up throughout; else, as in a ring or a cup, its hollow is filled.
    A mesh is taken as its convex hull. A filled hollow counts as occupied, so a configuration reported free
    is free.

    Args:
        shape: in the frame of its body.
        meshes: the points of meshes.
    """
    pose = shape.pose
    match shape.solid:
        case Box(size):
            corners = list(product(*((-edge / 2.0, edge / 2.0) for edge in size)))
            return (hull_of(corners, pose),)
        case Cylinder() as one:
            half = one.length / 2.0
            return (turned(((one.radius, -half), (one.top_radius, half)), pose),)
        case Sphere(radius):
            return (hull_of([(0.0, 0.0, 0.0)], pose, radius),)
        case Revolve(profile):
            return tuple(turned(run, pose) for run in _convex_runs(profile))
        case Prism(outline, length):
            parts = convex_parts(outline)
            return tuple(hull_of([(x, y, z) for x, y in one for z in (0.0, length)], pose) for one in parts)
        case Mesh() as mesh:
            points = meshes.get(mesh)
            return () if points is None else (_meshed(points, pose),)
        case Polyline():
            return ()


def has_filled_hollow(shape: Shape) -> bool:
    """Return whether a shape may have hollows that its convex bodies fill."""
    match shape.solid:
        case Mesh():
            return True
        case Revolve(profile):
            return any(after[1] < before[1] for before, after in pairwise(profile))
    return False


def _convex_runs(profile: Sequence[Point2]) -> Iterator[Sequence[Point2]]:
    """Yield runs of a profile, as long as can be, that bend towards the axis only."""
    first = 0
    for k in range(2, len(profile)):
        (r0, z0), (r1, z1), (r2, z2) = profile[k - 2 : k + 1]
        if (r1 - r0) * (z2 - z1) - (z1 - z0) * (r2 - r1) < 0.0:
            yield profile[first:k]
            first = k - 1
    yield profile[first:]


def _meshed(points: Array, pose: Pose) -> Convex:
    """Return the hull of the points of a mesh, in the frame of the mesh."""
    corners, margin = bounded_hull(points)
    return hull_of(corners, pose, margin)
