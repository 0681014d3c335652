"""The robot instructions that flow from the interpreter to the simulator, in program order."""

from dataclasses import field
from enum import Enum, StrEnum

from ropsim.core import Span, frozen_dataclass
from ropsim.flow.modal import ModalState
from ropsim.flow.tracking import PathTracking
from ropsim.spatial import Pose


class Comparison(Enum):
    """How the value of a channel is compared with that of a guard."""

    IS = "is"
    ABOVE = "above"
    BELOW = "below"


@frozen_dataclass
class Guard:
    """A guarded move ends where its condition is true.

    Attributes:
        channel: monitored channel.
        comparison: the channel has the value, exceeds it or is less than it.
        value: truth value of a digital channel, number of an analog one; fixed when the move begins.
        timeout: the move ends after this time even if its condition has not come true [s]; None for none.
    """

    channel: str
    comparison: Comparison
    value: bool | float
    timeout: float | None = None

    def holds(self, found: bool | float) -> bool:  # noqa: FBT001 - a signal's value
        """Return whether a value of the channel makes the condition true."""
        if self.comparison is Comparison.IS:
            return bool(found) is bool(self.value)
        return found > self.value if self.comparison is Comparison.ABOVE else found < self.value


class Side(Enum):
    """From which end of a move the place of a trigger is counted."""

    BEFORE_END = "before end"
    AFTER_START = "after start"


@frozen_dataclass
class Trigger:
    """Set an output channel where a move is some way or some time from one of its ends.

    Attributes:
        channel: output that is set.
        value: new value.
        side: end of the move from which is counted.
        distance: way of the TCP from there [m], ≥ 0; None where a time is given.
        time: time from there, as planned [s], ≥ 0; None where a distance is given.
    """

    channel: str
    value: bool | int | float
    side: Side
    distance: float | None = None
    time: float | None = None


class TargetOrientation(Enum):
    """Whether the orientation of a target counts."""

    GIVEN = "given"
    FREE = "free"


@frozen_dataclass
class PostureRequest:
    """Request of a target to the branch of the inverse kinematics.

    Attributes:
        words: words of a posture in the order in which they were written, such as `("left", "up")`; a part of
            the posture of which nothing is said is free.
        turns: for the axes of the arm from the first on, the whole turn k in which the axis is to be:
            its angle lies in [2πk - π, 2πk + π); axes beyond the last one given are free.
        orientation: whether the orientation of the target counts. Where it is free, that of an arm with six
            or more axes stays as it is at the start of the move; that of others follows from the position.
    """

    words: tuple[str, ...] = ()
    turns: tuple[int, ...] = ()
    orientation: TargetOrientation = TargetOrientation.GIVEN

    @property
    def names_branch(self) -> bool:
        """Return whether it names a posture or turns, so that some branches are left out."""
        return bool(self.words or self.turns)

    @property
    def of_any_branch(self) -> "PostureRequest":
        """Return the request without posture and turns."""
        return PostureRequest(orientation=self.orientation)


class MotionKind(StrEnum):
    """How the TCP travels, of the kinds that are built in.

    Pose to pose (synchronous joints), on a straight line, on an arc of a circle, on a smooth curve.
    """

    PTP = "PTP"
    LIN = "LIN"
    CIRC = "CIRC"
    SPLINE = "SPLINE"


class GripAction(Enum):
    """Action of a gripper."""

    OPEN = "open"
    CLOSE = "close"


@frozen_dataclass
class ListedPoint:
    """A point of a list of points; as text in words, such as "point 3 of `seam` (points/seam.csv line 5)".

    Attributes:
        list: name of the list.
        number: of the point, from 1.
        source: name of the text of the list; empty where it is not known.
        line: of the point in that text, 0 where it is not known.
    """

    list: str
    number: int
    source: str = ""
    line: int = 0

    def __str__(self) -> str:
        place = f" ({self.source} line {self.line})" if self.source and self.line else ""
        return f"point {self.number} of `{self.list}`{place}"


@frozen_dataclass
class Origin:
    """Where an instruction comes from.

    Attributes:
        span: the source line, where it is known.
        visit: how often this very instruction has been executed, from 1 ("loop pass").
        calls: procedures from `main` down to the one that holds the instruction.
        call_serials: for each entry of `calls`, the ordinal of that activation in the run (main = 0).
        point: the point of a list that the target is made of; None where it is made of none.
    """

    span: Span | None = None
    visit: int = 1
    calls: tuple[str, ...] = ("main",)
    call_serials: tuple[int, ...] = (0,)
    point: ListedPoint | None = None

    @property
    def data(self) -> dict[str, object]:
        """Return pass and point for the data of a finding."""
        if self.point is None:
            return {"pass": self.visit}
        point = self.point
        where = {"list": point.list, "point": point.number, "list_source": point.source}
        return {"pass": self.visit, **where, "list_line": point.line}


@frozen_dataclass
class MoveInstruction:
    """Go to a target.

    Attributes:
        kind: kind of path, one of `MotionKind` or the name of another one that the controller supports.
        target: pose of the tool in the task frame (X_KT), joint coordinates [rad | m], or None for the
            home position of the arm.
        modal: snapshot of the modal state.
        origin: source line and loop pass.
        external: values of the external axes at a pose [rad | m], in the order of the axes; empty to leave
            them unchanged, and for joint coordinates and home.
        via: poses of the tool that the path leads through (X_KT), in the frame of the target: one of an arc,
            any number of a curve, none of other kinds.
        angle: how far an arc goes on its circle [rad], > 0, instead of ending at the target; None ends there.
        triggers: outputs that are set on the way, in the order of the program.
        guard: condition that ends the move before its target; None without one.
        posture: in which posture the target is to be reached, and whether its orientation and those of the
            via points count; None leaves the posture to the planner.
        tracking: signal that corrects the path; None where it is made as planned.
    """

    kind: str
    target: Pose | tuple[float, ...] | None
    modal: ModalState
    origin: Origin = field(default_factory=Origin)
    external: tuple[float, ...] = ()
    via: tuple[Pose, ...] = ()
    angle: float | None = None
    triggers: tuple[Trigger, ...] = ()
    guard: Guard | None = None
    posture: PostureRequest | None = None
    tracking: PathTracking | None = None

    @property
    def asks_for_branch(self) -> bool:
        """Return whether the target is to be reached in a posture or with turns."""
        return self.posture is not None and self.posture.names_branch

    @property
    def has_free_orientation(self) -> bool:
        """Return whether the orientation of the target is free, and so that of the whole move."""
        return self.posture is not None and self.posture.orientation is TargetOrientation.FREE


@frozen_dataclass
class GripInstruction:
    """Open or close the gripper of a tool (empty name = the tool in force)."""

    action: GripAction
    tool: str
    modal: ModalState
    origin: Origin = field(default_factory=Origin)


@frozen_dataclass
class OutputInstruction:
    """Set an output channel when the motion before it has ended."""

    channel: str
    value: bool | int | float
    modal: ModalState
    origin: Origin = field(default_factory=Origin)


@frozen_dataclass
class WaitInstruction:
    """Stand still for a time [s] when the motion before it has ended."""

    duration: float
    modal: ModalState
    origin: Origin = field(default_factory=Origin)


@frozen_dataclass
class MessageInstruction:
    """Show a text to the operator."""

    text: str
    modal: ModalState
    origin: Origin = field(default_factory=Origin)


@frozen_dataclass
class SyncInstruction:
    """Wait until everything queued before it has been carried out.

    Attributes:
        modal: settings in force.
        origin: where it stands in the program.
        before: ICR instruction that comes next, such as `IN` or `HALT`; empty where it is not known.
    """

    modal: ModalState
    origin: Origin = field(default_factory=Origin)
    before: str = field(default="", kw_only=True)


@frozen_dataclass
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
