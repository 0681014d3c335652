"""During which control ticks of a plan the motion is within a zone."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from ropsim.controller.course import Course
from ropsim.controller.motion_plan import PlannedPiece
from ropsim.spatial import Array


def blend_ticks(
    course: Course, pieces: Sequence[PlannedPiece], phi: Array, slack: float
) -> tuple[tuple[int, int], ...]:
    """Return the corners of a motion: the last control tick before each begins, and the last one in it.

    That is the way round a rounded corner, or while two motions overlap.

    Args:
        course: of the stretch.
        pieces: of all its runs, in order.
        phi: motion times at the control ticks 1, 2, … [s], shape (ticks,).
        slack: by which motion times may be off [s].
    """
    parts = [piece for run in course.runs for piece in run.pieces]
    corners = [
        (piece.first, piece.last)
        for part, piece in zip(parts, pieces, strict=True)
        if part.corner is not None
    ]
    for _, behind in pairwise(course.runs):
        if behind.overlap > 0.0:
            times = np.array([behind.start, behind.start + behind.overlap]) + slack
            first, last = np.searchsorted(phi, times, side="right").tolist()
            corners.append((first, last))
    return tuple(sorted(corners))
