"""Bounds of speed, acceleration and jerk along a piece of a stretch: one stage, or several on a bent one."""

from collections.abc import Sequence

import numpy as np

from ropsim.controller.bends import Bends, bends_of, bent_speeds
from ropsim.controller.bends_kernel import TINY, join_alike, room_of
from ropsim.controller.coordination import Coordination
from ropsim.motion import JointMotionLimits, JointPath, Stage, ToolLimits, ToolPath, grid
from ropsim.spatial import Array

Stages = tuple[Stage, ...]

_PLACES = np.linspace(0.0, 1.0, 33)
_STRAIGHT = 1e-9
"""A path of the tool whose direction changes by less from end to end is straight."""
_ALIKE = np.array([1.1, 2.0, 2.0])
"""Factors by which speed, acceleration and jerk of cells differ at most that are made one stage."""
_SAME_PLACE = 1e-9
"""Share of a path below which two ends of stages are one."""


def joint_stages(path: JointPath, limits: JointMotionLimits) -> Stages:
    """Return the bounds along a path in joint space; for a straight one they are exact.

    Args:
        path: of the joints.
        limits: of every joint.
    """
    points = path.joints(_PLACES * path.length)
    if not points.d2.any():
        return _straight(path.length, np.abs(points.d1).max(axis=0), limits)

    def look(places: Array) -> tuple[Array, Array]:
        rows = path.joints(places)
        return rows.d1[:, :, None], rows.d2[:, :, None]

    bends = bends_of(look, _PLACES * path.length, limits)
    return _bent(bends, limits, bent_speeds(bends, limits))


def tool_stages(path: ToolPath, limits: ToolLimits) -> Stages:
    """Return the bounds along a path of the tool, as fast as its bends allow.

    Args:
        path: of the tool.
        limits: of the TCP and of the orientation.
    """
    return tool_choices(path, limits, (1.0,))[0]


def tool_choices(path: ToolPath, limits: ToolLimits, shares: Sequence[float]) -> tuple[Stages, ...]:
    """Return bounds along a path of the tool that go together; of an even bend one choice for each share.

    The slower a bend is walked, the more it leaves for changes of speed on it: not the highest speed is the
    quickest where the path begins or ends on the bend. Other paths have one choice.

    Args:
        path: of the tool.
        limits: of the TCP and of the orientation.
        shares: of the highest speed that the bend allows, falling from 1.
    """
    both = JointMotionLimits(
        np.array([limits.speed, limits.orientation_speed]),
        np.array([limits.acceleration, limits.orientation_acceleration]),
        np.array([limits.jerk, limits.orientation_jerk]),
    )

    def look(places: Array) -> tuple[Array, Array]:
        rows = path.tool(places)
        return rows.d1.reshape(-1, 2, 3), rows.d2.reshape(-1, 2, 3)

    d1, d2 = (np.linalg.norm(rows, axis=2).max(axis=0) for rows in look(_PLACES * path.length))
    if float((d2 * path.length).max()) <= _STRAIGHT * float(d1.max()):
        return (_straight(path.length, d1, both),)
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):  # of a point in which it turns back
        return _choices(bends_of(look, grid(path), both), both, shares)


def _choices(bends: Bends, both: JointMotionLimits, shares: Sequence[float]) -> tuple[Stages, ...]:
    most = bent_speeds(bends, both)
    first = _bent(bends, both, shares[0] * most)
    if len(first) > 1:  # a bend that changes: what is left for changes of speed is used up where it changes
        return (first,)
    return tuple(dict.fromkeys((first, *(_bent(bends, both, share * most) for share in shares[1:]))))


def along_with(stages: Stages, coordination: Coordination | None) -> Stages:
    """Return the bounds along a path of the tool on which external axes go along, theirs too.

    Args:
        stages: of the path.
        coordination: the axes; None where they stand.
    """
    if coordination is None:
        return stages
    axes = joint_stages(coordination.axes, coordination.limits)
    ways = [np.cumsum([one.length for one in each]) for each in (stages, axes)]
    length = float(ways[0][-1])
    ends = np.unique(np.concatenate((ways[0][:-1], ways[1][:-1])))
    near = _SAME_PLACE * length
    ends = ends[(np.diff(ends, prepend=0.0) > near) & (ends < length - near)]
    middles = 0.5 * (np.append(0.0, ends) + np.append(ends, length))
    here, there = (np.minimum(np.searchsorted(way, middles), len(way) - 1).tolist() for way in ways)
    lengths = np.diff(ends, prepend=0.0, append=length).tolist()
    return tuple(
        _least(length, stages[i], axes[k]) for length, i, k in zip(lengths, here, there, strict=True)
    )


def _least(length: float, one: Stage, other: Stage) -> Stage:
    return Stage(
        length,
        min(one.speed, other.speed),
        min(one.acceleration, other.acceleration),
        min(one.jerk, other.jerk),
    )


def _straight(length: float, d1: Array, limits: JointMotionLimits) -> Stages:
    speed, acceleration, jerk = (
        float((limit / np.maximum(d1, TINY)).min())
        for limit in (limits.speed, limits.acceleration, limits.jerk)
    )
    return (Stage(length, speed, acceleration, jerk),)


def _bent(bends: Bends, limits: JointMotionLimits, most: Array) -> Stages:
    """Return bounds that hold together on a bent path, where no cell is walked faster than it may.

    With the derivatives d1, d2, d3 of the path by its length s: acceleration d2·v² + d1·a, jerk
    d3·v³ + 3·d2·v·a + d1·j. What is along d1 adds up, and what is across it is at right angles to that.
    """
    slow = np.minimum((limits.speed / np.maximum(bends.d1, TINY)).min(axis=1), most)
    rates, bounds = np.array((limits.speed, limits.acceleration, limits.jerk)), np.empty((len(slow), 3))
    room_of(bends.table, rates, slow, slow**3, bounds)
    return _joined(bends.lengths, bounds)


def _joined(lengths: Array, bounds: Array) -> Stages:
    """Return stages of cells, of neighbours with similar bounds one.

    Args:
        lengths: of the cells, shape (k,).
        bounds: of their speeds, accelerations and jerks, shape (k, 3).
    """
    rows, told = np.empty((len(lengths), 7)), np.empty(1)
    join_alike(np.ascontiguousarray(lengths), bounds, _ALIKE, rows, told)
    return tuple(Stage(*row) for row in rows[: int(told[0]), :4].tolist())
