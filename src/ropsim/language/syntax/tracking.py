"""What corrects the path of a motion: `track signal = value [along [-]x|y|z] [gain k]`."""

from ropsim.language.syntax.cursor import Cursor
from ropsim.language.syntax.expressions import total
from ropsim.language.syntax.nodes import Node
from ropsim.language.syntax.statements import Tracking
from ropsim.language.syntax.words import ALONG, GAIN

_AXES = ("x", "y", "z")


def tracking(cursor: Cursor) -> Tracking:
    """Read the clause; `along` and `gain` stand behind the value, each once, in any order."""
    start = cursor.advance().start
    signal = cursor.name("the name of a signal")
    if not (cursor.accept("=") or cursor.accept(":=")):
        cursor.fail("`=`", "a sensor is given the value that it is to have: `track gap = 12 mm`")
    value = total(cursor)
    direction, gain = "", None
    while cursor.word in (ALONG, GAIN):
        if (cursor.word == ALONG and direction) or (cursor.word == GAIN and gain is not None):
            cursor.fail("another modifier", f"`{cursor.word}` stands once behind `track`")
        direction, gain = _option(cursor, direction, gain)
    return Tracking(signal, value, direction, gain, start, cursor.end)


def _option(cursor: Cursor, direction: str, gain: Node | None) -> tuple[str, Node | None]:
    if cursor.advance().word == GAIN:
        return direction, total(cursor)
    sign = "-" if cursor.accept("-") else ""
    if cursor.word not in _AXES:
        cursor.fail("`x`, `y` or `z`", "the correction goes along an axis of the tool: `along z`, `along -x`")
    return sign + cursor.advance().word, gain
