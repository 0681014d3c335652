"""A number that stands alone, in the type that its place needs: most values of a text are such."""

from math import isfinite

from ropsim.language.check import fold, units
from ropsim.language.check.body import Body
from ropsim.language.check.types import Type
from ropsim.language.syntax.nodes import Number
from ropsim.program import Constant, ValueType

_REAL, _INT = ValueType.REAL, ValueType.INT


def fitting(body: Body, node: Number, wanted: Type) -> Constant | None:
    """Return what `convert.to` makes of a number alone; None where there is something to say about it."""
    if wanted.value is _REAL:
        number = _fitting_real(body, node, wanted.dimension)
        return None if number is None else Constant(number, _REAL)
    is_bare = wanted.value is _INT and node.is_whole and not node.unit
    return fold.whole(int(node.value)) if is_bare else None


def _fitting_real(body: Body, node: Number, wanted: units.Dimension) -> float | None:
    if node.unit:
        dimension, factor = units.UNITS[node.unit]
        return node.value * factor if dimension == wanted else None
    if wanted == units.NUMBER:
        return node.value
    world = body.world
    if wanted == units.SHARE or (world.is_strict and node.value != 0.0):
        return None
    number = node.value * world.units.factor(wanted)
    return number if isfinite(number) else None
