"""The built-in entities of a station, and the plan of one move."""

from ropsim.flow import MoveInstruction
from ropsim.model import Cell, Station, in_base, still_frames
from ropsim.planning.built_in.table import BUILT_IN
from ropsim.planning.moves.interpolator import StandardInterpolator
from ropsim.planning.moves.inverse_transform import StandardInverseTransform
from ropsim.planning.moves.joint_interpolator import StandardJointInterpolator
from ropsim.planning.moves.path_planner import StandardPathPlanner
from ropsim.planning.planning import plan
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.motion_plan import MotionPlan, MotionState
from ropsim.planning.records.moving_frames import frames_of_others, moving_frames
from ropsim.planning.records.path_corrector import StandardPathCorrector
from ropsim.planning.records.work_frames import WorkFrames
from ropsim.spatial import Array


def standard_chain(cell: Cell, station: Station) -> MotionChain:
    """Return the built-in entities for the robot, tools, frames and controller of a station.

    Those that the controller names take the place of the standard ones, see `BUILT_IN`.

    Raises:
        KeyError: the controller names an entity that is not in that table; a cell file cannot.
    """
    robot, tools, tool, controller = station.robot, station.tools, station.default_tool, station.controller
    work = work_frames(cell, station)
    planner = StandardPathPlanner(
        robot, controller, tools, work.frames, tool, robot.home, moving=work.moving, others=work.others
    )
    chain = MotionChain(
        planner,
        StandardInterpolator(),
        StandardInverseTransform(robot, tools, tool),
        StandardJointInterpolator(),
        robot,
        controller,
        StandardPathCorrector(controller.correction),
        work,
    )
    chosen = {one.entity: one.name for one in controller.built_in}
    for entity, choices in BUILT_IN.items():
        if entity in chosen:
            chain = choices[chosen[entity]](chain)
    return chain


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
