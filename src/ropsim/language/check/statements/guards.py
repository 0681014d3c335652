"""The condition that ends a motion: one signal, and a value that is computed when the motion begins."""

from typing import NoReturn

from ropsim.flow import Comparison
from ropsim.language.check.doubts import numerals, plausible
from ropsim.language.check.expressions import arithmetic, convert, values
from ropsim.language.check.expressions.readings import reading
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import BOOL, TIME
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.program import Expression, Guard, SignalUse, ValueType

_ORDER = {"<": Comparison.BELOW, ">": Comparison.ABOVE}
_SWAPPED = {Comparison.BELOW: Comparison.ABOVE, Comparison.ABOVE: Comparison.BELOW}


def guard(body: Body, node: syntax.Motion) -> Guard | None:
    """Return the condition that ends a motion before its target.

    Raises:
        RejectedError: the condition is not on one signal, or the timeout does not fit.
    """
    if node.condition is None:
        if node.timeout is not None:
            hint = "write `until condition timeout t`"
            body.fail(kinds.WRONG_TYPE, node.timeout, "a motion has a `timeout` with `until` only", hint)
        return None
    if (node.via or node.along) and node.word in {"mov", "lin"}:
        message = "`until` ends one motion, points on the way make several"
        hint = "write the part that it is to end as a motion of its own"
        body.fail(kinds.WRONG_TYPE, node.condition, message, hint)
    signal, comparison, value = _condition(body, node.condition)
    return Guard(signal, comparison, value, _timeout(body, node))


def _condition(body: Body, node: nodes.Node) -> tuple[str, Comparison, Expression]:
    match node:
        case nodes.Name():
            return _level(body, node, fold.TRUE)
        case nodes.State(operand=operand):
            return _level(body, operand, fold.boolean((node.word in ("on", "true")) != node.negated))
        case nodes.Unary(op="not", operand=operand):
            signal, comparison, value = _condition(body, operand)
            if comparison is Comparison.IS:
                return signal, comparison, fold.unary("not", value, ValueType.BOOL)
        case nodes.Binary(op="=" | "==" | "<>", left=left, right=right):
            side, other = (right, left) if _signal(body, left) is None else (left, right)
            _level(body, side, fold.TRUE)
            arithmetic.refuse_level(body, node)
            value = values.expect(body, other, BOOL, f"what `{node.op}` compares a signal with")
            return _level(body, side, value if node.op != "<>" else fold.unary("not", value, ValueType.BOOL))
        case nodes.Binary(op="<" | ">", left=left, right=right):
            order, used, other = _ORDER[node.op], _signal(body, left), right
            if used is None:
                order, used, other = _SWAPPED[order], _signal(body, right), left
            if used is not None:
                signal = _number(body, node, used)
                return signal, order, reading(body, signal, other, "compared with a number")
        case nodes.Binary(op="<=" | ">="):
            hint = f"write `{node.op[0]}`: the motion ends when the signal goes past the value"
            body.fail(kinds.WRONG_TYPE, node, f"`until` of a motion does not compare by `{node.op}`", hint)
    values.check(body, node)  # reports an unknown name
    _refuse(body, node)


def _level(body: Body, node: nodes.Node, value: Expression) -> tuple[str, Comparison, Expression]:
    signal = _signal(body, node)
    if signal is None:
        values.check(body, node)  # reports an unknown name
        _refuse(body, node)
    if signal.type is not ValueType.BOOL:
        message, hint = f"the signal `{signal.name}` is analog", f"compare it: `until {signal.name} > 2.5`"
        body.fail(kinds.WRONG_TYPE, node, message, hint)
    return signal.name, Comparison.IS, value


def _number(body: Body, node: nodes.Node, signal: SignalUse) -> str:
    """Return the name of an analog signal."""
    if signal.type is ValueType.BOOL:
        message, hint = f"the signal `{signal.name}` is a truth value", f"write `until {signal.name} is on`"
        body.fail(kinds.WRONG_TYPE, node, message, hint)
    return signal.name


def _signal(body: Body, node: nodes.Node) -> SignalUse | None:
    """Return the signal that a node names, and note its use."""
    symbol = body.find(node.text) if isinstance(node, nodes.Name) else None
    if isinstance(symbol, SignalUse):
        body.used_signals[symbol.name] = symbol
        return symbol
    return None


def _refuse(body: Body, node: nodes.Node) -> NoReturn:
    message = "`until` of a motion looks at one signal"
    hint = "write `until SIGNAL`, `until SIGNAL is off` or `until SIGNAL > value`; a wait takes any condition"
    body.fail(kinds.WRONG_TYPE, node, message, hint)


def _timeout(body: Body, node: syntax.Motion) -> Expression | None:
    if node.timeout is None:
        return None
    value = values.check(body, node.timeout)
    timeout = convert.to(body, value, TIME, node.timeout, "the time of `timeout`")
    plausible.check_time(body, "timeout", value, timeout, node.timeout)
    number = fold.number_of(timeout)
    if number is not None and number <= 0.0:
        found = numerals.quoted(body, node.timeout, number, "s")
        message = f"the `timeout` of a motion must be greater than zero, found {found}"
        body.fail(kinds.OUT_OF_RANGE, node.timeout, message)
    return timeout
