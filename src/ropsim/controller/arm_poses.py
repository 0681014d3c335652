"""Poses of the tool of a station, in the frames and for the tools of its cell."""

import numpy as np

from ropsim.flow import ModalState
from ropsim.kinematics import tool_pose
from ropsim.model import RobotModel
from ropsim.planning import WorkFrames, inverted
from ropsim.spatial import Array, Pose, record


@record
class ArmPoses:
    """Where the tool of an arm is.

    Attributes:
        robot: the arm with its external axes.
        work: tools and task frames of the cell, which override the ones of the program.
    """

    robot: RobotModel
    work: WorkFrames

    def at(self, q: Array, modal: ModalState) -> Pose | None:
        """Return X_KT of the tool in force in the task frame in force; None if one of them is not known.

        Args:
            q: coordinates of the axes [rad | m], shape (n,).
            modal: the modal state.
        """
        X_MT = self.work.tool_pose(modal, None)
        if not isinstance(X_MT, Pose) or modal.frame in self.work.others:
            return None
        return inverted(self.work.frame_pose(modal, q)) @ tool_pose(self.robot, q, X_MT)

    def reached(
        self,
        target: Pose | tuple[float, ...] | None,
        then: ModalState,
        now: ModalState,
        axes: Array | None = None,
    ) -> Pose | None:
        """Return X_KT behind a move, for the tool and in the task frame of another modal state.

        Args:
            target: of the move: X_KT, joint coordinates [rad | m], or None for the home position.
            then: modal state of the move.
            now: the other modal state.
            axes: coordinates behind the move [rad | m], shape (n,), of which only the external axes count;
                None if they are not known.

        Returns:
            the pose; None if a tool or a frame is not known, and if the number of coordinates is wrong.
        """
        if not isinstance(target, Pose):
            q = self.robot.home if target is None else np.array(target)
            return self.at(q, now) if len(q) == self.robot.n else None
        moving = {*self.work.others, *(self.work.moving if axes is None else ())}
        if then.frame != now.frame and {then.frame, now.frame} & moving:
            return None
        X_MT, X_MU = (self.work.tool_pose(one, None) for one in (then, now))
        if not isinstance(X_MT, Pose) or not isinstance(X_MU, Pose):
            return None
        q = self.robot.home if axes is None else axes
        X_BK, X_BL = (self.work.frame_pose(one, q) for one in (then, now))
        X_LT = target if X_BK == X_BL else inverted(X_BL) @ X_BK @ target
        return X_LT if X_MT == X_MU else X_LT @ inverted(X_MT) @ X_MU
