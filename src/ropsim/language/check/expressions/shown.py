"""Output of `print` for a value: quantities in the units of the text, with their names."""

from functools import lru_cache

from ropsim.language.check.expressions import components
from ropsim.language.check.scope import fold, units
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import ANGLE, LENGTH, POSE, Type, Value, known
from ropsim.language.check.scope.units import Dimension, UnitSystem
from ropsim.program import Component, Constant, Expression, Keeping, Kept, MakeVector, ValueType

_REAL = ValueType.REAL


def parts(body: Body, value: Value) -> tuple[Expression, ...]:
    """Return the parts of a message for a value, each part with a blank before the next one.

    A location is shown as three lengths and the angles about the fixed axes, in the frame in force.
    Where external axes may belong to it, it is shown whole and in SI units.
    """
    kind = known(value.type)
    environment = body.world.environment
    if value.is_bare or not isinstance(kind, Type):
        return (value.expression,)
    if kind == POSE and not (environment.external or environment.moving):
        return _location(body, components.numbers_in_frame(body, value.expression))
    factor, unit = _unit(body.world.units, kind.dimension) if kind.value is _REAL else (1.0, "")
    if not unit:
        return (value.expression,)
    return _scaled(value.expression, factor), _text(unit)


def _location(body: Body, numbers: Expression) -> tuple[Expression, ...]:
    shown: list[Expression] = []
    for first, dimension in ((0, LENGTH.dimension), (3, ANGLE.dimension)):
        factor, unit = _unit(body.world.units, dimension)
        x, y, z = (_scaled(Component(Kept(ValueType.POSE), k), factor) for k in range(first, first + 3))
        shown += (Keeping(numbers, MakeVector(x, y, z), ValueType.VEC), _text(unit))
    return tuple(shown)


@lru_cache(maxsize=256)
def _unit(of_text: UnitSystem, dimension: Dimension) -> tuple[float, str]:
    """Return factor and name of the unit in which a text has a dimension; no name where there is none."""
    if dimension == units.SHARE:
        return 0.01, "%"
    if dimension == units.NUMBER:
        return 1.0, ""
    system = of_text if of_text.name(dimension) else units.SI
    name = system.name(dimension)
    return (system.factor(dimension), name) if name else of_text.composed(dimension)


def _scaled(number: Expression, factor: float) -> Expression:
    return fold.binary("div", number, fold.real(factor), _REAL)


def _text(unit: str) -> Constant:
    return Constant(unit, ValueType.STR)
