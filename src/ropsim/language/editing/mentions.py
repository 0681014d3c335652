"""Every name that one statement mentions, and its role there; independent of other lines."""

from collections.abc import Callable, Iterator
from enum import Enum
from typing import Any

from ropsim.core import frozen_dataclass
from ropsim.language.check.expressions.functions import NAMES
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.nodes import Name, Node


class Part(Enum):
    """Role of a name in a statement."""

    TASK = "task of a header"
    PARAMETER = "parameter of a header"
    DECLARED = "declared"
    LOOP = "given values by a loop"
    LOOP_PLACES = "given the places of a pattern by a loop"
    WRITTEN = "given a value"
    CHANGED = "given a component"
    READ = "read"
    CALLED = "called"
    ARGUMENT = "parameter of the task that is called"
    FRAME = "frame"
    TOOL = "tool"


@frozen_dataclass
class Mention:
    """A name in a statement.

    Attributes:
        name: with its place in the logical line.
        part: its role there.
        callee: name of the task that is called, for arguments.
    """

    name: Name
    part: Part
    callee: str = ""


def mentions(statement: syntax.Statement | None) -> tuple[Mention, ...]:
    """Return the names of a statement, names read before names assigned; components are none."""
    return tuple(_mentioned(statement))


def _mentioned(statement: syntax.Statement | None) -> Iterator[Mention]:
    reader = _READERS.get(type(statement))
    if reader is not None:
        yield from reader(statement)
        return
    if isinstance(statement, syntax.NAMED):
        yield Mention(statement.name, Part.DECLARED)
    for part in _EXPRESSIONS.get(type(statement), ()):
        value = getattr(statement, part)
        for node in value if isinstance(value, tuple) else (value,):
            yield from _read(node)


def _header(header: syntax.TaskHeader) -> Iterator[Mention]:
    yield Mention(header.name, Part.TASK)
    for parameter in header.parameters or ():
        yield Mention(parameter.name, Part.PARAMETER)
        yield from _read(parameter.default)


def _assign(statement: syntax.Assign) -> Iterator[Mention]:
    yield from _read(statement.value)
    yield Mention(statement.name, Part.WRITTEN if statement.member is None else Part.CHANGED)


def _load(statement: syntax.Load) -> Iterator[Mention]:
    yield from _read(statement.source)
    yield from (Mention(name, Part.WRITTEN) for name in statement.names)


def _gripper(statement: syntax.Gripper) -> Iterator[Mention]:
    if statement.tool is not None:
        yield Mention(statement.tool, Part.TOOL)


def _set_signal(statement: syntax.SetSignal) -> Iterator[Mention]:
    yield Mention(statement.name, Part.READ)
    yield from _read(statement.value)


def _with(statement: syntax.With) -> Iterator[Mention]:
    for setting in statement.settings:
        yield from _setting(setting)


def _if(statement: syntax.If) -> Iterator[Mention]:
    yield from _read(statement.condition)
    yield from _mentioned(statement.body)


def _wait(statement: syntax.WaitCondition) -> Iterator[Mention]:
    yield from _read(statement.condition)
    yield from _read(statement.timeout)
    yield from _mentioned(statement.otherwise)


def _loop(statement: syntax.For | syntax.ForEach) -> Iterator[Mention]:
    if isinstance(statement, syntax.ForEach):
        yield Mention(statement.name, Part.LOOP_PLACES)
        yield Mention(statement.pattern, Part.READ)
        return
    yield Mention(statement.name, Part.LOOP)
    for node in (statement.first, statement.last, statement.step):
        yield from _read(node)


def _motion(motion: syntax.Motion) -> Iterator[Mention]:
    for node in (*motion.via, motion.target, motion.condition, motion.timeout):
        yield from _read(node)
    for setting in motion.modifiers:
        yield from _setting(setting)
    for trigger in motion.triggers:
        yield from _read(trigger.place)
        yield from _set_signal(trigger.action)
    if motion.tracking is not None:
        yield Mention(motion.tracking.signal, Part.READ)
        yield from _read(motion.tracking.value)
        yield from _read(motion.tracking.gain)
    if motion.store is not None:
        yield Mention(motion.store, Part.WRITTEN)


def _setting(setting: syntax.Setting) -> Iterator[Mention]:
    if setting.name is not None and setting.word in ("tool", "frame"):
        yield Mention(setting.name, Part.TOOL if setting.word == "tool" else Part.FRAME)
    yield from _read(setting.value)


def _call(call: syntax.Call) -> Iterator[Mention]:
    yield Mention(call.name, Part.CALLED)
    yield from _arguments(call)


def _arguments(call: syntax.Call) -> Iterator[Mention]:
    """Yield the names in the arguments of a call; one parenthesis around them all is left out of account."""
    items = call.arguments
    if len(items) == 1 and items[0].name is None:
        only = items[0].value
        if isinstance(only, nodes.Tuple) and not only.turns and any(one.name for one in only.items):
            items = only.items
    yield from _listed(items, call.name)


def _listed(items: tuple[nodes.Item, ...], task: Name) -> Iterator[Mention]:
    for item in items:
        if item.name is not None:
            yield Mention(item.name, Part.ARGUMENT, task.text)
        yield from _read(item.value)


def _read(node: Node | None) -> Iterator[Mention]:
    """Yield the names that an expression reads."""
    match node:
        case Name():
            yield Mention(node, Part.READ)
        case (
            nodes.Unary(operand=inner)
            | nodes.State(operand=inner)
            | nodes.Member(operand=inner)
            | nodes.Free(operand=inner)
        ):
            yield from _read(inner)
        case nodes.Index():
            yield from _read(node.operand)
            yield from _read(node.index)
        case nodes.Binary():
            yield from _read(node.left)
            yield from _read(node.right)
        case nodes.Rebase():
            yield from _read(node.operand)
            yield Mention(node.frame, Part.FRAME)
        case nodes.External():
            for inner in (node.operand, *node.values):
                yield from _read(inner)
        case nodes.Function():
            if node.name.text.lower() not in NAMES:
                yield Mention(node.name, Part.CALLED)
            yield from _listed(node.arguments, node.name)
        case nodes.Joints(values=values):
            for inner in values:
                yield from _read(inner)
        case nodes.Tuple():
            yield from _tuple(node)


def _tuple(node: nodes.Tuple) -> Iterator[Mention]:
    for item in node.items:
        yield from _read(item.value)
    for turn in node.turns:
        for inner in (*turn.values, turn.like):
            yield from _read(inner)
    for inner in node.posture.turns if node.posture is not None else ():
        yield from _read(inner)


_READERS: dict[type, Callable[[Any], Iterator[Mention]]] = {
    syntax.TaskHeader: _header,
    syntax.Call: _call,
    syntax.Assign: _assign,
    syntax.For: _loop,
    syntax.ForEach: _loop,
    syntax.Load: _load,
    syntax.Motion: _motion,
    syntax.Gripper: _gripper,
    syntax.SetSignal: _set_signal,
    syntax.SetMode: lambda statement: _setting(statement.setting),
    syntax.With: _with,
    syntax.If: _if,
    syntax.WaitCondition: _wait,
}
_EXPRESSIONS: dict[type, tuple[str, ...]] = {
    syntax.FrameDeclaration: ("value",),
    syntax.ToolDeclaration: ("value",),
    syntax.LocationDeclaration: ("value",),
    syntax.SignalDeclaration: ("channel",),
    syntax.ConstantDeclaration: ("value",),
    syntax.VariableDeclaration: ("value",),
    syntax.PatternDeclaration: ("counts", "origin", "steps"),
    syntax.Until: ("condition",),
    syntax.ElseIf: ("condition",),
    syntax.While: ("condition",),
    syntax.Repeat: ("count",),
    syntax.Return: ("value",),
    syntax.Stop: ("message",),
    syntax.WaitTime: ("duration",),
    syntax.Print: ("values",),
}
"""Parts of a statement that are expressions, where it mentions no other names."""
