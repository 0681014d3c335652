"""A text cut where no statement and no block goes on: each task by itself, and what stands between."""

import re
from collections.abc import Iterator, Sequence

from ropsim.core import frozen_dataclass

_TASK = re.compile(r"\s*(?:\d+\.\s+)?task\b", re.IGNORECASE)
_END = re.compile(r"\s*(?:endp|endtask)\s*(?:(?:#|//).*)?", re.IGNORECASE)
_FIRST = frozenset("tTeE0123456789")
"""Letters with which such lines begin; most others need no further look."""


@frozen_dataclass
class Chunk:
    """Lines that are read by themselves.

    Attributes:
        lines: as in the text.
        first: number of the first one, from 1.
    """

    lines: tuple[str, ...]
    first: int


def chunks(lines: Sequence[str]) -> Iterator[Chunk]:
    """Yield the lines of a text in chunks: one begins before the header of a task and one after its end."""
    start, in_task = 0, False
    for number, line in enumerate(lines):
        if line.lstrip()[:1] not in _FIRST or (number and lines[number - 1].endswith("\\")):
            continue
        if _TASK.match(line):
            if number > start:
                yield Chunk(tuple(lines[start:number]), start + 1)
            start, in_task = number, True
        elif in_task and _END.fullmatch(line):
            yield Chunk(tuple(lines[start : number + 1]), start + 1)
            start, in_task = number + 1, False
    if start < len(lines):
        yield Chunk(tuple(lines[start:]), start + 1)
