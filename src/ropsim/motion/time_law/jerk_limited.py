"""The jerk-limited time law of a path of several segments, from rest to rest, as fast as its bounds allow."""

from collections.abc import Iterable

import numpy as np

from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.time_law import time_law_kernel
from ropsim.motion.time_law.interval import Interval
from ropsim.motion.time_law.levelling_kernel import ROWS
from ropsim.motion.time_law.longer_segments_kernel import plan_longer
from ropsim.motion.time_law.piecewise_law import PiecewiseLaw
from ropsim.motion.time_law.profile import ProfileError
from ropsim.motion.time_law.time_law_kernel import LEAST, MOST
from ropsim.spatial import Array

_SEGMENTS = 8  # of a path segment, at most, up and the same number down


def plan_time_law(path_limits: Iterable[Interval]) -> PiecewiseLaw:
    """Return the time law of a path of p path segments, in time proportional to p and the sample-ahead.

    The motion starts and ends at rest and keeps the bounds of each path segment; its acceleration goes on
    where a path segment ends. Rises are as steep as the bounds allow, so are falls: the motion follows the
    lower of both, and goes over between them at the highest speed there is. Between path segments whose
    bounds differ it is not the fastest of all: a rise never waits, so that it may come to a bound too early:
    up to 23 % for two path segments of very different acceleration, none below a factor of three. One path
    segment alone has the S-curve of `plan_profile`, and so has a line that is cut into path segments.

    Args:
        path_limits: bounds of the path segments, in their order.

    Raises:
        ProfileError: M540, where there are no path segments, a length, bound or ratio is not from 1e-50 to
            1e50, in its own unit or that of the first path segment (a ratio may be 0), or a horizon lies
            before its path segment.

    References:
        Biagiotti and Melchiorri 2008, Trajectory Planning for Automatic Machines and Robots, section 3.4.
        Bobrow, Dubowsky and Gibson 1985, Int. J. Robotics Research 4(3), for the passes.
    """
    rows = [
        (one.length, one.speed, one.acceleration, one.jerk, one.ratio, one.horizon) for one in path_limits
    ]
    return _planned(np.array(rows, dtype=np.float64))


def jerk_limited(bounds: Array, counts: Array) -> PiecewiseLaw:
    """Return the result of `plan_time_law` for intervals in rows, over path segments of several of them.

    Args:
        bounds: of the path limits, in their order: length, speed, acceleration, jerk, ratio, horizon, see
            `Interval`;
            within a path segment the ratio is 1; shape (s, 6), one or more.
        counts: how many path limits each path segment has, one or more, shape (p,); their sum is s.

    Raises:
        ProfileError: M540, as there.
    """
    ends = np.empty(len(counts))
    tables, rises, rows, limit_ends, result = _work_arrays(len(bounds))
    plan_longer(bounds, counts, tables, rises, rows, limit_ends, ends, result)
    return PiecewiseLaw(rows[:, : _count(result, bounds)].copy(), ends)


def _planned(bounds: Array) -> PiecewiseLaw:
    """Return the time law of path segments, rows as for `plan_segments`, shape (p, 6)."""
    tables, rises, rows, ends, result = _work_arrays(len(bounds))
    time_law_kernel.plan_segments(bounds, tables, rises, rows, ends, result)
    return PiecewiseLaw(rows[:, : _count(result, bounds)].copy(), ends)


def _work_arrays(p: int) -> tuple[Array, Array, Array, Array, Array]:
    """Return the work arrays and outputs of p path segments for `plan_segments`."""
    if p == 0:
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, "a path has no segments, allowed is one or more"))
    tables, rises = np.empty((3, ROWS, p + 1)), np.empty((3, 8, _SEGMENTS * p))
    return tables, rises, np.empty((8, 2 * _SEGMENTS * p)), np.empty(p), np.empty(2)


def _count(result: Array, bounds: Array) -> int:
    """Return the number of segments that have been planned."""
    count, wrong = result.tolist()
    if count < 0.0:
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, _wrong_words(int(wrong), bounds[int(wrong)])))
    return int(count)


def _wrong_words(path_segment: int, bounds: Array) -> str:
    """Return the fault in the bounds of a path segment, shape (6,)."""
    length, speed, acceleration, jerk, ratio, horizon = bounds.tolist()
    found = (
        f"length {length:g}, speed {speed:g}, acceleration {acceleration:g}, "
        f"jerk {jerk:g}, ratio {ratio:g}, horizon {int(horizon)}"
    )
    return (
        f"path segment {path_segment} has {found}; allowed are numbers from {LEAST:g} to {MOST:g}, "
        "for the ratio also 0, and a horizon that is -1 or not before the path segment"
    )
