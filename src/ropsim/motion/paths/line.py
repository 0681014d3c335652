"""Line: the TCP on a straight way while the tool turns; or the tool turning about a TCP that stands."""

from collections.abc import Sequence
from dataclasses import field

import numpy as np

from ropsim.model import OrientationMode
from ropsim.motion.paths.line_kernel import segment_distances
from ropsim.motion.paths.orientation import ToolTurn, tool_turn
from ropsim.motion.paths.path import STANDS, STILL, ToolPoints
from ropsim.spatial import Array, Pose, frozen, record


@record
class Line:
    """X(s): position (1 - r)·p_start + r·p_end, orientation R_start·turn(r), with r = s / length.

    At its end it is X_end to the bit, wherever it began: so what comes behind it need not know that.

    Attributes:
        X_start: at place 0 in the reference frame.
        X_end: at the end.
        mode: how the tool turns.
        turn: what follows from that.
        way: from start to end [m], shape (3,).
        moves: whether the TCP moves, so that the place is its way.
        length: of the way [m]; where the TCP stands (moves less than `STANDS`) the size of the turn [rad];
            0 where the tool neither moves nor turns.
    """

    X_start: Pose
    X_end: Pose
    mode: OrientationMode = OrientationMode.FIXED_AXIS
    turn: ToolTurn = field(init=False, repr=False)
    way: Array = field(init=False, repr=False)
    moves: bool = field(init=False, repr=False)
    length: float = field(init=False)

    def __post_init__(self) -> None:
        turn = tool_turn(self.X_start, self.X_end, self.mode)
        way = frozen(self.X_end.position - self.X_start.position)
        length = float(np.linalg.norm(way))
        object.__setattr__(self, "moves", length > STANDS)
        if not self.moves:
            length = turn.turn.size if turn.turn.size > STILL else 0.0
        object.__setattr__(self, "turn", turn)
        object.__setattr__(self, "way", way)
        object.__setattr__(self, "length", length)

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool and its derivatives at places s, shape (k,)."""
        share = 1.0 / self.length if self.length else 0.0
        r = s / self.length if self.length else s * 0.0
        turned = self.turn.at(r)
        matrices = np.zeros((len(s), 4, 4))
        matrices[:, :3, :3] = turned.rotations
        matrices[r == 1.0, :3, :3] = self.X_end.rotation()
        matrices[:, :3, 3] = self._between(r)
        matrices[:, 3, 3] = 1.0
        d1, d2 = np.empty((len(s), 6)), np.zeros((len(s), 6))
        d1[:, :3] = self.way * share
        d1[:, 3:] = turned.d1 * share
        d2[:, 3:] = turned.d2 * (share * share)
        return ToolPoints(matrices, d1, d2)

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at places s, shape (k,) to (k, 3) [m]."""
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
        distances: where the answers go [m], shape (k,); those of other points stay as they are.
    """
    numbers = np.concatenate([part for one in lines for part in (one.X_start.position, one.way)])
    rows = np.array(spans, dtype=np.float64)
    segment_distances(numbers.reshape(-1, 6), rows, np.ascontiguousarray(points), distances)
