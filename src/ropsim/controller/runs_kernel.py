"""When the runs of a stretch begin and end, in a loop that numba compiles."""

from math import isnan

from ropsim.codegen import kernel
from ropsim.controller.stretch_kernel import DURATION, END, FIRST_PIECE, OVERLAP, SEGMENT, SEGMENTS, START
from ropsim.motion import time_at
from ropsim.spatial import Array

_SEGMENTS, _PIECES, _LEAVE, _ENTER = range(4)
"""Columns of what is asked."""


@kernel("void(f8[:,::1], f8[::1], f8[:,::1], f8[:,::1], f8[:,::1])")
def lay_runs(segments: Array, ends: Array, asked: Array, runs: Array, times: Array) -> None:
    """Write when runs begin and end, and for how long the run before each still lasts when it begins [s].

    Both motions are added no longer than the shorter one of their parts beside the corner lasts.

    Args:
        segments: of the time laws of all runs, shape (8, m).
        ends: times of each law at which its pieces end [s], shape (p,).
        asked: of each run segments and pieces; the place on its last piece from which on the next run may
            begin, NaN where it stops; and the place on the first piece of that up to which it may last;
            shape (r, 4).
        runs: where all goes that is known of them, see `Course.table`, shape (r, 7).
        times: where start, overlap and end go [s], shape (r, 3).
    """
    segment = piece = 0
    for number in range(runs.shape[0]):
        run, told = runs[number], runs[number, OVERLAP:]
        run[SEGMENT], run[SEGMENTS], run[FIRST_PIECE] = segment, asked[number, _SEGMENTS], piece
        segment, first, piece = segment + int(run[SEGMENTS]), piece, piece + int(asked[number, _PIECES])
        run[DURATION], both, end = ends[piece - 1], 0.0, 0.0
        if number:
            before, over, end = runs[number - 1], asked[number - 1], runs[number - 1, END]
            if not isnan(over[_LEAVE]):
                left = _time(segments, ends[:first], before, int(over[_PIECES]) - 1, over[_LEAVE], told)
                entered = _time(segments, ends[:piece], run, 0, over[_ENTER], told)
                both = min(before[DURATION] - left, entered)
        run[START], run[OVERLAP] = end - both, both
        run[END] = run[START] + run[DURATION]
        times[number, 0], times[number, 1], times[number, 2] = run[START], both, run[END]


def _time(segments: Array, ends: Array, run: Array, piece: int, place: float, told: Array) -> float:
    """Return the time of its law at which a run is at a place of one of its pieces [s]; see `time_at`."""
    own = segments[:, int(run[SEGMENT]) : int(run[SEGMENT] + run[SEGMENTS])]
    time_at(own, ends[int(run[FIRST_PIECE]) :], piece, place, told)
    return float(told[0])
