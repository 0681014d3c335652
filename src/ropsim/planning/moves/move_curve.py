"""Curve of moves: short lines one after the other that are flown as one curve of the tool."""

from ropsim.motion import JointPath, ToolPath
from ropsim.spatial import Array, record


@record
class MoveCurve:
    """Short lines one after the other as one curve.

    Attributes:
        tool: the curve, in the base frame.
        joints: the same in joint space.
        parameters: path parameters [m] at the point before the first move and at the targets of all moves,
            shape (m + 1,). The first one is above 0 where the curve begins on the line before, and the last
            one below its length where it ends on the line behind.
        before: length on the line before that the curve takes the place of [m].
        behind: the same on the line behind [m].
        deviation: greatest distance of the curve from the lines [m].
        turn: greatest angle between the orientations on the curve and on the lines [rad].
    """

    tool: ToolPath
    joints: JointPath
    parameters: Array
    before: float
    behind: float
    deviation: float
    turn: float

    @property
    def moves(self) -> int:
        """Return how many moves it takes the place of."""
        return len(self.parameters) - 1

    @property
    def length(self) -> float:
        """Return its length [m]."""
        return self.tool.length


@record
class OnCurve:
    """A move that is flown as a part of a curve.

    Attributes:
        curve: the curve.
        index: of the move among those of the curve, 0 for the first.
    """

    curve: MoveCurve
    index: int

    @property
    def is_first(self) -> bool:
        """Return whether it is the first move of the curve."""
        return self.index == 0

    @property
    def is_last(self) -> bool:
        """Return whether it is the last move of the curve."""
        return self.index == self.curve.moves - 1

    @property
    def begin(self) -> float:
        """Return the path parameter of the curve at which the move begins [m]."""
        return float(self.curve.parameters[self.index])

    @property
    def end(self) -> float:
        """Return the path parameter of the curve at which the move ends [m]."""
        return float(self.curve.parameters[self.index + 1])
