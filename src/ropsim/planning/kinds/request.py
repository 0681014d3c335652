"""What a kind of tool path is made of."""

from ropsim.flow import MoveInstruction
from ropsim.motion import OrientationMode
from ropsim.spatial import Pose, record


@record
class PathRequest:
    """A tool path that is wanted; all poses are of the tool in the base frame.

    Attributes:
        move: the instruction.
        X_start: where the tool is.
        via: what it passes on its way, in order.
        X_end: where it goes; its position and orientation may be those of the start.
        orientation: how the tool turns.
    """

    move: MoveInstruction
    X_start: Pose
    via: tuple[Pose, ...]
    X_end: Pose
    orientation: OrientationMode
