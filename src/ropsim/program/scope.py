"""What lowering knows: the names in sight, the loops around, and what the whole program has used so far."""

from collections import ChainMap
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from ropsim.icr import IoChannel, Type
from ropsim.program.diagnostics import unsound
from ropsim.program.emitter import Emitter, Label
from ropsim.program.program import Program, SignalUse, Task
from ropsim.program.source_map import SourceMap
from ropsim.program.statements import Block


@dataclass(slots=True)
class Used:
    """What the program defines, by name, and what of it is used; only that is declared in ICR."""

    tasks: Mapping[str, Task]
    signals: Mapping[str, SignalUse]
    globals: dict[str, Type]
    channels: dict[str, IoChannel] = field(default_factory=dict)
    tools: dict[str, None] = field(default_factory=dict)
    frames: dict[str, None] = field(default_factory=dict)
    axes: int | None = None

    @classmethod
    def by(cls, program: Program) -> "Used":
        """Return the names of a program, nothing used yet; of two equal names the first one counts."""
        tasks = {task.name: task for task in reversed(program.tasks)}
        signals = {signal.name: signal for signal in reversed(program.signals)}
        return cls(tasks, signals, {one.name: one.type for one in program.main_locals})


@dataclass(frozen=True, slots=True)
class Loop:
    """A loop around a statement: where break and continue lead, and the saved modal states at its start."""

    leave: Label
    again: Label
    depth: int


@dataclass(slots=True)
class Scope:
    """The lowering of one procedure.

    Attributes:
        program: the structured program.
        task: the task, or None for the control statements.
        used: shared by all procedures.
        source: where the lines are that are recorded.
        lower_block: lowers a block in this scope.
        emitter: the code so far.
        hidden: counters and limits of loops, by name.
        callees: tasks called, in the order of the calls.
        loops: loops around, innermost last.
        depth: modal states saved here.
        kept: names of the values that expressions around keep, innermost last.
        numbers: of the newest hidden name, by its purpose.
        types: of the variables in sight, by name; locals hide globals.
    """

    program: Program
    task: Task | None
    used: Used
    source: SourceMap
    lower_block: "Callable[[Scope, Block], None]"
    emitter: Emitter = field(default_factory=Emitter)
    hidden: dict[str, Type] = field(default_factory=dict)
    callees: dict[str, None] = field(default_factory=dict)
    loops: list[Loop] = field(default_factory=list)
    depth: int = 0
    kept: list[str] = field(default_factory=list)
    numbers: dict[str, int] = field(default_factory=dict)
    types: ChainMap[str, Type] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        own = (*self.task.parameters, *self.task.locals) if self.task else ()
        self.types = ChainMap({local.name: local.type for local in own}, self.used.globals)

    def type_of(self, name: str) -> Type:
        """Return the type of a variable in sight.

        Raises:
            LoweringError: there is no such variable.
        """
        if name not in self.types:
            raise unsound(f"variable `{name}` is not declared")
        return self.types[name]

    def hide(self, purpose: str, kind: Type) -> str:
        """Return a new local whose name no variable of the program has."""
        number = self.numbers.get(purpose, 0) + 1
        while f"{purpose}.{number}" in self.types:
            number += 1
        self.numbers[purpose] = number
        name = f"{purpose}.{number}"
        self.hidden[name] = kind
        return name

    def channel(self, name: str) -> IoChannel:
        """Return a channel and note its use.

        Raises:
            LoweringError: there is no such signal.
        """
        signal = self.used.signals.get(name)
        if signal is None:
            raise unsound(f"signal `{name}` is not declared")
        letters = ("D" if signal.type is Type.BOOL else "A") + ("I" if signal.is_input else "O")
        return self.used.channels.setdefault(name, IoChannel(name, letters, signal.type))

    def frame(self, name: str) -> str:
        """Return the name of a frame in which locations are given, and note its use.

        Raises:
            LoweringError: there is no such frame.
        """
        if name not in self.program.frames:
            raise unsound(f"frame `{name}` is not declared")
        self.used.frames.setdefault(name)
        return name

    def callee(self, name: str) -> Task:
        """Return a task and note the call.

        Raises:
            LoweringError: there is no such task.
        """
        task = self.used.tasks.get(name)
        if task is None:
            raise unsound(f"task `{name}` is not defined")
        self.callees.setdefault(name)
        return task
