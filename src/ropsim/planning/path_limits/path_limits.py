"""Bounds of speed, acceleration and jerk along a path segment: one path limit, or several on a bent one."""

from functools import lru_cache
from math import sqrt
from typing import NamedTuple

import numpy as np

from ropsim.motion import (
    JointMotionLimits,
    JointPath,
    PathLimits,
    ToolLimits,
    ToolPath,
    constant_derivatives,
    grid,
)
from ropsim.planning.path_limits.derivative_bounds import DerivativeBounds, derivative_bounds_of
from ropsim.planning.path_limits.derivative_bounds_kernel import TINY
from ropsim.planning.path_limits.path_limits_kernel import bent_limits, straight_limits
from ropsim.planning.records.coordination import Coordination
from ropsim.spatial import Array, frozen, record

_SHARES = np.linspace(0.0, 1.0, 33)
_STRAIGHT = 1e-9
"""A path of the tool whose direction changes by less from end to end is straight."""
_CALM = 0.95
"""Where bends leave this share of acceleration and jerk on all of a path, less speed is not quicker."""
_SAME_PARAMETER = 1e-9
"""Share of a path below which two ends of path limits are one."""


def joint_path_limits(path: JointPath, limits: JointMotionLimits) -> PathLimits:
    """Return the bounds along a path in joint space; for a straight one they are exact.

    Args:
        path: of the joints.
        limits: of every joint.
    """
    if (same := constant_derivatives(path)) is not None:
        return _straight(path.length, np.abs(same), limits)
    points = path.joints(_SHARES * path.length)
    if not points.d2.any():
        return _straight(path.length, np.abs(points.d1).max(axis=0), limits)

    def sample(s: Array) -> tuple[Array, Array]:
        rows = path.joints(s)
        return rows.d1[:, :, None], rows.d2[:, :, None]

    return _bent(derivative_bounds_of(sample, _SHARES * path.length, limits), limits, _FASTEST)


class BendSpeeds(NamedTuple):
    """How fast bends are traversed.

    Attributes:
        share: of the highest speed that a bend allows, at most 1.
        level: multiple of the mean of these speeds along the path that none exceeds.
    """

    share: float
    level: float


@record
class Bend:
    """A bent path of the tool: the slower it is traversed, the more it leaves for changes of speed.

    Attributes:
        bounds: of the derivatives of the path.
        limits: of its two parts, position and orientation, each of shape (2,).
    """

    bounds: DerivativeBounds
    limits: JointMotionLimits

    @property
    def cells(self) -> int:
        """Return the number of its cells."""
        return len(self.bounds.lengths)

    @property
    def borders(self) -> Array:
        """Return the path parameters between which its cells lie, shape (k + 1,)."""
        return np.append(0.0, np.cumsum(self.bounds.lengths))

    def within(self, speeds: Array) -> PathLimits:
        """Return the bounds that go together if speeds are not exceeded in its cells, shape (k,)."""
        return _bent(self.bounds, self.limits, _FASTEST, speeds)


class ToolBounds(NamedTuple):
    """Bounds along a path of the tool.

    Attributes:
        choices: that go together, first those of the highest speed.
        bend: the path where it is bent so that its speed matters; None where it is not.
    """

    choices: tuple[PathLimits, ...]
    bend: Bend | None


_FASTEST = BendSpeeds(1.0, np.inf)
_EVEN = tuple(BendSpeeds(0.9**number, np.inf) for number in range(1, 11))
"""What else is tried on an even bend."""
_CHANGING = BendSpeeds(1.0, 0.95), BendSpeeds(1.0, 0.7), BendSpeeds(0.81, 2.0)
"""The same on a bend that changes; there speeds of a ladder are tried as well."""


def tool_path_limits(path: ToolPath, limits: ToolLimits) -> PathLimits:
    """Return the bounds along a path of the tool, as fast as its bends allow.

    Args:
        path: of the tool.
        limits: of the TCP and of the orientation.
    """
    return fastest_bounds(path, limits).choices[0]


def fastest_bounds(path: ToolPath, limits: ToolLimits) -> ToolBounds:
    """Return the bounds along a path of the tool, as fast as its bends allow.

    Args:
        path: of the tool.
        limits: of the TCP and of the orientation.
    """
    found = _fastest_limits(path, limits)
    if isinstance(found, PathLimits):
        return ToolBounds((found,), None)
    first, bounds, _ = found
    return ToolBounds((first,), Bend(bounds, _of_parts(limits)))


def tool_path_limit_choices(path: ToolPath, limits: ToolLimits) -> ToolBounds:
    """Return bounds along a path of the tool that go together; of a bent one several choices.

    The slower a bend is traversed, the more it leaves for changes of speed on it: not the highest speed is
    the quickest where the path begins or ends on a bend, or where its bend changes. Where bends take hardly
    any acceleration or jerk there is a single choice.

    Args:
        path: of the tool.
        limits: of the TCP and of the orientation.
    """
    found = _fastest_limits(path, limits)
    if isinstance(found, PathLimits):
        return ToolBounds((found,), None)
    first, bounds, d1 = found
    both = _of_parts(limits)
    if (first.bounds[:, 1:] >= _CALM * _straight(path.length, d1, both).bounds[:, 1:]).all():
        return ToolBounds((first,), None)
    others = (_bent(bounds, both, one) for one in (_EVEN if len(first) == 1 else _CHANGING))
    choices = {one.rows.tobytes(): one for one in (first, *others)}
    return ToolBounds(tuple(choices.values()), Bend(bounds, both))


def _fastest_limits(
    path: ToolPath, limits: ToolLimits
) -> PathLimits | tuple[PathLimits, DerivativeBounds, Array]:
    """Return the bounds along a path of the tool at the highest speed.

    Returns:
        the bounds; of a bent path with those of its derivatives, and the sizes of the first ones, shape (2,).
    """
    if (same := constant_derivatives(path)) is not None:
        return _even(path.length, same.tolist(), limits)

    def sample(s: Array) -> tuple[Array, Array]:
        rows = path.tool(s)
        return rows.d1.reshape(-1, 2, 3), rows.d2.reshape(-1, 2, 3)

    both = _of_parts(limits)
    d1, d2 = (np.linalg.norm(rows, axis=2).max(axis=0) for rows in sample(_SHARES * path.length))
    if float((d2 * path.length).max()) <= _STRAIGHT * float(d1.max()):
        return _straight(path.length, d1, both)
    with np.errstate(over="ignore", invalid="ignore", divide="ignore"):  # of a point in which it turns back
        bounds = derivative_bounds_of(sample, grid(path), both)
    return _bent(bounds, both, _FASTEST), bounds, d1


@lru_cache(maxsize=256)
def rates_of(limits: ToolLimits) -> Array:
    """Return limits of the tool as an array, a row for each of speed, acceleration and jerk.

    Its columns are position and orientation, shape (3, 2).
    """
    return frozen(np.reshape(limits.all, (2, 3)).T)


def lesser_limits(one: ToolLimits, other: ToolLimits) -> ToolLimits:
    """Return the limits that keep both."""
    return one if one is other or one == other else ToolLimits(*map(min, one.all, other.all))


def along_with(path_limits: PathLimits, coordination: Coordination | None) -> PathLimits:
    """Return the bounds along a path of the tool with external axes, including their bounds.

    Args:
        path_limits: of the path.
        coordination: the axes; None where they stand.
    """
    if coordination is None:
        return path_limits
    axes = joint_path_limits(coordination.axes, coordination.limits)
    borders = [each.ends for each in (path_limits, axes)]
    length = float(borders[0][-1])
    ends = np.unique(np.concatenate((borders[0][:-1], borders[1][:-1])))
    near = _SAME_PARAMETER * length
    ends = ends[(np.diff(ends, prepend=0.0) > near) & (ends < length - near)]
    middles = 0.5 * (np.append(0.0, ends) + np.append(ends, length))
    here, there = (np.minimum(np.searchsorted(border, middles), len(border) - 1) for border in borders)
    least = np.minimum(path_limits.bounds[here], axes.bounds[there])
    return PathLimits(np.column_stack((np.diff(ends, prepend=0.0, append=length), least)))


@lru_cache(maxsize=256)
def _of_parts(limits: ToolLimits) -> JointMotionLimits:
    """Return limits of the tool as limits of its two parts, position and orientation, each of shape (2,)."""
    return JointMotionLimits(*rates_of(limits))


def _even(length: float, d1: list[float], limits: ToolLimits) -> PathLimits:
    """Return the bounds along a path with the same first derivatives of the tool everywhere, six numbers."""
    x, y, z, a, b, c = d1
    shift, turn = max(sqrt(x * x + y * y + z * z), TINY), max(sqrt(a * a + b * b + c * c), TINY)
    row = (
        length,
        min(limits.speed / shift, limits.orientation_speed / turn),
        min(limits.acceleration / shift, limits.orientation_acceleration / turn),
        min(limits.jerk / shift, limits.orientation_jerk / turn),
    )
    return PathLimits(np.array((row,)))


def _straight(length: float, d1: Array, limits: JointMotionLimits) -> PathLimits:
    row = np.empty((1, 4))
    straight_limits(length, d1, limits.speed, limits.acceleration, limits.jerk, row)
    return PathLimits(row)


def _bent(
    derivative_bounds: DerivativeBounds,
    limits: JointMotionLimits,
    choice: BendSpeeds,
    most: Array | None = None,
) -> PathLimits:
    """Return bounds that hold together on a bent path, at no more than some speeds in its cells (k,)."""
    rates, k = np.array((limits.speed, limits.acceleration, limits.jerk)), len(derivative_bounds.lengths)
    out, result = np.empty((k, 7)), np.empty(1)
    bent_limits(
        derivative_bounds.table,
        derivative_bounds.lengths,
        rates,
        choice.share,
        choice.level,
        np.full(k, np.inf) if most is None else np.ascontiguousarray(most),
        np.empty(k),
        np.empty((k, 3)),
        out,
        result,
    )
    return PathLimits(out[: int(result[0]), :4].copy())
