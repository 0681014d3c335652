"""Corrections of the path of a motion: an analog signal, its set value, and the direction."""

from ropsim.flow import STANDARD_GAIN, ToolDirection
from ropsim.language.check.expressions import values
from ropsim.language.check.expressions.readings import reading
from ropsim.language.check.scope import fold
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import NUMBER
from ropsim.language.findings import names as name_kinds
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax
from ropsim.program import Expression, SignalUse, Tracking, ValueType


def tracking(body: Body, node: syntax.Motion) -> Tracking | None:
    """Return the correction of the path of a motion.

    Raises:
        RejectedError: the motion has no path of its own, or signal, value or gain do not fit.
    """
    clause = node.tracking
    if clause is None:
        return None
    if node.word == "mov":
        message = "`mov` has no path of the tool that a sensor could correct"
        body.fail(kinds.WRONG_TYPE, clause, message, "write `lin`, `circ` or `spline`")
    if (node.via or node.along) and node.word == "lin":
        message = "`track` corrects one motion, points on the way make several"
        body.fail(kinds.WRONG_TYPE, clause, message, "write each part as a motion of its own, or a `spline`")
    direction = ToolDirection(clause.direction or ToolDirection.Z)
    signal = _signal(body, clause.signal)
    value = reading(body, signal.name, clause.value, "given a number to have")
    return Tracking(signal.name, value, _gain(body, clause.gain), direction)


def _signal(body: Body, node: nodes.Name) -> SignalUse:
    symbol = body.find(node.text)
    if isinstance(symbol, SignalUse) and symbol.type is ValueType.REAL:
        body.used_signals[symbol.name] = symbol
        return symbol
    if symbol is None:
        hint = f"declare it in the cell file: `[signals.{node.text}]`, with `analog = true`"
        body.fail(name_kinds.UNKNOWN_NAME, node, f"there is no signal `{node.text}`", hint)
    found = "a truth value" if isinstance(symbol, SignalUse) else "no signal"
    hint = "name a signal that the cell file gives as `analog`"
    body.fail(kinds.WRONG_TYPE, node, f"`track` needs an analog signal, `{node.text}` is {found}", hint)


def _gain(body: Body, node: nodes.Node | None) -> Expression:
    if node is None:
        return fold.real(STANDARD_GAIN)
    gain = values.expect(body, node, NUMBER, "the value of `gain`")
    number = fold.number_of(gain)
    if number is not None and number <= 0.0:
        message = f"`gain` must be greater than zero, found {number:g}"
        hint = "to correct the other way round write `along -z`"
        body.fail(kinds.OUT_OF_RANGE, node, message, hint)
    return gain
