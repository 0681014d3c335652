"""The plan of a motion sequence: input of the follower."""

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import JointReference, MoveInstruction, ReachedSpeed
from ropsim.model import Payload
from ropsim.motion import ToolPath
from ropsim.planning.records.moving_frames import MovingFrame
from ropsim.planning.records.planned_path import MoveLimits
from ropsim.planning.records.trigger_ticks import PlannedTrigger
from ropsim.spatial import Array, Pose, frozen, record


@record
class MotionState:
    """Where a motion begins.

    Attributes:
        q: command joint coordinates [rad | m], shape (n,).
        qd: command speeds [rad/s | m/s], shape (n,).
        qdd: command accelerations [rad/s² | m/s²], shape (n,).
    """

    q: Array
    qd: Array
    qdd: Array

    @classmethod
    def at_rest(cls, q: Array) -> "MotionState":
        """Return the state of an arm that stands at `q` [rad | m], shape (n,)."""
        return cls(q, np.zeros(len(q)), np.zeros(len(q)))


@record
class TimedSegment:
    """A part of a plan: of the path of a move, or the path of a blend.

    Attributes:
        path: of the tool, in the base frame or that which is moved; None for one in joint space.
        X_MT: the tool.
        first: last control tick of the plan before it begins.
        last: last control tick on it.
        frame: that external axes move meanwhile and in which the path is given; None for the base frame.
    """

    path: ToolPath | None
    X_MT: Pose
    first: int
    last: int
    frame: MovingFrame | None = None


@record
class TimedMove:
    """A move within a plan.

    Attributes:
        move: the instruction.
        X_MT: the tool that is meant.
        q_end: command joint coordinates at its target [rad | m], shape (n,).
        last: control tick of the plan at which it ends: the middle of its blend, or the end of the plan.
        zone: distance from its target at which the path goes on to the next move [m]; 0 where it stops.
        triggers: outputs that are set on its path, in order of time.
        limits: its limits; None without motion.
        on_tool_path: whether it is on a path of the tool.
        reached: how slow it is on that, and why; None where it is as fast as programmed.
    """

    move: MoveInstruction
    X_MT: Pose
    q_end: Array
    last: int
    zone: float
    triggers: tuple[PlannedTrigger, ...] = ()
    limits: MoveLimits | None = None
    on_tool_path: bool = False
    reached: ReachedSpeed | None = None


@record
class MotionPlan:
    """A motion from rest to rest through one or more moves.

    Attributes:
        moves: in order; the last one stops.
        path_segments: in order of time.
        q_start: command joint coordinates at its start [rad | m], shape (n,).
        reference: for the control ticks 1, 2, … of the plan.
        period: time of a control tick [s].
        findings: warnings and hints.
        blends: its blends, each with the last control tick before it begins, and the last one in it.
    """

    moves: tuple[TimedMove, ...]
    path_segments: tuple[TimedSegment, ...]
    q_start: Array
    reference: JointReference
    period: float
    findings: tuple[Diagnostic, ...]
    blends: tuple[tuple[int, int], ...] = ()

    @property
    def ticks(self) -> int:
        """Return its length in control ticks."""
        return self.reference.ticks

    @property
    def is_corrected(self) -> bool:
        """Return whether a sensor corrects its path."""
        return any(one.move.tracking is not None for one in self.moves)

    @property
    def duration(self) -> float:
        """Return its length [s]."""
        return self.ticks * self.period

    @property
    def q_end(self) -> Array:
        """Return the command joint coordinates at its end [rad | m], shape (n,)."""
        return self.moves[-1].q_end


@record
class MotionSequence:
    """A sequence before it is planned.

    Attributes:
        moves: in order; all except the last may be blended.
        q_start: command joint coordinates at its start [rad | m], shape (n,).
        payload: tool and part as one body.
        ahead: moves that are known to come behind them, in the posture in which they end.
    """

    moves: tuple[MoveInstruction, ...]
    q_start: Array
    payload: Payload
    ahead: tuple[MoveInstruction, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "q_start", frozen(self.q_start))
