"""What lowering knows: the names in sight, the loops around, and what the whole program has used so far."""

from collections.abc import Callable
from dataclasses import dataclass, field

from ropsim.icr import IoChannel, Type
from ropsim.program.diagnostics import unsound
from ropsim.program.emitter import Emitter, Label
from ropsim.program.program import Program, Task
from ropsim.program.statements import Block


@dataclass(slots=True)
class Used:
    """What the program uses; only that is declared in ICR."""

    channels: dict[str, IoChannel] = field(default_factory=dict)
    tools: dict[str, None] = field(default_factory=dict)
    axes: int | None = None


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
        source: name of the text whose lines are recorded.
        lower_block: lowers a block in this scope.
        emitter: the code so far.
        hidden: counters and limits of loops, by name.
        callees: tasks called, in the order of the calls.
        loops: loops around, innermost last.
        depth: modal states saved here.
    """

    program: Program
    task: Task | None
    used: Used
    source: str
    lower_block: "Callable[[Scope, Block], None]"
    emitter: Emitter = field(default_factory=Emitter)
    hidden: dict[str, Type] = field(default_factory=dict)
    callees: dict[str, None] = field(default_factory=dict)
    loops: list[Loop] = field(default_factory=list)
    depth: int = 0

    def type_of(self, name: str) -> Type:
        """Return the type of a variable in sight; locals hide globals.

        Raises:
            LoweringError: there is no such variable.
        """
        own = (*self.task.parameters, *self.task.locals) if self.task else ()
        for local in (*own, *self.program.main_locals):
            if local.name == name:
                return local.type
        raise unsound(f"variable `{name}` is not declared")

    def hide(self, purpose: str, kind: Type) -> str:
        """Return a new local whose name no variable of the program has."""
        own = (*self.task.parameters, *self.task.locals) if self.task else ()
        taken = {local.name for local in (*own, *self.program.main_locals)} | self.hidden.keys()
        number = 1
        while f"{purpose}.{number}" in taken:
            number += 1
        name = f"{purpose}.{number}"
        self.hidden[name] = kind
        return name

    def channel(self, name: str) -> IoChannel:
        """Return a channel and note its use.

        Raises:
            LoweringError: there is no such signal.
        """
        for signal in self.program.signals:
            if signal.name == name:
                kind = signal.type
                letters = ("D" if kind is Type.BOOL else "A") + ("I" if signal.is_input else "O")
                return self.used.channels.setdefault(name, IoChannel(name, letters, kind))
        raise unsound(f"signal `{name}` is not declared")

    def callee(self, name: str) -> Task:
        """Return a task and note the call.

        Raises:
            LoweringError: there is no such task.
        """
        for task in self.program.tasks:
            if task.name == name:
                self.callees.setdefault(name)
                return task
        raise unsound(f"task `{name}` is not defined")
