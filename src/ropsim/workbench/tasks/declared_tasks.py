"""Names, parameters and purpose of tasks from their texts alone, without Prolog."""

import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path

from ropsim.core import SourceText, Span, frozen_dataclass, read_bytes

FARTHEST = 10_000
"""Number of characters of comments that are searched in front of a name."""

_BLANKS = re.compile(r"(?:[\s(]|%[^\n]*+)*+")
_ESCAPE = re.compile(
    r"\\(?:x([0-9a-fA-F]+)\\?|([0-7]+)\\?|u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8})|(\r?\n|c\s*)|.)|''", re.DOTALL
)
"""Numbers of characters, comments and layout, others; two quotes are one."""
_LAST = 0x10FFFF


def behind_layout(text: str, begin: int) -> int:
    """Return the place behind blanks, comments and opening parentheses that stand at a place of a text."""
    place, end = begin, begin + FARTHEST
    while True:
        blanks = _BLANKS.match(text, place, end)
        place = blanks.end() if blanks is not None else place
        close = text.find("*/", place + 2, end) if text.startswith("/*", place) else -1
        if close < 0:
            return place
        place = close + 2


def unquoted(inside: str) -> str:
    """Return the name that stands between single quotes; an escape for a sign stays, it is in no name."""
    return _ESCAPE.sub(_meant, inside)


def _meant(escape: re.Match[str]) -> str:
    hexadecimal, octal, short, long, nothing = escape.groups()
    digits = hexadecimal or short or long
    if nothing is not None:
        return ""
    if not digits and not octal:
        return escape[0]
    code = int(digits, 16) if digits else int(octal, 8)
    return chr(code) if code <= _LAST else escape[0]


_TASK = re.compile(r"(?:\btask|'task'|'([^'\\]{0,3}\\(?:[^'\\]|\\.){0,60}+)')\(", re.DOTALL)
"""The word, bare, in quotes, or with escapes as the group."""
_LINE_FEED = re.compile("\n")
_NAME = re.compile(r"[^\W\d]\w*|'((?:[^'\\]|\\.|'')*+)'", re.DOTALL)
"""A name, bare or in quotes as the group."""
_DOC = re.compile(r"\bdoc\(\s*\"((?:[^\"\\]|\\.)*)\"")
_PARAMETERS = re.compile(r"\bparams\(\s*\[([^\]]*)\]")
_PARAMETER = re.compile(
    r"([A-Z_]\w*)\s*-\s*([a-z]\w*)\s*(?:(=)\s*(-?[\w.]+(?:\s*\*\s*\w+)?(?=\s*(?:,|$)))?)?"
)
_WORD = re.compile(r"[^\W\d]\w*")
_BY_STATE = frozenset(("part", "tool", "device", "thing"))


@frozen_dataclass
class DeclaredTask:
    """A task as declared in its text.

    Attributes:
        name: how it is called.
        parameters: parameters of a call, in words such as `clear: length = 50 mm`.
        doc: purpose; empty if the text has none.
        span: of the name, in its text.
    """

    name: str
    parameters: tuple[str, ...]
    doc: str
    span: Span

    def __str__(self) -> str:
        return f"{self.name}({', '.join(self.parameters)})"


def declared_tasks(texts: Iterable[SourceText]) -> Mapping[str, DeclaredTask]:
    """Return the tasks of some texts by name; of two with one name the first counts."""
    found: dict[str, DeclaredTask] = {}
    for text in texts:
        for one in _told(text):
            found.setdefault(one.name, one)
    return found


@lru_cache(maxsize=4096)
def _told(text: SourceText) -> tuple[DeclaredTask, ...]:
    heads = tuple(_heads(text.text))
    ends = (*(begin for begin, _ in heads[1:]), len(text.text))
    starts = (0, *(found.end() for found in _LINE_FEED.finditer(text.text)))
    return tuple(_task(text, name, end, starts) for (_, name), end in zip(heads, ends, strict=False))


def _heads(text: str) -> Iterator[tuple[int, re.Match[str]]]:
    """Yield where each task begins, and its name."""
    for word in _TASK.finditer(text):
        name = _NAME.match(text, behind_layout(text, word.end()))
        is_task = word[1] is None or unquoted(word[1]) == "task"
        if is_task and name is not None and _WORD.fullmatch(_read(name)):
            yield word.start(), name


def _read(name: re.Match[str]) -> str:
    return name[0] if name[1] is None else unquoted(name[1])


def _task(text: SourceText, name: re.Match[str], end: int, starts: Sequence[int]) -> DeclaredTask:
    """Return the task of a name, whose clause ends before `end`; `starts` are the places of all lines."""
    doc = _DOC.search(text.text, name.end(), end)
    listed = _PARAMETERS.search(text.text, name.end(), end)
    begin, behind = name.span() if name[1] is None else name.span(1)
    line = bisect_right(starts, begin)
    column = begin - starts[line - 1] + 1
    return DeclaredTask(
        _read(name),
        tuple(
            f"{one.lower()}: {kind}{f' = {_default(value)}' if given else ''}"
            for one, kind, given, value in _PARAMETER.findall(listed[1] if listed else "")
            if kind not in _BY_STATE
        ),
        " ".join(doc[1].split()) if doc else "",
        Span.on_line(text.name, line, column, behind - begin),
    )


def _default(value: str) -> str:
    """Return a default in words of the task language: `50 mm` for `50*mm`; dots unless it is a number."""
    return " ".join(value.replace("*", " ").split()) or "…"


@lru_cache(maxsize=1)
def library_texts() -> tuple[SourceText, ...]:
    """Return the texts that come with ropsim, under the names of their files; nothing reads them."""
    folder = Path(__file__).parents[2] / "tasks" / "library"
    return tuple(SourceText(str(one), read_bytes(one).decode()) for one in sorted(folder.glob("*.pl")))
