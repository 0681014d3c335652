"""Comparisons of sensor readings: a bare number counts in SI units there, which is rarely meant."""

import math

from ropsim.language.check.doubts import origins
from ropsim.language.check.doubts.plausible import mended
from ropsim.language.check.expressions import convert, values
from ropsim.language.check.scope import fold, units
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import Type, Value, article, known
from ropsim.language.check.scope.world import Formal, OfParameter, Reading, Written
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.program import Expression, variables_of

_DIMENSIONS = {"length": units.LENGTH, "force": units.FORCE, "torque": units.TORQUE}


def reading(body: Body, signal: str, node: nodes.Node, purpose: str) -> Expression:
    """Return the number compared with an analog signal, in SI units; T313 if it is probably misread.

    Args:
        body: where it stands.
        signal: analog, of a sensor or not.
        node: the number.
        purpose: use of a signal, in words.

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
    """Warn of a value that is not compared with a signal as it looks (T313); 0 needs no unit.

    Args:
        body: where it stands.
        signal: analog, of a sensor or not.
        value: the other side of the comparison.
        place: of the value.
    """
    measure = body.world.environment.measured.get(signal, "")
    if not measure:
        return
    dimension, kind = _DIMENSIONS[measure], known(value.type)
    if not (isinstance(kind, Type) and kind.is_number):
        return
    if kind.dimension not in (units.NUMBER, dimension):
        found = units.dimension_name(kind.dimension)
        message = f"`{signal}` measures a {measure}, it is compared with a {found}"
        body.warn(kinds.READING, place, message, "check the units")
    elif kind.dimension == units.NUMBER:
        _check_number(body, f"`{signal}` measures a {measure}", measure, value.expression, place)


def check_compared(body: Body, one: Value, other: Value, place: nodes.Node) -> None:
    """Warn of a number that is compared with a value computed from readings (T313).

    Args:
        body: where it stands.
        one: worked out of readings, or anything else.
        other: the other side of the comparison.
        place: of the other one.
    """
    if not origins.has_sensors(body.world):
        return
    origin, kind = origins.origin_of(body, one.expression), known(other.type)
    if isinstance(origin, Reading) and isinstance(kind, Type) and kind.is_number:
        said = f"the other side is a {origin.measure} that a sensor measures"
        _check_number(body, said, origin.measure, other.expression, place)


def check_argument(body: Body, task: str, formal: Formal, value: Expression, place: nodes.Node) -> None:
    """Warn of an argument without a unit that the task compares with a reading (T313)."""
    kind = known(formal.type)
    if not origins.has_sensors(body.world) or not isinstance(kind, Type) or not kind.is_number:
        return
    found = body.world.origins.get(task)
    measure = found.readings.get(formal.name, "") if found is not None else ""
    if not measure or kind.dimension != units.NUMBER:
        return
    origin = origins.origin_of(body, value)
    if isinstance(origin, OfParameter):
        body.readings.setdefault(origin.name, measure)
    elif isinstance(origin, Written) and origin.number != 0.0:
        si = units.SI.name(_DIMENSIONS[measure])
        message = (
            f"task `{task}` compares `{formal.name}` with a {measure} that a sensor measures: "
            f"`{body.written(place)}` without a unit counts in {si} there"
        )
        hint = f"declare the parameter as `{formal.name}: {measure}`, and write the unit here"
        body.warn(kinds.READING, place, message, hint)


def _check_number(body: Body, said: str, measure: str, value: Expression, place: nodes.Node) -> None:
    """Warn of a plain number that was written without a unit, and remember of which variables it is made."""
    dimension = _DIMENSIONS[measure]
    factor, si, unit = (
        body.world.units.factor(dimension),
        units.SI.name(dimension),
        body.world.units.name(dimension),
    )
    if math.isclose(factor, 1.0):
        return
    origin = origins.origin_of(body, value)
    if isinstance(origin, OfParameter):
        body.readings.setdefault(origin.name, measure)
    if isinstance(origin, Written) and origin.number != 0.0:
        _warn(body, said, fold.number_of(value), origin, (si, unit or si), place)
        return
    names = {one for one in variables_of(value) if not body.report.muted}
    body.counted |= names
    both = sorted(name for name, other in body.quantities if name in names and other == unit)
    if both:
        convert.warn_of_two_counts(body, both[0], unit, si, place)


def _warn(
    body: Body,
    said: str,
    number: float | None,
    origin: Written,
    names: tuple[str, str],
    place: nodes.Node,
) -> None:
    si, unit = names
    if number is not None:
        message = f"{said}, and {number:g} without a unit counts as {number:g} {si} here"
        hint, fix = f"write `{number:g} {unit}`, or `{number:g} {si}`", mended(place, number, unit)
        body.warn(kinds.READING, place, message, hint, fix)
        return
    written = body.written(place)
    message = f"{said}, and `{written}` is a number without a unit, which counts in {si} here"
    value = f"{origin.number:g} " if origin.number is not None else "… "
    hint = f"give it a unit where it gets its value: `{value}{unit}`, or `{value}{si}`"
    body.warn(kinds.READING, place, message, hint)
