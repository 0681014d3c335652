"""Aligned columns of text for a terminal."""

from collections.abc import Sequence
from dataclasses import dataclass

from ropsim.views.characters import width
from ropsim.views.style import Style, Tone, paint


@dataclass(frozen=True, slots=True)
class Cell:
    """A text in a column, with a tone where it needs attention."""

    text: str
    tone: Tone | None = None


def columns_text(header: tuple[str, ...], rows: Sequence[tuple[Cell, ...]], style: Style) -> list[str]:
    """Return a table: the first column aligned left, all others right, two spaces between them."""
    widths = [max([width(title), *(width(row[k].text) for row in rows)]) for k, title in enumerate(header)]
    titles = tuple(Cell(title, Tone.QUIET) for title in header)
    return [_line(row, widths, style) for row in (titles, *rows)]


def _line(row: tuple[Cell, ...], widths: list[int], style: Style) -> str:
    parts = []
    for k, (cell, size) in enumerate(zip(row, widths, strict=True)):
        space = " " * (size - width(cell.text))
        text = paint(cell.text, cell.tone, style) if cell.tone else cell.text
        parts.append(text + space if k == 0 else space + text)
    return "  " + "  ".join(parts).rstrip()
