"""Points that a task needs: places of a tool, with or without an orientation."""

import numpy as np

from ropsim.spatial import Array, Pose, record


@record
class TaskPoint:
    """A point that is to be reached.

    Attributes:
        name: of it.
        position: of the TCP in the frame of the task [m], shape (3,).
        orientation: of the tool, quaternion (w, x, y, z), shape (4,); None where any will do.
    """

    name: str
    position: Array
    orientation: Array | None = None

    def pose(self) -> Pose | None:
        """Return the pose of the tool in the frame of the task; None where the orientation is free."""
        return None if self.orientation is None else Pose(self.position, self.orientation)

    def seen_from(self, X_WB: Pose) -> "TaskPoint":
        """Return the point in the frame of a base that stands at X_WB in the frame of the task."""
        back = X_WB.inverse()
        if self.orientation is None:
            return TaskPoint(self.name, np.asarray(back.matrix()[:3, :3] @ self.position + back.position))
        X = back @ Pose(self.position, self.orientation)
        return TaskPoint(self.name, X.position, X.orientation)
