"""Request for a kind of tool path."""

from dataclasses import replace

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

    def of_points(self) -> "PathRequest":
        """Return the request with poses of which the positions count, turned as the frame is."""
        start, *via, end = (Pose(one.position) for one in (self.X_start, *self.via, self.X_end))
        return replace(self, X_start=start, via=tuple(via), X_end=end, orientation=OrientationMode.FIXED_AXIS)
