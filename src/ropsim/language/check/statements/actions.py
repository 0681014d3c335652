"""Statements that act: grippers, outputs, waits, messages."""

from collections.abc import Iterable
from dataclasses import replace

from ropsim.core import Kind, did_you_mean, there_are
from ropsim.flow import GripAction
from ropsim.language.check.doubts import numerals, plausible
from ropsim.language.check.expressions import convert, frames, shown, values
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body, RejectedError
from ropsim.language.check.scope.types import BOOL, NUMBER, STR, TIME, Type, article, known
from ropsim.language.check.scope.world import Poison
from ropsim.language.check.statements import settings
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import syntax as syntax_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import statements as syntax
from ropsim.language.syntax.nodes import Literal, Name, Node, Number
from ropsim.language.syntax.other_languages import LEVELS
from ropsim.language.syntax.readers.setting import QUANTITIES, UNLIKE
from ropsim.program import (
    Block,
    Grip,
    Message,
    Output,
    Set,
    SignalUse,
    Stop,
    ValueType,
    Wait,
    WaitUntil,
    signals_of,
)


def _refuse_signal(body: Body, node: Node) -> None:
    """Report the name of a signal, or of nothing, where a time is to be waited for.

    Raises:
        RejectedError: it is one.
    """
    if not isinstance(node, Name) or body.is_tolerant:
        return
    symbol, condition = body.find(node.text), node.text
    if isinstance(symbol, SignalUse) and symbol.type is not ValueType.BOOL:
        condition += " > 0"
    hint = f"signals are read by name: write `wait until {condition}`"
    if isinstance(symbol, SignalUse):
        message = f"the time of `wait` must be a time, found the signal `{node.text}`"
        body.fail(kinds.WRONG_TYPE, node, message, hint, f"until {condition}")
    if symbol is None and not did_you_mean(node.text, values.visible(body)):
        hint += f", and declare it in the cell file: `[signals.{node.text}]`"
        message = f"there is no name `{node.text}`"
        body.fail(name_kinds.UNKNOWN_NAME, node, message, hint, f"until {condition}")


def _refuse_undeclared(body: Body, kind: Kind, name: Name, what: str, candidates: Iterable[str]) -> None:
    """Report a signal that is undeclared and not similar to a known name.

    Raises:
        RejectedError: it is near to none.
    """
    if not did_you_mean(name.text, candidates):
        listed = there_are(sorted(candidates)[:8]) if what == "output" else ""
        hint = f"declare it in the cell file: `[signals.{name.text}]`" + (f"; {listed}" if listed else "")
        body.fail(kind, name, f"there is no {what} `{name.text}`", hint)


def gripper(body: Body, node: syntax.Gripper) -> Block:
    """Return an opening or closing."""
    tool = body.tool(node.tool) if node.tool else ""
    return (Grip(GripAction(node.word), tool, body.statement_span),)


def set_signal(body: Body, node: syntax.SetSignal) -> Block:
    """Return the setting of an output."""
    return (output(body, node),)


def output(body: Body, node: syntax.SetSignal) -> Output:
    """Return the output and its new value.

    Raises:
        RejectedError: it is none, or the value does not fit.
    """
    symbol = body.find(node.name.text)
    if isinstance(symbol, Poison):
        raise RejectedError
    if not isinstance(symbol, SignalUse):
        outputs = [n for n, s in body.world.symbols.items() if isinstance(s, SignalUse) and not s.is_input]
        if symbol is None and node.name.text in QUANTITIES:
            place = replace(node.name, end=node.value.start)
            message, hint = f"there is no output `{node.name.text}`", "a setting stands without `=`"
            body.fail(name_kinds.UNKNOWN_SIGNAL, place, message, hint, fix=f"{node.name.text} ")
        if symbol is not None:
            hint = "to assign a variable leave out `set`"
            body.fail(name_kinds.UNKNOWN_SIGNAL, node.name, f"`{node.name.text}` is no output", hint)
        _refuse_undeclared(body, name_kinds.UNKNOWN_SIGNAL, node.name, "output", outputs)
        body.unknown(name_kinds.UNKNOWN_SIGNAL, node.name, "output", outputs)
    if symbol.is_input:
        teller = body.world.environment.told.get(symbol.name, "")
        body.fail(
            name_kinds.NOT_ASSIGNABLE,
            node.name,
            f"`{node.name.text}` is an input",
            f"the device `{teller}` sets it" if teller else "inputs are set by the cell",
        )
    body.used_signals[symbol.name] = symbol
    wanted = BOOL if symbol.type is ValueType.BOOL else NUMBER
    _refuse_level(body, node, wanted)
    if wanted == BOOL:
        _refuse_number(body, node)
    value = values.expect(body, node.value, wanted, f"the value of `{node.name.text}`")
    return Output(symbol.name, value, body.statement_span)


def _refuse_level(body: Body, node: syntax.SetSignal, wanted: Type) -> None:
    """Report a level of another language, or any level of an analog output.

    Raises:
        RejectedError: it is one.
    """
    value = node.value
    if not isinstance(value, Literal) or (wanted == BOOL and value.word not in UNLIKE.values()):
        return
    if wanted == BOOL:
        level = LEVELS[value.word]
        message = f"expected `on`, `off` or `=`, found `{body.written(value)}`"
        body.fail(syntax_kinds.UNEXPECTED, value, message, f"write `{level}`", fix=level)
    if value.word in (*LEVELS, *UNLIKE):
        message = f"the value of `{node.name.text}` must be a number, found a level"
        hint = f"an analog output is given a number: `set {node.name.text} = 1`"
        body.fail(kinds.WRONG_TYPE, value, message, hint)


def _refuse_number(body: Body, node: syntax.SetSignal) -> None:
    """Report a digital output that is set to 1 or 0.

    Raises:
        RejectedError: it is.
    """
    value = node.value
    if isinstance(value, Number) and not value.unit and value.value in (0.0, 1.0):
        level = "on" if value.value else "off"
        message = f"the value of `{node.name.text}` must be a truth value, found a number"
        body.fail(kinds.WRONG_TYPE, value, message, f"write `{level}`", fix=level)


def set_mode(body: Body, node: syntax.SetMode) -> Block:
    """Return a modal setting; `set frame` acts on the literals that follow and leaves nothing to run."""
    if node.setting.word == "frame":
        assert node.setting.name is not None
        frames.set_frame(body, node.setting.name)
        return ()
    return (Set(settings.gather(body, (node.setting,)), body.statement_span),)


def wait(body: Body, node: syntax.WaitTime) -> Block:
    """Return a wait for a time."""
    _refuse_signal(body, node.duration)
    value = values.check(body, node.duration)
    duration = convert.to(body, value, TIME, node.duration, "the time of `wait`")
    plausible.check_time(body, "wait", value, duration, node.duration)
    number = fold.number_of(duration)
    if number is not None and number < 0.0:
        found = numerals.quoted(body, node.duration, number, "s")
        body.fail(
            kinds.OUT_OF_RANGE, node.duration, f"the time of `wait` must not be negative, found {found}"
        )
    return (Wait(duration, body.statement_span),)


def wait_until(body: Body, node: syntax.WaitCondition, otherwise: Block) -> Block:
    """Return a wait for a condition."""
    if isinstance(node.condition, Name) and body.find(node.condition.text) is None and not body.is_tolerant:
        _refuse_undeclared(body, name_kinds.UNKNOWN_NAME, node.condition, "signal", values.visible(body))
    condition = values.expect(body, node.condition, BOOL, "the condition of `wait until`")
    if not any(signals_of(condition)):
        message = "nothing in this condition changes while the program waits"
        body.warn(kinds.NOTHING_CHANGES, node.condition, message, "let it read a signal, or write `if`")
    timeout = None
    if node.timeout is not None:
        value = values.check(body, node.timeout)
        timeout = convert.to(body, value, TIME, node.timeout, "the time of `timeout`")
        plausible.check_time(body, "timeout", value, timeout, node.timeout)
        number = fold.number_of(timeout)
        if number is not None and number < 0.0:
            found = numerals.quoted(body, node.timeout, number, "s")
            message = f"the time of `timeout` must not be negative, found {found}"
            body.fail(kinds.OUT_OF_RANGE, node.timeout, message)
    return (WaitUntil(condition, timeout, otherwise, body.statement_span),)


def message(body: Body, node: syntax.Print) -> Block:
    """Return a message; quantities are shown in the units of the text, with their names."""
    parts = [part for one in node.values for part in shown.parts(body, values.check(body, one))]
    return (Message(tuple(parts), body.statement_span),)


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
