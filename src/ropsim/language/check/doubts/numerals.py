"""A number that stands alone, in the type that its place needs: most values of a text are such."""

from math import isfinite

from ropsim.language.check.scope import fold, units
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import Type
from ropsim.language.report import Placed
from ropsim.language.syntax.nodes import Node, Number, Unary
from ropsim.program import Constant, ValueType

_REAL, _INT = ValueType.REAL, ValueType.INT


def fitting(body: Body, node: Node, wanted: Type) -> Constant | None:
    """Return the result of `convert.to` for a single number; None if a conversion or a finding is needed."""
    if wanted.value is _REAL:
        number = fitting_real(body, node, wanted.dimension)
        return None if number is None else fold.constant(number, _REAL)
    if wanted.value is _INT and isinstance(node, Number) and node.is_whole and not node.unit:
        return fold.whole(int(node.value))
    return None


def fitting_real(body: Body, node: Node, wanted: units.Dimension) -> float | None:
    """Return the same number of a REAL, in SI units; it may have a minus."""
    if isinstance(node, Number):
        return _in_units(body, node, wanted)
    if not isinstance(node, Unary) or not isinstance(node.operand, Number) or node.op != "neg":
        return None
    number = _in_units(body, node.operand, wanted)
    return -number if number else None  # whether 0 has a sign depends on its type


def bare(node: Node) -> float | None:
    """Return a number that stands alone without a unit, as written; it may have a minus."""
    if isinstance(node, Number):
        return node.value if not node.unit else None
    if isinstance(node, Unary) and isinstance(node.operand, Number) and node.op == "neg":
        return -node.operand.value if not node.operand.unit else None
    return None


def quoted(body: Body, place: Placed, number: float, unit: str) -> str:
    """Return a value as messages quote it: as written, with the number in a unit if that says more."""
    written, measured = body.written(place), f"{number:g} {unit}"
    return f"`{written}`" if written == measured else f"`{written}` ({measured})"


def is_alone(node: Node) -> bool:
    """Return whether a number stands alone, with a unit or without; it may have a minus."""
    return isinstance(node.operand if isinstance(node, Unary) and node.op == "neg" else node, Number)


def _in_units(body: Body, node: Number, wanted: units.Dimension) -> float | None:
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
