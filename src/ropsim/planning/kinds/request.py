"""Request for a kind of tool path."""

from ropsim.flow import MoveInstruction
from ropsim.motion import OrientationMode
from ropsim.spatial import Pose, record


@record
class PathRequest:
    """A requested tool path; all poses are of the tool in the base frame.

    Attributes:
        move: the instruction.
        X_start: where the tool is.
        via: via points, in order.
        X_end: its end; position and orientation may equal the start.
        orientation: how the tool turns.
    """

    move: MoveInstruction
    X_start: Pose
    via: tuple[Pose, ...]
    X_end: Pose
    orientation: OrientationMode
