"""Where keys and values stand in a TOML text; the standard reader has no places.

The text must be valid TOML: it is parsed a second time after `tomllib`, for the places only.
"""

import re
import tomllib
from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from itertools import accumulate

from ropsim.core import SourceText, Span, frozen_dataclass

Path = tuple[str | int, ...]

_BLANK = re.compile(r"(?:[ \t]+|#[^\n]*)*+")
_SPACE = re.compile(r"(?:[ \t\n]+|#[^\n]*)*+")
_ITEMS = re.compile(r"(?:[ \t\n,]+|#[^\n]*)*+")
_BARE_KEY = re.compile(r"[^ \t\n.=\]]*")
_PLAIN = re.compile(r"[^,\]}#\n]*")
_STRINGS = {
    '"': re.compile(r'"(?:[^"\\]++|\\.)*+"?', re.DOTALL),
    "'": re.compile(r"'[^']*'?"),
    '"""': re.compile(r'"""(?:[^"\\]++|\\.|"(?!""))*+(?:"""+)?', re.DOTALL),
    "'''": re.compile(r"'''(?:[^']++|'(?!''))*+(?:'''+)?", re.DOTALL),
}
"""By their quotation marks; a long text may end with up to two of its own."""


@frozen_dataclass
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
            if isinstance(path[-1], int) and path in self.values:  # an item of a list has no key
                return self.values[path]
            path = path[:-1]
        return self.start

    def value(self, path: Path) -> Span:
        """Return the span of the value at `path`, or of its key, or of the nearest thing around it."""
        return self.values.get(path) or self.key(path)


def positions(source: SourceText) -> Positions:
    """Return the places of all keys and values of a valid TOML text.

    Most files are right and nothing points into them: the text is parsed when a place is requested.
    """
    places = _Places(source)
    keys, values = _Spans(places, lambda walk: walk.keys), _Spans(places, lambda walk: walk.values)
    return Positions(keys, values, source.span(1))


@dataclass(frozen=True, eq=False)
class _Places:
    """A text and where things stand in it."""

    source: SourceText

    @cached_property
    def text(self) -> str:
        return "\n".join(self.source.lines)

    @cached_property
    def starts(self) -> tuple[int, ...]:
        """Return the offset of each line."""
        return (0, *accumulate(len(line) + 1 for line in self.source.lines))

    @cached_property
    def walk(self) -> "_Walk":
        walk = _Walk(self.text)
        walk.document()
        return walk


@dataclass(frozen=True, slots=True, eq=False)
class _Spans(Mapping[Path, Span]):
    """Spans by path, made on request: most of a file is never pointed to.

    Attributes:
        places: where things stand.
        chosen: selected part of them, offsets of start and end by path.
    """

    places: _Places
    chosen: "Callable[[_Walk], Mapping[Path, tuple[int, int]]]"

    @property
    def ranges(self) -> Mapping[Path, tuple[int, int]]:
        return self.chosen(self.places.walk)

    def __getitem__(self, path: Path) -> Span:
        start, end = self.ranges[path]
        starts = self.places.starts
        line = bisect_right(starts, start)
        first, _, _ = self.places.text[start:end].partition("\n")
        return self.places.source.span(line, start - starts[line - 1] + 1, len(first))

    def __contains__(self, path: object) -> bool:
        return path in self.ranges

    def __iter__(self) -> Iterator[Path]:
        return iter(self.ranges)

    def __len__(self) -> int:
        return len(self.ranges)


@dataclass(slots=True)
class _Open:
    """A list or inline table that is not closed yet; `count` is None for a table."""

    path: Path
    start: int
    count: int | None


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
                self._value(self._key(section))

    def _header(self) -> Path:
        start = self.at
        brackets = 2 if self.text.startswith("[[", start) else 1
        self.at += brackets
        key_parts = self._dotted_key()
        self._skip(_BLANK)
        self.at += brackets
        path: Path = ()
        for name, part_start, part_end in key_parts[:-1]:
            path = (*path, name)
            self.keys.setdefault(path, (part_start, part_end))
            if path in self.lists:
                path = (*path, self.lists[path] - 1)
        path = (*path, key_parts[-1][0])
        self.keys.setdefault(path, (start, self.at))
        if brackets == 2:
            count = self.lists.get(path, 0)
            self.lists[path] = count + 1
            path = (*path, count)
        self.keys[path] = (start, self.at)
        return path

    def _key(self, section: Path) -> Path:
        """Pass over a key and the equals sign; return the path of the value that follows."""
        path = section
        for name, start, end in self._dotted_key():
            path = (*path, name)
            self.keys.setdefault(path, (start, end))
        self._skip(_BLANK)
        self.at += 1  # the equals sign
        self._skip(_BLANK)
        return path

    def _dotted_key(self) -> list[tuple[str, int, int]]:
        key_parts = []
        while True:
            start = self._skip(_BLANK)
            if self.text[start : start + 1] in {'"', "'"}:
                self._string()
                raw = self.text[start : self.at]
                name = next(iter(tomllib.loads(f"{raw} = 0"))) if "\\" in raw else raw[1:-1]
            else:
                name = self.text[start : self._skip(_BARE_KEY)]
            key_parts.append((name, start, self.at))
            self._skip(_BLANK)
            if self.text[self.at : self.at + 1] != ".":
                return key_parts
            self.at += 1

    def _value(self, path: Path) -> None:
        """Pass over a value and its contents; without recursion, however deep it is nested."""
        around: list[_Open] = []
        while True:
            start = self.at
            first = self.text[start : start + 1]
            if first in {"[", "{"}:
                around.append(_Open(path, start, 0 if first == "[" else None))
                self.at += 1
            else:
                if first in {'"', "'"}:
                    self._string()
                else:
                    plain = self.text[start : self._skip(_PLAIN)]
                    self.at = start + max(len(plain.rstrip()), 1)
                self.values[path] = (start, self.at)
            while around and (
                self._skip(_ITEMS) >= len(self.text)
                or self.text[self.at] == ("}" if around[-1].count is None else "]")
            ):
                closed = around.pop()
                self.at += 1
                self.values[closed.path] = (closed.start, self.at)
            if not around:
                return
            inner = around[-1]
            if inner.count is None:
                path = self._key(inner.path)
            else:
                path = (*inner.path, inner.count)
                inner.count += 1

    def _string(self) -> None:
        quote = self.text[self.at]
        mark = quote * 3 if self.text.startswith(quote * 3, self.at) else quote
        self._skip(_STRINGS[mark])

    def _skip(self, pattern: re.Pattern[str]) -> int:
        """Pass over the match of a pattern, which may be empty; return the new place."""
        found = pattern.match(self.text, self.at)
        self.at = found.end() if found else self.at
        return self.at


def offsets(source: SourceText) -> tuple[Mapping[Path, tuple[int, int]], Mapping[Path, tuple[int, int]]]:
    """Return where keys and values of a valid TOML text begin and end in its lines, joined by line feeds."""
    walk = _Places(source).walk
    return walk.keys, walk.values
