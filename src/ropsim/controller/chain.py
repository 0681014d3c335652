"""The slow side of the controller on one page: the entities, and what makes them those of a station."""

from dataclasses import dataclass, field

from ropsim.controller.entities import (
    Interpolator,
    InverseTransform,
    JointInterpolator,
    PathPlanner,
    Refusal,
)
from ropsim.controller.interpolator import StandardInterpolator
from ropsim.controller.inverse_transform import StandardInverseTransform
from ropsim.controller.joint_interpolator import StandardJointInterpolator
from ropsim.controller.motion_plan import MotionPlan, MotionState
from ropsim.controller.moving_frames import frames_of_others, moving_frames
from ropsim.controller.path_planner import StandardPathPlanner
from ropsim.controller.planning import plan
from ropsim.controller.work_frames import WorkFrames
from ropsim.flow import ModalState, MoveInstruction
from ropsim.model import Cell, ControllerModel, RobotModel, Station, in_base, still_frames
from ropsim.spatial import Array, Pose


@dataclass(frozen=True, slots=True, eq=False)
class MotionChain:
    """The entities between a move instruction and the joint controller, in series.

    Attributes:
        planner: move instruction to path.
        interpolator: path of the tool to pose setpoints.
        inverse: pose setpoints to joint samples.
        joint_interpolator: joint samples to a path of the joints.
        robot: the arm.
        controller: rates, limits, how far it looks ahead.
        work: tools and task frames of the cell.
    """

    planner: PathPlanner
    interpolator: Interpolator
    inverse: InverseTransform
    joint_interpolator: JointInterpolator
    robot: RobotModel
    controller: ControllerModel
    work: WorkFrames = field(default_factory=WorkFrames)

    def tool_pose(self, modal: ModalState) -> Pose:
        """Return X_MT of the tool in force; of the mechanical interface itself where the tool is unknown."""
        X_MT = self.work.tool_pose(modal, None)
        return X_MT if isinstance(X_MT, Pose) else Pose()


def standard_chain(cell: Cell, station: Station) -> MotionChain:
    """Return the built-in entities for the robot, tools, frames and controller of a station.

    This is the one place where the poses of the world become those of the controller, in the base frame.
    """
    robot, tools, tool = station.robot, station.tools, station.default_tool
    frames = in_base(station.X_WB, still_frames(cell.frames))
    moving, others = moving_frames(cell, station), frames_of_others(cell, station)
    return MotionChain(
        StandardPathPlanner(
            robot, station.controller, tools, frames, tool, robot.home, moving=moving, others=others
        ),
        StandardInterpolator(),
        StandardInverseTransform(robot, tools, tool),
        StandardJointInterpolator(),
        robot,
        station.controller,
        WorkFrames(tools, frames, tool, moving, others),
    )


def plan_move(chain: MotionChain, move: MoveInstruction, q_start: Array) -> MotionPlan | Refusal:
    """Return the motion of one move from rest to rest, or why it cannot be made.

    Args:
        chain: the entities.
        move: the instruction with its modal state.
        q_start: command joint coordinates at its start [rad | m], shape (n,).
    """
    planned, refusal = plan(chain, (move,), MotionState.at_rest(q_start))
    return refusal or planned or Refusal(())
