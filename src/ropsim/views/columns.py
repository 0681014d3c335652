"""Aligned columns of text for a terminal."""

from collections.abc import Sequence
from itertools import zip_longest

from ropsim.core import frozen_dataclass
from ropsim.views.characters import width
from ropsim.views.style import Style, Tone, paint


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
