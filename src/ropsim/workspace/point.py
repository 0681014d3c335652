"""The point of an arm whose workspace is requested: wrist centre, flange or TCP."""

from enum import Enum

import numpy as np

from ropsim.kinematics import frames_batch
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, Pose, frozen, record
from ropsim.workspace.diagnostics import WorkspaceError, no_wrist_centre

MEETING = 1e-5
"""Axes count as meeting within this [m]: files are rounded to 0.01 mm."""
INTERFACE = -1
"""Number of the mechanical interface among the frames of `kinematics.frames_batch`."""


class PointKind(Enum):
    """Which point of the arm is followed."""

    WRIST_CENTRE = "wrist centre"
    FLANGE = "flange"
    TCP = "TCP"


@record
class MovedPoint:
    """A point that is fixed to a link of an arm.

    Attributes:
        kind: kind of point.
        frame: number of the frame in which it stands still: a link from 0, or `INTERFACE`.
        p: its coordinates there [m], shape (3,).
    """

    kind: PointKind
    frame: int
    p: Array

    def positions(self, robot: RobotModel, Q: Array) -> Array:
        """Return where it is for axes at Q (k, n) [rad | m], in the base frame [m], shape (k, 3)."""
        F = frames_batch(robot, Q)[:, self.frame]
        return np.asarray(F[:, :3, :3] @ self.p + F[:, :3, 3])


def moved_point(robot: RobotModel, kind: PointKind, X_MT: Pose | None = None) -> MovedPoint:
    """Return a point of an arm.

    Args:
        robot: the arm.
        kind: which point.
        X_MT: tool frame in the frame of the mechanical interface, for `TCP`.

    Raises:
        WorkspaceError: W101, the last three axes of the arm do not meet in a point.
        MechanismError: the arm cannot be.
    """
    if kind is PointKind.TCP and X_MT is not None:
        return MovedPoint(kind, INTERFACE, X_MT.position)
    if kind is not PointKind.WRIST_CENTRE:
        return MovedPoint(kind, INTERFACE, frozen(np.zeros(3)))
    centre = wrist_centre(robot)
    if centre is None:
        raise WorkspaceError(no_wrist_centre(robot.name))
    return centre


def wrist_centre(robot: RobotModel) -> MovedPoint | None:
    """Return the point in which the last three axes of a serial arm meet, fixed to the link before them."""
    turning = [joint.type is JointType.REVOLUTE for joint in robot.axis_joints]
    if not is_serial(robot) or robot.n < 6 or not all(turning[-3:]):
        return None
    frames = frames_batch(robot, np.zeros((1, robot.n)))[0]
    z, origins = frames[-4:-1, :3, 2], frames[-4:-1, :3, 3]
    across = np.eye(3) - z[:, :, np.newaxis] * z[:, np.newaxis, :]
    total = across.sum(axis=0)
    if abs(np.linalg.det(total)) < MEETING:  # parallel axes
        return None
    p = np.linalg.solve(total, np.einsum("kij,kj->i", across, origins))
    if np.linalg.norm(np.einsum("kij,kj->ki", across, p - origins), axis=1).max() > MEETING:
        return None
    link = robot.n - 4
    R, t = frames[link, :3, :3], frames[link, :3, 3]
    return MovedPoint(PointKind.WRIST_CENTRE, link, frozen(R.T @ (p - t)))


def is_serial(robot: RobotModel) -> bool:
    """Return whether each link hangs on the one before it and is moved by one axis of its own."""
    simple = all(joint.type in (JointType.REVOLUTE, JointType.PRISMATIC) for joint in robot.joints)
    in_order = all(joint.parent == number - 1 for number, joint in enumerate(robot.joints))
    axes = robot.axes == tuple(range(len(robot.joints)))
    return simple and in_order and axes and not robot.couplings and not robot.cuts
