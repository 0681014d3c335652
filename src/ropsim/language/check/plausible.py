"""Numbers that seem to be meant in another unit."""

from collections.abc import Sequence
from math import degrees, pi

from ropsim.language.check import fold, units
from ropsim.language.check.body import Body
from ropsim.language.check.types import Value
from ropsim.language.findings import types as kinds
from ropsim.language.syntax import nodes
from ropsim.program import Expression

LONGEST_WAIT = 100.0
"""From this on a wait without unit is taken for one in milliseconds [s]."""
SLOWEST = 0.001
"""Below this a bare speed or acceleration is taken for one in metres, or for a share [m/s, m/s²]."""
FASTEST = 50.0
"""Above this a bare speed or acceleration is taken for one in millimetres [m/s, m/s²]."""


_DIGITS = 0.005
"""Difference at which two decimals of a right angle in radians are recognised."""


def check_wait(body: Body, value: Value, duration: Expression, place: nodes.Node) -> None:
    """Warn of a long wait without unit (T338)."""
    number, written = fold.number_of(duration), fold.number_of(value.expression)
    if value.is_bare and number is not None and written is not None and number >= LONGEST_WAIT:
        message = f"`wait {written:g}` without a unit takes {number:g} s"
        body.warn(kinds.OTHER_UNIT, place, message, f"write `wait {written:g} ms`, or `wait {written:g} s`")


def check_rate(
    body: Body, word: str, value: Value, rate: Expression, dimension: units.Dimension, place: nodes.Node
) -> None:
    """Warn of a speed or acceleration without unit, or a speed with one, that no arm makes (T338)."""
    number, written = fold.number_of(rate), fold.number_of(value.expression)
    if not value.is_bare and dimension == units.SPEED and number is not None and number > FASTEST:
        message = f"`{word}` is {number:g} m/s, no arm is faster than {FASTEST:g} m/s"
        hint = f"write `{word} {number:g} mm/s`, or the speed of a robot"
        body.warn(kinds.OTHER_UNIT, place, message, hint)
        return
    if not value.is_bare or number is None or written is None or SLOWEST <= number <= FASTEST:
        return
    unit, bare = units.SI.name(dimension), body.world.units.name(dimension)
    message = f"`{word} {written:g}` without a unit is " + (
        f"{written:g} {bare}" if bare else f"{number:g} {unit}"
    )
    body.warn(kinds.OTHER_UNIT, place, message, f"write the unit: {_meant(word, written, number, unit)}")


def _meant(word: str, written: float, number: float, unit: str) -> str:
    """Return what may have been meant by a speed or acceleration that is too small or too large."""
    if number > FASTEST:
        return f"`{word} {written:g} mm{unit[1:]}`"
    share = f", or for joints `{word} {written * 100:g} %`" if written <= 1.0 else ""
    return f"`{word} {written:g} {unit}`{share}"


def check_joints(body: Body, angles: Sequence[Value], place: nodes.Node) -> None:
    """Warn of joint angles in degrees of which one has the digits of a right angle in radians (T338)."""
    if body.world.units.angle == 1.0 or not all(value.is_bare for value in angles):
        return
    written = [fold.number_of(value.expression) for value in angles]
    sizes = [abs(number) for number in written if number is not None]
    if len(sizes) < len(angles) or max(sizes, default=0.0) > 2.0 * pi:
        return
    for size in sizes:
        for turn in (pi / 2.0, pi):
            if abs(size - turn) < _DIGITS:
                message = f"`joints(…)` has {size:g}°, the digits of {degrees(turn):g}° in radians"
                body.warn(kinds.OTHER_UNIT, place, message, "write degrees, or `rad` behind each number")
                return
