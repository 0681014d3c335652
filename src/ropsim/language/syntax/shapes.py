"""Lines read by their shape: the text of a line without its numbers and its names with digits.

Lines of one shape become statements that differ in those numbers and names, and in offsets. When many lines
of a shape have been parsed, a reader for further ones is generated; it takes a third of the time of parsing.
"""

from collections.abc import Sequence

from ropsim.language.syntax.fault import Fault
from ropsim.language.syntax.line import MAX_LENGTH, parse_line
from ropsim.language.syntax.shape_reader import Reader, parts_of, reader_of
from ropsim.language.syntax.statements import Statement

MANY = 50
"""Number of lines of a shape whose parsing takes as long as generating a reader."""
MOST_KEPT = 4_000
"""Shapes that are known, and shapes of which lines are counted."""

Shape = tuple[str, ...]


class Shapes:
    """Shapes of lines, and how many lines of each there were; they save time and change no result."""

    __slots__ = ("_counts", "_many", "_readers")

    def __init__(self, many: int = MANY) -> None:
        self._many = many
        self._counts: dict[Shape, int] = {}
        self._readers: dict[Shape, Reader] = {}

    def parsed(self, line: str) -> tuple[Statement | None, Fault | None]:
        """Return the result of `parse_line` for a line."""
        parts = parts_of(line)
        shape = tuple(parts[::2])
        reader = self._readers.get(shape)
        if reader is not None and len(line) <= MAX_LENGTH:
            statement = reader(parts)
            if statement is not None:
                return statement, None
        statement, fault = parse_line(line)
        if reader is None and shape and statement is not None and fault is None:
            self._count(shape, parts, statement)
        return statement, fault

    def _count(self, shape: Shape, parts: Sequence[str], statement: Statement) -> None:
        """Count a line of a shape of which none is known by now."""
        if len(self._counts) >= MOST_KEPT:
            self._counts.clear()
        count = self._counts[shape] = self._counts.get(shape, 0) + 1
        if count != self._many:
            return
        reader = reader_of(parts, statement)
        if reader is not None:
            if len(self._readers) >= MOST_KEPT:
                self._readers.clear()
            self._readers[shape] = reader
