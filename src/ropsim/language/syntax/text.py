"""A text read line by line: the green layer of the tree, independent of where a line stands."""

import re
from collections.abc import Iterator, Sequence
from typing import Protocol

from ropsim.core import SourceText, frozen_dataclass, maker
from ropsim.language.syntax.fault import Fault
from ropsim.language.syntax.lines import LogicalLine, joined_lines
from ropsim.language.syntax.statements import Broken, Closer, Statement

MAX_LINES = 200_000

_WORD = re.compile(r"[^\W\d]\w*")
Parsed = tuple[Statement | None, Fault | None]


@frozen_dataclass
class Line:
    """A logical line with its statement.

    Attributes:
        logical: text and line number.
        statement: None for an empty line or prose.
        fault: its fault.
    """

    logical: LogicalLine
    statement: Statement | None
    fault: Fault | None = None

    @staticmethod
    def empty() -> "Line":
        """Return the line that stands for the head of the whole text."""
        return _EMPTY

    @property
    def indent(self) -> int:
        """Return how many blanks stand before it."""
        text = self.logical.text
        return len(text) - len(text.lstrip())

    @property
    def start(self) -> int:
        """Return the offset of the statement."""
        return self.statement.start if self.statement else 0

    @property
    def end(self) -> int:
        """Return the offset after the statement."""
        return self.statement.end if self.statement else len(self.logical.text)

    @property
    def head(self) -> str:
        """Return the first word, lower case."""
        if isinstance(self.statement, Broken | Closer):
            return self.statement.head if isinstance(self.statement, Broken) else self.statement.word
        word = _WORD.match(self.logical.text, self.start)
        return word[0].lower() if word else ""


_line = maker(Line)
_EMPTY = Line(LogicalLine(1, ""), None)


class Parser(Protocol):
    """Parses lines, or returns remembered results."""

    def parsed(self, text: str) -> Parsed:
        """Return statement and fault of a logical line."""
        ...


def read(source: SourceText, cache: Parser) -> Iterator[Line]:
    """Yield the lines of a text; `cache` may keep parsed lines."""
    return read_lines(source.lines, cache)


def read_lines(lines: Sequence[str], cache: Parser) -> Iterator[Line]:
    """Yield the lines of a part of a text, counted from its first one."""
    parsed = cache.parsed
    for logical in joined_lines(lines):
        statement, fault = parsed(logical.text)
        yield _line(logical, statement, fault)
