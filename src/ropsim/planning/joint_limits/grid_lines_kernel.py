"""Between which times and path parameters cells lie, in loops that numba compiles."""

from math import ceil, inf, log, sqrt
from typing import NamedTuple

import numpy as np

from ropsim.codegen import Array1, Array2, kernel
from ropsim.motion import rows_at, time_at
from ropsim.spatial import Array

SPEED, ACCELERATION, JERK = range(3)
"""Rows of what is used."""
PARAMETER, TIME, FIRST_BOUND, PATH_SEGMENT = 0, 1, 2, 5
"""Rows of cells."""
MOST_PARTS = 64
"""Into which an interval is divided, at most."""
STEEP = 0.4
"""Greatest change of the logarithm of the speed that joints allow between two times, about."""


@kernel
def cell_times(
    used: Array2, phi: Array1, duration: float, intervals: Array2, times: Array1, result: Array1
) -> None:
    """Write nominal times that are about one real time apart, as dense as a motion must be slow there.

    Equal intervals between two times are divided by the rate that they and their neighbours leave, and where
    the speed that joints allow changes steeply.

    Args:
        used: of the limits at control ticks, in the order of `Quantity`, shape (4, k).
        phi: nominal times of the ticks, rising [s], shape (k,).
        duration: nominal time at the end [s].
        intervals: work for w equal intervals, shape (2, w).
        times: where they go, from 0 to the end, rising, shape (64 · w + 1,).
        result: where their number goes, shape (1,).
    """
    last = intervals.shape[1] - 1
    step = duration / (last + 1)
    for interval in range(last + 1):
        intervals[0, interval], intervals[1, interval] = 1.0, 0.0
    here, before = 0, 0.0
    for k in range(phi.shape[0]):
        while here < last and (here + 1) * step <= phi[k]:
            here += 1
        if used[ACCELERATION, k] > 1.0:
            intervals[0, here] = max(intervals[0, here], sqrt(used[ACCELERATION, k]))
        if used[JERK, k] > 1.0:
            intervals[0, here] = max(intervals[0, here], np.cbrt(used[JERK, k]))
        if before > 0.0 or used[SPEED, k] > 1.0:
            intervals[0, here] = max(intervals[0, here], used[SPEED, k])
            now = log(max(used[SPEED, k], 1.0))
            intervals[1, here] += abs(now - before)
            before = now
    count = 0
    for interval in range(last + 1):
        needed = max(
            intervals[0, max(interval - 1, 0)], intervals[0, interval], intervals[0, min(interval + 1, last)]
        )
        parts = int(min(max(ceil(needed), ceil(intervals[1, interval] / STEEP)), MOST_PARTS))
        begin, end = interval * step, duration if interval == last else (interval + 1) * step
        for part in range(parts):
            times[count] = begin + (end - begin) * (part / parts)
            count += 1
    times[count] = duration
    result[0] = count + 1


class SectionTimes(NamedTuple):
    """Times of a section.

    Attributes:
        segments: of its time law, see `TimeLaw`, shape (8, m).
        ends: times at which its path segments end [s], shape (p,).
        start: nominal time at which it begins [s].
    """

    segments: Array2
    ends: Array1
    start: float


class GridLines(NamedTuple):
    """Results of `lay_grid`: c cells.

    Attributes:
        begins: path parameters at which path segments begin, and the end of the last one, shape (p + 1,).
        cells: their c + 1 borders and the times there since the start of the section [s]; then bounds of
            speed, acceleration and jerk, and number of the path segment of each; shape (6, k + s + 1).
        total: number of the cells, shape (1,).
    """

    begins: Array1
    cells: Array2
    total: Array1


@kernel
def lay_grid(
    section: SectionTimes,
    times: Array1,
    path_limits: Array2,
    counts: Array1,
    near: float,
    inner: Array1,
    law: Array2,
    out: GridLines,
) -> None:
    """Write the cells of a part, between the path parameters where it is at times, and where path limits end.

    Args:
        section: its times.
        times: nominal times, rising [s], shape (k,).
        path_limits: length, and bounds of speed, acceleration and jerk of each path limit, shape (s, 4).
        counts: how many path limits each path segment has, shape (p,).
        near: below this share of the part a path parameter and the end of a path limit are one.
        inner: work, shape (k,).
        law: work, shape (4, k).
        out: the results.
    """
    segments, ends, start = section
    begins, grid = out.begins, out.cells
    _begin(path_limits, counts, begins)
    inside, duration, least = 0, ends[ends.shape[0] - 1], near * begins[begins.shape[0] - 1]
    for k in range(times.shape[0]):
        if 0.0 < times[k] - start < duration:
            inner[inside] = times[k] - start
            inside += 1
    rows_at(segments, duration, inner[:inside], law)
    count, k, begin = 0, 0, 0.0
    path_segment, left = 0, counts[0]
    grid[PARAMETER, 0], grid[TIME, 0] = 0.0, 0.0
    for limit in range(path_limits.shape[0]):
        end = begin + path_limits[limit, 0]
        if left == 0.0:
            path_segment += 1
            left = counts[path_segment]
        left -= 1.0
        until = inf if limit + 1 == path_limits.shape[0] else end
        while k < inside and begins[int(law[0, k])] + law[1, k] <= until:
            at = begins[int(law[0, k])] + law[1, k]
            k += 1
            if at > grid[PARAMETER, count] and at - begin > least and end - at > least:
                grid[TIME, count + 1] = inner[k - 1]
                count = _add(grid, count, at, path_limits, limit, path_segment)
        time_at(segments, ends, path_segment, end - begins[path_segment], grid[TIME, count + 1 : count + 2])
        count = _add(grid, count, end, path_limits, limit, path_segment)
        begin = end
    out.total[0] = count


def _begin(path_limits: Array, counts: Array, begins: Array) -> None:
    """Write the path parameters at which path segments begin, and the end of the last one."""
    begins[0], limit, s = 0.0, 0, 0.0
    for path_segment in range(counts.shape[0]):
        for _ in range(int(counts[path_segment])):
            s += path_limits[limit, 0]
            limit += 1
        begins[path_segment + 1] = s


def _add(grid: Array, count: int, end: float, path_limits: Array, limit: int, path_segment: int) -> int:
    """Write a cell but for the time at its end; return the number of all."""
    grid[PARAMETER, count + 1], grid[PATH_SEGMENT, count] = end, path_segment
    for kind in range(3):
        grid[FIRST_BOUND + kind, count] = path_limits[limit, 1 + kind]
    return count + 1
