"""The runs of a stretch as numbers, for the compiled loop that walks all of them."""

from collections.abc import Sequence

import numpy as np

from ropsim.controller.course import Run
from ropsim.motion import rows_of_path
from ropsim.spatial import Array, record


@record
class WalkTable:
    """Runs with their time laws and paths.

    Attributes:
        runs: start and end [s], duration [s], first segment, segments, and first piece, shape (r, 6).
        segments: of all time laws, see `TimeLaw`, shape (8, m).
        pieces: kind, place at which it begins, length of the path, first row, rows, and first slope of each
            piece, see `PathRows`, shape (p, 6).
        rows: of all paths, shape (k, n).
        slopes: likewise, shape (2, l, n).
    """

    runs: Array
    segments: Array
    pieces: Array
    rows: Array
    slopes: Array

    def timed(self, runs: Sequence[Run]) -> "WalkTable":
        """Return the table of runs with the same pieces and other times."""
        return WalkTable(*_times(runs), self.pieces, self.rows, self.slopes)


def walk_table(runs: Sequence[Run]) -> WalkTable | None:
    """Return the table of runs; None where one has a path that compiled loops do not know.

    Args:
        runs: of a course, one or more.
    """
    paths = [rows_of_path(piece.joints) for run in runs for piece in run.pieces]
    known = [path for path in paths if path is not None]
    if len(known) < len(paths):
        return None
    rows = [path.rows for path in known]
    firsts = np.cumsum([0, *(len(each) for each in rows)])[:-1].tolist()
    slope_rows = np.cumsum([0, *(path.slopes.shape[1] for path in known)])[:-1].tolist()
    pieces = [
        (path.kind, path.begin, path.length, first, len(path.rows), slope)
        for path, first, slope in zip(known, firsts, slope_rows, strict=True)
    ]
    slopes = np.concatenate([path.slopes for path in known], axis=1)
    return WalkTable(*_times(runs), np.array(pieces, dtype=np.float64), np.concatenate(rows), slopes)


def _times(runs: Sequence[Run]) -> tuple[Array, Array]:
    """Return the rows of runs, and the segments of their time laws."""
    table, segment, piece = [], 0, 0
    for run in runs:
        count = run.law.segments.shape[1]
        table.append((run.start, run.end, run.law.duration, segment, count, piece))
        segment, piece = segment + count, piece + len(run.pieces)
    segments = np.concatenate([run.law.segments for run in runs], axis=1)
    return np.array(table, dtype=np.float64), segments
