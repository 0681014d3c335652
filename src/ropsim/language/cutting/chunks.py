"""A text cut where no statement and no block goes on: each task, and the lines between tasks in pieces.

Where a piece ends depends on the lines there alone, so that an edit changes the pieces around it and no
others (A. Muthitacharoen, B. Chen, D. Mazieres, "A low-bandwidth network file system", SOSP 2001: chunks that
their content defines).
"""

import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from ropsim.core import frozen_dataclass
from ropsim.language.cutting.cuts import cuts
from ropsim.language.cutting.line_kinds import CLOSES, TASK, kinds_of, those_with

_END = re.compile(r"\s*(?:endp|endtask)\s*(?:(?:#|//).*)?", re.IGNORECASE)
_OF_TASKS = those_with(TASK | CLOSES)


@frozen_dataclass
class Chunk:
    """Lines that are read together, independent of others.

    Attributes:
        lines: as in the text.
        ends_part: whether a part of the control statements ends with it.
    """

    lines: tuple[str, ...]
    ends_part: bool = False


@frozen_dataclass
class Bounds:
    """Where a task lies, or the lines between two of them.

    Attributes:
        start: its first line, from 0.
        end: the line behind it.
        in_task: whether the first one is the header of a task.
        is_ended: whether its last one is the end of the task.
    """

    start: int
    end: int
    in_task: bool
    is_ended: bool = False


@frozen_dataclass
class TextSection:
    """A task, or the lines between two of them.

    Attributes:
        in_task: whether its first line is the header of a task.
        chunks: its lines.
        is_plain: whether it is no task and all blocks in it have a beginning and an end.
    """

    in_task: bool
    chunks: tuple[Chunk, ...]
    is_plain: bool


def chunks(lines: Sequence[str]) -> Iterator[Chunk]:
    """Yield the lines of a text in chunks: one begins before the header of a task and one after its end."""
    kinds = kinds_of(lines)
    for one in bounds(lines, kinds):
        yield from section_of(lines, kinds, one).chunks


def bounds(lines: Sequence[str], kinds: bytes, start: int = 0, *, in_task: bool = False) -> Iterator[Bounds]:
    """Yield the sections of a text from the first line of one on; `kinds` has the kind of each line."""
    for match in _OF_TASKS.finditer(kinds, start):
        number = match.start()
        if number and lines[number - 1].endswith("\\"):
            continue
        if kinds[number] & TASK:
            if number > start:
                yield Bounds(start, number, in_task)
            start, in_task = number, True
        elif in_task and _END.fullmatch(lines[number]):
            yield Bounds(start, number + 1, in_task, is_ended=True)
            start, in_task = number + 1, False
    if start < len(lines):
        yield Bounds(start, len(lines), in_task)


def section_of(lines: Sequence[str], kinds: bytes, one: Bounds) -> TextSection:
    """Return the lines between bounds in chunks."""
    if one.is_ended:
        return TextSection(one.in_task, (Chunk(tuple(lines[one.start : one.end])),), is_plain=False)
    found, is_plain = cuts(lines, kinds, one.start, one.end)
    if not one.in_task:
        return TextSection(one.in_task, chunks_at(lines, (one.start, *found, one.end), one.end), is_plain)
    first = found[0] if found else one.end  # a task without a closing line
    rest, _ = cuts(lines, kinds, first, one.end)
    inner = chunks_at(lines, (first, *rest, one.end), one.end) if first < one.end else ()
    return TextSection(one.in_task, (Chunk(tuple(lines[one.start : first])), *inner), is_plain=False)


def chunks_at(lines: Sequence[str], borders: Sequence[int], end: int) -> tuple[Chunk, ...]:
    """Return the lines between borders; a part ends with each but the last one before the end."""
    return tuple(Chunk(tuple(lines[one:other]), other != end) for one, other in pairwise(borders))
