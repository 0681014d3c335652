"""Graphic elements as triangles: enough of them that round ones look round."""

from math import pi

import numpy as np

from ropsim.model import Box, Cylinder, Point3, Polyline, Prism, Revolve, Shape, Solid, Sphere
from ropsim.spatial import Array

SIDES = 56
"""Facets round a body of revolution."""
_STACKS = 20  # of a sphere
_BAR = 0.002  # [m], radius of the bar that stands for a line
_X, _Z = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])


def facets(shape: Shape) -> Array:
    """Return the triangles of a shape in the frame of its body [m], shape (k, 3, 3).

    Lines are thin bars. Meshes have no triangles: they are files of a project. Corners go counter-clockwise
    as seen from outside.
    """
    made = _facets(shape.solid)
    X = shape.pose.matrix()
    return np.asarray(made @ X[:3, :3].T + X[:3, 3])


def _facets(solid: Solid) -> Array:
    match solid:
        case Box(size):
            x, y, z = (0.5 * edge for edge in size)
            return _drawn_out(((-x, -y), (x, -y), (x, y), (-x, y)), -z, z)
        case Cylinder(radius, length):
            low, high = -0.5 * length, 0.5 * length
            return _turned(((0.0, low), (radius, low), (solid.top_radius, high), (0.0, high)))
        case Sphere(radius):
            angles = np.linspace(-0.5 * pi, 0.5 * pi, _STACKS + 1)
            return _turned(tuple((radius * np.cos(one), radius * np.sin(one)) for one in angles))
        case Revolve(profile):
            return _turned(profile)
        case Prism(outline, length):
            return _drawn_out(outline, 0.0, length)
        case Polyline(points):
            return _bars(points)
        case _:
            return np.empty((0, 3, 3))


def _turned(profile: tuple[tuple[float, float], ...]) -> Array:
    """Return the surface of a body of revolution about z."""
    angles = np.linspace(0.0, 2.0 * pi, SIDES + 1)
    round_ = np.stack((np.cos(angles), np.sin(angles)), axis=1)
    rings = np.array([np.column_stack((r * round_, np.full(len(angles), z))) for r, z in profile])
    a, b = rings[:-1, :-1].reshape(-1, 3), rings[:-1, 1:].reshape(-1, 3)
    c, d = rings[1:, 1:].reshape(-1, 3), rings[1:, :-1].reshape(-1, 3)
    return _with_area(np.concatenate((np.stack((a, b, c), axis=1), np.stack((a, c, d), axis=1))))


def _drawn_out(outline: tuple[tuple[float, float], ...], low: float, high: float) -> Array:
    """Return the surface of a flat outline that is drawn out along z; caps are cut into ears."""
    flat = np.array(outline)
    bottom, top = (np.column_stack((flat, np.full(len(flat), z))) for z in (low, high))
    following = np.roll(np.arange(len(flat)), -1)
    sides = [
        np.stack((bottom, bottom[following], top[following]), axis=1),
        np.stack((bottom, top[following], top), axis=1),
    ]
    ears = np.array(_ears(flat))
    return _with_area(np.concatenate((*sides, top[ears], bottom[ears[:, ::-1]])))


def _bars(points: tuple[Point3, ...]) -> Array:
    """Return a bar of three sides for each straight part of a line."""
    line = np.array(points)
    start, way = line[:-1], np.diff(line, axis=0)
    long = np.linalg.norm(way, axis=1) > 1e-9
    start, way = start[long], way[long]
    other = np.where(np.abs(way[:, 2:]) > 0.9 * np.linalg.norm(way, axis=1)[:, None], _X, _Z)
    one = np.cross(way, other)
    one /= np.linalg.norm(one, axis=1)[:, None]
    two = np.cross(way, one) / np.linalg.norm(way, axis=1)[:, None]
    angles = 2.0 * pi / 3.0 * np.arange(3)
    rings = start + _BAR * (np.cos(angles)[:, None, None] * one + np.sin(angles)[:, None, None] * two)
    ends, following = rings + way, np.roll(np.arange(3), -1)
    sides = (
        np.stack((rings, rings[following], ends[following]), axis=2),
        np.stack((rings, ends[following], ends), axis=2),
    )
    return _with_area(np.concatenate([side.reshape(-1, 3, 3) for side in sides]))


def _ears(flat: Array) -> list[tuple[int, int, int]]:
    """Return the triangles of a simple polygon, counter-clockwise (Meisters 1975), corners by number."""
    left, found = list(range(len(flat))), []
    while len(left) > 3:
        ear = next((k for k in range(len(left)) if _is_ear(flat, left, k)), 0)
        found.append((left[ear - 1], left[ear], left[(ear + 1) % len(left)]))
        del left[ear]
    return [*found, (left[0], left[1], left[2])]


def _is_ear(flat: Array, left: list[int], k: int) -> bool:
    a, b, c = flat[left[k - 1]], flat[left[k]], flat[left[(k + 1) % len(left)]]
    if _turn(a, b, c) <= 0.0:
        return False
    others = [flat[one] for one in left if one not in (left[k - 1], left[k], left[(k + 1) % len(left)])]
    return not any(min(_turn(a, b, p), _turn(b, c, p), _turn(c, a, p)) > 0.0 for p in others)


def _turn(a: Array, b: Array, c: Array) -> float:
    return float((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))


def _with_area(triangles: Array) -> Array:
    """Return the triangles that are more than a line."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    return np.asarray(triangles[np.linalg.norm(normals, axis=1) > 1e-12])
