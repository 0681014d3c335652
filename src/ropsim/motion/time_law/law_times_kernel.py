"""When a motion of constant jerks is at given path parameters, in loops that numba compiles.

Segments stand in columns: path segment, time at the start [s], path parameter, speed, acceleration, jerk,
duration [s], path parameter at the end; see `TimeLaw`.
"""

from math import inf, isnan, sqrt

from ropsim.codegen import Array1, Array2, kernel
from ropsim.spatial import Array

HALVINGS = 80
"""More steps than the search for a time needs, were it by halves alone."""
SIXTH = 1.0 / 6.0
ROUNDING = 1e-16
"""Relative; the search for a time ends at a step below this share of it."""
HALLEY = 5e-6
"""Relative; after a step of Halley no greater than this the remainder is its cube, which is rounding."""
NEARLY_EVEN = 0.2
"""Relative; where half the change of the speed on a step is below this share of it, the series converges."""


@kernel
def times_at(
    segments: Array2, ends: Array1, path_segments: Array1, parameters: Array1, out: Array1, result: Array1
) -> None:
    """Write the time [s] at which the motion is at each of some path parameters of path segments.

    Args:
        segments: shape (8, m).
        ends: times [s] at which the path segments end, shape (p,).
        path_segments: index of the path segment of each path parameter, best in order, shape (k,).
        parameters: on it; those outside of it count as its start or end; shape (k,).
        out: where the times go, shape (k,).
        result: output for the number of times; fewer than k if a path segment does not exist.
    """
    path_segment, first, beyond, low = -1, 0, 0, 0
    result[0] = parameters.shape[0]
    for k in range(parameters.shape[0]):
        if not 0.0 <= path_segments[k] < ends.shape[0]:
            result[0] = k
            break
        if path_segment != int(path_segments[k]):
            path_segment = int(path_segments[k])
            first, beyond = _lower(segments, 0, float(path_segment)), _lower(segments, 0, path_segment + 1.0)
            low = first
        low = _row_of(segments, parameters[k], first, beyond, low)
        out[k] = _time_of(segments, ends, path_segment, beyond, low, parameters[k])


@kernel
def times_along(
    segments: Array2, ends: Array1, path_segments: Array1, parameters: Array1, out: Array1
) -> None:
    """Write the result of `times_at` within rounding, for rising path parameters, searched in order.

    Args:
        segments: shape (8, m).
        ends: times [s] at which the path segments end, shape (p,).
        path_segments: index of the path segment of each path parameter, rising, shape (k,).
        parameters: on it, in order; those outside of it count as its start or end; shape (k,).
        out: where the times go, shape (k,).
    """
    last, row, near = segments.shape[1] - 1, 0, 0.0
    for k in range(parameters.shape[0]):
        path_segment, s = path_segments[k], parameters[k]
        while row < last and (
            segments[0, row] < path_segment
            or (segments[0, row + 1] == path_segment and segments[2, row + 1] <= s)
        ):
            row += 1
            near = 0.0
        end = segments[7, row] if row == last or segments[0, row + 1] > path_segment else inf
        if s >= end:
            out[k] = ends[int(path_segment)]
            continue
        near = _near(segments, row, max(s - segments[2, row], 0.0), near)
        out[k] = segments[1, row] + near


def _near(segments: Array, row: int, distance: float, u: float) -> float:
    """Return the time since the start of a segment at which a distance is covered, no less than `u` [s].

    By Halley's steps from a few terms of the series there, kept between the times known to be too early and
    too late.
    """
    v, a, j = segments[3, row], segments[4, row], segments[5, row]
    least, most = u, segments[6, row]
    if distance <= 0.0:
        return u
    u = 0.5 * (least + most)
    slope = v + least * (a + 0.5 * least * j)
    if slope > 0.0:
        ahead = (distance - least * (v + least * (0.5 * a + least * (j * SIXTH)))) / slope
        faster = 0.5 * (a + least * j) / slope * ahead
        if abs(faster) < NEARLY_EVEN:
            ahead *= 1.0 - faster * (1.0 - 2.0 * faster) - j * SIXTH * ahead * ahead / slope
        tried = least + ahead
        u = tried if tried < most else u
    for _ in range(HALVINGS):
        over = u * (v + u * (0.5 * a + u * (j * SIXTH))) - distance
        slope = v + u * (a + 0.5 * u * j)
        if over > 0.0:
            most = u
        else:
            least = u
        below = slope * slope - 0.5 * over * (a + u * j)
        step = over * slope / below if below > 0.0 else inf
        tried = u - step
        if abs(step) <= HALLEY * u:
            return float(min(max(tried, least), most))
        u = tried if least < tried < most else 0.5 * (least + most)
    return u


@kernel
def time_at(segments: Array2, ends: Array1, path_segment: int, s: float, out: Array1) -> None:
    """Write the time [s] at which the motion is at a parameter of an existing path segment; see `times_at`.

    Args:
        segments: shape (8, m).
        ends: times [s] at which the path segments end, shape (p,).
        path_segment: index of the path segment.
        s: on it; one outside of it counts as its start or end.
        out: where the time goes, shape (1,).
    """
    first, beyond = _lower(segments, 0, float(path_segment)), _lower(segments, 0, path_segment + 1.0)
    row = _row_of(segments, s, first, beyond, first)
    out[0] = _time_of(segments, ends, path_segment, beyond, row, s)


def _time_of(segments: Array, ends: Array, path_segment: int, beyond: int, row: int, s: float) -> float:
    """Return the time [s] of a path parameter of a path segment, within one of its segments."""
    if s >= segments[7, beyond - 1]:
        return float(ends[path_segment])
    if isnan(s):
        return s
    if s <= 0.0:
        return 0.0 if path_segment == 0 else float(ends[path_segment - 1])
    return _time_at(segments, row, s, min(start_of(segments, row + 1), ends[path_segment]))


def _row_of(segments: Array, s: float, first: int, beyond: int, row: int) -> int:
    """Return the last segment that starts no later than at a path parameter, searched first at `row`."""
    low, high = first, beyond
    if row > first and segments[2, row] <= s:
        low = row
        if row + 1 < beyond and segments[2, row + 1] > s:
            return row
    while high - low > 1:
        middle = (low + high) // 2
        if segments[2, middle] <= s:
            low = middle
        else:
            high = middle
    return low


def start_of(segments: Array, row: int) -> float:
    """Return the time at which a segment starts [s], endless behind the last one."""
    return float(segments[1, row]) if row < segments.shape[1] else inf


def _lower(segments: Array, column: int, value: float) -> int:
    """Return the first segment whose number in a column is not below a value."""
    low, high = 0, segments.shape[1]
    while low < high:
        middle = (low + high) // 2
        if segments[column, middle] < value:
            low = middle + 1
        else:
            high = middle
    return low


def _time_at(segments: Array, row: int, s: float, end: float) -> float:
    """Return the time [s] of a path parameter in a segment that ends at `end`.

    Newton's steps for the distance v·u + a·u²/2 + j·u³/6 start at the least of the times that its parts would
    take alone; a step that leaves the times known to be too early and too late is replaced by halving.
    """
    v, a, j = segments[3, row], segments[4, row], segments[5, row]
    distance = s - segments[2, row]
    u: float = segments[6, row]
    if v > 0.0:
        u = min(u, distance / v)
    if a > 0.0:
        u = min(u, sqrt(2.0 * distance / a))
    if j > 0.0:
        u = min(u, (6.0 * distance / j) ** (1.0 / 3.0))
    if u == 0.0:  # so near that the parts round to no time
        return min(float(segments[1, row]), end)
    least, most = 0.0, segments[6, row]
    for _ in range(HALVINGS):
        over = u * (v + u * (0.5 * a + u * (j * SIXTH))) - distance
        slope = v + u * (a + 0.5 * u * j)
        if over > 0.0:
            most = u
        else:
            least = u
        step = over / slope if slope > 0.0 else inf
        if abs(step) <= ROUNDING * u:
            break
        tried = u - step
        u = tried if least < tried < most else 0.5 * (least + most)
    return min(float(segments[1, row]) + u, end)
