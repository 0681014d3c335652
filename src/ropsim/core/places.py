"""Where characters of a text stand: offsets to lines and columns."""

from bisect import bisect_right
from re import compile as pattern

from ropsim.core.frozen_dataclass import frozen_without_equality
from ropsim.core.source import SourceText
from ropsim.core.span import Span

_LINE_END = pattern(r"\r\n|\r|\n")


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
