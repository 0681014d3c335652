"""Moves of a run, and the paths that they took, as executed."""

import numpy as np

from ropsim.flow import MoveInstruction
from ropsim.motion import ToolPath
from ropsim.planning import MovingFrame
from ropsim.spatial import Array, record


@record
class MoveSpan:
    """An executed move.

    Attributes:
        move: the instruction.
        start: tick at which it began.
        end: tick at which the reference reached its end.
        settled: tick at which the arm was in position.
    """

    move: MoveInstruction
    start: int
    end: int
    settled: int


@record
class FollowedCorrection:
    """How a sensor has shifted a path while it was followed.

    Attributes:
        ticks: at which the shift is known, shape (k,).
        values: the shift at these [m], linear between two of them, shape (k,).
        direction: of the tool frame, of length 1, shape (3,).
    """

    ticks: Array
    values: Array
    direction: Array

    def at(self, ticks: Array) -> Array:
        """Return the shift at some ticks [m]; behind the last one it stays."""
        return np.interp(ticks, self.ticks, self.values)


@record
class PathSpan:
    """A followed part of a path of the tool.

    Attributes:
        path: in the base frame, or in that which external axes move meanwhile.
        start: tick at which it began.
        end: tick at which it ended; at a fine stop the arm was in position then.
        frame: that is moved; None for the base frame.
        correction: how a sensor has shifted it; None where it was made as planned.
    """

    path: ToolPath
    start: int
    end: int
    frame: MovingFrame | None = None
    correction: FollowedCorrection | None = None
