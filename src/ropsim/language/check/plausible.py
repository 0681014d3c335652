"""Bare numbers that seem to be meant in another unit."""

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


def check_wait(body: Body, value: Value, duration: Expression, place: nodes.Node) -> None:
    """Warn of a long wait without unit (T338)."""
    number, written = fold.number_of(duration), fold.number_of(value.expression)
    if value.is_bare and number is not None and written is not None and number >= LONGEST_WAIT:
        message = f"`wait {written:g}` without a unit takes {number:g} s"
        body.warn(kinds.OTHER_UNIT, place, message, f"write `wait {written:g} ms`, or `wait {written:g} s`")


def check_rate(
    body: Body, word: str, value: Value, rate: Expression, dimension: units.Dimension, place: nodes.Node
) -> None:
    """Warn of a speed or acceleration without unit that no arm makes (T338)."""
    number, written = fold.number_of(rate), fold.number_of(value.expression)
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
