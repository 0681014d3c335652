"""An ICR program as a value: declarations and procedures of flat code."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import field
from operator import attrgetter
from typing import NamedTuple

from ropsim.core import Span, frozen_dataclass
from ropsim.icr.types import Constant, Type
from ropsim.spatial import PoseTuple

VERSION = "1.0"
CHANNEL_TYPES = {
    "DI": (Type.BOOL,),
    "DO": (Type.BOOL,),
    "AI": (Type.REAL, Type.INT),
    "AO": (Type.REAL, Type.INT),
}
"""Kind of channel -> types that it may have."""

Operand = str | int | Constant
_NAME = attrgetter("name")


class Step(NamedTuple):
    """One ICR instruction; a label operand is the index of the target in the code of its procedure."""

    mnemonic: str
    operands: tuple[Operand, ...] = ()


@frozen_dataclass
class Variable:
    """A global variable, parameter or local."""

    name: str
    type: Type


@frozen_dataclass
class IoChannel:
    """A symbolic channel; the cell file binds it.

    `kind` is DI or DO (BOOL), AI or AO (REAL or INT).
    """

    name: str
    kind: str
    type: Type

    @property
    def is_output(self) -> bool:
        """Return whether OUT may set it."""
        return self.kind in {"DO", "AO"}


def channel_fault(channel: IoChannel) -> str:
    """Return the fault in kind and type of a channel, or an empty string."""
    allowed = CHANNEL_TYPES.get(channel.kind)
    if allowed is None:
        return f"`{channel.kind}` is no kind of channel, allowed are {', '.join(CHANNEL_TYPES)}"
    if channel.type not in allowed:
        names = " or ".join(one.value for one in allowed)
        return f"a channel of kind `{channel.kind}` has type {names}, found {channel.type.value}"
    return ""


@frozen_dataclass
class FrameDefinition:
    """A task frame: X_BK, nominal (x, y, z, qw, qx, qy, qz) [m, 1]."""

    name: str
    pose: PoseTuple


@frozen_dataclass
class ToolDefinition:
    """A tool: X_MT, nominal; None leaves it to the cell file."""

    name: str
    pose: PoseTuple | None


@frozen_dataclass
class PoseList:
    """A list of poses, counted from 1: each (x, y, z, qw, qx, qy, qz) [m, 1]; one at least.

    Attributes:
        name: of the list.
        poses: in their order.
        source: name of the text that it was made of; empty where there is none. Like the lines it is not part
            of the identity of the program, and neither form of it holds it.
        lines: of that text in which the poses stand; empty where they are not known.
    """

    name: str
    poses: tuple[PoseTuple, ...]
    source: str = field(default="", compare=False)
    lines: tuple[int, ...] = field(default=(), compare=False, repr=False)


@frozen_dataclass
class LibraryText:
    """Source of a procedure that is not in the source text.

    Attributes:
        procedure: its name.
        source: name of the text.
        version: of its content, such as a SHA-256.
    """

    procedure: str
    source: str
    version: str


@frozen_dataclass
class Procedure:
    """A procedure.

    Attributes:
        name: unique; `main` is run.
        parameters: taken from the stack by CALL, the last one from the top.
        locals: other variables of one activation.
        results: types left on the stack by RET.
        code: instructions.
        lines: source line of each instruction, 0 where unknown; not part of the identity of the procedure.
        places: where each instruction stands in the ICR text; empty where there was none.
    """

    name: str
    parameters: tuple[Variable, ...] = ()
    locals: tuple[Variable, ...] = ()
    results: tuple[Type, ...] = ()
    code: tuple[Step, ...] = ()
    lines: tuple[int, ...] = field(default=(), compare=False)
    places: tuple[Span, ...] = field(default=(), compare=False, repr=False)
    _numbers: dict[str, int] | None = field(init=False, default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        missing = len(self.code) - len(self.lines)
        object.__setattr__(self, "lines", self.lines + (0,) * missing)

    @property
    def numbers(self) -> dict[str, int]:
        """Return the place of each variable, parameters first, by its name; computed on the first request."""
        return _known_places(self, "_numbers", self.variables)

    @property
    def variables(self) -> tuple[Variable, ...]:
        """Return parameters and locals."""
        return self.parameters + self.locals


@frozen_dataclass
class Program:
    """An ICR program.

    Attributes:
        name: of the program.
        procedures: `main` among them.
        version: of the language.
        capabilities: required capabilities of a robot, sorted.
        axes: how many joint coordinates every JOINTS value has; None where no JOINTS occurs.
        variables: global ones.
        channels: inputs and outputs.
        frames: task frames.
        tools: tools.
        lists: lists of poses.
        source: name of the text that the source lines refer to; empty where there is none. Like the lines it
            is not part of the identity of the program.
        libraries: texts of the procedures that come from elsewhere; also not part of the identity.
        declared_at: record (`PROC main`, `FRAMEDEF st1`) -> place in the ICR text.
    """

    name: str
    procedures: tuple[Procedure, ...]
    version: str = VERSION
    capabilities: tuple[str, ...] = ()
    axes: int | None = None
    variables: tuple[Variable, ...] = ()
    channels: tuple[IoChannel, ...] = ()
    frames: tuple[FrameDefinition, ...] = ()
    tools: tuple[ToolDefinition, ...] = ()
    lists: tuple[PoseList, ...] = ()
    source: str = field(default="", compare=False)
    libraries: tuple[LibraryText, ...] = field(default=(), compare=False)
    declared_at: Mapping[str, Span] = field(default_factory=dict, compare=False, repr=False)
    _numbers: dict[str, int] | None = field(init=False, default=None, compare=False, repr=False)
    _procedure_numbers: dict[str, int] | None = field(init=False, default=None, compare=False, repr=False)
    _channel_numbers: dict[str, int] | None = field(init=False, default=None, compare=False, repr=False)
    _identity: str = field(init=False, default="", compare=False, repr=False)

    @property
    def numbers(self) -> dict[str, int]:
        """Return the place of each global variable, by its name; computed on the first request."""
        return _known_places(self, "_numbers", self.variables)

    @property
    def procedure_numbers(self) -> dict[str, int]:
        """Return the place of each procedure, by its name; computed on the first request."""
        return _known_places(self, "_procedure_numbers", self.procedures)

    def identity(self, find: Callable[[], str]) -> str:
        """Return the identity of the program, see `program_id`; computed on the first request."""
        if not self._identity:
            object.__setattr__(self, "_identity", find())
        return self._identity

    def procedure(self, name: str) -> Procedure | None:
        """Return the first procedure of that name, or None."""
        number = self.procedure_numbers.get(name)
        return None if number is None else self.procedures[number]

    def channel(self, name: str) -> IoChannel | None:
        """Return the first channel of that name, or None."""
        number = _known_places(self, "_channel_numbers", self.channels).get(name)
        return None if number is None else self.channels[number]


def _known_places(
    owner: Procedure | Program, field_name: str, named: Sequence[Variable | Procedure | IoChannel]
) -> dict[str, int]:
    """Return the place of each name, of two equal ones the first; a field of the owner remembers them."""
    known: dict[str, int] | None = getattr(owner, field_name)
    if known is None:
        known = dict(zip(map(_NAME, reversed(named)), range(len(named) - 1, -1, -1), strict=True))
        object.__setattr__(owner, field_name, known)
    return known


def text_place(program: Program, procedure: Procedure, index: int) -> Span | None:
    """Return where an instruction stands: in the ICR text if it came from one, else in the source."""
    if index < len(procedure.places):
        return procedure.places[index]
    return source_place(program, procedure, index) or program.declared_at.get(f"PROC {procedure.name}")


def source_place(program: Program, procedure: Procedure, index: int) -> Span | None:
    """Return the source line of an instruction, or its place in the ICR text where no line is known."""
    line = procedure.lines[index]
    if line > 0:
        return Span.whole_line(program.source or program.name, line)
    return procedure.places[index] if index < len(procedure.places) else None
