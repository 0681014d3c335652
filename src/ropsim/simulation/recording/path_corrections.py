"""How sensors have shifted the paths of a run, row by row."""

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from ropsim.simulation.records.move_span import FollowedCorrection, PathSpan
from ropsim.spatial import Array


def corrections(paths: Sequence[PathSpan], ticks: Array) -> Array:
    """Return the shift at recorded ticks [m], shape (k,), NaN where no sensor corrects a path.

    Args:
        paths: as followed, in order of time.
        ticks: recorded ticks, shape (k,).
    """
    values = np.full(len(ticks), np.nan)
    for correction, rows in _corrected(paths, ticks):
        values[rows] = correction.at(ticks[rows])
    return values


def without_corrections(
    paths: Sequence[PathSpan], ticks: Array, points: Array, rotations: Callable[[slice], Array]
) -> Array:
    """Return where the TCP would be on the planned paths [m], shape (k, 3).

    Args:
        paths: as followed, in order of time.
        ticks: recorded ticks, shape (k,).
        points: attained TCP positions in the base frame [m], shape (k, 3).
        rotations: returns orientations R_BT of the command pose at some rows, which a correction leaves
            unchanged, shape (rows, 3, 3).
    """
    if all(span.correction is None for span in paths):
        return points
    seen = np.array(points)
    for correction, rows in _corrected(paths, ticks):
        seen[rows] -= correction.at(ticks[rows])[:, None] * (rotations(rows) @ correction.direction)
    return seen


def _corrected(paths: Sequence[PathSpan], ticks: Array) -> Iterator[tuple[FollowedCorrection, slice]]:
    for span in paths:
        if span.correction is not None:
            first, last = np.searchsorted(ticks, [span.start, span.end], side="right")
            yield span.correction, slice(int(first), int(last))
