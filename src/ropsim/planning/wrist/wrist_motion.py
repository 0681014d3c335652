"""Prescribed motion for wrist angles: the path of the TCP, the joints of the wrist, external axes."""

import numpy as np

from ropsim.model import RobotModel, held_arm
from ropsim.motion import JointPath, ToolPath
from ropsim.planning.records.coordination import Coordination
from ropsim.planning.records.moving_frames import MovingFrame
from ropsim.planning.wrist.wrist_path import WristPath
from ropsim.spatial import Array, Pose, record


@record
class WristMotion:
    """A path on which the wrist leads the tool.

    Attributes:
        robot: with an arm with spherical wrist.
        X_MT: the tool.
        path: of the tool in the base frame or that of the coordination, of which the positions count.
        wrist: joints of the wrist along it [rad], three columns.
        q_start: coordinates of all axes at its start [rad | m], shape (n,).
        coordination: external axes that go along; None where they stand.
    """

    robot: RobotModel
    X_MT: Pose
    path: ToolPath
    wrist: JointPath
    q_start: Array
    coordination: Coordination | None

    @property
    def frame(self) -> MovingFrame | None:
        """Return the frame in which the path is given where external axes move it; None for the base."""
        return self.coordination.frame if self.coordination else None

    def given(self, s: Array) -> Array:
        """Return all coordinates at parameters s (k,), with the first three joints of the start, (k, n)."""
        Q = standing(self.q_start, self.coordination, s)
        Q[:, list(arm_axes(self.robot)[3:])] = self.wrist.joints(s).q
        return Q

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at path parameters s in the base frame [m], shape (k,) to (k, 3)."""
        positions = self.path.positions(s)
        if self.frame is None:
            return positions
        X_BK = self.frame.matrices(self.given(s))
        return np.asarray((X_BK[:, :3, :3] @ positions[..., np.newaxis])[..., 0] + X_BK[:, :3, 3])

    def led_by(self, joints: JointPath) -> WristPath:
        """Return the path of the tool on which joints lead it, in the frame of the path."""
        return WristPath(self.robot, self.path, joints, self.X_MT, self.frame)


def standing(q: Array, coordination: Coordination | None, s: Array) -> Array:
    """Return coordinates q (n,) at path parameters s, the external ones where they go along, shape (k, n)."""
    return coordination.rows(q, s) if coordination else np.tile(q, (len(s), 1))


def arm_axes(robot: RobotModel) -> tuple[int, ...]:
    """Return the numbers of the axes of the arm of a robot among all of them."""
    return held_arm(robot).axes if robot.external else tuple(range(robot.n))
