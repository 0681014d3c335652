"""Where something stands in a source text."""

from functools import total_ordering

from ropsim.core.frozen_dataclass import frozen_dataclass


@total_ordering
@frozen_dataclass
class Span:
    """A range of a source text; lines and columns count from 1, the end column is exclusive.

    A span of no characters at the start of a line stands for the whole line: see `whole_line`.

    Attributes:
        source: name of the text, usually the path as the user gave it.
        line: first line.
        column: first column of the first line, in characters.
        end_line: last line (equal to `line` for most spans).
        end_column: column after the last character on `end_line`.
    """

    source: str
    line: int
    column: int
    end_line: int
    end_column: int

    @classmethod
    def on_line(cls, source: str, line: int, column: int, length: int = 1) -> "Span":
        """Return the span of `length` characters from `column` on one line."""
        return cls(source, line, column, line, column + max(length, 1))

    @classmethod
    def whole_line(cls, source: str, line: int) -> "Span":
        """Return the span of a line with unknown columns, as in an executed program."""
        return cls(source, line, 1, line, 1)

    @property
    def is_whole_line(self) -> bool:
        """Return whether the span stands for a whole line."""
        return (self.column, self.end_line, self.end_column) == (1, self.line, 1)

    def to(self, other: "Span") -> "Span":
        """Return the span from the start of this one to the end of `other`."""
        return Span(self.source, self.line, self.column, other.end_line, other.end_column)

    def __lt__(self, other: object) -> bool:
        return _place(self) < _place(other) if isinstance(other, Span) else NotImplemented

    def __str__(self) -> str:
        return f"{self.source}:{self.line}:{self.column}"


def _place(span: Span) -> tuple[str, int, int, int, int]:
    return span.source, span.line, span.column, span.end_line, span.end_column
