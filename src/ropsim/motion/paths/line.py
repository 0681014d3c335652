"""Line: the TCP on a straight path while the tool turns; or the tool turning about a TCP that stands."""

from collections.abc import Sequence
from dataclasses import field

import numpy as np

from ropsim.model import OrientationMode
from ropsim.motion.curves.path import ToolPoints
from ropsim.motion.curves.segment_kernel import segment_distances
from ropsim.motion.paths.line_kernel import (
    AXIS,
    DISPLACEMENT,
    LINE_LENGTH,
    LINE_SIZE,
    MOVES,
    ROLL,
    VELOCITY,
    line_numbers,
    straight_points,
)
from ropsim.spatial import Array, Pose, record


@record
class Line:
    """X(s): position (1 - r)·p_start + r·p_end, orientation R_start·turn(r), with r = s / length.

    At its end it is X_end to the bit, for any start: so later moves do not depend on it.

    Attributes:
        X_start: at path parameter 0 in the reference frame.
        X_end: at the end.
        mode: how the tool turns.
        numbers: derived numbers, see `line_kernel`.
        moves: whether the TCP moves, so that the path parameter is its arc length.
        length: of the path [m]; where the TCP stands (moves less than `STANDS`) the size of the turn [rad];
            0 where the tool neither moves nor turns.
    """

    X_start: Pose
    X_end: Pose
    mode: OrientationMode = OrientationMode.FIXED_AXIS
    numbers: Array = field(init=False, repr=False)
    moves: bool = field(init=False, repr=False)
    length: float = field(init=False)

    def __post_init__(self) -> None:
        start, end, numbers = self.X_start, self.X_end, np.empty(LINE_SIZE)
        drives = int(self.mode is OrientationMode.DRIVE_TRANSFORM)
        line_numbers(start.position, start.orientation, end.position, end.orientation, drives, numbers)
        numbers.flags.writeable = False
        length, moves = numbers[LINE_LENGTH : MOVES + 1].tolist()
        object.__setattr__(self, "numbers", numbers)
        object.__setattr__(self, "moves", bool(moves))
        object.__setattr__(self, "length", length)

    @property
    def displacement(self) -> Array:
        """Return the displacement from start to end [m], shape (3,)."""
        return self.numbers[DISPLACEMENT : DISPLACEMENT + 3]

    @property
    def axis(self) -> Array:
        """Return the axis about which the tool turns, in its frame at the start, shape (3,)."""
        return self.numbers[AXIS : AXIS + 3]

    @property
    def constant_derivatives(self) -> Array | None:
        """Return the first derivatives of the tool, None where it rolls while it swings, shape (6,)."""
        if not self.length or self.numbers[ROLL] != 0.0:
            return None
        share = 1.0 / self.length
        return (
            np.concatenate(
                (self.numbers[DISPLACEMENT : DISPLACEMENT + 3], self.numbers[VELOCITY : VELOCITY + 3])
            )
            * share
        )

    @property
    def has_straight_tcp(self) -> bool:
        """Return whether the TCP moves: it goes on one straight line then."""
        return self.moves

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool and its derivatives at path parameters s, shape (k,)."""
        count = len(s)
        points = ToolPoints(np.empty((count, 4, 4)), np.empty((count, 6)), np.empty((count, 6)))
        parameters = np.ascontiguousarray(s, dtype=np.float64)
        straight_points(self.numbers, parameters, points.matrices, points.d1, points.d2)
        return points

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at path parameters s, shape (k,) to (k, 3) [m]."""
        return self._between(s / self.length if self.length else s * 0.0)

    def distance(self, points: Array) -> Array:
        """Return how far points, shape (k, 3) [m], are from the segment, shape (k,) [m]."""
        distances = np.empty(len(points))
        enter_distances([self], [(0, len(points))], points, distances)
        return distances

    def _between(self, r: Array) -> Array:
        return (1.0 - r)[:, None] * self.X_start.position + r[:, None] * self.X_end.position


def enter_distances(
    lines: Sequence[Line], spans: Sequence[tuple[int, int]], points: Array, distances: Array
) -> None:
    """Write how far points are from the segments to which they belong.

    Args:
        lines: the segments.
        spans: which points belong to each of them, from one number up to, without it, another one.
        points: in the reference frame of the lines [m], shape (k, 3).
        distances: output [m], shape (k,); entries of other points stay unchanged.
    """
    numbers = np.concatenate([part for one in lines for part in (one.X_start.position, one.displacement)])
    rows = np.array(spans, dtype=np.float64)
    segment_distances(numbers.reshape(-1, 6), rows, np.ascontiguousarray(points), distances)
