"""A named text: input of readers, quoted by diagnostics."""

from bisect import bisect_right
from dataclasses import field
from re import compile as pattern

from ropsim.core.frozen_dataclass import frozen_dataclass, frozen_without_equality
from ropsim.core.span import Span

_LINE_END = pattern(r"\r\n|\r|\n")


@frozen_dataclass
class SourceText:
    """A text and the name under which messages speak of it.

    Attributes:
        name: path or label.
        text: the characters; every kind of line end is understood.
    """

    name: str
    text: str
    _lines: tuple[str, ...] | None = field(init=False, repr=False, compare=False, default=None)

    @property
    def lines(self) -> tuple[str, ...]:
        """Return the text cut into lines, without line ends; computed on the first request."""
        if self._lines is None:
            object.__setattr__(self, "_lines", tuple(self.with_line_feeds().split("\n")))
        found = self._lines
        assert found is not None
        return found

    def with_line_feeds(self) -> str:
        """Return the characters with a line feed as the only kind of line end."""
        text = self.text
        return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text

    def line(self, number: int) -> str:
        """Return line `number` (from 1), or an empty string beyond the end."""
        return self.lines[number - 1] if 1 <= number <= len(self.lines) else ""

    def span(self, line: int, column: int = 1, length: int = 1) -> Span:
        """Return a span on one line of this text."""
        return Span.on_line(self.name, line, column, length)


@frozen_without_equality
class Places:
    """The beginnings of the lines of a text.

    Attributes:
        source: the text.
        starts: offset of the first character of each line.
    """

    source: SourceText
    starts: tuple[int, ...]

    def span(self, offset: int, length: int = 1) -> Span:
        """Return the place of some characters of one line."""
        line = bisect_right(self.starts, offset)
        return self.source.span(line, offset - self.starts[line - 1] + 1, length)


def places_of(source: SourceText) -> Places:
    """Return the beginnings of the lines of a text; every kind of line end is understood."""
    return Places(source, (0, *(match.end() for match in _LINE_END.finditer(source.text))))
