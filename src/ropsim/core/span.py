"""Where something stands in a source text."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, order=True)
class Span:
    """A stretch of a source text; lines and columns count from 1, the end column is exclusive.

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

    def to(self, other: "Span") -> "Span":
        """Return the span from the start of this one to the end of `other`."""
        return Span(self.source, self.line, self.column, other.end_line, other.end_column)

    def __str__(self) -> str:
        return f"{self.source}:{self.line}:{self.column}"
