"""Cells of a line of a table: separators, quotes, numbers with a point or a comma."""

from collections.abc import Sequence
from math import isfinite

from ropsim.core import SourceText, Span, frozen_dataclass

SEPARATORS = (";", "\t", ",")
"""Signs between cells; the first of these that stands in the titles separates the cells of the list."""
LONGEST = 10_000
"""Characters of a line, above which it is none of a list of points."""
_SHOWN = 40
_NUMBER = "write a number such as `12.5`"


class CellError(Exception):
    """A cell that is wrong: its place among the cells of the line, what is found, and what to do."""

    def __init__(self, index: int, message: str, hint: str = "") -> None:
        super().__init__(message)
        self.index = index
        self.message = message
        self.hint = hint


@frozen_dataclass
class Separator:
    """The sign between cells, and whether numbers may have a comma, which separates nothing then."""

    sign: str

    @property
    def has_decimal_commas(self) -> bool:
        """Return whether a comma in a number is its decimal point."""
        return self.sign != ","


def separator_of(titles: str) -> Separator:
    """Return the separator of a list by its line of titles."""
    return Separator(next((sign for sign in SEPARATORS if sign in titles), ","))


def cells_of(line: str, separator: Separator) -> list[str]:
    """Return the cells of a line without blanks and quotes around them.

    A quote inside of quotes is written twice, as in RFC 4180; a line ends where it ends, also in quotes.

    Raises:
        CellError: a quote is not closed.
    """
    if '"' not in line:
        return [cell.strip() for cell in line.split(separator.sign)]
    return [text for text, _, _ in _quoted_cells(line, separator)]


def place_of(text: SourceText, number: int, index: int, separator: Separator) -> Span:
    """Return the place of a cell of a line; that of the whole line where it has no such cell."""
    line = text.line(number)
    try:
        spans = [(start, end) for _, start, end in _quoted_cells(line, separator)]
    except CellError:
        spans = []
    if not 0 <= index < len(spans):
        return text.span(number, 1, max(len(line), 1))
    start, end = spans[index]
    cell = line[start:end]
    start += len(cell) - len(cell.lstrip())
    return text.span(number, start + 1, max(len(cell.strip()), 1))


def number_of(cell: str, index: int, separator: Separator) -> float:
    """Return the number in a cell.

    Raises:
        CellError: it is none, or not a finite one.
    """
    written = cell
    if "," in cell and separator.has_decimal_commas:
        if "." in cell:
            hint = "leave the sign between thousands out"
            raise CellError(index, f"`{shown(cell)}` has a comma and a point", hint)
        written = cell.replace(",", ".")
    try:
        value = float(written) if "_" not in written else float("x")
    except ValueError:
        hint = "write a number such as `12.5`"
        if "," in cell:
            hint = "with decimal commas separate the cells by `;`"
        raise CellError(
            index, f"`{shown(cell)}` is no number" if cell else "a number is missing", hint
        ) from None
    if not isfinite(value):
        raise CellError(index, f"`{shown(cell)}` is no finite number", _NUMBER)
    return value


def shown(text: str) -> str:
    """Return the beginning of a text that is quoted in a message, without control characters."""
    short = text if len(text) <= _SHOWN else text[: _SHOWN - 1] + "…"
    return "".join(one if one.isprintable() else "�" for one in short)


def _quoted_cells(line: str, separator: Separator) -> Sequence[tuple[str, int, int]]:
    """Return the cells of a line, each with the places where it begins and ends in it.

    Raises:
        CellError: a quote is not closed.
    """
    found: list[tuple[str, int, int]] = []
    at, size = 0, len(line)
    while True:
        start = at
        while at < size and line[at] in " \t" and line[at] != separator.sign:
            at += 1
        if at < size and line[at] == '"':
            parts, at = _inside_quotes(line, at, len(found))
            end = line.find(separator.sign, at)
            end = size if end < 0 else end
            found.append(((parts + line[at:end]).strip(), start, end))
        else:
            end = line.find(separator.sign, at)
            end = size if end < 0 else end
            found.append((line[start:end].strip(), start, end))
        if end >= size:
            return found
        at = end + 1


def _inside_quotes(line: str, at: int, index: int) -> tuple[str, int]:
    """Return the text in quotes that begins at a place, and the place behind it."""
    parts: list[str] = []
    at += 1
    while True:
        end = line.find('"', at)
        if end < 0:
            raise CellError(index, "a quote is not closed in its line", "close it, or leave it out")
        parts.append(line[at:end])
        if line[end + 1 : end + 2] != '"':
            return "".join(parts), end + 1
        parts.append('"')
        at = end + 2
