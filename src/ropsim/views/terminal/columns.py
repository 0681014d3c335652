"""Aligned columns of text for a terminal, and its text styles."""

from collections.abc import Sequence
from enum import Enum
from itertools import zip_longest

from ropsim.core import frozen_dataclass
from ropsim.views.words.characters import width


class Style(Enum):
    """Whether text carries ANSI colour codes."""

    PLAIN = "plain"
    COLOR = "color"


class Tone(Enum):
    """Meaning of a piece of text; the value is its ANSI SGR code."""

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


@frozen_dataclass
class TableCell:
    """A text in a column, with a tone where it needs attention."""

    text: str
    tone: Tone | None = None


def columns_text(header: tuple[str, ...], rows: Sequence[tuple[TableCell, ...]], style: Style) -> list[str]:
    """Return a table: the first column aligned left, all others right, two spaces between them.

    Args:
        header: titles of the columns, each of one line or more.
        rows: a cell for each column.
        style: whether cells have colours.
    """
    titles = [
        tuple(TableCell(text, Tone.QUIET) for text in line)
        for line in zip_longest(*(title.split("\n") for title in header), fillvalue="")
    ]
    lines = [*titles, *rows]
    widths = [max(width(line[k].text) for line in lines) for k in range(len(header))]
    return [_line(line, widths, style) for line in lines]


def _line(row: tuple[TableCell, ...], widths: list[int], style: Style) -> str:
    parts = []
    for k, (cell, size) in enumerate(zip(row, widths, strict=True)):
        space = " " * (size - width(cell.text))
        text = paint(cell.text, cell.tone, style) if cell.tone else cell.text
        parts.append(text + space if k == 0 else space + text)
    return "  " + "  ".join(parts).rstrip()
