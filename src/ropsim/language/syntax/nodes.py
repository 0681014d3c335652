"""Expression nodes; `start` and `end` are offsets in the logical line, so a node depends on the text only."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Name:
    """A name where a name is meant."""

    text: str
    start: int
    end: int


@frozen_dataclass
class Number:
    """A number with its unit; an empty unit marks a bare number."""

    value: float
    is_whole: bool
    unit: str
    start: int
    end: int


@frozen_dataclass
class Text:
    """A text in quotes."""

    value: str
    start: int
    end: int


@frozen_dataclass
class Literal:
    """One of the words `true false on off here home`."""

    word: str
    start: int
    end: int


@frozen_dataclass
class Unary:
    """`neg` or `not`."""

    op: str
    operand: "Node"
    start: int
    end: int


@frozen_dataclass
class Binary:
    """`+ - * / mod and or = == <> < > <= >=` and the pose operators `above`, `offset`, `rel`."""

    op: str
    left: "Node"
    right: "Node"
    start: int
    end: int


@frozen_dataclass
class Rebase:
    """`operand in frame`: the same numbers, read in another frame."""

    operand: "Node"
    frame: Name
    start: int
    end: int


@frozen_dataclass
class External:
    """`operand external (values)`: a location with values of external axes."""

    operand: "Node"
    values: tuple["Node", ...]
    start: int
    end: int


@frozen_dataclass
class Free:
    """`operand free`: a location whose orientation is free."""

    operand: "Node"
    start: int
    end: int


@frozen_dataclass
class State:
    """`operand is [not] on|off|true|false`."""

    operand: "Node"
    word: str
    negated: bool
    start: int
    end: int


@frozen_dataclass
class Function:
    """`name(arguments)`: a fixed function, or a task that returns a value; `opening` is its parenthesis."""

    name: Name
    arguments: tuple["Item", ...]
    opening: int
    start: int
    end: int

    @property
    def values(self) -> tuple["Node", ...]:
        """Return the arguments without the names of parameters."""
        return tuple(argument.value for argument in self.arguments)


@frozen_dataclass
class Item:
    """An argument, or a member of a parenthesis; `name` is None unless written `name = value`."""

    name: Name | None
    value: "Node"


@frozen_dataclass
class Turn:
    """One orientation term of a tuple.

    Attributes:
        word: `rpy quat euler rotvec pitch roll yaw rx ry rz down like`.
        axes: axes of `euler`, upper case.
        values: the numbers.
        like: the pose of `like`.
    """

    word: str
    axes: str
    values: tuple["Node", ...]
    like: "Node | None"
    start: int
    end: int


@frozen_dataclass
class Posture:
    """`config (word, …)`, `turns (n, …)` and `free` of a location."""

    words: tuple[Name, ...]
    turns: tuple["Node", ...]
    is_free: bool
    start: int
    end: int


@frozen_dataclass
class Tuple:
    """A parenthesis with several members or an orientation: a location, a vector or an argument list."""

    items: tuple[Item, ...]
    turns: tuple[Turn, ...]
    posture: Posture | None
    start: int
    end: int


@frozen_dataclass
class Joints:
    """`joints(...)`."""

    values: tuple["Node", ...]
    start: int
    end: int


@frozen_dataclass
class Member:
    """`operand.name`."""

    operand: "Node"
    name: Name
    start: int
    end: int


@frozen_dataclass
class Index:
    """`operand[index]`: an element of a list; `opening` is its bracket."""

    operand: "Node"
    index: "Node"
    opening: int
    start: int
    end: int


Node = (
    Name
    | Number
    | Text
    | Literal
    | Unary
    | Binary
    | Rebase
    | External
    | Free
    | State
    | Function
    | Tuple
    | Joints
    | Member
    | Index
)
