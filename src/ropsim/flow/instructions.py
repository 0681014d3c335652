"""The robot instructions that flow from the interpreter to the simulator, in program order."""

from dataclasses import dataclass, field
from enum import Enum

from ropsim.core import Span
from ropsim.flow.modal import ModalState
from ropsim.spatial import Pose


class MotionKind(Enum):
    """How the TCP travels: pose to pose (synchronous joints) or on a straight line."""

    PTP = "PTP"
    LIN = "LIN"


class GripAction(Enum):
    """What a gripper does."""

    OPEN = "open"
    CLOSE = "close"


@dataclass(frozen=True, slots=True)
class Origin:
    """Where an instruction comes from.

    Attributes:
        span: the source line, where it is known.
        visit: how often this very instruction has been executed, from 1 ("loop pass").
        calls: procedures from `main` down to the one that holds the instruction.
        call_serials: for each entry of `calls`, the ordinal of that activation in the run (main = 0).
    """

    span: Span | None = None
    visit: int = 1
    calls: tuple[str, ...] = ("main",)
    call_serials: tuple[int, ...] = (0,)


@dataclass(frozen=True, slots=True)
class MoveInstruction:
    """Go to a target.

    Attributes:
        kind: PTP or LIN.
        target: pose of the tool in the task frame (X_KT), joint coordinates [rad | m], or None for the
            home position of the arm.
        modal: snapshot of the modal state.
        origin: source line and loop pass.
        external: values of the external axes that a pose is reached with [rad | m], in the order of the axes;
            empty to leave them where they are, as it is for joint coordinates and home.
    """

    kind: MotionKind
    target: Pose | tuple[float, ...] | None
    modal: ModalState
    origin: Origin = field(default_factory=Origin)
    external: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class GripInstruction:
    """Open or close the gripper of a tool (empty name = the tool in force)."""

    action: GripAction
    tool: str
    modal: ModalState
    origin: Origin = field(default_factory=Origin)


@dataclass(frozen=True, slots=True)
class OutputInstruction:
    """Set an output channel when the motion before it has ended."""

    channel: str
    value: bool | int | float
    modal: ModalState
    origin: Origin = field(default_factory=Origin)


@dataclass(frozen=True, slots=True)
class WaitInstruction:
    """Stand still for a time [s] when the motion before it has ended."""

    duration: float
    modal: ModalState
    origin: Origin = field(default_factory=Origin)


@dataclass(frozen=True, slots=True)
class MessageInstruction:
    """Show a text to the operator."""

    text: str
    modal: ModalState
    origin: Origin = field(default_factory=Origin)


@dataclass(frozen=True, slots=True)
class SyncInstruction:
    """Wait until everything queued before it has been carried out."""

    modal: ModalState
    origin: Origin = field(default_factory=Origin)


@dataclass(frozen=True, slots=True)
class AwaitInstruction(SyncInstruction):
    """Then stand still until a channel has a value, or until `timeout` [s] is over; None waits on."""

    channel: str = ""
    value: bool = True
    timeout: float | None = None


Instruction = (
    MoveInstruction
    | GripInstruction
    | OutputInstruction
    | WaitInstruction
    | MessageInstruction
    | SyncInstruction
)
