"""A whole structured program: tasks, global variables, frames, tools and signals by name."""

from collections.abc import Mapping
from dataclasses import field

from ropsim.core import Span, frozen_dataclass
from ropsim.flow import GripAction
from ropsim.program.statements import Block
from ropsim.program.types import ValueType
from ropsim.spatial import PoseTuple


@frozen_dataclass
class Local:
    """A parameter or variable of a task, or a global one."""

    name: str
    type: ValueType


@frozen_dataclass
class Contract:
    """Preconditions of a task.

    Attributes:
        gripper: state that the gripper must be in, or None.
        text: the words of the source.
        span: where it stands.
    """

    gripper: GripAction | None
    text: str
    span: Span


@frozen_dataclass
class Task:
    """A task: name, parameters, locals, body.

    Attributes:
        name: as declared.
        parameters: in the order in which a call passes them.
        locals: all other variables.
        result: type of the returned value, or None.
        body: statements.
        contracts: preconditions.
        span: the header.
    """

    name: str
    parameters: tuple[Local, ...]
    locals: tuple[Local, ...]
    result: ValueType | None
    body: Block
    contracts: tuple[Contract, ...]
    span: Span


@frozen_dataclass
class SignalUse:
    """A channel that the program names."""

    name: str
    is_input: bool
    type: ValueType


@frozen_dataclass
class Program:
    """A structured program.

    Attributes:
        name: of the program.
        main: the control statements, run from top to bottom.
        main_locals: variables of the control statements (globals).
        tasks: in the order of their declaration.
        frame: name of the frame in which all locations are given; empty = base frame.
        frames: name -> pose in the base frame (nominal; the cell may calibrate them).
        tools: name -> pose in the mechanical interface frame (nominal).
        tool: tool in force at the start, empty for the cell's default.
        signals: channels that the program names.
        lists: name -> poses of the lists of points.
        places: name -> text of the list and the lines of its points there, where they are known.
    """

    name: str
    main: Block
    main_locals: tuple[Local, ...]
    tasks: tuple[Task, ...]
    frame: str = ""
    frames: Mapping[str, PoseTuple] = field(default_factory=dict)
    tools: Mapping[str, PoseTuple] = field(default_factory=dict)
    tool: str = ""
    signals: tuple[SignalUse, ...] = ()
    lists: Mapping[str, tuple[PoseTuple, ...]] = field(default_factory=dict)
    places: Mapping[str, tuple[str, tuple[int, ...]]] = field(default_factory=dict)
