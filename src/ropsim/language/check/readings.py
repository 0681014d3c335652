"""What readings of sensors are compared with: a bare number counts in SI units there, which few mean."""

import math

from ropsim.language.check import convert, fold, units, values
from ropsim.language.check.body import Body
from ropsim.language.check.plausible import mended
from ropsim.language.check.types import Type, Value, article, known
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.program import Expression

_DIMENSIONS = {"length": units.LENGTH, "force": units.FORCE}


def reading(body: Body, signal: str, node: nodes.Node, purpose: str) -> Expression:
    """Return the number beside an analog signal, in SI units; T313 where it is not what it looks like.

    Args:
        body: where it stands.
        signal: analog, of a sensor or not.
        node: the number.
        purpose: what a signal has with it, in words.

    Raises:
        RejectedError: it is no number.
    """
    value = values.check(body, node)
    kind = known(value.type)
    if isinstance(kind, Type) and not kind.is_number:
        body.fail(kinds.WRONG_TYPE, node, f"a signal is {purpose}, found {article(kind)}")
    check_reading(body, signal, value, node)
    return convert.real(value)


def check_reading(body: Body, signal: str, value: Value, place: nodes.Node) -> None:
    """Warn of a value that is not compared with a signal as it looks (T313).

    A variable may have been worked out in SI units, so only constants are looked at; 0 needs no unit.

    Args:
        body: where it stands.
        signal: analog, of a sensor or not.
        value: what the signal is compared with.
        place: of the value.
    """
    measure = body.world.environment.measured.get(signal, "")
    dimension, kind = _DIMENSIONS.get(measure), known(value.type)
    if dimension is None or not (isinstance(kind, Type) and kind.is_number):
        return
    if kind.dimension not in (units.NUMBER, dimension):
        found = units.dimension_name(kind.dimension)
        message = f"`{signal}` measures a {measure}, it is compared with a {found}"
        body.warn(kinds.READING, place, message, "check the units")
        return
    number, factor = fold.number_of(value.expression), body.world.units.factor(dimension)
    if kind.dimension == dimension or not number or math.isclose(factor, 1.0):
        return
    si, unit = units.SI.name(dimension), body.world.units.name(dimension)
    message = f"`{signal}` measures a {measure}, and {number:g} without a unit counts as {number:g} {si} here"
    hint = f"write `{number:g} {unit or si}`, or `{number:g} {si}`"
    body.warn(kinds.READING, place, message, hint, mended(place, number, unit or si))
