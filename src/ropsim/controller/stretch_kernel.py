"""From paths over their length to a motion over time, in a loop that numba compiles."""

from ropsim.codegen import kernel
from ropsim.motion import (
    SYNCHRONISED,
    TRACED,
    joint_rows,
    line_points,
    rows_at,
    traced_points,
)
from ropsim.spatial import Array

START, END, DURATION, SEGMENT, SEGMENTS, FIRST_PIECE = range(6)
"""Columns of runs."""
KIND, BEGIN, LENGTH, FIRST_ROW, ROWS, FIRST_SLOPE = range(6)
"""Columns of pieces."""
PIECE, PLACE, SPEED, ACCELERATION, TIME = range(5)
"""Rows of what time laws tell."""


@kernel("void(f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[::1], i8, i8, f8[::1], f8[:,:,::1])")
def add_in_time(
    q: Array,
    d1: Array,
    d2: Array,
    speeds: Array,
    accelerations: Array,
    first: int,
    shared: int,
    corner: Array,
    total: Array,
) -> None:
    """Write coordinates and derivatives by time: q' = dq/ds·v and q'' = d²q/ds²·v² + dq/ds·a.

    Args:
        q: joint coordinates at k places of a path [rad | m], shape (k, n).
        d1: their first derivatives by the place, shape (k, n).
        d2: second ones.
        speeds: along the path at the k times, v, shape (k,).
        accelerations: along it, a, shape (k,).
        first: row of the motion at which the first of them is.
        shared: row of the motion up to which another path still ends: there both are added, as far as they
            are from the corner between them.
        corner: joint coordinates there [rad | m], shape (n,).
        total: the motion; rows from `first` on are written, shape (3, m, n).
    """
    for k in range(q.shape[0]):
        row, v, a = first + k, speeds[k], accelerations[k]
        for j in range(q.shape[1]):
            place, slope, bend = q[k, j], d1[k, j] * v, d2[k, j] * (v * v) + d1[k, j] * a
            if row < shared:
                place += total[0, row, j] - corner[j]
                slope += total[1, row, j]
                bend += total[2, row, j]
            total[0, row, j], total[1, row, j], total[2, row, j] = place, slope, bend


@kernel(
    "void(f8[:,::1], f8[:,::1], f8[:,::1], f8[:,::1], f8[:,:,::1], f8[:,::1], f8[::1], f8[:,::1],"
    " f8[:,:,::1], f8[:,:,::1])"
)
def walk_runs(
    runs: Array,
    segments: Array,
    pieces: Array,
    rows: Array,
    slopes: Array,
    corners: Array,
    phi: Array,
    law: Array,
    points: Array,
    total: Array,
) -> None:
    """Write coordinates and derivatives by time of a whole motion; see `WalkTable`.

    Args:
        runs: shape (r, 6).
        segments: of their time laws, shape (8, m).
        pieces: of all runs, shape (p, 6).
        rows: of their paths, shape (l, n).
        slopes: likewise, shape (2, l or fewer, n).
        corners: joint coordinates where one run ends and the next one has begun, shape (r - 1 or more, n).
        phi: motion times, rising [s], shape (k,).
        law: room to work in, shape (5, k).
        points: room to work in, shape (3, k, n).
        total: the motion, shape (3, k, n).
    """
    last, before = runs.shape[0] - 1, 0
    for number in range(last + 1):
        first = _behind(phi, runs[number, START]) if number else 0
        until = _behind(phi, runs[number, END]) if number < last else phi.shape[0]
        if until > first:
            for k in range(first, until):
                law[TIME, k] = phi[k] - runs[number, START]
            segment = int(runs[number, SEGMENT])
            own = segments[:, segment : segment + int(runs[number, SEGMENTS])]
            times = law[TIME, first:until]
            rows_at(own, runs[number, DURATION], times, law[:TIME, first:until])
        begin = first
        while begin < until:
            end = begin + 1
            while end < until and law[PIECE, end] == law[PIECE, begin]:
                end += 1
            piece = pieces[int(runs[number, FIRST_PIECE] + law[PIECE, begin])]
            for k in range(begin, end):
                law[PLACE, k] += piece[BEGIN]
            _points(piece, rows, slopes, law[PLACE, begin:end], points[:, begin:end])
            add_in_time(
                points[0, begin:end],
                points[1, begin:end],
                points[2, begin:end],
                law[SPEED, begin:end],
                law[ACCELERATION, begin:end],
                begin,
                before,
                corners[max(number - 1, 0)],
                total,
            )
            begin = end
        before = until


@kernel("void(i8, f8[:,::1], f8[:,::1], f8[:,:,::1], f8[::1], f8[::1], f8[:,:,::1])")
def points_on(
    first: int, pieces: Array, rows: Array, slopes: Array, numbers: Array, places: Array, points: Array
) -> None:
    """Write the joints and their derivatives by the place at places of the pieces of a run.

    Args:
        first: piece with which the run begins.
        pieces: of all runs, as for `walk_runs`, and so are rows and slopes.
        rows: see there.
        slopes: see there.
        numbers: of the pieces of the run at which the places are, rising, shape (k,).
        places: on these pieces; becomes those on their paths, shape (k,).
        points: where all goes, shape (3, k, n).
    """
    begin = first - first
    while begin < places.shape[0]:
        end = begin + 1
        while end < places.shape[0] and numbers[end] == numbers[begin]:
            end += 1
        piece = pieces[first + int(numbers[begin])]
        for k in range(begin, end):
            places[k] += piece[BEGIN]
        _points(piece, rows, slopes, places[begin:end], points[:, begin:end])
        begin = end


def _points(piece: Array, rows: Array, slopes: Array, places: Array, points: Array) -> None:
    """Write the joints and their derivatives at places of a path."""
    first, count, kind = int(piece[FIRST_ROW]), int(piece[ROWS]), int(piece[KIND])
    own = rows[first : first + count]
    if kind == TRACED:
        slope = int(piece[FIRST_SLOPE])
        there = slopes[:, slope : slope + count]
        traced_points(own, there, (count - 1) / piece[LENGTH], places, points[0], points[1], points[2])
    elif kind == SYNCHRONISED:
        joint_rows(own[0], own[1], own[2:], piece[LENGTH], places, points)
    else:
        line_points(own[0], own[1], places, points)


def _behind(phi: Array, time: float) -> int:
    """Return the number of motion times before a time."""
    low, high = 0, phi.shape[0]
    while low < high:
        middle = (low + high) // 2
        if phi[middle] < time:
            low = middle + 1
        else:
            high = middle
    return low
