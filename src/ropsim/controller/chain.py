"""The slow side of the controller on one page: from a move instruction to references for the servo."""

from dataclasses import dataclass, field

from ropsim.controller.entities import (
    Interpolator,
    InverseTransform,
    JointInterpolator,
    PathPlanner,
    Refusal,
)
from ropsim.controller.entity_faults import guarded, unusable
from ropsim.controller.interpolator import StandardInterpolator
from ropsim.controller.inverse_transform import StandardInverseTransform
from ropsim.controller.joint_interpolator import SplineJointInterpolator
from ropsim.controller.moving_frames import frames_of_others, moving_frames
from ropsim.controller.path_planner import StandardPathPlanner
from ropsim.controller.work_frames import WorkFrames
from ropsim.core import Diagnostic
from ropsim.flow import JointReference, JointSamples, ModalState, MoveInstruction, PoseSetpoints
from ropsim.model import Cell, Rates, Station, in_base, still_frames
from ropsim.motion import JointTrajectory, LineTrajectory
from ropsim.spatial import Array, Pose, frozen, record


@dataclass(frozen=True, slots=True, eq=False)
class MotionChain:
    """The entities between a move instruction and the joint controller, in series.

    Attributes:
        planner: move instruction to trajectory.
        interpolator: trajectory to setpoints at the interpolation tick.
        inverse: pose setpoints to joint samples.
        joint_interpolator: joint samples to references at the control tick.
        rates: the periods.
        work: tools and task frames of the cell.
    """

    planner: PathPlanner
    interpolator: Interpolator
    inverse: InverseTransform
    joint_interpolator: JointInterpolator
    rates: Rates
    work: WorkFrames = field(default_factory=WorkFrames)

    def tool_pose(self, modal: ModalState) -> Pose:
        """Return X_MT of the tool in force; of the mechanical interface itself where the tool is unknown."""
        X_MT = self.work.tool_pose(modal, None)
        return X_MT if isinstance(X_MT, Pose) else Pose()


@record
class PlannedMove:
    """A move that can be made.

    Attributes:
        move: the instruction.
        reference: what the joint controller is given at each control tick; no ticks for a move of length 0.
        q_end: command joint coordinates at the end [rad | m], shape (n,): the last row of the reference.
        duration: [s].
        trajectory: the path over time.
        findings: warnings and hints.
    """

    move: MoveInstruction
    reference: JointReference
    q_end: Array
    duration: float
    trajectory: JointTrajectory | LineTrajectory
    findings: tuple[Diagnostic, ...]


TRAJECTORIES = (JointTrajectory, LineTrajectory)
SETPOINTS = (JointSamples, PoseSetpoints)


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
        SplineJointInterpolator(),
        station.controller.rates,
        WorkFrames(tools, frames, tool, moving, others),
    )


def plan_move(chain: MotionChain, move: MoveInstruction, q_start: Array) -> PlannedMove | Refusal:
    """Return the references of a move that starts at rest at `q_start`, or why it cannot be made.

    Args:
        chain: the entities.
        move: the instruction with its modal state.
        q_start: command joint coordinates at the end of the move before [rad | m], shape (n,).
    """
    rates, refine = chain.rates, chain.joint_interpolator.refine
    planner, interpolator, inverse = chain.planner, chain.interpolator, chain.inverse
    trajectory = guarded(planner, lambda: planner.plan(move, q_start), TRAJECTORIES, move)
    if isinstance(trajectory, Refusal):
        return trajectory
    period = rates.interpolation_period
    setpoints = guarded(interpolator, lambda: interpolator.sample(trajectory, period), SETPOINTS, move)
    if isinstance(setpoints, PoseSetpoints):
        samples = guarded(inverse, lambda: inverse.solve(setpoints, q_start, move), (JointSamples,), move)
    else:
        samples = setpoints
    if isinstance(samples, Refusal):
        return samples
    ticks = rates.interpolation_ticks
    last = chain.joint_interpolator
    reference = guarded(last, lambda: refine(samples, q_start, ticks), (JointReference,), move)
    if isinstance(reference, Refusal):
        return reference
    wrong = unusable(last, reference, q_start, move)
    if wrong:
        return wrong
    q_end = frozen(reference.q[-1] if reference.ticks else q_start)
    duration = reference.ticks * rates.control_period
    findings = (*trajectory.findings, *samples.findings)
    return PlannedMove(move, reference, q_end, duration, trajectory, findings)
