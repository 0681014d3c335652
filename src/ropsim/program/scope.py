"""State of the lowering of a procedure: names in sight, loops around, and usage so far."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from ropsim.core import Span, frozen_dataclass
from ropsim.icr import IoChannel, Type
from ropsim.program.diagnostics import unsound
from ropsim.program.emitter import Emitter, Label
from ropsim.program.program import Program, SignalUse, Task
from ropsim.program.statements import Block
from ropsim.spatial import PoseTuple


@frozen_dataclass
class Known:
    """Definitions of a program, by name: the only data of a procedure besides its own statements.

    Attributes:
        tasks: of which only parameters and result count here.
        signals: channels.
        globals: types of the global variables.
        frames: in which locations can be given.
        axes: number of joint coordinates, None until a statement determines it.
    """

    tasks: Mapping[str, Task]
    signals: Mapping[str, SignalUse]
    globals: Mapping[str, Type]
    frames: Mapping[str, PoseTuple]
    axes: int | None = None

    @classmethod
    def by(cls, program: Program) -> "Known":
        """Return the names of a program; of two equal names the first one counts."""
        tasks = {task.name: task for task in reversed(program.tasks)}
        signals = {signal.name: signal for signal in reversed(program.signals)}
        return cls(tasks, signals, {one.name: one.type for one in program.main_locals}, program.frames)


@dataclass(slots=True)
class Used:
    """Entities of the program used by a procedure; only these are declared in ICR.

    Attributes:
        channels: inputs and outputs by name.
        tools: by name.
        frames: by name.
        lists: by name.
        axes: how many joint coordinates its values have.
        has_guessed_axes: whether a value was needed before the number was determined.
    """

    channels: dict[str, IoChannel] = field(default_factory=dict)
    tools: dict[str, None] = field(default_factory=dict)
    frames: dict[str, None] = field(default_factory=dict)
    lists: dict[str, None] = field(default_factory=dict)
    axes: int | None = None
    has_guessed_axes: bool = False


@frozen_dataclass
class Loop:
    """A loop around a statement: where break and continue lead, and the saved modal states at its start."""

    leave: Label
    again: Label
    depth: int


@frozen_dataclass
class _Types:
    """Types of the variables in sight: of two of one name the own one hides the global one."""

    own: Mapping[str, Type]
    globals: Mapping[str, Type]

    def __contains__(self, name: str) -> bool:
        return name in self.own or name in self.globals

    def find(self, name: str) -> Type | None:
        """Return the type of a variable, None where there is none of that name."""
        return self.own.get(name) or self.globals.get(name)


def no_number(_: str) -> int:
    """Return 0: no hidden name stands before."""
    return 0


@dataclass(slots=True)
class Scope:
    """The lowering of one procedure.

    Attributes:
        known: definitions of the program.
        task: the task, or None for the control statements.
        unit: name of the unit of recorded lines in spans.
        lower_block: lowers a block in this scope.
        used: its usage of the program.
        emitter: the code so far.
        hidden: counters and limits of loops, by name.
        callees: tasks called, in the order of the calls.
        loops: loops around, innermost last.
        depth: modal states saved here.
        kept: names of the values that expressions around keep, innermost last.
        numbers: of the newest hidden name, by its purpose.
        first: returns the number of the newest one before this scope, 0 for none.
        types: of the variables in sight, by name; locals hide globals.
    """

    known: Known
    task: Task | None
    unit: str
    lower_block: "Callable[[Scope, Block], None]"
    used: Used = field(default_factory=Used)
    emitter: Emitter = field(default_factory=Emitter)
    hidden: dict[str, Type] = field(default_factory=dict)
    callees: dict[str, None] = field(default_factory=dict)
    loops: list[Loop] = field(default_factory=list)
    depth: int = 0
    kept: list[str] = field(default_factory=list)
    numbers: dict[str, int] = field(default_factory=dict)
    first: Callable[[str], int] = field(default=no_number)
    types: "_Types" = field(init=False, repr=False)

    def __post_init__(self) -> None:
        own = (*self.task.parameters, *self.task.locals) if self.task else ()
        self.types = _Types({local.name: local.type for local in own}, self.known.globals)

    def line(self, span: Span) -> int:
        """Return the line of a span in the unit, 0 for one of another text."""
        return span.line if span.source == self.unit else 0

    def type_of(self, name: str) -> Type:
        """Return the type of a variable in sight.

        Raises:
            LoweringError: the variable is unknown.
        """
        kind = self.types.find(name)
        if kind is None:
            raise unsound(f"variable `{name}` is not declared")
        return kind

    def hide(self, purpose: str, kind: Type) -> str:
        """Return a new local whose name no variable of the program has."""
        before = self.numbers.get(purpose)
        number = (self.first(purpose) if before is None else before) + 1
        while f"{purpose}.{number}" in self.types:
            number += 1
        self.numbers[purpose] = number
        name = f"{purpose}.{number}"
        self.hidden[name] = kind
        return name

    def channel(self, name: str) -> IoChannel:
        """Return a channel and note its use.

        Raises:
            LoweringError: the signal is unknown.
        """
        signal = self.known.signals.get(name)
        if signal is None:
            raise unsound(f"signal `{name}` is not declared")
        letters = ("D" if signal.type is Type.BOOL else "A") + ("I" if signal.is_input else "O")
        return self.used.channels.setdefault(name, IoChannel(name, letters, signal.type))

    def frame(self, name: str) -> str:
        """Return the name of a frame in which locations are given, and note its use.

        Raises:
            LoweringError: the frame is unknown.
        """
        if name not in self.known.frames:
            raise unsound(f"frame `{name}` is not declared")
        self.used.frames.setdefault(name)
        return name

    def callee(self, name: str) -> Task:
        """Return a task and note the call.

        Raises:
            LoweringError: the task is unknown.
        """
        task = self.known.tasks.get(name)
        if task is None:
            raise unsound(f"task `{name}` is not defined")
        self.callees.setdefault(name)
        return task
