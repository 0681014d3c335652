"""Coordination: external axes that go along with a path of the tool, and the frame that they carry it in."""

from dataclasses import replace

import numpy as np

from ropsim.flow import PoseSetpoints
from ropsim.model import JointType, RobotModel
from ropsim.motion import JointMotionLimits, JointPath, JointSection, ToolPath, evenly, smoothly
from ropsim.planning.records.moving_frames import MovingFrame
from ropsim.spatial import Array, record

_SAME_POSITION = 1e-9  # [rad | m]; rounding of values that a program computes
_TURN, _DISTANCE = np.radians(2.0), 0.01  # of an axis between two samples [rad | m]


@record
class Coordination:
    """External axes over the path parameters of a path of the tool.

    Attributes:
        robot: the arm with its m external axes.
        axes: where these are at the path parameters of the path.
        frame: the frame K that they move and in which the path is given; None for one in the base frame.
        limits: of the external axes.
    """

    robot: RobotModel
    axes: JointPath
    frame: MovingFrame | None
    limits: JointMotionLimits

    def part(self, begin: float, end: float) -> "Coordination":
        """Return the coordination of the section between two path parameters."""
        return replace(self, axes=JointSection(self.axes, begin, end))

    def in_base(self, setpoints: PoseSetpoints) -> PoseSetpoints:
        """Return samples of the path as X_BT with the external axes: X_BT(s) = X_BK(axes(s)) · X_KT(s).

        Args:
            setpoints: in the reference frame of the path, at equally spaced path parameters.
        """
        Q = self.rows(self.robot.home, np.linspace(0.0, setpoints.length, len(setpoints.matrices)))
        external = Q[:, list(self.robot.external)]
        if self.frame is None:
            return replace(setpoints, external=external)
        return PoseSetpoints(setpoints.length, self.frame.matrices(Q) @ setpoints.matrices, external)

    def rows(self, q: Array, s: Array) -> Array:
        """Return coordinates of all axes, with the external ones at path parameters of the path, (k, n).

        Args:
            q: the others [rad | m], shape (n,).
            s: path parameters, shape (k,).
        """
        Q = np.tile(q, (len(s), 1))
        Q[:, list(self.robot.external)] = self.axes.joints(s).q
        return Q

    def coarseness(self, steps: int) -> float:
        """Return how many times too far the axes move from sample to sample with `steps` steps."""
        s = np.linspace(0.0, self.axes.length, steps + 1)
        far = np.abs(np.diff(self.axes.joints(s).q, axis=0)).max(axis=0, initial=0.0)
        joints = (self.robot.axis_joints[k] for k in self.robot.external)
        most = [_TURN if joint.measure is JointType.REVOLUTE else _DISTANCE for joint in joints]
        return float((far / most).max())


def moved_axes(robot: RobotModel, q_start: Array, q_end: Array) -> tuple[int, ...]:
    """Return the numbers of the external axes that are elsewhere at the end of a move.

    Args:
        robot: the arm with its external axes.
        q_start: coordinates of all axes at its start [rad | m], shape (n,).
        q_end: at its end, of which only the external axes count [rad | m], shape (n,).
    """
    return tuple(k for k in robot.external if abs(float(q_end[k] - q_start[k])) > _SAME_POSITION)


def coordination_along(
    path: ToolPath, robot: RobotModel, q_start: Array, q_end: Array, frame: MovingFrame | None, share: float
) -> Coordination:
    """Return external axes that move evenly with the path: e(s) = e_start + (e_end - e_start)·s/L.

    Args:
        path: of the tool, in the frame.
        robot: the arm with its external axes.
        q_start: coordinates of all axes at its start [rad | m], shape (n,); the external ones count.
        q_end: the same at its end.
        frame: in which the path is given; None for the base frame.
        share: of their speed limits that the axes may use.
    """
    which = list(robot.external)
    limits = JointMotionLimits(
        share * robot.max_speeds[which], robot.max_accelerations[which], robot.max_jerks[which]
    )
    return Coordination(robot, evenly(path.length, q_start[which], q_end[which]), frame, limits)


def coordination_round(
    length: float, before: Coordination, leaves: float, behind: Coordination, enters: float
) -> Coordination:
    """Return the external axes on a blend, smoothly from one side to the other.

    Args:
        length: of the blend [m].
        before: along the path before, seen from the frame of the blend.
        leaves: its path parameter at which the blend begins [m].
        behind: along the path behind, seen from the same frame.
        enters: its path parameter at which the blend ends [m].
    """
    first, last = (one.axes.joints(np.array([s])) for one, s in ((before, leaves), (behind, enters)))
    least = (
        np.minimum(getattr(before.limits, name), getattr(behind.limits, name))
        for name in ("speed", "acceleration", "jerk")
    )
    return replace(before, axes=smoothly(length, first, last), limits=JointMotionLimits(*least))
