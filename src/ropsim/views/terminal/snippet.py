"""Source lines with marks under them."""

from ropsim.core import SourceText, Span, frozen_dataclass
from ropsim.views.terminal.columns import Style, Tone, paint
from ropsim.views.words.characters import clean, visible, width

SHOWN_LINES = 6
"""A marked range of more lines is shown by its first and last ones."""


LINE_WIDTH = 100
"""Terminal columns of source text that are shown; longer lines are cut around the first mark."""

EXCERPT = 2000
"""Characters of one line that are shown, around the mark."""


@frozen_dataclass
class Mark:
    """A range to underline.

    Attributes:
        span: place to mark.
        text: words after the mark, may be empty.
        sign: the character to draw with.
        tone: its colour.
    """

    span: Span
    text: str
    sign: str
    tone: Tone


@frozen_dataclass
class _Row:
    """One source line as shown: text and the marked display columns (from 0, end exclusive)."""

    text: str
    start: int
    end: int


def snippet(source: SourceText, span: Span, marks: tuple[Mark, ...], gutter: int, style: Style) -> list[str]:
    """Return the quoted lines of a span with every mark drawn under its line.

    Args:
        source: the text.
        span: place to quote; every mark lies on its lines.
        marks: places to underline, in the order of drawing.
        gutter: width of the line number column.
        style: plain or with ANSI colours.
    """
    lines: list[str] = []
    bar = paint("|", Tone.GUTTER, style)
    shown = _shown_lines(span, len(source.lines))
    for number in shown:
        if number == 0:
            lines.append(paint("...", Tone.GUTTER, style))
            continue
        text = source.line(number)
        base = _excerpt_start(text, number, marks[0].span)
        rows = [(mark, _row(text, base, number, mark.span)) for mark in marks]
        shift, limit = _window(rows[0][1], LINE_WIDTH)
        quoted = _cut(rows[0][1].text, shift, limit)
        lines.append(f"{paint(str(number).rjust(gutter), Tone.GUTTER, style)} {bar} {quoted}".rstrip())
        for mark, row in rows:
            start, end = max(row.start - shift, 0), max(row.end - shift, row.start - shift + 1)
            words = f" {clean(mark.text)}" if mark.text and number == shown[-1] else ""
            sign = mark.sign * max(min(end, limit) - start, 1)
            lines.append(f"{' ' * gutter} {bar} {' ' * start}{paint(sign + words, mark.tone, style)}")
    return lines


def _shown_lines(span: Span, count: int) -> list[int]:
    """Return the line numbers to show, 0 for an ellipsis."""
    first, last = span.line, max(span.line, min(span.end_line, max(count, span.line)))
    if span.end_column <= 1 and last > first:
        last -= 1
    numbers = list(range(first, min(last, first + SHOWN_LINES) + 1))
    if last - first < SHOWN_LINES:
        return numbers
    return [*numbers[: SHOWN_LINES // 2], 0, last - 1, last]


def _excerpt_start(text: str, number: int, span: Span) -> int:
    """Return the first character to show: lines of megabytes are not rendered whole."""
    if len(text) <= EXCERPT or number != span.line:
        return 0
    return max(min(span.column - 1, len(text)) - EXCERPT // 2, 0)


def _row(text: str, base: int, number: int, span: Span) -> _Row:
    """Return a line (from character `base`) made visible and where a span marks it."""
    indent = len(text) - len(text.lstrip())
    if span.is_whole_line:
        first, after = indent, len(text.rstrip())
    else:
        first = span.column - 1 if number == span.line else indent
        after = span.end_column - 1 if number == span.end_line else len(text)
    parts: list[str] = []
    column = start = 0
    end = -1
    for index, character in enumerate(text[base : base + EXCERPT], base):
        start = column if index <= first else start
        end = column if index == after else end
        parts.append(visible(character, column))
        column += width(parts[-1])
    start = column if first >= base + len(parts) else start
    return _Row("".join(parts), start, max(end if end >= 0 else column, start + 1))


def _window(row: _Row, columns: int) -> tuple[int, int]:
    """Return the display columns to hide on the left and how many to show, the mark well inside."""
    total = width(row.text)
    if total <= columns:
        return 0, max(total, row.end)
    middle = (row.start + min(row.end, row.start + columns)) // 2
    shift = min(max(middle - columns // 2, 0), max(total - columns, 0))
    return min(shift, row.start), columns


def _cut(text: str, shift: int, limit: int) -> str:
    """Return display columns `shift` to `shift + limit` of a text, ellipses where something is hidden."""
    if shift == 0 and width(text) <= limit:
        return text
    kept, column = [], 0
    for character in text:
        size = width(character)
        if column >= shift and column + size <= shift + limit:
            kept.append(character)
        elif column < shift < column + size:
            kept.append(" ")
        column += size
    if kept and shift > 0:
        kept[0] = "…".ljust(width(kept[0]))
    if kept and column > shift + limit:
        kept[-1] = "…"
    return "".join(kept)
