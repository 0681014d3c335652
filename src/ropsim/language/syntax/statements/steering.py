"""Nodes of lines that steer the flow, and of broken lines; positions as in `nodes`."""

from ropsim.core import frozen_dataclass
from ropsim.language.syntax.nodes import Name, Node


@frozen_dataclass
class Broken:
    """A line that could not be read; the head word and first name are kept so that blocks still match."""

    head: str
    name: str
    start: int
    end: int


@frozen_dataclass
class Closer:
    """`end`, or a closer of one kind of block: `endp endr endif endw endf endwith`."""

    word: str
    start: int
    end: int


@frozen_dataclass
class Until:
    """`until condition`, the other end of `repeat`."""

    condition: Node
    start: int
    end: int


@frozen_dataclass
class ElseIf:
    """`elseif condition`."""

    condition: Node
    start: int
    end: int


@frozen_dataclass
class Else:
    """`else`."""

    start: int
    end: int


@frozen_dataclass
class While:
    """`while condition [do]`."""

    condition: Node
    start: int
    end: int


@frozen_dataclass
class Repeat:
    """`repeat [count]`."""

    count: Node | None
    start: int
    end: int


@frozen_dataclass
class For:
    """`for name = first to last [step s]`."""

    name: Name
    first: Node
    last: Node
    step: Node | None
    start: int
    end: int


@frozen_dataclass
class ForEach:
    """`for each name in pattern`."""

    name: Name
    pattern: Name
    start: int
    end: int


@frozen_dataclass
class Jump:
    """`break` or `continue`."""

    word: str
    start: int
    end: int


@frozen_dataclass
class Return:
    """`return [value]`."""

    value: Node | None
    start: int
    end: int
