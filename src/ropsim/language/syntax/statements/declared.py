"""Nodes of declarations, task headers and contracts; positions as in `nodes`."""

from ropsim.core import frozen_dataclass
from ropsim.language.syntax.nodes import Name, Node


@frozen_dataclass
class ProgramHeader:
    """`program name`."""

    name: Name
    start: int
    end: int


@frozen_dataclass
class Units:
    """`units mm, deg, s`."""

    names: tuple[Name, ...]
    start: int
    end: int


@frozen_dataclass
class Mode:
    """`classic` or `strict`."""

    word: str
    start: int
    end: int


@frozen_dataclass
class FrameDeclaration:
    """`frame name = pose`."""

    name: Name
    value: Node
    start: int
    end: int


@frozen_dataclass
class LocationDeclaration:
    """`loc name = pose` or `loc name = joints(...)`."""

    name: Name
    value: Node
    start: int
    end: int


@frozen_dataclass
class ToolDeclaration:
    """`tool name = pose`, with the words `payload`, `cog`, `gripper` that were written after it."""

    name: Name
    value: Node
    extras: tuple[Name, ...]
    start: int
    end: int


@frozen_dataclass
class SignalDeclaration:
    """`signal name = [analog] input|output channel`."""

    name: Name
    is_analog: bool
    is_input: bool
    channel: Node
    start: int
    end: int


@frozen_dataclass
class ConstantDeclaration:
    """`const name [: type] = value`."""

    name: Name
    type: Name | None
    value: Node
    start: int
    end: int


@frozen_dataclass
class VariableDeclaration:
    """`var name [: type] [= value]`."""

    name: Name
    type: Name | None
    value: Node | None
    start: int
    end: int


@frozen_dataclass
class PatternDeclaration:
    """`pattern name = grid a x b from pose step v1, v2 [order word]`."""

    name: Name
    counts: tuple[Node, ...]
    origin: Node
    steps: tuple[Node, ...]
    order: Name | None
    start: int
    end: int


@frozen_dataclass
class Parameter:
    """`name [: type] [= default]`."""

    name: Name
    type: Name | None
    default: Node | None


@frozen_dataclass
class TaskHeader:
    """`task name [(parameters)] [-> type]`; `parameters` is None where no list is written."""

    name: Name
    parameters: tuple[Parameter, ...] | None
    result: Name | None
    start: int
    end: int


@frozen_dataclass
class ContractClause:
    """`needs …` or `assumes …`."""

    text: str
    start: int
    end: int


SYMBOLS = (
    LocationDeclaration,
    SignalDeclaration,
    ConstantDeclaration,
    VariableDeclaration,
    PatternDeclaration,
)
"""Declarations of entities that expressions can name."""
NAMED = (*SYMBOLS, FrameDeclaration, ToolDeclaration)
"""Declarations that name an entity."""
DECLARATIONS = (*NAMED, ProgramHeader, Units, Mode)
"""All declarations outside tasks."""
