"""Bounds of speed, acceleration and jerk along a piece of a stretch."""

from dataclasses import replace

import numpy as np

from ropsim.controller.coordination import Coordination
from ropsim.motion import JointMotionLimits, JointPath, Stage, ToolLimits, ToolPath
from ropsim.spatial import Array

_PLACES = np.linspace(0.0, 1.0, 33)
_TINY = 1e-300

_BENT, _ALONG = 0.92, 0.08
"""Shares of a joint's acceleration for the bend of its path and for changes of speed along it."""
_TOOL_BENT, _TOOL_ALONG = 0.9, 0.43
"""The same for the tool, where both are at right angles: 0.9² + 0.43² < 1."""
_JERK_BENT = 0.9
"""Share of a jerk for the bend at most; of the rest, half is for changes of speed in the bend."""


def joint_stage(path: JointPath, limits: JointMotionLimits) -> Stage:
    """Return the bounds of a path in joint space; for a straight one they are exact.

    Args:
        path: of the joints.
        limits: of every joint.
    """
    points = path.joints(_PLACES * path.length)
    d1, d2 = np.abs(points.d1).max(axis=0), np.abs(points.d2).max(axis=0)
    speed = _least(limits.speed, d1)
    if not d2.any():
        return Stage(path.length, speed, _least(limits.acceleration, d1), _least(limits.jerk, d1))
    d3 = np.abs(_slopes(points.d2, path.length)).max(axis=0)
    return _bent(path.length, speed, (d1, d2, d3), limits.acceleration, limits.jerk, (_BENT, _ALONG))


def tool_stage(path: ToolPath, limits: ToolLimits) -> Stage:
    """Return the bounds of a path of the tool.

    Args:
        path: of the tool.
        limits: of the TCP and of the orientation.
    """
    points = path.tool(_PLACES * path.length)
    d1, d2 = _sizes(points.d1), _sizes(points.d2)
    speeds = np.array([limits.speed, limits.orientation_speed])
    accelerations = np.array([limits.acceleration, limits.orientation_acceleration])
    jerks = np.array([limits.jerk, limits.orientation_jerk])
    speed = _least(speeds, d1)
    if float((d2 * path.length).max()) <= 1e-9 * float(d1.max()):
        return Stage(path.length, speed, _least(accelerations, d1), _least(jerks, d1))
    d3 = _sizes(_slopes(points.d2, path.length))
    return _bent(path.length, speed, (d1, d2, d3), accelerations, jerks, (_TOOL_BENT, _TOOL_ALONG))


def along_with(stage: Stage, coordination: Coordination | None) -> Stage:
    """Return the bounds of a path of the tool on which external axes go along, theirs too.

    Args:
        stage: of the path.
        coordination: the axes; None where they stand.
    """
    if coordination is None:
        return stage
    axes = joint_stage(coordination.axes, coordination.limits)
    return replace(
        stage,
        speed=min(stage.speed, axes.speed),
        acceleration=min(stage.acceleration, axes.acceleration),
        jerk=min(stage.jerk, axes.jerk),
    )


def _slopes(rows: Array, length: float) -> Array:
    """Return slopes of rows at `_PLACES` by the length: between them, and at both ends."""
    between = np.diff(rows, axis=0) * ((len(_PLACES) - 1) / length)
    start, end = 1.5 * between[0] - 0.5 * between[1], 1.5 * between[-1] - 0.5 * between[-2]
    return np.vstack((start, between, end))


def _bent(
    length: float,
    speed: float,
    derivatives: tuple[Array, Array, Array],
    accelerations: Array,
    jerks: Array,
    shares: tuple[float, float],
) -> Stage:
    """Return bounds that hold together on a bent path.

    With d1, d2, d3 the largest derivatives of the path by its length s: acceleration d2·v² + d1·a, jerk
    d3·v³ + 3·d2·v·a + d1·j. What the bend does not take is left for changes of speed; a part of the tool
    that is not bent has all of it.
    """
    d1, d2, d3 = derivatives
    bent, along = shares
    v = min(
        speed,
        _least(bent * accelerations, d2) ** 0.5,
        _least(_JERK_BENT * jerks, d3) ** (1.0 / 3.0),
    )
    jerks = jerks - d3 * v**3
    free = np.maximum(along * accelerations, accelerations - d2 * v**2)
    a = min(_least(free, d1), _least(0.5 * jerks, 3.0 * d2 * v))
    return Stage(length, v, a, _least(jerks - 3.0 * d2 * v * a, d1))


def _least(limits: Array, sizes: Array) -> float:
    return float((limits / np.maximum(sizes, _TINY)).min())


def _sizes(rows: Array) -> Array:
    """Return the largest sizes of the parts of position and of orientation of rows (k, 6), shape (2,)."""
    return np.array([np.linalg.norm(part, axis=1).max() for part in (rows[:, :3], rows[:, 3:])])
