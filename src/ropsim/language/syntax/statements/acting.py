"""Nodes of lines that move, set, call or assign; positions as in `nodes`."""

from ropsim.core import frozen_dataclass
from ropsim.language.syntax.nodes import Item, Name, Node


@frozen_dataclass
class Setting:
    """`speed|acc|blend|angle value`, `fine`, `tool name` or `frame name`."""

    word: str
    value: Node | None
    name: Name | None
    start: int
    end: int


@frozen_dataclass
class SetSignal:
    """`set output on|off|= value`."""

    name: Name
    value: Node
    start: int
    end: int


@frozen_dataclass
class Trigger:
    """`at place after start|before end do set output …`; the side is `after` or `before`."""

    place: Node
    side: str
    action: SetSignal
    start: int
    end: int


@frozen_dataclass
class Tracking:
    """`track signal = value [along [-]x|y|z] [gain k]`; without `along` the direction is empty."""

    signal: Name
    value: Node
    direction: str
    gain: Node | None
    start: int
    end: int


@frozen_dataclass
class Motion:
    """`mov`, `lin`, `circ` or `spline` to a target, through points on the way.

    `condition` and `timeout` end it before, `store` is a variable for the pose at its end, `tracking` the
    correction of its path. `along` is the name, in the target, of the list whose points it leads through.
    """

    word: str
    via: tuple[Node, ...]
    target: Node
    modifiers: tuple[Setting, ...]
    triggers: tuple[Trigger, ...]
    condition: Node | None
    timeout: Node | None
    store: Name | None
    tracking: Tracking | None
    along: Name | None
    start: int
    end: int


@frozen_dataclass
class Gripper:
    """`open` or `close`, with an optional tool."""

    word: str
    tool: Name | None
    start: int
    end: int


@frozen_dataclass
class Load:
    """`load (x, y, z), l`."""

    names: tuple[Name, ...]
    source: Node
    start: int
    end: int


@frozen_dataclass
class SetMode:
    """`set speed|acc|blend|frame|tool …`."""

    setting: Setting
    start: int
    end: int


@frozen_dataclass
class With:
    """`with setting, setting`."""

    settings: tuple[Setting, ...]
    start: int
    end: int


@frozen_dataclass
class WaitTime:
    """`wait t`."""

    duration: Node
    start: int
    end: int


@frozen_dataclass
class Stop:
    """`stop [text]`."""

    message: Node | None
    start: int
    end: int


@frozen_dataclass
class Print:
    """`print value, value`."""

    values: tuple[Node, ...]
    start: int
    end: int


@frozen_dataclass
class Call:
    """`[call] task arguments`.

    `closing` is the place behind the parenthesis that touches the name, -1 without one.
    """

    name: Name
    arguments: tuple[Item, ...]
    closing: int
    start: int
    end: int


@frozen_dataclass
class Assign:
    """`name = value` or `name.member = value`."""

    name: Name
    member: Name | None
    value: Node
    start: int
    end: int
