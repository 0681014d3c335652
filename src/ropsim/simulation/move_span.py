"""Moves of a run, and the paths that they took, as they were carried out."""

from ropsim.controller import MovingFrame
from ropsim.flow import MoveInstruction
from ropsim.motion import ToolPath
from ropsim.spatial import record


@record
class MoveSpan:
    """A move as it was carried out.

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
class PathSpan:
    """A part of a path of the tool as it was followed.

    Attributes:
        path: in the base frame, or in that which external axes move meanwhile.
        start: tick at which it began.
        end: tick at which it ended; at a fine stop the arm was in position then.
        frame: that is moved; None for the base frame.
    """

    path: ToolPath
    start: int
    end: int
    frame: MovingFrame | None = None
