"""Text styles of a terminal."""

from enum import Enum


class Style(Enum):
    """Whether text carries ANSI colour codes."""

    PLAIN = "plain"
    COLOR = "color"


class Tone(Enum):
    """What a piece of text means; the value is its ANSI SGR code."""

    ERROR = "1;31"
    WARNING = "1;33"
    HINT = "1;36"
    GOOD = "1;32"
    STRONG = "1"
    QUIET = "2"
    GUTTER = "1;34"


def paint(text: str, tone: Tone, style: Style) -> str:
    """Return the text in a tone; unchanged in the plain style."""
    return f"\x1b[{tone.value}m{text}\x1b[0m" if style is Style.COLOR and text else text
