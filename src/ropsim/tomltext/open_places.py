"""Open constructs at a place of a text that need not be TOML: its section, lists, inline tables."""

import re
from dataclasses import dataclass, field, replace

from ropsim.tomltext.dotted_keys import DOTTED, names_of
from ropsim.tomltext.positions import Path

_KEY = re.compile(rf"{DOTTED}=")
_HEADER = re.compile(rf"\s*+(\[\[?)({DOTTED})\]\]?\s*+(?:#.*)?$")
_NO_ROW = re.compile(r"\s*+\[\[?\s*+(?!(?:true|false|inf|nan)\b)[^\W\d]")
_SIGN = re.compile(
    r"""(?P<long>\"{3}|'{3})|(?P<one>[\[\]{},=])|(?P<remark>\#.*)"""
    r"""|"(?:[^"\\]++|\\.)*+"?|'[^']*+'?|[^\[\]{},=\#"']++|."""
)
_LONG_ENDS = {
    '"""': re.compile(r'(?:[^"\\]++|\\.|"(?!""))*+"{3,5}'),
    "'''": re.compile(r"(?:[^']++|'(?!''))*+'{3,5}"),
}
_OPENED_BY = {"]": "[", "}": "{"}

#: A line and a character of it, from 0.
Place = tuple[int, int]


@dataclass(slots=True)
class Open:
    """A section, a list or an inline table that is not closed yet.

    Attributes:
        sign: that has opened it, empty for a section.
        start: of its item that is being read.
        seen: keys of a table with the starts of their items.
        key: of the value that is being read, empty for none.
        count: of the items of a list before this one.
        is_filled: whether this item of a list has begun.
    """

    sign: str
    start: Place
    seen: set[tuple[str, Place]] = field(default_factory=set)
    key: tuple[str, ...] = ()
    count: int = 0
    is_filled: bool = False

    @property
    def steps(self) -> Path:
        """Return the steps from it to the item that is being read."""
        return (self.count,) if self.sign == "[" else self.key

    def begin(self) -> None:
        """Begin a value in a list, behind the one before it where its comma is missing."""
        self.count += self.is_filled
        self.is_filled = True

    def go_on(self, start: Place) -> None:
        """Pass over a comma."""
        self.start, self.key, self.is_filled = start, (), False
        self.count += 1


@dataclass(slots=True)
class OpenPlaces:
    """One pass over the lines, each given once.

    Attributes:
        stop: the requested place.
        found: open constructs there, the section first; empty until the place has been passed.
        typed: text before it since the last sign.
        is_quiet: whether it is in a remark or in a text over several lines.
        section: the path of the section where the pass is.
        section_found: that of the place.
        opened: open constructs at the present place.
        goes_on: whether the line goes on with a construct of a line above.
        long: quotation marks of the text over several lines that is open, empty for none.
        lists: how many sections of one name there are, by path.
        seen: keys of sections by path.
    """

    stop: Place
    found: list[Open] = field(default_factory=list)
    typed: str = ""
    is_quiet: bool = False
    section: Path = ()
    section_found: Path = ()
    opened: list[Open] = field(default_factory=list)
    goes_on: bool = False
    long: str = ""
    lists: dict[Path, int] = field(default_factory=dict)
    seen: dict[Path, set[tuple[str, Place]]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.opened.append(Open("", (0, 0), self._seen_in(())))

    def pass_line(self, row: int, line: str) -> None:
        """Pass over a line.

        An unclosed construct includes nothing below it: an inline table ends with its line, and a list before
        a line that cannot be part of it, a header or a key.
        """
        if row == self.stop[0]:
            self.stop = row, min(self.stop[1], len(line))
        at = self._behind_long(row, line)
        if at == 0 and len(self.opened) > 1 and (_NO_ROW.match(line) or _KEY.match(line)):
            del self.opened[1:]
        self.goes_on = at > 0 or len(self.opened) > 1
        if not self.goes_on:
            self.opened[0].go_on((row, 0))
        if not self.goes_on and line.lstrip().startswith("["):
            self._find(row, line, 0, len(line), len(line))
            self._pass_header(row, line)
        else:
            self._pass_signs(row, line, at)
        while self.opened[-1].sign == "{" and not self.long:
            self.opened.pop()

    def _behind_long(self, row: int, line: str) -> int:
        """Return where the text over several lines ends that is open; 0 where none is."""
        if not self.long:
            return 0
        found = _LONG_ENDS[self.long].match(line)
        end = found.end() if found else len(line) + 1
        self._find(row, line, 0, end, -1)
        self.long = "" if found else self.long
        return end

    def _pass_header(self, row: int, line: str) -> None:
        header = _HEADER.match(line)
        names = names_of(header[2]) if header else ()
        if header is None or not names:
            return
        path: Path = ()
        for name in names[:-1]:
            path = (*path, name)
            path = (*path, self.lists[path] - 1) if path in self.lists else path
        self._seen_in(path).add((names[-1], (row, 0)))
        path = (*path, names[-1])
        if header[1] == "[[":
            self.lists[path] = self.lists.get(path, 0) + 1
            path = (*path, self.lists[path] - 1)
        self.section, self.opened = path, [Open("", (row, 0), self._seen_in(path))]

    def _seen_in(self, section: Path) -> set[tuple[str, Place]]:
        return self.seen.setdefault(section, set())

    def _pass_signs(self, row: int, line: str, at: int) -> None:
        since = at
        while (found := _SIGN.match(line, at)) is not None:
            begin, at = at, found.end()
            if found["long"]:
                end = _LONG_ENDS[found["long"]].match(line, at)
                at, self.long = (end.end(), "") if end else (len(line), found["long"])
            sign = found["one"]
            if sign is None:
                is_quiet = found["long"] is not None or found["remark"] is not None
                self._find(row, line, since, at, begin if is_quiet else at)
                if not found["remark"] and found[0].strip() and self.opened[-1].sign == "[":
                    self.opened[-1].is_filled = True
                continue
            self._find(row, line, since, begin, begin)
            since = self._pass_sign(sign, (row, at), line[since:begin], since)
        self._find(row, line, since, len(line), len(line))

    def _pass_sign(self, sign: str, behind: Place, before: str, since: int) -> int:
        """Take one sign in; return the start of the text behind it."""
        here = self.opened[-1]
        if sign == "=" and here.sign != "[" and not here.key:
            here.key = names_of(before)
            here.seen.update((name, here.start) for name in here.key[:1])
        elif sign == "," and here.sign:
            here.go_on(behind)
        elif sign in "[{" and (here.key or here.sign == "["):
            here.begin()
            self.opened.append(Open(sign, behind))
        elif sign in _OPENED_BY and here.sign == _OPENED_BY[sign]:
            self.opened.pop()
        elif sign in _OPENED_BY and len(self.opened) > 2 and self.opened[-2].sign == _OPENED_BY[sign]:
            del self.opened[-2:]
        else:
            return since
        return behind[1]

    def _find(self, row: int, line: str, since: int, end: int, quiet_from: int) -> None:
        """Store the open constructs at the place, if it lies on this line before an end."""
        if self.found or row != self.stop[0] or self.stop[1] > end:
            return
        self.found = [replace(one) for one in self.opened]
        self.section_found = self.section
        self.typed = line[since : self.stop[1]]
        self.is_quiet = self.stop[1] > quiet_from
