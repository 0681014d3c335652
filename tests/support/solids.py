"""Points on the surfaces of graphic elements, for tests of how things touch."""

from itertools import pairwise

import numpy as np

from ropsim.model import Box, Cylinder, Prism, Revolve, Shape, Solid, Sphere
from ropsim.spatial import Array

STEP = 0.008
"""Distance of neighbouring points [m]."""


def surface_points(shape: Shape) -> Array:
    """Return points on a shape in the frame of its body [m], shape (k, 3), at most about `STEP` apart."""
    return np.asarray(_points(shape.solid) @ shape.pose.rotation().T + shape.pose.position)


def _points(solid: Solid) -> Array:
    match solid:
        case Box((x, y, z)):
            outline = [(-x / 2, -y / 2), (x / 2, -y / 2), (x / 2, y / 2), (-x / 2, y / 2)]
            return _drawn_out(outline, z) - [0.0, 0.0, z / 2]
        case Cylinder(radius, length):
            half = length / 2
            return _turned([(0.0, -half), (radius, -half), (solid.top_radius, half), (0.0, half)])
        case Sphere(radius):
            angles = np.linspace(-np.pi / 2, np.pi / 2, 40)
            return _turned([(radius * float(np.cos(a)), radius * float(np.sin(a))) for a in angles])
        case Revolve(profile):
            return _turned(list(profile))
        case Prism(outline, length):
            return _drawn_out(list(outline), length)
    raise AssertionError(f"no points of a {type(solid).__name__}")


def _along(points: list[tuple[float, float]]) -> Array:
    pieces = []
    for first, last in pairwise(points):
        count = max(2, int(np.hypot(last[0] - first[0], last[1] - first[1]) / STEP) + 2)
        pieces.append(np.linspace(first, last, count))
    return np.concatenate(pieces)


def _turned(profile: list[tuple[float, float]]) -> Array:
    rows = _along(profile)
    angles = np.arange(0.0, 2.0 * np.pi, STEP / max(float(rows[:, 0].max()), STEP))
    around = np.array([[np.cos(a), np.sin(a)] for a in angles])
    flat = rows[:, np.newaxis, :1] * around
    heights = np.broadcast_to(rows[:, np.newaxis, 1:], (len(rows), len(angles), 1))
    return np.concatenate([flat, heights], axis=2).reshape(-1, 3)


def _drawn_out(outline: list[tuple[float, float]], length: float) -> Array:
    rim = _along([*outline, outline[0]])
    middle = rim.mean(axis=0)
    shares = np.linspace(0.0, 1.0, int(float(np.linalg.norm(rim - middle, axis=1).max()) / STEP) + 2)
    face = (middle + shares[:, np.newaxis, np.newaxis] * (rim - middle)).reshape(-1, 2)
    heights = np.linspace(0.0, length, int(length / STEP) + 2)
    sides = [np.column_stack([rim, np.full(len(rim), height)]) for height in heights]
    caps = [np.column_stack([face, np.full(len(face), height)]) for height in (0.0, length)]
    return np.concatenate([*sides, *caps])
