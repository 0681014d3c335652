"""Move context: common data of moves to poses under one valid modal state."""

from ropsim.core import Diagnostic
from ropsim.flow import ModalState, MotionKind, MoveInstruction, Origin
from ropsim.kinematics import Method, solver_of
from ropsim.model import ControllerModel, RobotModel
from ropsim.motion import JointMotionLimits
from ropsim.planning.moves.move_check import check_values
from ropsim.planning.records.planned_path import PlannedPath, move_limits
from ropsim.planning.records.work_frames import WorkFrames
from ropsim.spatial import Pose, record


@record
class MoveContext:
    """Data of a move to a pose that do not depend on its target.

    Attributes:
        plan: limits and tool of the move, without a path.
        X_BK: the task frame in force, which stands still.
    """

    plan: PlannedPath
    X_BK: Pose


def move_context_of(
    robot: RobotModel,
    joints: JointMotionLimits,
    controller: ControllerModel,
    work: WorkFrames,
    modal: ModalState,
) -> MoveContext | None:
    """Return the common data of moves, None if there are findings or axes move the task frame.

    Args:
        robot: the arm.
        joints: capabilities of its joints.
        controller: defaults on lines, speed override.
        work: tools and task frames.
        modal: the modal state of the moves.
    """
    X_MT = work.tool_pose(modal, None)
    if isinstance(X_MT, Diagnostic) or modal.frame in work.moving:
        return None
    if not robot.has_arm or solver_of(robot).method is Method.NUMERIC:
        return None
    somewhere = MoveInstruction(MotionKind.PTP, Pose(), modal)
    if check_values(somewhere) or work.out_of_hand(modal, None) or work.frame_findings(modal, Origin()):
        return None
    plan = PlannedPath(None, None, move_limits(modal, joints, controller), X_MT)
    return MoveContext(plan, work.frames.get(modal.frame, modal.X_BK))
