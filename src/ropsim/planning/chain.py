"""The built-in entities of a station, and the plan of one move."""

from dataclasses import replace

from ropsim.flow import MoveInstruction
from ropsim.model import BuiltIn, Cell, RobotModel, Station, in_base, still_frames
from ropsim.motion import ACCELERATION_RISE, JERK_LIMITED, TRAPEZOIDAL
from ropsim.planning.moves.interpolator import StandardInterpolator
from ropsim.planning.moves.inverse_transform import StandardInverseTransform
from ropsim.planning.moves.joint_interpolator import StandardJointInterpolator
from ropsim.planning.moves.path_planner import StandardPathPlanner
from ropsim.planning.planning import plan
from ropsim.planning.postures.damped_inverse import DampedInverseTransform
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.motion_plan import MotionPlan, MotionState
from ropsim.planning.records.moving_frames import frames_of_others, moving_frames
from ropsim.planning.records.path_corrector import ProportionalIntegralCorrector, StandardPathCorrector
from ropsim.planning.records.work_frames import WorkFrames
from ropsim.spatial import Array


def standard_chain(cell: Cell, station: Station) -> MotionChain:
    """Return the built-in entities for the robot, tools, frames and controller of a station.

    Those that the controller names take the place of the standard ones.
    """
    tools, tool, controller = station.tools, station.default_tool, station.controller
    chosen = controller.built_in
    robot = _with_steps_of_acceleration(station.robot) if BuiltIn.TRAPEZOIDAL in chosen else station.robot
    work = work_frames(cell, station)
    inverse = StandardInverseTransform(robot, tools, tool)
    limits, period = controller.correction, controller.rates.interpolation_period
    is_integral = BuiltIn.PROPORTIONAL_INTEGRAL in chosen
    return MotionChain(
        StandardPathPlanner(
            robot,
            controller,
            tools,
            work.frames,
            tool,
            robot.home,
            moving=work.moving,
            others=work.others,
        ),
        StandardInterpolator(),
        DampedInverseTransform(inverse) if BuiltIn.DAMPED_LEAST_SQUARES in chosen else inverse,
        StandardJointInterpolator(),
        robot,
        controller,
        ProportionalIntegralCorrector(limits, period) if is_integral else StandardPathCorrector(limits),
        work,
        TRAPEZOIDAL if BuiltIn.TRAPEZOIDAL in chosen else JERK_LIMITED,
    )


def _with_steps_of_acceleration(robot: RobotModel) -> RobotModel:
    """Return an arm whose joints come to their accelerations within 10 µs, as the trapezoidal law has it."""
    joints = tuple(replace(one, max_jerk=one.max_acceleration / ACCELERATION_RISE) for one in robot.joints)
    return replace(robot, joints=joints)


def work_frames(cell: Cell, station: Station) -> WorkFrames:
    """Return the tools and task frames of a station.

    This is the one place where the poses of the world are converted to poses of the controller, in the base
    frame.
    """
    frames = in_base(station.X_WB, still_frames(cell.frames))
    moving, others = moving_frames(cell, station), frames_of_others(cell, station)
    return WorkFrames(station.tools, frames, station.default_tool, moving, others)


def plan_move(chain: MotionChain, move: MoveInstruction, q_start: Array) -> MotionPlan | Refusal:
    """Return the motion of one move from rest to rest, or why it cannot be made.

    Args:
        chain: the entities.
        move: the instruction with its modal state.
        q_start: command joint coordinates at its start [rad | m], shape (n,).
    """
    planned, refusal = plan(chain, (move,), MotionState.at_rest(q_start))
    return refusal or planned or Refusal(())
