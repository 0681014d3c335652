"""The sections of a motion sequence as numbers, for the compiled loop that evaluates all of them."""

from dataclasses import replace

import numpy as np

from ropsim.motion import rows_of_path
from ropsim.planning.trajectory.timing import Timing
from ropsim.spatial import Array, record


@record
class TrajectoryTable:
    """Runs with their time laws and paths.

    Attributes:
        sections: see `Timing.table`, shape (r, 7).
        segments: see `Timing.segments`, shape (8, m).
        path_segments: kind, path parameter at its begin, length of the path, first row, rows, and first slope
            of each, see `PathRows`, shape (p, 6).
        rows: of all paths, shape (k, n).
        slopes: derivatives of traced ones, shape (2, l, n).
        parameters: path parameters of these, shape (l,).
    """

    sections: Array
    segments: Array
    path_segments: Array
    rows: Array
    slopes: Array
    parameters: Array

    def timed(self, timing: Timing) -> "TrajectoryTable":
        """Return the table of a timing with the same path segments and other times."""
        return replace(self, sections=timing.table, segments=timing.segments)


def trajectory_table(timing: Timing) -> TrajectoryTable | None:
    """Return the table of the sections of a timing; None if compiled loops do not support a path.

    Args:
        timing: of one section or more.
    """
    numbers, rows, slopes, parameters = list[float](), list[Array](), list[Array](), list[Array]()
    row = slope = 0
    for section in timing.sections:
        for path_segment in section.path_segments:
            path = rows_of_path(path_segment.joints)
            if path is None:
                return None
            kind, begin, length, size, joints, changes, traced = path
            numbers += (kind, begin, length, row, size, slope)
            rows += joints
            row += size
            if changes is not None and traced is not None:
                slopes.append(changes)
                parameters.append(traced)
                slope += size
    path_segments, at = np.fromiter(numbers, np.float64).reshape(-1, 6), np.concatenate(rows).reshape(row, -1)
    along = np.concatenate(slopes, axis=1) if slopes else np.empty((2, 0, at.shape[1]))
    s = np.concatenate(parameters) if parameters else np.empty(0)
    return TrajectoryTable(timing.table, timing.segments, path_segments, at, along, s)
