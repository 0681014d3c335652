"""Where keys and values stand in a TOML text; the standard reader does not tell.

The text must be valid TOML: what `tomllib` accepts is walked through once more, for the places only.
"""

import tomllib
from bisect import bisect_right
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import accumulate

from ropsim.core import SourceText, Span

Path = tuple[str | int, ...]

_BLANK = " \t"
_SPACE = " \t\n"


@dataclass(frozen=True, slots=True)
class Positions:
    """Spans by path; a path has keys for tables and indices (from 0) for lists.

    Attributes:
        keys: span of the key, or of the header of a section.
        values: span of the value.
        start: the first character of the text.
    """

    keys: Mapping[Path, Span]
    values: Mapping[Path, Span]
    start: Span

    def key(self, path: Path) -> Span:
        """Return the span of the key at `path`, or of the nearest thing around it."""
        while path:
            if path in self.keys:
                return self.keys[path]
            path = path[:-1]
        return self.start

    def value(self, path: Path) -> Span:
        """Return the span of the value at `path`, or of its key, or of the nearest thing around it."""
        return self.values.get(path) or self.key(path)


def positions(source: SourceText) -> Positions:
    """Return the places of all keys and values of a valid TOML text."""
    text = "\n".join(source.lines)
    walk = _Walk(text)
    walk.document()
    starts = (0, *accumulate(len(line) + 1 for line in source.lines))
    keys, values = (_Spans(source, text, starts, found) for found in (walk.keys, walk.values))
    return Positions(keys, values, source.span(1))


@dataclass(frozen=True, slots=True, eq=False)
class _Spans(Mapping[Path, Span]):
    """Spans by path, made when they are asked for: most of a file is never pointed to.

    Attributes:
        source: the text with its name.
        text: its lines, joined.
        starts: offset of each line.
        stretches: offsets of start and end by path.
    """

    source: SourceText
    text: str
    starts: tuple[int, ...]
    stretches: Mapping[Path, tuple[int, int]]

    def __getitem__(self, path: Path) -> Span:
        start, end = self.stretches[path]
        line = bisect_right(self.starts, start)
        first, _, _ = self.text[start:end].partition("\n")
        return self.source.span(line, start - self.starts[line - 1] + 1, len(first))

    def __contains__(self, path: object) -> bool:
        return path in self.stretches

    def __iter__(self) -> Iterator[Path]:
        return iter(self.stretches)

    def __len__(self) -> int:
        return len(self.stretches)


@dataclass(slots=True)
class _Walk:
    """One pass over the text; `keys` and `values` collect (start, end) offsets."""

    text: str
    at: int = 0
    keys: dict[Path, tuple[int, int]] = field(default_factory=dict)
    values: dict[Path, tuple[int, int]] = field(default_factory=dict)
    lists: dict[Path, int] = field(default_factory=dict)

    def document(self) -> None:
        section: Path = ()
        while self._skip(_SPACE) < len(self.text):
            if self.text[self.at] == "[":
                section = self._header()
            else:
                self._key_value(section)

    def _header(self) -> Path:
        start = self.at
        brackets = 2 if self.text.startswith("[[", start) else 1
        self.at += brackets
        pieces = self._dotted_key()
        self._skip(_BLANK)
        self.at += brackets
        path: Path = ()
        for name, piece_start, piece_end in pieces[:-1]:
            path = (*path, name)
            self.keys.setdefault(path, (piece_start, piece_end))
            if path in self.lists:
                path = (*path, self.lists[path] - 1)
        path = (*path, pieces[-1][0])
        self.keys.setdefault(path, (start, self.at))
        if brackets == 2:
            count = self.lists.get(path, 0)
            self.lists[path] = count + 1
            path = (*path, count)
        self.keys[path] = (start, self.at)
        return path

    def _key_value(self, section: Path) -> None:
        path = section
        for name, start, end in self._dotted_key():
            path = (*path, name)
            self.keys.setdefault(path, (start, end))
        self._skip(_BLANK)
        self.at += 1  # the equals sign
        self._skip(_BLANK)
        self._value(path)

    def _dotted_key(self) -> list[tuple[str, int, int]]:
        pieces = []
        while True:
            start = self._skip(_BLANK)
            if self.text[start : start + 1] in {'"', "'"}:
                self._string()
                raw = self.text[start : self.at]
                name = next(iter(tomllib.loads(f"{raw} = 0"))) if "\\" in raw else raw[1:-1]
            else:
                while self.text[self.at : self.at + 1] not in {*_SPACE, ".", "=", "]", ""}:
                    self.at += 1
                name = self.text[start : self.at]
            pieces.append((name, start, self.at))
            self._skip(_BLANK)
            if self.text[self.at : self.at + 1] != ".":
                return pieces
            self.at += 1

    def _value(self, path: Path) -> None:
        start = self.at
        first = self.text[start : start + 1]
        if first in {'"', "'"}:
            self._string()
        elif first == "[":
            self._list(path)
        elif first == "{":
            self._inline_table(path)
        else:
            while self.text[self.at : self.at + 1] not in {",", "]", "}", "#", "\n", ""}:
                self.at += 1
            self.at = start + max(len(self.text[start : self.at].rstrip()), 1)
        self.values[path] = (start, self.at)

    def _list(self, path: Path) -> None:
        self.at += 1
        count = 0
        while self._skip(_SPACE + ",") < len(self.text) and self.text[self.at] != "]":
            self._value((*path, count))
            count += 1
        self.at += 1

    def _inline_table(self, path: Path) -> None:
        self.at += 1
        while self._skip(_SPACE + ",") < len(self.text) and self.text[self.at] != "}":
            self._key_value(path)
        self.at += 1

    def _string(self) -> None:
        quote = self.text[self.at]
        mark = quote * 3 if self.text.startswith(quote * 3, self.at) else quote
        self.at += len(mark)
        while self.at < len(self.text) and not self.text.startswith(mark, self.at):
            self.at += 2 if quote == '"' and self.text[self.at] == "\\" else 1
        self.at += len(mark)
        while len(mark) == 3 and self.text[self.at : self.at + 1] == quote:
            self.at += 1  # a long text may end with up to two quotation marks of its own

    def _skip(self, characters: str) -> int:
        """Pass over `characters` and comments; return the new place."""
        while self.at < len(self.text):
            if self.text[self.at] == "#":
                end = self.text.find("\n", self.at)
                self.at = end if end >= 0 else len(self.text)
            elif self.text[self.at] in characters:
                self.at += 1
            else:
                break
        return self.at
