"""A text cut where no statement and no block goes on: each task by itself, and what stands between in pieces.

Where a piece ends is told by the lines there alone, whatever stands elsewhere, so that an edit changes the
pieces around it and no others (A. Muthitacharoen, B. Chen, D. Mazieres, "A low-bandwidth network file
system", SOSP 2001: chunks that their content defines).
"""

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache
from zlib import crc32

from ropsim.core import frozen_dataclass
from ropsim.language.syntax.words import END, HEADS, OPENERS

_TASK = re.compile(r"\s*(?:\d+\.\s+)?task\b", re.IGNORECASE)
_END = re.compile(r"\s*(?:endp|endtask)\s*(?:(?:#|//).*)?", re.IGNORECASE)
_FIRST = frozenset("tTeE0123456789")
"""Letters with which such lines begin; most others need no further look."""
_HEAD = re.compile(r"\s*(?:\d+\.\s+)?([A-Za-z_]\w*)", re.ASCII)
_COMMENT = re.compile(r"#|//")
_ONE_LINE_IF = re.compile(r"\bthen\s+\S", re.IGNORECASE)
_CLOSERS = frozenset(word for words in OPENERS.values() for word in words) | {END, "until"}
_CONTRACTS = ("needs", "assumes")

MOST_LINES = 256
"""Of a piece, where some place in it is one to cut at."""
ONE_OF = 32
"""So many lines have one among them, on average, before which a piece ends."""


_BEGINS, _MARKED, _OPENS, _CLOSES, _RUNS_ON, _FORBIDS = 1, 2, 4, 8, 16, 32
"""What a line means for where pieces end, bits of one number, since there are many lines: it never goes on
with the statement of the line before it, unless that ends with a backslash; a piece ends before it, if one
may; it opens a block; it closes one; the next lines may go on with its statement; lines below may belong to
it, wherever they stand."""


@frozen_dataclass
class Chunk:
    """Lines that are read by themselves.

    Attributes:
        lines: as in the text.
        first: number of the first one, from 1.
        ends_part: whether a part of the control statements ends with it.
    """

    lines: tuple[str, ...]
    first: int
    ends_part: bool = False


def chunks(lines: Sequence[str]) -> Iterator[Chunk]:
    """Yield the lines of a text in chunks: one begins before the header of a task and one after its end."""
    start, in_task = 0, False
    for number in [number for number, line in enumerate(lines) if line.lstrip()[:1] in _FIRST]:
        line = lines[number]
        if number and lines[number - 1].endswith("\\"):
            continue
        if _TASK.match(line):
            if number > start:
                between = _whole(lines, start, number)
                yield from (between,) if in_task else _pieces(lines, start, number)
            start, in_task = number, True
        elif in_task and _END.fullmatch(line):
            yield _whole(lines, start, number + 1)
            start, in_task = number + 1, False
    if start < len(lines):
        rest = _whole(lines, start, len(lines))
        yield from (rest,) if in_task else _pieces(lines, start, len(lines))


def _whole(lines: Sequence[str], start: int, end: int) -> Chunk:
    return Chunk(tuple(lines[start:end]), start + 1)


def _pieces(lines: Sequence[str], start: int, end: int) -> Iterator[Chunk]:
    """Yield what stands between two tasks."""
    cuts = _cuts(lines, start, end)
    for first, last in zip((start, *cuts), (*cuts, end), strict=True):
        yield Chunk(tuple(lines[first:last]), first + 1, ends_part=last != end)


def _cuts(lines: Sequence[str], start: int, end: int) -> list[int]:
    """Return before which lines between two tasks no statement and no block goes on, of those to cut at."""
    found: list[int] = []
    depth, size, goes_on = 0, 0, start > 0 and lines[start - 1].endswith("\\")
    for number, kind in enumerate(map(_kind, lines[start:end]), start):
        if kind <= _BEGINS and size < MOST_LINES and not goes_on:  # most lines
            size += kind
            continue
        if not kind:
            continue
        if kind & _BEGINS:
            goes_on = lines[number - 1].endswith("\\")
        is_due = kind & _MARKED or size >= MOST_LINES
        if is_due and size and not depth and not goes_on:
            found.append(number)
            size = 0
        size += 1
        goes_on = goes_on or bool(kind & _RUNS_ON)
        if kind & _OPENS:
            depth += 1
        elif kind & _CLOSES:
            depth -= 1
        if depth < 0 or kind & _FORBIDS:
            return []
    return found


@lru_cache(maxsize=65_536)
def _kind(line: str) -> int:
    """Return what a line means for where pieces end."""
    head = _HEAD.match(line)
    word = head[1].lower() if head else ""
    kind = _MARKED if word and is_marked(_COMMENT.split(line)[0]) else 0
    if word in HEADS or word == END:
        kind |= _BEGINS
    if word in _CONTRACTS:
        kind |= _FORBIDS
    if word in _CLOSERS:
        kind |= _CLOSES
    elif word in OPENERS and not (word == "if" and _ONE_LINE_IF.search(_COMMENT.split(line)[0])):
        kind |= _OPENS
    if line.endswith("\\") or sum(map(line.count, "([")) != sum(map(line.count, ")]")):
        kind |= _RUNS_ON
    return kind


def is_marked(text: str) -> bool:
    """Return whether a text is one of those, one of so many, at which parts end."""
    return crc32(text.strip().encode(errors="surrogatepass")) % ONE_OF == 0
