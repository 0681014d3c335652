"""Logical lines: physical lines joined after an open parenthesis or a final backslash."""

import re
from collections.abc import Iterator, Sequence

from ropsim.core import SourceText, Span, frozen_dataclass, maker
from ropsim.language.syntax.words import HEADS

MAX_JOINED = 20

# Nothing is read twice: an unclosed text goes to the end of its line, and no repetition backtracks.
_BRACKETS = re.compile(r'"(?:[^"\\]++|\\.)*+(?:"|\\?$)|\#.*|//.*|[()\[\]]')
_HEAD = re.compile(r"\s*(?:\d+\.\s+)?([A-Za-z_]\w*)(.?)")
_END = re.compile(r"\s*+end\s*+\.?\s*+(?:#|//|$)", re.IGNORECASE)


@frozen_dataclass
class LogicalLine:
    """The text of a statement and the number of its first physical line.

    Attributes:
        number: from 1.
        text: physical lines joined by a line feed, a final backslash replaced by a blank, so that offsets in
            `text` still determine line and column.
    """

    number: int
    text: str

    def span(self, source: str, start: int, end: int) -> Span:
        """Return the span of the characters from offset `start` to `end` (exclusive)."""
        if start < end <= len(self.text) and "\n" not in self.text:
            return _span(source, self.number, start + 1, self.number, end + 1)
        first = min(start, max(len(self.text) - 1, 0))
        last = max(first, min(end, len(self.text)) - 1)
        line, column = self._place(first)
        end_line, end_column = self._place(last)
        return Span(source, line, column, end_line, end_column + 1)

    def _place(self, offset: int) -> tuple[int, int]:
        before = self.text.count("\n", 0, offset)
        if not before:
            return self.number, offset + 1
        return self.number + before, offset - self.text.rindex("\n", 0, offset)


_logical_line, _span = maker(LogicalLine), maker(Span)


def logical_lines(source: SourceText) -> Iterator[LogicalLine]:
    """Yield all logical lines of a text; see `joined_lines`."""
    return joined_lines(source.lines)


def joined_lines(lines: Sequence[str]) -> Iterator[LogicalLine]:
    """Yield all logical lines, empty ones included.

    A line with an open parenthesis goes on in the next ones, but never into a line that starts with a
    statement word or is `end` alone: a forgotten parenthesis spoils its own line and no other.
    """
    number = 0
    while number < len(lines):
        text = lines[number].replace("\ufeff", " ", 1) if number == 0 else lines[number]
        first = number + 1
        number += 1
        if "(" in text or "[" in text or text.endswith("\\"):
            joined = [text]
            while number < len(lines) and len(joined) < MAX_JOINED and _goes_on(joined, lines[number]):
                if joined[-1].endswith("\\"):
                    joined[-1] = joined[-1][:-1] + " "
                joined.append(lines[number])
                number += 1
            text = "\n".join(joined)
        yield _logical_line(first, text)


def _goes_on(joined: list[str], following: str) -> bool:
    if joined[-1].endswith("\\"):
        return True
    if sum(map(bracket_depth, joined)) <= 0 or not following.strip() or _END.match(following):
        return False
    head = _HEAD.match(following)
    return head is None or head.group(1).lower() not in HEADS


def bracket_depth(text: str) -> int:
    """Return how many more brackets a line opens than it closes."""
    if '"' not in text and "#" not in text and "//" not in text:
        return text.count("(") + text.count("[") - text.count(")") - text.count("]")
    depth = 0
    for mark in _BRACKETS.findall(text):
        depth += (mark in "([") - (mark in ")]")
    return depth
