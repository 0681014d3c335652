"""How the ranges of the axes are divided: sheets of two axes, one for each combination of the others.

Each sheet is a grid of triangles. A chord of an arc of radius ρ over an angle δ is at most ρ·δ²/8 away from
it, and an envelope of sheets that are δ apart is also within this distance: with n steps of an axis the
workspace is too small by that at most along its border, so that half of the step leaves a quarter of the
error.
"""

import numpy as np

from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, record
from ropsim.workspace.point import MovedPoint, is_serial
from ropsim.workspace.ranges import AxisRanges
from ropsim.workspace.volume.sweep import Sweep, SweepKind, point_jacobian

STILL = 1e-9
"""An axis that moves the point by less than this [m/rad] does not move it."""
FINEST = 3e-5
"""Least sag that is worth its time [m]."""
COARSER = 1.15
"""Factor by which the sag grows until the work fits."""


@record
class Division:
    """How many steps each axis is divided into.

    Attributes:
        pair: numbers of the two axes of a sheet.
        inner: of axes whose values need separate frames.
        outer: of axes behind the pair in a serial arm, which only move the point in the frame of it.
        steps: of each of the n axes; 0 for axes at rest.
        sag: by which the border may lie too far inside for each axis [m].
    """

    pair: tuple[int, int]
    inner: tuple[int, ...]
    outer: tuple[int, ...]
    steps: tuple[int, ...]
    sag: float


def divided(
    robot: RobotModel, point: MovedPoint, sweep: Sweep, ranges: AxisRanges, Q: Array, budget: int
) -> Division:
    """Return the finest division that needs at most `budget` quadrangles.

    Args:
        robot: the arm.
        point: of it.
        sweep: effect of the first axis.
        ranges: of the axes.
        Q: configurations that fill them, shape (k, n).
        budget: quadrangles of all sheets.
    """
    J = point_jacobian(robot, point, Q)
    levers = np.linalg.norm(J, axis=1).max(axis=0)
    moving = [k for k in range(robot.n) if k != sweep.axis and levers[k] > STILL and ranges.extent[k] > 0.0]
    pair = _largest_pair(point.positions(robot, Q), J, sweep, ranges, moving)
    rest = [k for k in moving if k not in pair]
    outer = tuple(k for k in rest if k > max(pair) and is_serial(robot))
    slides = [joint.measure is JointType.PRISMATIC for joint in robot.axis_joints]
    sag = FINEST
    while True:
        steps = [0] * robot.n
        for k in moving:
            lever = float(levers.max()) if slides[k] else float(levers[k])
            curved = ranges.extent[k] / max(lever, 1.0) if slides[k] else ranges.extent[k]
            steps[k] = max(1 if slides[k] else 2, int(np.ceil(curved * np.sqrt(lever / (8.0 * sag)))))
        sheets = np.prod([float(steps[k] + 1) for k in rest])
        if sheets * steps[pair[0]] * steps[pair[1]] <= budget or sag > 1.0:
            return Division(pair, tuple(k for k in rest if k not in outer), outer, tuple(steps), sag)
        sag *= COARSER


def halved(division: Division) -> Division:
    """Return a division into half as many steps, whose border is up to four times as far off."""
    steps = tuple((count + 1) // 2 for count in division.steps)
    return Division(division.pair, division.inner, division.outer, steps, 4.0 * division.sag)


def section_coordinates(sweep: Sweep, p: Array) -> Array:
    """Return coordinates in the section for points of the base frame (k, 3) [m], shape (k, 2)."""
    x, y, z = ((p - sweep.X_BS[:3, 3]) @ sweep.X_BS[:3, :3]).T
    if sweep.kind is SweepKind.TURN:
        return np.column_stack((np.hypot(x, y), z))
    return np.column_stack((x, y))


def _largest_pair(p: Array, J: Array, sweep: Sweep, ranges: AxisRanges, moving: list[int]) -> tuple[int, int]:
    """Return the two axes whose sheet covers most of the section, in their order.

    Where fewer than two axes are left, others stand in for them: the section is then a curve or a point.
    """
    if len(moving) < 2:
        others = [k for k in range(len(ranges.lower)) if k not in moving]
        first, second = sorted([*moving, *others[::-1]][:2])
        return first, second
    X = sweep.X_BS
    local, turned = (p - X[:3, 3]) @ X[:3, :3], np.einsum("ji,kjn->kin", X[:3, :3], J)
    if sweep.kind is SweepKind.TURN:
        radius = np.maximum(np.hypot(local[:, 0], local[:, 1]), STILL)
        along = (local[:, :1] * turned[:, 0] + local[:, 1:2] * turned[:, 1]) / radius[:, np.newaxis]
        planar = np.stack((along, turned[:, 2]), axis=1)
    else:
        planar = turned[:, :2]
    pairs = [(a, b) for a in moving for b in moving if a < b]
    sizes = [
        float(np.abs(planar[:, 0, a] * planar[:, 1, b] - planar[:, 1, a] * planar[:, 0, b]).mean())
        * ranges.extent[a]
        * ranges.extent[b]
        for a, b in pairs
    ]
    return pairs[int(np.argmax(sizes))]
