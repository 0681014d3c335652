"""The section of a workspace on a lattice: which of its points the arm reaches, and on how much of its sweep.

The lattice is turned by the angle whose tangent is the golden ratio, so that edges along its coordinates,
as the walls of a cylinder, meet it as evenly as edges can (its slopes are the worst to approximate).
"""

from collections.abc import Iterator
from itertools import product
from math import atan, cos, sin, sqrt

import numpy as np

from ropsim.kinematics import frames_batch
from ropsim.model import RobotModel, coupled_limits
from ropsim.spatial import Array, record
from ropsim.workspace.point import MovedPoint, is_serial
from ropsim.workspace.ranges import TURN, AxisRanges
from ropsim.workspace.volume import raster_kernel
from ropsim.workspace.volume.sheets import Division
from ropsim.workspace.volume.sweep import Sweep, SweepKind

TILT = atan((sqrt(5.0) - 1.0) / 2.0)
"""Angle of the lattice against the section [rad]."""
CHORD = 0.1
"""Largest distance of a chord from its arc near the axis, in spacings of the lattice."""


@record
class Section:
    """The section on a lattice of na × nb points.

    Attributes:
        spacing: of the lattice [m].
        corner: lattice coordinates of point (0, 0), in spacings, shape (2,).
        covered: 1.0 for points that are reached, else 0.0, shape (na, nb).
        share: how much of the sweep reaches them, [rad] of a turn, [m] of a slide, 1 where flat, (na, nb).
        starts: intervals of the third coordinate, as `raster_kernel` keeps them, shape (na, nb, 1 + 2·MOST).
    """

    spacing: float
    corner: Array
    covered: Array
    share: Array
    starts: Array

    def places(self) -> Array:
        """Return the coordinates of the lattice points in the section [m], shape (na, nb, 2)."""
        na, nb = self.covered.shape
        a, b = np.arange(float(na)), np.arange(float(nb))
        return self.placed(np.stack(np.meshgrid(a, b, indexing="ij"), axis=-1))

    def placed(self, at: Array) -> Array:
        """Return coordinates in the section [m] of places between lattice points, shape (..., 2)."""
        A, B = np.moveaxis(at + self.corner, -1, 0)
        c, s = cos(TILT) * self.spacing, sin(TILT) * self.spacing
        return np.stack((c * A - s * B, s * A + c * B), axis=-1)


def lattice_coordinates(places: Array, spacing: float) -> Array:
    """Return coordinates along the lattice, in spacings, for places (k, 2) in the section [m]."""
    c, s = cos(TILT) / spacing, sin(TILT) / spacing
    return np.asarray(places @ np.array([[c, -s], [s, c]]))


def rastered(
    robot: RobotModel,
    point: MovedPoint,
    sweep: Sweep,
    ranges: AxisRanges,
    division: Division,
    box: Array,
    spacing: float,
) -> Section:
    """Return the section of a workspace.

    Args:
        robot: the arm.
        point: of it.
        sweep: effect of its first axis.
        ranges: of the axes.
        division: of them.
        box: least and greatest coordinates of the section [m], shape (2, 2).
        spacing: of the lattice [m].
    """
    (u0, v0), (u1, v1) = box.tolist()
    ends = lattice_coordinates(np.array([[u0, v0], [u0, v1], [u1, v0], [u1, v1]]), spacing)
    corner = np.floor(ends.min(axis=0)) - 2.0
    na, nb = (int(count) for count in np.ceil(ends.max(axis=0)) + 3.0 - corner)
    marks = np.zeros((na, nb, 1 + 2 * raster_kernel.MOST))
    c, s = cos(TILT) / spacing, sin(TILT) / spacing
    turning = 1.0 if sweep.kind is SweepKind.TURN else 0.0
    columns = division.steps[division.pair[1]] + 1
    lattice = np.array([turning, sweep.reach, c, s, -corner[0], -s, c, -corner[1], columns, CHORD * spacing])
    for F, V, slacks in _sheets(robot, point, sweep, ranges, division):
        width = 3 + slacks.shape[1]
        stack = np.empty((raster_kernel.DEPTH, 3 * width))
        raster_kernel.cover(lattice, F, V, slacks, np.empty((len(F), width)), stack, marks)
    covered = (marks[:, :, 0] != 0.0).astype(np.float64)
    return Section(spacing, corner, covered, _share(marks, sweep), marks)


def _sheets(
    robot: RobotModel, point: MovedPoint, sweep: Sweep, ranges: AxisRanges, division: Division
) -> Iterator[tuple[Array, Array, Array]]:
    """Yield frames of the grid (k, 12), points in them (s, 3) and the margins of coupled limits (k, c)."""
    i, j = division.pair
    still = np.where(ranges.lower > 0.0, ranges.lower, np.minimum(ranges.upper, 0.0))
    if sweep.axis >= 0:
        still[sweep.axis] = 0.0
    values = [_values(ranges, division, k) for k in range(robot.n)]
    grid = np.stack(np.meshgrid(values[i], values[j], indexing="ij"), axis=-1).reshape(-1, 2)
    coupled = coupled_limits(robot)
    R, o = sweep.X_BS[:3, :3], sweep.X_BS[:3, 3]
    serial = is_serial(robot)
    for inner in product(*(values[k] for k in division.inner)):
        Q = np.tile(still, (len(grid), 1))
        Q[:, list(division.inner)] = inner
        Q[:, [i, j]] = grid
        X = _frames(robot, Q, values, (i, j)) if serial else frames_batch(robot, Q)[:, point.frame]
        F = np.concatenate(((R.T @ X[:, :3, :3]).reshape(-1, 9), (X[:, :3, 3] - o) @ R), axis=1)
        V = _points(robot, point, Q[0], division, values) if serial else point.p[np.newaxis]
        held = coupled.values(Q)
        slacks = np.concatenate((held - coupled.lower, coupled.upper - held), axis=1)
        yield np.ascontiguousarray(F), np.ascontiguousarray(V), np.ascontiguousarray(slacks)


def _frames(robot: RobotModel, Q: Array, values: list[Array], pair: tuple[int, int]) -> Array:
    """Return the frames of the second of two axes of a serial arm on their grid Q, shape (k, 4, 4).

    They are products of frames of the first axis and of frames of the second one in them.
    """
    i, j = pair
    columns = len(values[j])
    first = frames_batch(robot, Q[::columns])[:, i]
    both = frames_batch(robot, Q[:columns])
    second = np.linalg.inv(both[0, i]) @ both[:, j]
    return np.asarray((first[:, np.newaxis] @ second).reshape(-1, 4, 4))


def _points(robot: RobotModel, point: MovedPoint, q: Array, division: Division, values: list[Array]) -> Array:
    """Return the point in the frame of the last axis of a sheet for all values of the later axes, (s, 3)."""
    outer = list(division.outer)
    rows = np.array(list(product(*(values[k] for k in outer))))
    Q = np.tile(q, (len(rows), 1))
    Q[:, outer] = rows
    frames = frames_batch(robot, Q)
    X = frames[0, division.pair[1]]
    F = frames[:, point.frame]
    return np.asarray((F[:, :3, :3] @ point.p + F[:, :3, 3] - X[:3, 3]) @ X[:3, :3])


def _values(ranges: AxisRanges, division: Division, k: int) -> Array:
    """Return the values of an axis [rad | m]: both ends and evenly spaced values between."""
    return np.linspace(ranges.lower[k], ranges.upper[k], division.steps[k] + 1)


def _share(marks: Array, sweep: Sweep) -> Array:
    """Return how much of the sweep reaches each point, shape (na, nb)."""
    count = marks[:, :, 0]
    if sweep.kind is SweepKind.FLAT:
        return np.asarray((count != 0.0).astype(np.float64))
    lengths = marks[:, :, 2::2] - marks[:, :, 1::2] + sweep.reach
    used = np.arange(raster_kernel.MOST) < count[:, :, np.newaxis]
    total = np.where(used, lengths, 0.0).sum(axis=-1)
    if sweep.kind is SweepKind.TURN:
        return np.where(count == raster_kernel.FULL, TURN, np.minimum(total, TURN))
    return np.asarray(total)
