"""From paths over their length to a motion over time, in loops that numba compiles."""

from typing import NamedTuple

import numpy as np

from ropsim.codegen import Array1, Array2, Array3, columns, kernel
from ropsim.motion import (
    COEFFICIENTS,
    SYNCHRONISED,
    TRACED,
    joints_in_time,
    line_in_time,
    rows_at,
    traced_in_time,
)
from ropsim.spatial import Array

START, END, DURATION, SEGMENT, SEGMENTS, FIRST_PATH_SEGMENT, OVERLAP = range(7)
"""Columns of runs."""
KIND, BEGIN, LENGTH, FIRST_ROW, ROWS, FIRST_SLOPE = range(6)
"""Columns of path segments."""
PATH_SEGMENT, PARAMETER, SPEED, ACCELERATION, TIME = range(5)
"""Rows of what time laws tell."""
AT_ONCE = 512
"""Times that are evaluated together, so that what is known of them stays near the processor."""


class TrajectoryNumbers(NamedTuple):
    """Numbers of a trajectory; see `TrajectoryTable`.

    Attributes:
        sections: shape (r, 7).
        segments: of their time laws, shape (8, m).
        path_segments: path segments of all runs, shape (p, 6).
        rows: of their paths, shape (l, n).
        slopes: of shape (2, l or fewer, n).
        parameters: path parameters of the slopes, shape (l or fewer,).
    """

    sections: Array2
    segments: Array2
    path_segments: Array2
    rows: Array2
    slopes: Array3
    parameters: Array1


class TrajectoryWork(NamedTuple):
    """Work buffers of `evaluate_trajectory`: shapes (5, AT_ONCE), (COEFFICIENTS, n) and (3, AT_ONCE, n)."""

    law: Array2
    coefficients: Array2
    held: Array3

    @classmethod
    def of(cls, n: int) -> "TrajectoryWork":
        """Return buffers for n joints."""
        return cls(np.empty((5, AT_ONCE)), np.empty((COEFFICIENTS, n)), np.empty((3, AT_ONCE, n)))


@kernel
def evaluate_trajectory(
    table: TrajectoryNumbers, junctions: Array2, phi: Array1, work: TrajectoryWork, total: Array3
) -> None:
    """Write coordinates and derivatives by time of a whole trajectory.

    Args:
        table: the trajectory.
        junctions: joint coordinates where one run ends and the next one has begun, shape (r - 1 or more, n).
        phi: nominal times, rising [s], shape (k,).
        work: buffers.
        total: the motion, shape (3, k, n).
    """
    sections, segments, path_segments, rows, slopes, parameters = table
    law, coefficients, held = work
    last, before = sections.shape[0] - 1, 0
    for number in range(last + 1):
        section = sections[number]
        first = count_before(phi, section[START]) if number else 0
        until = count_before(phi, section[END]) if number < last else phi.shape[0]
        own = segments[:, int(section[SEGMENT]) : int(section[SEGMENT] + section[SEGMENTS])]
        for begin in range(first, until, AT_ONCE):
            count = min(until - begin, AT_ONCE)
            for k in range(count):
                law[TIME, k] = phi[begin + k] - section[START]
            rows_at(own, section[DURATION], law[TIME, :count], law)
            shared = min(before - begin, count)
            for k in range(shared):
                _copy(total.shape[2], total[0, begin + k], held[0, k])
                _copy(total.shape[2], total[1, begin + k], held[1, k])
                _copy(total.shape[2], total[2, begin + k], held[2, k])
            _evaluate(
                int(section[FIRST_PATH_SEGMENT]),
                path_segments,
                rows,
                slopes,
                parameters,
                law,
                count,
                coefficients,
                begin,
                total,
            )
            for k in range(shared):
                q, qd, qdd = total[0, begin + k], total[1, begin + k], total[2, begin + k]
                _add(total.shape[2], held[0, k], held[1, k], held[2, k], junctions[number - 1], q, qd, qdd)
        before = until


@kernel
def points_on(
    first: int,
    path_segments: Array2,
    rows: Array2,
    slopes: Array3,
    parameters: Array1,
    law: Array2,
    work: Array2,
    points: Array3,
) -> None:
    """Write the joints and their derivatives by time where a time law of a run is.

    Args:
        first: path segment with which the run begins.
        path_segments: of all runs, as for `evaluate_trajectory`, and so are rows and slopes.
        rows: see there.
        slopes: see there.
        parameters: of the slopes.
        law: numbers of the path segments of the run, rising, path parameters on these, which become those on
            their paths, speeds and accelerations, shape (4, k).
        work: to work in, shape (COEFFICIENTS, n).
        points: where all goes, shape (3, k, n).
    """
    _evaluate(first, path_segments, rows, slopes, parameters, law, law.shape[1], work, 0, points)


def _evaluate(
    first: int,
    path_segments: Array,
    rows: Array,
    slopes: Array,
    parameters: Array,
    law: Array,
    count: int,
    work: Array,
    row: int,
    total: Array,
) -> None:
    """Write the joints and their derivatives by time at times of a run, of which the first one has a row."""
    begin = 0
    while begin < count:
        end = begin + 1
        while end < count and law[PATH_SEGMENT, end] == law[PATH_SEGMENT, begin]:
            end += 1
        path_segment = path_segments[first + int(law[PATH_SEGMENT, begin])]
        for k in range(begin, end):
            law[PARAMETER, k] += path_segment[BEGIN]
        _in_time(path_segment, rows, slopes, parameters, law, begin, end, work, row, total)
        begin = end


def _in_time(
    path_segment: Array,
    rows: Array,
    slopes: Array,
    parameters: Array,
    law: Array,
    first: int,
    until: int,
    work: Array,
    at: int,
    total: Array,
) -> None:
    """Write the joints and their derivatives by time at times on one path."""
    row, count, kind = int(path_segment[FIRST_ROW]), int(path_segment[ROWS]), int(path_segment[KIND])
    own = rows[row : row + count]
    if kind == TRACED:
        slope = int(path_segment[FIRST_SLOPE])
        d1, d2 = slopes[0, slope : slope + count], slopes[1, slope : slope + count]
        s = parameters[slope : slope + count]
        traced_in_time(own, d1, d2, s, law, first, until, work, at, total)
    elif kind == SYNCHRONISED:
        joints_in_time(own[0], own[1], own[2:], path_segment[LENGTH], law, first, until, at, total)
    else:
        line_in_time(own[0], own[1], law, first, until, at, total)


@columns
def _copy(count: int, row: Array, out: Array) -> None:
    """Write a row elsewhere."""
    for j in range(count):
        out[j] = row[j]


@columns
def _add(
    count: int, held: Array, d1: Array, d2: Array, junction: Array, q: Array, qd: Array, qdd: Array
) -> None:
    """Add where another path is to where this one is, as far as that is from the junction between them."""
    for j in range(count):
        q[j] = q[j] + (held[j] - junction[j])
        qd[j] = qd[j] + d1[j]
        qdd[j] = qdd[j] + d2[j]


def count_before(phi: Array, time: float) -> int:
    """Return the number of nominal times before a time."""
    low, high = 0, phi.shape[0]
    while low < high:
        middle = (low + high) // 2
        if phi[middle] < time:
            low = middle + 1
        else:
            high = middle
    return low


@kernel
def add_in_time(
    q: Array2,
    d1: Array2,
    d2: Array2,
    speeds: Array1,
    accelerations: Array1,
    first: int,
    shared: int,
    junction: Array1,
    total: Array3,
) -> None:
    """Write coordinates and derivatives by time: q' = dq/ds·v and q'' = d²q/ds²·v² + dq/ds·a.

    Args:
        q: joint coordinates at k path parameters of a path [rad | m], shape (k, n).
        d1: their first derivatives by the path parameter, shape (k, n).
        d2: second ones.
        speeds: along the path at the k times, v, shape (k,).
        accelerations: along it, a, shape (k,).
        first: row of the motion at which the first of them is.
        shared: row of the motion up to which another path still ends: there both are added, as far as they
            are from the junction between them.
        junction: joint coordinates there [rad | m], shape (n,).
        total: the motion; rows from `first` on are written, shape (3, m, n).
    """
    for k in range(q.shape[0]):
        row, v, a = first + k, speeds[k], accelerations[k]
        for j in range(q.shape[1]):
            position, slope, bend = q[k, j], d1[k, j] * v, d2[k, j] * (v * v) + d1[k, j] * a
            if row < shared:
                position += total[0, row, j] - junction[j]
                slope += total[1, row, j]
                bend += total[2, row, j]
            total[0, row, j], total[1, row, j], total[2, row, j] = position, slope, bend
