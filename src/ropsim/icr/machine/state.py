"""The state of the machine: registers while it runs, and an immutable snapshot of them."""

from dataclasses import dataclass, field, replace
from typing import NamedTuple

from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.flow import Guard, ListedPoint, ModalState, Origin, PathTracking, Trigger
from ropsim.icr.machine.handlers import Datum
from ropsim.icr.machine.location import Location

_MOST_KNOWN = 1000
"""Changes of the modal state that a program remembers."""


@frozen_dataclass
class Finished:
    """The end of a run.

    Attributes:
        trap: why the program could not go on; None at HALT, at STOP and at the end of `main`.
        steps: ICR instructions carried out.
        stop: category of the STOP that ended it (IEC 60204-1), or None.
    """

    trap: Diagnostic | None
    steps: int
    stop: int | None = None


class Commanded(NamedTuple):
    """The location commanded last, with the modal state it was commanded under."""

    target: Location
    modal: ModalState


class CommandedJoints(NamedTuple):
    """The joint coordinates [rad | m] commanded last, None for the home position, with the modal state."""

    joints: tuple[float, ...] | None
    modal: ModalState


class Caller(NamedTuple):
    """An activation that waits for the procedure it called.

    Attributes:
        procedure: index of its procedure.
        pc: its next instruction.
        values: its parameters and locals.
        place: source line of the call; if it lacks a line, that of the nearest call below with a line.
    """

    procedure: int
    pc: int
    values: tuple[Datum, ...]
    place: Span | None = None


class CodePlace(NamedTuple):
    """Where a program is.

    Attributes:
        callers: procedure and next instruction of the activations below, `main` first.
        procedure: index of the active procedure.
        pc: its next instruction.
    """

    callers: tuple[tuple[int, int], ...]
    procedure: int
    pc: int


@frozen_dataclass
class MachineState:
    """A snapshot: plain values from which `Machine.resume` goes on in exactly the same way.

    Attributes:
        procedure: index of the active procedure.
        pc: its next instruction.
        values: its parameters and locals.
        stack: values on the stack, the top last.
        shared: global variables.
        callers: activations below, `main` first.
        calls: names of the active procedures, `main` first.
        call_serials: ordinal of each of them in the run.
        modal: modal state in force.
        saved: modal states saved, the last one on top.
        commanded: target of the last move; None at the start, and if the target does not determine the end.
        triggers: triggers of the next move.
        guard: that of the next move, or None.
        tracking: that of the next move, or None.
        visits: (procedure, instruction) and how often it was carried out.
        activations: procedures started so far, `main` not counted.
        steps: instructions carried out.
        is_synced: whether everything before has been carried out for the instruction that comes next.
        finished: the end, where it has been reached.
    """

    procedure: int
    pc: int
    values: tuple[Datum, ...]
    stack: tuple[Datum, ...]
    shared: tuple[Datum, ...]
    callers: tuple[Caller, ...]
    calls: tuple[str, ...]
    call_serials: tuple[int, ...]
    modal: ModalState
    saved: tuple[ModalState, ...]
    commanded: Commanded | CommandedJoints | None
    triggers: tuple[Trigger, ...]
    guard: Guard | None
    tracking: PathTracking | None
    visits: tuple[tuple[tuple[int, int], int], ...]
    activations: int
    steps: int
    is_synced: bool
    finished: Finished | None


@dataclass(slots=True)
class Registers:
    """The same quantities while the machine runs; see `MachineState`."""

    procedure: int
    values: list[Datum]
    shared: list[Datum]
    pc: int = 0
    stack: list[Datum] = field(default_factory=list)
    callers: list[Caller] = field(default_factory=list)
    calls: tuple[str, ...] = ("main",)
    call_serials: tuple[int, ...] = (0,)
    modal: ModalState = field(default_factory=ModalState)
    saved: list[ModalState] = field(default_factory=list)
    commanded: Commanded | CommandedJoints | None = None
    triggers: tuple[Trigger, ...] = ()
    guard: Guard | None = None
    tracking: PathTracking | None = None
    visits: dict[tuple[int, int], int] = field(default_factory=dict)
    activations: int = 0
    steps: int = 0
    is_synced: bool = False
    finished: Finished | None = None
    known: dict[tuple[int, str, Datum], tuple[ModalState, ModalState]] = field(default_factory=dict)
    """Cache of derived modal states, by the identity of the old state and the change."""

    def changed(self, said: tuple[str, Datum], **fields: Datum) -> ModalState:
        """Return the modal state in force with other fields: in loops the same object in each pass.

        Args:
            said: instruction and value, which determine the fields.
            fields: by their names.
        """
        key = (id(self.modal), *said)
        before, after = self.known.get(key, (None, self.modal))
        if before is not self.modal:
            if len(self.known) >= _MOST_KNOWN:
                self.known.clear()
            after = replace(self.modal, **fields)
            self.known[key] = self.modal, after
        return after

    def origin(self, key: tuple[int, int], span: Span | None, point: ListedPoint | None = None) -> Origin:
        """Count one more visit of an instruction, to a point of a list or not, and return its origin."""
        visit = self.visits.get(key, 0) + 1
        self.visits[key] = visit
        return Origin(self.place(span), visit, self.calls, self.call_serials, point)

    def place(self, span: Span | None) -> Span | None:
        """Return a source line; where there is none, as in tasks of a library, that of the call."""
        return span if span is not None or not self.callers else self.callers[-1].place

    def snapshot(self) -> MachineState:
        """Return an immutable copy."""
        return MachineState(
            self.procedure,
            self.pc,
            tuple(self.values),
            tuple(self.stack),
            tuple(self.shared),
            tuple(self.callers),
            self.calls,
            self.call_serials,
            self.modal,
            tuple(self.saved),
            self.commanded,
            self.triggers,
            self.guard,
            self.tracking,
            tuple(sorted(self.visits.items())),
            self.activations,
            self.steps,
            self.is_synced,
            self.finished,
        )

    def restore(self, state: MachineState) -> None:
        """Take over a snapshot; the list of globals stays the same object, since loaded code points to it."""
        self.procedure, self.pc, self.values = state.procedure, state.pc, list(state.values)
        self.stack, self.callers, self.saved = list(state.stack), list(state.callers), list(state.saved)
        self.shared[:] = state.shared
        self.calls, self.call_serials = state.calls, state.call_serials
        self.modal, self.commanded = state.modal, state.commanded
        self.triggers, self.guard, self.tracking = state.triggers, state.guard, state.tracking
        self.visits = dict(state.visits)
        self.activations, self.steps = state.activations, state.steps
        self.is_synced, self.finished = state.is_synced, state.finished
