"""A move of a run as it was carried out."""

from ropsim.flow import MoveInstruction
from ropsim.spatial import Array, Pose, record


@record
class MoveSpan:
    """A move as it was carried out.

    Attributes:
        move: the instruction.
        start: tick at which it began.
        end: tick at which the reference reached its end.
        settled: tick at which the arm was in position.
        q_start: command coordinates at its start, shape (n,).
        q_end: command coordinates at its end, shape (n,).
        X_MT: tool frame in force.
    """

    move: MoveInstruction
    start: int
    end: int
    settled: int
    q_start: Array
    q_end: Array
    X_MT: Pose
