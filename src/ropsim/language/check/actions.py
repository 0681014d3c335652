"""Statements that act: motions, grippers, outputs, waits, messages."""

from ropsim.flow import GripAction, MotionKind
from ropsim.language.check import convert, fold, settings, values
from ropsim.language.check.body import Body
from ropsim.language.check.types import BOOL, JOINTS, NUMBER, POSE, STR, TIME, Type, article, known
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import statements as syntax
from ropsim.program import (
    Block,
    Grip,
    Message,
    Move,
    Output,
    Set,
    SignalUse,
    Stop,
    ValueType,
    Wait,
    WaitUntil,
)


def motion(body: Body, node: syntax.Motion) -> Block:
    """Return a move."""
    word = "lin" if node.is_linear else "mov"
    value = values.check(body, node.target)
    kind = known(value.type)
    wanted = JOINTS if kind == JOINTS and not node.is_linear else POSE
    target = convert.to(body, value, wanted, node.target, f"the target of `{word}`")
    chosen = settings.gather(body, node.modifiers)
    settings.check_effect(body, node, chosen)
    return (Move(MotionKind.LIN if node.is_linear else MotionKind.PTP, target, chosen, body.statement_span),)


def gripper(body: Body, node: syntax.Gripper) -> Block:
    """Return an opening or closing."""
    tool = body.tool(node.tool) if node.tool else ""
    return (Grip(GripAction(node.word), tool, body.statement_span),)


def set_signal(body: Body, node: syntax.SetSignal) -> Block:
    """Return the setting of an output."""
    symbol = body.find(node.name.text)
    if not isinstance(symbol, SignalUse):
        outputs = [n for n, s in body.world.symbols.items() if isinstance(s, SignalUse) and not s.is_input]
        if symbol is not None:
            hint = "to assign a variable leave out `set`"
            body.fail(name_kinds.UNKNOWN_SIGNAL, node.name, f"`{node.name.text}` is no output", hint)
        body.unknown(name_kinds.UNKNOWN_SIGNAL, node.name, "output", outputs)
    if symbol.is_input:
        body.fail(
            name_kinds.NOT_ASSIGNABLE,
            node.name,
            f"`{node.name.text}` is an input",
            "inputs are set by the cell",
        )
    body.world.used_signals[symbol.name] = symbol
    wanted = BOOL if symbol.type is ValueType.BOOL else NUMBER
    value = values.expect(body, node.value, wanted, f"the value of `{node.name.text}`")
    return (Output(symbol.name, value, body.statement_span),)


def set_mode(body: Body, node: syntax.SetMode) -> Block:
    """Return a modal setting; `set frame` acts on the literals that follow and leaves nothing to run."""
    if node.setting.word == "frame":
        assert node.setting.name is not None
        body.X_KC, body.moving = body.frame(node.setting.name)
        return ()
    return (Set(settings.gather(body, (node.setting,)), body.statement_span),)


def wait(body: Body, node: syntax.WaitTime) -> Block:
    """Return a wait for a time."""
    duration = values.expect(body, node.duration, TIME, "the time of `wait`")
    number = fold.number_of(duration)
    if number is not None and number < 0.0:
        body.fail(
            kinds.OUT_OF_RANGE, node.duration, f"the time of `wait` must not be negative, found {number:g} s"
        )
    return (Wait(duration, body.statement_span),)


def wait_until(body: Body, node: syntax.WaitCondition, otherwise: Block) -> Block:
    """Return a wait for a condition."""
    condition = values.expect(body, node.condition, BOOL, "the condition of `wait until`")
    timeout = None
    if node.timeout is not None:
        timeout = values.expect(body, node.timeout, TIME, "the time of `timeout`")
        number = fold.number_of(timeout)
        if number is not None and number < 0.0:
            body.fail(
                kinds.OUT_OF_RANGE,
                node.timeout,
                f"the time of `timeout` must not be negative, found {number:g} s",
            )
    return (WaitUntil(condition, timeout, otherwise, body.statement_span),)


def message(body: Body, node: syntax.Print) -> Block:
    """Return a message."""
    return (Message(tuple(values.check(body, v).expression for v in node.values), body.statement_span),)


def stop(body: Body, node: syntax.Stop) -> Block:
    """Return the end of the program."""
    text = ""
    if node.message is not None:
        value = values.check(body, node.message)
        kind = known(value.type)
        if isinstance(kind, Type) and kind == STR:
            text = str(convert.constant(body, value.expression, node.message, "the text of `stop`").value)
        else:
            body.fail(
                kinds.WRONG_TYPE,
                node.message,
                f"`stop` takes a text, found {article(kind)}",
                'write it in quotes: `stop "no parts"`',
            )
    return (Stop(text, body.statement_span),)
