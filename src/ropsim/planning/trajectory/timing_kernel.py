"""The timing of sections in loops that numba compiles: look-ahead, overlaps, control ticks."""

from math import isnan, sqrt

from ropsim.codegen import Array1, Array2, kernel
from ropsim.motion import time_at
from ropsim.planning.trajectory.trajectory_kernel import (
    DURATION,
    END,
    FIRST_PATH_SEGMENT,
    OVERLAP,
    SEGMENT,
    SEGMENTS,
    START,
    count_before,
)
from ropsim.spatial import Array

RATIO, HORIZON = 4, 5
"""Columns of the bounds of path limits."""


@kernel
def lay_horizons(moves: Array1, counts: Array1, most: int, braking: float, bounds: Array2) -> None:
    """Write the last path limit that is known where a path limit ends, of all path limits; -1 if unknown.

    Within a path segment no more gets known: who can stop after it can stop before.

    Args:
        moves: number of the move of each path segment, rising, shape (p,).
        counts: how many path limits each path segment has, one or more, shape (p,).
        most: how many moves beyond the present one are known.
        braking: how many braking distances beyond the present path segment are known, if that is further.
        bounds: of the path limits, see `plan_segments`; ratio and horizon are written, shape (s, 6).
    """
    for k in range(bounds.shape[0]):
        bounds[k, RATIO], bounds[k, HORIZON] = 1.0, -1.0
    last, known, last_known, ahead = -1, 0, int(counts[0]) - 1, 0.0
    for path_segment in range(moves.shape[0]):
        first = last + 1
        last += int(counts[path_segment])
        if path_segment > 0:
            for k in range(first, last + 1):
                ahead -= bounds[k, 0]
        distance = _braking_distance(bounds[first : last + 1])
        while known + 1 < moves.shape[0] and (
            moves[known + 1] <= moves[path_segment] + most or ahead < braking * distance
        ):
            known += 1
            for k in range(last_known + 1, last_known + 1 + int(counts[known])):
                ahead += bounds[k, 0]
            last_known += int(counts[known])
        bounds[last, HORIZON] = last_known


def _braking_distance(bounds: Array) -> float:
    """Return the distance in which the greatest speed of path limits ends, by their greatest bounds."""
    v, a, j = 0.0, 0.0, 0.0
    for k in range(bounds.shape[0]):
        v, a, j = max(v, bounds[k, 1]), max(a, bounds[k, 2]), max(j, bounds[k, 3])
    time = v / a + a / j if v * j >= a * a else 2.0 * sqrt(v / j)
    return 0.5 * v * time


_SEGMENTS, _PATH_SEGMENTS, _LEAVE, _ENTER = range(4)
"""Columns of the request."""


@kernel
def lay_sections(segments: Array2, ends: Array1, requested: Array2, sections: Array2, times: Array2) -> None:
    """Write when sections begin and end, and how long each overlaps the one before [s].

    Both motions are added no longer than the shorter one of their sections next to the blend.

    Args:
        segments: of the time laws of all sections, shape (8, m).
        ends: times of each law at which its path segments end [s], shape (p,).
        requested: of each section: numbers of law segments and path segments; the path parameter on its last
            one from which on the next section may begin, NaN if it stops; and the path parameter on the first
            one of that up to which it may last; shape (r, 4).
        sections: where all goes that is known of them, see `Timing.table`, shape (r, 7).
        times: where start, overlap and end go [s], shape (r, 3).
    """
    segment = path_segment = 0
    for number in range(sections.shape[0]):
        section, result = sections[number], sections[number, OVERLAP:]
        section[SEGMENT], section[SEGMENTS], section[FIRST_PATH_SEGMENT] = (
            segment,
            requested[number, _SEGMENTS],
            path_segment,
        )
        segment, first, path_segment = (
            segment + int(section[SEGMENTS]),
            path_segment,
            path_segment + int(requested[number, _PATH_SEGMENTS]),
        )
        section[DURATION], both, end = ends[path_segment - 1], 0.0, 0.0
        if number:
            before, over, end = sections[number - 1], requested[number - 1], sections[number - 1, END]
            if not isnan(over[_LEAVE]):
                left = _time(
                    segments, ends[:first], before, int(over[_PATH_SEGMENTS]) - 1, over[_LEAVE], result
                )
                entered = _time(segments, ends[:path_segment], section, 0, over[_ENTER], result)
                both = min(before[DURATION] - left, entered)
        section[START], section[OVERLAP] = end - both, both
        section[END] = section[START] + section[DURATION]
        times[number, 0], times[number, 1], times[number, 2] = section[START], both, section[END]


def _time(segments: Array, ends: Array, section: Array, path_segment: int, s: float, result: Array) -> float:
    """Return the time [s] at which a section is at a parameter of a path segment; see `time_at`."""
    own = segments[:, int(section[SEGMENT]) : int(section[SEGMENT] + section[SEGMENTS])]
    time_at(own, ends[int(section[FIRST_PATH_SEGMENT]) :], path_segment, s, result)
    return float(result[0])


@kernel
def ticks_come(
    sections: Array2,
    path_segment_ends: Array1,
    move_ends: Array1,
    phi: Array1,
    slack: float,
    path_segments: Array2,
    overlaps: Array2,
    moves: Array1,
) -> None:
    """Write the control ticks of events; a segment counts as far as no other section overlaps it.

    Args:
        sections: see `Timing.table`, shape (r, 7).
        path_segment_ends: see `Timing.path_segment_ends`, shape (p,).
        move_ends: nominal times at which moves end [s], shape (m,).
        phi: nominal times at the control ticks 1, 2, … [s], shape (ticks,).
        slack: by which nominal times may be off [s].
        path_segments: where the last tick before each path segment goes, and the last one on it, shape (p,
            2).
        overlaps: the same for the overlap of each section with the one before, shape (r, 2).
        moves: where the first tick goes, 0 for the start, at which each move has ended, shape (m,).
    """
    count, ticks = sections.shape[0], phi.shape[0]
    for r in range(count):
        start, together = sections[r, START], sections[r, OVERLAP]
        overlaps[r, 0], overlaps[r, 1] = _come(phi, start + slack), _come(phi, start + together + slack)
        begin, end, beyond = start + together, sections[r, END], path_segment_ends.shape[0]
        if r + 1 < count:
            end, beyond = end - sections[r + 1, OVERLAP], int(sections[r + 1, FIRST_PATH_SEGMENT])
        first, tick = int(sections[r, FIRST_PATH_SEGMENT]), _come(phi, min(max(start, begin), end) + slack)
        for p in range(first, beyond):
            path_segments[p, 0] = tick
            time = end if p + 1 == beyond else min(max(start + path_segment_ends[p], begin), end)
            tick = _come(phi, time + slack)
            path_segments[p, 1] = tick
        if r + 1 == count:
            path_segments[beyond - 1, 1] = ticks
    for m in range(move_ends.shape[0]):
        time = move_ends[m] - slack
        moves[m] = min(count_before(phi, time) + (1 if time > 0.0 else 0), ticks)


def _come(phi: Array, time: float) -> int:
    """Return the number of nominal times that are no later than a time."""
    low, high = 0, phi.shape[0]
    while low < high:
        middle = (low + high) // 2
        if phi[middle] <= time:
            low = middle + 1
        else:
            high = middle
    return low
