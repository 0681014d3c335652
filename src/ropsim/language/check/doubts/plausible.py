"""Times, speeds and accelerations that seem to be meant in another unit."""

from collections.abc import Callable

from ropsim.language.check.scope import fold, units
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import Value
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.program import Expression

LONGEST_WAIT = 100.0
"""From this on a wait without unit is taken for one in milliseconds [s]."""
SLOWEST = {units.SPEED: 0.005, units.ACCELERATION: 0.05}
"""Below this a bare speed or acceleration is taken for one in metres, or for a share [m/s, m/s²]."""
SLOWEST_IN_METRES = 0.001
"""The same where it is in metres anyhow [m/s, m/s²]."""
FASTEST = 50.0
"""Above this a bare speed or acceleration is taken for one in millimetres [m/s, m/s²]."""

Doubt = Callable[[Body, str, Value, Expression, units.Dimension, nodes.Node], None]
"""Warns of a speed or an acceleration that is hardly meant."""


def check_time(body: Body, word: str, value: Value, duration: Expression, place: nodes.Node) -> None:
    """Warn of a long time without unit behind `wait` or `timeout`, where `units` names none for times (T338).

    There is no fix: `wait 3600` and `timeout 300` may well be in seconds.
    """
    number, written = fold.number_of(duration), fold.number_of(value.expression)
    if not value.is_bare or number is None or written is None or body.world.units.names_time:
        return
    if number >= LONGEST_WAIT:
        takes = "takes" if word == "wait" else "is"
        message = f"`{word} {written:g}` without a unit {takes} {number:g} s"
        shown = _digits(body, place, written)
        body.warn(kinds.OTHER_UNIT, place, message, f"write `{word} {shown} ms`, or `{word} {shown} s`")


def check_rate(
    body: Body, word: str, value: Value, rate: Expression, dimension: units.Dimension, place: nodes.Node
) -> None:
    """Warn of a speed or acceleration for several motions that no arm makes (T338)."""
    written = fold.number_of(value.expression)
    shares = (f"for joints `{word} {written * 100:g} %`",) if written is not None and written <= 1.0 else ()
    _check(body, word, shares, value, rate, dimension, place)


def check_path_rate(
    body: Body, word: str, value: Value, rate: Expression, dimension: units.Dimension, place: nodes.Node
) -> None:
    """Warn of a rate for a path of the tool, which cannot be a share (T338)."""
    _check(body, word, (), value, rate, dimension, place)


def believe(*_: object) -> None:
    """Report nothing about a setting that the motion does not use; T309 reports it."""


def _check(
    body: Body,
    word: str,
    shares: tuple[str, ...],
    value: Value,
    rate: Expression,
    dimension: units.Dimension,
    place: nodes.Node,
) -> None:
    """Warn of a bare one that is too small or too large, and of a speed that is too large with its unit.

    Args:
        body: where it stands.
        word: of the setting.
        shares: other meanings of a number of at most 1.
        value: as written.
        rate: the same in SI units.
        dimension: speed or acceleration.
        place: of the value.
    """
    number, written = fold.number_of(rate), fold.number_of(value.expression)
    if not value.is_bare and dimension == units.SPEED and number is not None and number > FASTEST:
        message = f"`{word}` is {number:g} m/s, no arm is faster than {FASTEST:g} m/s"
        hint = f"write `{word} {number:g} mm/s`, or the speed of a robot"
        body.warn(kinds.OTHER_UNIT, place, message, hint, mended(place, number, "mm/s"))
        return
    if not value.is_bare or number is None or written is None:
        return
    slowest = SLOWEST_IN_METRES if body.world.units.factor(dimension) == 1.0 else SLOWEST[dimension]
    if slowest <= number <= FASTEST:
        return
    unit, bare = units.SI.name(dimension), body.world.units.name(dimension)
    shown, small = _digits(body, place, written), f"mm{unit[1:]}"
    meant = small if max(number, written) > FASTEST else unit
    readings, is_certain = [f"`{word} {shown} {meant}`"], bool(bare)
    if number <= FASTEST:
        as_written = f"{shown} {bare}" if bare else f"{number * 1000.0:g} {small}"
        readings = [*dict.fromkeys((*readings, f"`{word} {as_written}`")), *shares]
        is_certain = bare not in ("", unit) and _is_share_of_one(body, place, written)
    measured = f"{number:g} {unit}" if number > FASTEST else f"{number * 1000.0:g} {small}"
    message = f"`{word} {written:g}` without a unit is {f'{written:g} {bare}' if bare else measured}"
    hint = f"write the unit: {', or '.join(readings)}"
    body.warn(kinds.OTHER_UNIT, place, message, hint, mended(place, written, meant) if is_certain else None)


def _is_share_of_one(body: Body, place: nodes.Node, written: float) -> bool:
    """Return whether a number is below 1 and has a point, unusual for millimetres."""
    return written < 1.0 and "." in body.written(place)


def _digits(body: Body, place: nodes.Node, number: float) -> str:
    """Return a number as written, or the computed value."""
    return body.written(place) if isinstance(place, nodes.Number) else f"{number:g}"


def mended(place: nodes.Node, number: float, unit: str) -> str | None:
    """Return a number with a unit in place of one that is written out; None where another thing stands."""
    text = f"{number:g}"
    return f"{text} {unit}" if isinstance(place, nodes.Number) and float(text) == number else None
