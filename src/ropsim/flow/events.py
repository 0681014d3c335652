"""Events of a run, one record for each kind; texts for users are made by views."""

from collections.abc import Mapping
from dataclasses import KW_ONLY
from types import MappingProxyType
from typing import ClassVar

from ropsim.core import Span, frozen_dataclass
from ropsim.flow.critical_limit import CriticalLimit
from ropsim.flow.instructions import Origin
from ropsim.flow.reached_speed import ReachedSpeed


@frozen_dataclass
class Event:
    """Something that happened from one time on.

    Attributes:
        kind: word of the event, the same for all events of a class.
        time: [s], a whole control tick.
        duration: [s], 0 for an instant.
        station: name of the station whose program made it; empty for events of the cell.
        origin: statement and pass of the instruction; None for an event without an instruction.
    """

    kind: ClassVar[str] = ""

    time: float
    duration: float = 0.0
    station: str = ""
    origin: Origin | None = None

    @property
    def end(self) -> float:
        """Return when it was over [s]."""
        return self.time + self.duration

    @property
    def span(self) -> Span | None:
        """Return the source line, None where none is known."""
        return self.origin.span if self.origin else None

    @property
    def line(self) -> int:
        """Return the number of the source line, 0 where none is known."""
        return self.span.line if self.span else 0

    @property
    def visit(self) -> int:
        """Return the loop pass, 0 for an event without an instruction."""
        return self.origin.visit if self.origin else 0


@frozen_dataclass
class MoveEvent(Event):
    """A move was carried out; it lasts until the arm is in position.

    Attributes:
        motion: kind of path, such as PTP or LIN.
        ordinal: of the move in its station, from 0, as in the channel `move`.
        travel: time to the end of the reference [s].
        settle: time after that until the arm was in position [s].
        zone: distance from the target at which the program lets the next move begin [m].
        flown: distance from the target at which the path went on to the next move [m]; 0 where it stopped.
        blending: part of `travel` within its own zone or that of the move before [s].
        critical: limit that sets its time; None where it reaches none, as in a zone.
        path_speed: that in force for its path of the tool, of program or cell [m/s]; None without one.
        path_error_max: largest distance of the TCP from the path of the tool [m]; None where there is none.
        target: where the command puts the TCP if the move goes to its end, in the base frame [m], three
            numbers; empty where it is not known.
        reached: how slow it is against `path_speed`, and why; None where it is not.
        out_of_position: largest error of a joint at its end, as a share of `in_position` of the controller:
            up to 1 the arm was; None where the move went on to the next one, or the run was cut short.
        free_orientation: whether the orientation of its target is free, so that none can be missed.
    """

    kind: ClassVar[str] = "move"

    _: KW_ONLY
    motion: str
    ordinal: int
    travel: float = 0.0
    settle: float = 0.0
    zone: float = 0.0
    flown: float = 0.0
    blending: float = 0.0
    critical: CriticalLimit | None = None
    path_speed: float | None = None
    path_error_max: float | None = None
    reached: ReachedSpeed | None = None
    target: tuple[float, ...] = ()
    out_of_position: float | None = None
    free_orientation: bool = False


@frozen_dataclass
class SkipEvent(Event):
    """A move was refused, a finding says why, and left out."""

    kind: ClassVar[str] = "skip"

    _: KW_ONLY
    motion: str


@frozen_dataclass
class WaitEvent(Event):
    """The program stood still for a time, or for a polling loop without other actions.

    Attributes:
        pause: how long it was to stand [s]; the event is shorter where the run was cut short.
        looked: channels that the program polls until they change.
    """

    kind: ClassVar[str] = "wait"

    _: KW_ONLY
    pause: float
    looked: tuple[str, ...] = ()


@frozen_dataclass
class AwaitEvent(Event):
    """The program stood still until a channel had a value, or its timeout was over.

    Attributes:
        channel: name of the input or output.
        value: that it waited for.
        came: whether it came; false where the timeout or the run was over before.
    """

    kind: ClassVar[str] = "await"

    _: KW_ONLY
    channel: str
    value: bool
    came: bool


@frozen_dataclass
class OutputEvent(Event):
    """The program set an output.

    Attributes:
        channel: name of the output.
        value: as the program gave it.
    """

    kind: ClassVar[str] = "output"

    _: KW_ONLY
    channel: str
    value: bool | int | float


@frozen_dataclass
class MessageEvent(Event):
    """The program printed a message for its operator.

    Attributes:
        text: as the program made it; any characters.
    """

    kind: ClassVar[str] = "message"

    _: KW_ONLY
    text: str


@frozen_dataclass
class GripEvent(Event):
    """A gripper closed.

    Attributes:
        part: name of the gripped part, empty for none.
    """

    kind: ClassVar[str] = "grip"

    _: KW_ONLY
    part: str = ""


@frozen_dataclass
class ReleaseEvent(Event):
    """A gripper opened.

    Attributes:
        part: name of the released part, empty for none.
    """

    kind: ClassVar[str] = "release"

    _: KW_ONLY
    part: str = ""


@frozen_dataclass
class TaskEvent(Event):
    """A task was active, from its first to its last instruction.

    Attributes:
        name: of the task.
        serial: ordinal of the activation in the run of its station; 0 is `main`.
        depth: of the call; 1 was called by `main`.
    """

    kind: ClassVar[str] = "task"

    _: KW_ONLY
    name: str
    serial: int
    depth: int


@frozen_dataclass
class InputEvent(Event):
    """An input was changed from outside, by a key or a record of keys.

    Attributes:
        signal: name of the input.
        value: from now on.
    """

    kind: ClassVar[str] = "input"

    _: KW_ONLY
    signal: str
    value: float


EVENTS: Mapping[str, type[Event]] = MappingProxyType(
    {
        one.kind: one
        for one in (
            MoveEvent,
            SkipEvent,
            WaitEvent,
            AwaitEvent,
            OutputEvent,
            MessageEvent,
            GripEvent,
            ReleaseEvent,
            TaskEvent,
            InputEvent,
        )
    }
)
"""All kinds of events by their words; readers and writers support only these."""
