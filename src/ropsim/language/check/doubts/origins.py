"""Where a plain number comes from: the unit of readings and of numbers without a unit is known.

A sensor measures in SI units, a number without a unit counts in units of the text: if the two are combined,
one of them is probably misread (T313). The origin of the value of a variable is tracked line by line; below a
block that assigns it, the origin before the block also remains possible.
"""

from collections.abc import Iterable
from dataclasses import replace
from functools import reduce

from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import Type, known
from ropsim.language.check.scope.world import OfParameter, Origin, Reading, Variable, World, Written
from ropsim.program import Binary, Call, Constant, Expression, SignalValue, Unary
from ropsim.program import Variable as VariableExpression

_SUMS = frozenset(("add", "sub", "min", "max", "mod"))
_KEEPING = frozenset(("neg", "abs", "to_real", "round", "trunc"))


def has_sensors(world: World) -> bool:
    """Return whether the cell has a sensor whose readings can be taken for numbers of the text."""
    return bool(world.environment.measured)


def origin_of(body: Body, expression: Expression) -> Origin | None:
    """Return where a plain number comes from, None if its parts have none."""
    match expression:
        case Constant(value=bool() | str()):
            return None
        case Constant(value=int() | float() as number):
            return Written(float(number))
        case VariableExpression(name=name):
            variable = _variable(body, name)
            return variable.origin if variable is not None else None
        case SignalValue(name=name):
            measure = body.world.environment.measured.get(name, "")
            return Reading(measure) if measure else None
        case Unary(op=op, operand=operand) if op in _KEEPING:
            return origin_of(body, operand)
        case Binary(op=op, left=left, right=right):
            return _combined(op, origin_of(body, left), origin_of(body, right))
    return None


def is_reading(body: Body, expression: Expression) -> bool:
    """Return whether a plain number counts in SI units, as it comes from a reading."""
    return has_sensors(body.world) and isinstance(origin_of(body, expression), Reading)


def _variable(body: Body, name: str) -> Variable | None:
    """Return the variable of the structured program behind a name."""
    symbol = body.find(name.partition(".")[0])
    return symbol if isinstance(symbol, Variable) and symbol.name == name else None


def _combined(op: str, left: Origin | None, right: Origin | None) -> Origin | None:
    """Return the origin of a sum, a product or a quotient; a factor without a unit changes nothing."""
    if op in _SUMS:
        if _is_zero(left) or _is_zero(right):
            return right if _is_zero(left) else left
        return _either(left, right)
    if op not in ("mul", "div"):
        return None
    if isinstance(right, Written):
        return Written() if isinstance(left, Written) else left
    return right if op == "mul" and isinstance(left, Written) else None


def _is_zero(origin: Origin | None) -> bool:
    return isinstance(origin, Written) and origin.number == 0.0


def _either(one: Origin | None, other: Origin | None) -> Origin | None:
    """Return the origin of a value with one of two origins, or both."""
    if one == other:
        return one
    for sort in (Written, OfParameter, Reading):
        if isinstance(one, sort) or isinstance(other, sort):
            return Written() if sort is Written else one if isinstance(one, sort) else other
    return None


def joined(origins: Iterable[Origin | None]) -> Origin | None:
    """Return the origin of a value with one of several origins."""
    first, *others = [*origins] or [None]
    return reduce(_either, others, first)


def note(body: Body, name: str, variable: Variable, expression: Expression) -> None:
    """Remember of a variable where the number comes from that it is assigned."""
    if not has_sensors(body.world) or body.report.muted or not is_number(variable):
        return
    keep(body, name, variable, origin_of(body, expression))


def keep(body: Body, name: str, variable: Variable, origin: Origin | None) -> None:
    """Remember the origin of the value of a variable; in a block it may be left out."""
    if not has_sensors(body.world) or body.report.muted or name not in body.names:
        return
    found = _either(variable.origin, origin) if body.depth > 1 else origin
    if found != variable.origin:
        body.names[name] = replace(variable, origin=found)


def is_number(variable: Variable) -> bool:
    """Return whether a variable keeps plain or whole numbers."""
    kind = known(variable.type)
    return isinstance(kind, Type) and kind.is_number and not any(kind.dimension)


def of_result(body: Body, call: Call, formals: tuple[str, ...]) -> Origin | None:
    """Return where the result of a call comes from."""
    found = body.world.origins.get(call.task)
    result = found.result if found is not None else None
    if isinstance(result, OfParameter):
        return origin_of(body, call.arguments[formals.index(result.name)])
    return result
