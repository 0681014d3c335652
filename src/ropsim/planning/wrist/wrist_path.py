"""The path of a tool that the wrist leads: the path of the TCP, and the joints that turn the tool on it."""

import numpy as np

from ropsim.kinematics import forward_batch
from ropsim.model import RobotModel
from ropsim.motion import JointPath, ToolPath, ToolPoints, grid, pose_derivatives
from ropsim.planning.records.moving_frames import MovingFrame
from ropsim.spatial import Array, Pose, record

_STEP = 0.01
"""How far the joints go from pose to pose of a difference [rad]; its sixth power is rounding."""


@record
class WristPath:
    """The TCP goes along a path; how the tool turns follows from the joints.

    Attributes:
        robot: the arm with its external axes.
        path: a path of the tool in its reference frame, of which the positions count.
        joints: that take the TCP along it, over the same length.
        X_MT: the tool.
        frame: that external axes move and in which the path is given; None for the base frame.
    """

    robot: RobotModel
    path: ToolPath
    joints: JointPath
    X_MT: Pose
    frame: MovingFrame | None = None

    @property
    def length(self) -> float:
        """Return the length in the unit of the path."""
        return self.path.length

    def own_grid(self) -> Array:
        """Return the grid of the path, at whose points the joints have theirs, shape (m,)."""
        return grid(self.path)

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool and its derivatives at path parameters s, shape (k,).

        How the tool turns is that of joints that go on from each path parameter with its first two
        derivatives.
        """
        at, moved_tool = self.joints.joints(s), self.path.tool(s)
        rates = np.maximum(np.abs(at.d1).max(axis=1), np.sqrt(np.abs(at.d2).max(axis=1)))
        q, d1, d2 = (rows[:, np.newaxis] for rows in (at.q, at.d1, at.d2))

        def around(offsets: Array) -> Array:
            o = offsets[..., np.newaxis]
            return self._matrices(q + o * (d1 + 0.5 * o * d2))

        turned = pose_derivatives(around, _STEP / np.maximum(rates, _STEP / self.length))
        matrices = turned.matrices.copy()
        matrices[:, :3, 3] = moved_tool.matrices[:, :3, 3]
        both = ((moved_tool.d1, turned.d1), (moved_tool.d2, turned.d2))
        return ToolPoints(matrices, *(np.hstack((moved[:, :3], turns[:, 3:])) for moved, turns in both))

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at path parameters s, shape (k,) to (k, 3) [m]."""
        return self.path.positions(s)

    def distance(self, points: Array) -> Array:
        """Return how far points, shape (k, 3) [m], are from the path of the TCP, shape (k,) [m]."""
        return self.path.distance(points)

    def _matrices(self, Q: Array) -> Array:
        """Return the tool in the reference frame with the axes at Q (..., n), shape (..., 4, 4)."""
        rows = np.ascontiguousarray(Q.reshape(-1, Q.shape[-1]))
        X = forward_batch(self.robot, rows) @ self.X_MT.matrix()
        if self.frame:
            X = np.linalg.inv(self.frame.matrices(rows)) @ X
        return np.asarray(X.reshape(*Q.shape[:-1], 4, 4))
