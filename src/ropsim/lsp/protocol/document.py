"""An open document: its text, and positions of the protocol in characters, inside the document."""

import re
import sys
from bisect import bisect_right
from collections.abc import Iterable, Iterator
from dataclasses import field, replace
from itertools import accumulate
from pathlib import Path
from typing import TypeVar
from urllib.parse import unquote, urlsplit

from msgspec import structs

from ropsim.core import Span, frozen_dataclass
from ropsim.lsp.protocol.messages import Json
from ropsim.lsp.protocol.parameters import AtPosition, ContentChange, InRange, Position, Range
from ropsim.workbench import ROBOT_FORMATS

#: Ways of counting characters that an editor may choose; the first one where it says nothing.
ENCODINGS = ("utf-16", "utf-8", "utf-32")

_LINE_END = re.compile(r"\r\n|\n|\r")
_WIDE = re.compile("[\U00010000-\U0010ffff]")


@frozen_dataclass
class Document:
    """A text that an editor has open.

    Attributes:
        uri: its name in the protocol.
        version: as the editor counts.
        text: all characters, line ends included.
        encoding: in which units positions of the protocol count, one of `ENCODINGS`.
        starts: offset of the first character of each line; computed if not passed.
    """

    uri: str
    version: int
    text: str
    encoding: str = "utf-16"
    starts: tuple[int, ...] = field(default=(), repr=False, compare=False)

    def __post_init__(self) -> None:
        if not self.starts:
            object.__setattr__(self, "starts", _starts(self.text))

    @property
    def path(self) -> Path | None:
        """Return the file behind the document, None where its URI is no file."""
        parts = urlsplit(self.uri) if self.uri.startswith("file:") else None
        if parts is None or "\0" in unquote(parts.path):
            return None
        if sys.platform == "win32":
            from urllib.request import url2pathname

            return Path(url2pathname(parts.path))
        return Path(unquote(parts.path))  # other systems, without importing HTTP and TLS

    @property
    def name(self) -> str:
        """Return the name that findings use: the path, else the URI."""
        path = self.path
        return str(path) if path is not None else self.uri

    @property
    def is_robot_file(self) -> bool:
        """Return whether it is the file of a robot, in the folder `robots` of a project."""
        path = self.path
        return path is not None and path.parent.name == "robots" and path.suffix.lower() in ROBOT_FORMATS

    @property
    def is_task_text(self) -> bool:
        """Return whether it is a text of tasks of a knowledge base."""
        return self.name.endswith(".pl")

    @property
    def is_program(self) -> bool:
        """Return whether it is a text of the task language."""
        return not self.name.endswith((".toml", ".icr", ".pl"))

    def line(self, number: int) -> str:
        """Return line `number` (from 0), empty beyond the end."""
        if not 0 <= number < len(self.starts):
            return ""
        return self.text[self.starts[number] : self.end(number)]

    def lines(self) -> Iterator[str]:
        """Yield all lines."""
        return map(self.line, range(len(self.starts)))

    def end(self, number: int) -> int:
        """Return the offset after the last character of line `number` (from 0), without its line end."""
        if number + 1 == len(self.starts):
            return len(self.text)
        start, end = self.starts[number], self.starts[number + 1] - 1
        return end - 1 if start < end and self.text[end - 1 : end + 1] == "\r\n" else end

    def offset(self, position: Position) -> int:
        """Return the offset of a position; one beyond a line or the text is its end."""
        if position.line >= len(self.starts):
            return len(self.text)
        return self.starts[position.line] + self.column(position)

    def column(self, position: Position) -> int:
        """Return how many characters stand before a position on its line."""
        line = self.line(position.line)
        if line.isascii():
            return min(position.character, len(line))
        units = 0
        for column, character in enumerate(line):
            if units >= position.character:
                return column
            units += _units(character, self.encoding)
        return len(line)

    def position(self, line: int, column: int) -> Json:
        """Return the protocol position of a character, counted from 0; beyond a line it is the line's end."""
        last = len(self.starts) - 1
        if line > last:
            line, column = last, len(self.text)
        before = self.line(line)[: max(column, 0)]
        return {"line": line, "character": _units(before, self.encoding)}

    def width(self, line: int) -> int:
        """Return how many units of the protocol a line has, counted from 0; 0 beyond the text."""
        return _units(self.line(line), self.encoding)

    def units(self, line: int, first: int, last: int) -> int:
        """Return how many units of the protocol stand between two characters of a line, counted from 0."""
        begin, end = self.starts[line], self.end(line)
        return _units(self.text[min(begin + first, end) : min(begin + last, end)], self.encoding)

    def range_of(self, span: Span | None) -> Json:
        """Return the range of a span; one of a whole line, or none, becomes the words of that line."""
        if span is None or span.is_whole_line:
            number = span.line - 1 if span is not None else 0
            line = self.line(number)
            blank = len(line) - len(line.lstrip())
            return {
                "start": self.position(number, blank),
                "end": self.position(number, max(len(line.rstrip()), blank)),
            }
        return {
            "start": self.position(span.line - 1, span.column - 1),
            "end": self.position(span.end_line - 1, span.end_column - 1),
        }

    def changed(self, changes: Iterable[ContentChange], version: int) -> "Document":
        """Return the document after changes, each of which refers to the state that the one before left."""
        after = self
        for change in changes:
            if change.range is None:
                after = replace(after, text=change.text, version=version, starts=())
            else:
                after = after._edited(change.range.start, change.range.end, change.text, version)
        return after if after.version == version else replace(after, version=version)

    def _edited(self, begin: Position, behind: Position, new: str, version: int) -> "Document":
        """Return the document with another text between two positions; the lines elsewhere are known."""
        start = self.offset(begin)
        end = max(self.offset(behind), start)
        text = self.text[:start] + new + self.text[end:]
        starts: tuple[int, ...] = ()
        if "\r" not in text and "\r" not in self.text:
            above, below = bisect_right(self.starts, start), bisect_right(self.starts, end)
            between = (match.end() + start for match in _LINE_END.finditer(new))
            moved = (len(text) - len(self.text)).__add__
            starts = (*self.starts[:above], *between, *map(moved, self.starts[below:]))
        return replace(self, text=text, version=version, starts=starts)


def _starts(text: str) -> tuple[int, ...]:
    """Return the offsets of the first character of each line."""
    if text.count("\r") != text.count("\r\n"):
        return (0, *(match.end() for match in _LINE_END.finditer(text)))
    lines = text.split("\n")
    return (0, *accumulate(len(line) + 1 for line in lines[:-1]))


def _units(text: str, encoding: str) -> int:
    """Return how many units a text has."""
    if encoding == "utf-8" and not text.isascii():
        return len(text.encode("utf-8", "surrogatepass"))
    is_plain = encoding != "utf-16" or text.isascii()
    return len(text) + (0 if is_plain else len(_WIDE.findall(text)))


P = TypeVar("P")


def within(document: Document, params: P) -> P:
    """Return parameters whose position or range lies in a document.

    A place beyond a line becomes its end, one below the text the end of the text, as the protocol says; a
    range whose end stands before its start becomes the place of its start.
    """
    if isinstance(params, AtPosition):
        return structs.replace(params, position=_inside(document, params.position))
    if isinstance(params, InRange):
        start, end = _inside(document, params.range.start), _inside(document, params.range.end)
        return structs.replace(params, range=Range(start, max(start, end, key=_order)))
    return params


def _inside(document: Document, position: Position) -> Position:
    last = len(document.starts) - 1
    if position.line > last:
        return Position(last, document.width(last))
    return Position(position.line, min(position.character, document.width(position.line)))


def _order(position: Position) -> tuple[int, int]:
    return position.line, position.character
