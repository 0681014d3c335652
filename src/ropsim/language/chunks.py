"""A text cut where no statement and no block goes on: each task by itself, and what stands between in pieces.

Where a piece ends is told by the lines there alone, whatever stands elsewhere, so that an edit changes the
pieces around it and no others (A. Muthitacharoen, B. Chen, D. Mazieres, "A low-bandwidth network file
system", SOSP 2001: chunks that their content defines).
"""

import re
from collections.abc import Iterator, Sequence

from ropsim.core import frozen_dataclass
from ropsim.language.cuts import cuts
from ropsim.language.line_kinds import CLOSES, TASK, kinds_of, those_with

_END = re.compile(r"\s*(?:endp|endtask)\s*(?:(?:#|//).*)?", re.IGNORECASE)
_OF_TASKS = those_with(TASK | CLOSES)


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


@frozen_dataclass
class Stretch:
    """A task, or what stands between two of them.

    Attributes:
        start: its first line, from 0.
        in_task: whether that is the header of a task.
        chunks: its lines.
    """

    start: int
    in_task: bool
    chunks: tuple[Chunk, ...]


def chunks(lines: Sequence[str]) -> Iterator[Chunk]:
    """Yield the lines of a text in chunks: one begins before the header of a task and one after its end."""
    for one in stretches(lines, kinds_of(lines)):
        yield from one.chunks


def stretches(
    lines: Sequence[str], kinds: bytes, start: int = 0, *, in_task: bool = False
) -> Iterator[Stretch]:
    """Yield the stretches of a text from a line on with which one begins; `kinds` says what lines mean."""
    for match in _OF_TASKS.finditer(kinds, start):
        number = match.start()
        if number and lines[number - 1].endswith("\\"):
            continue
        if kinds[number] & TASK:
            if number > start:
                yield _stretch(lines, kinds, start, number, in_task)
            start, in_task = number, True
        elif in_task and _END.fullmatch(lines[number]):
            yield Stretch(start, in_task, (_whole(lines, start, number + 1),))
            start, in_task = number + 1, False
    if start < len(lines):
        yield _stretch(lines, kinds, start, len(lines), in_task)


def _stretch(lines: Sequence[str], kinds: bytes, start: int, end: int, in_task: bool) -> Stretch:  # noqa: FBT001
    found = (_without_end if in_task else _pieces)(lines, kinds, start, end)
    return Stretch(start, in_task, tuple(found))


def _whole(lines: Sequence[str], start: int, end: int) -> Chunk:
    return Chunk(tuple(lines[start:end]), start + 1)


def _without_end(lines: Sequence[str], kinds: bytes, start: int, end: int) -> Iterator[Chunk]:
    """Yield a task that no line ends, and what is not of it as far as can be told."""
    first = next(iter(cuts(lines, kinds, start, end)), end)
    yield _whole(lines, start, first)
    if first < end:
        yield from _pieces(lines, kinds, first, end)


def _pieces(lines: Sequence[str], kinds: bytes, start: int, end: int) -> Iterator[Chunk]:
    """Yield what stands between two tasks."""
    found = cuts(lines, kinds, start, end)
    for first, last in zip((start, *found), (*found, end), strict=True):
        yield Chunk(tuple(lines[first:last]), first + 1, ends_part=last != end)
