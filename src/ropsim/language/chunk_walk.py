"""The chunks of a text, read one after the other.

What was read stands in a trail. As long as the names of tasks are what they were, and the chunks above leave
to a chunk what they left, nobody asks for it again.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TypeVar

from ropsim.core import SourceText, frozen_dataclass
from ropsim.language import prose
from ropsim.language.chunks import Chunk
from ropsim.language.environment import Environment
from ropsim.language.reading import (
    CALLABLE,
    TASK_NAMES,
    Ends,
    Key,
    Parsed,
    Read,
    has_foreign,
    mended,
    mended_names,
    parsed,
    read_chunk,
)
from ropsim.language.recut import Cut, ends_alike, recut
from ropsim.language.report import MAX_FINDINGS
from ropsim.query import Database

T = TypeVar("T")
Lines = tuple[str, ...]

_TRAIL = "trail of the chunks"
"""Input: what the last reading has passed."""


@frozen_dataclass
class Step:
    """A chunk on the way.

    Attributes:
        chunk: where it lies.
        key: what it was read with.
        read: its blocks.
    """

    chunk: Chunk
    key: Key
    read: Read


@frozen_dataclass
class _Left:
    """What the chunks above leave to a chunk.

    Attributes:
        manner: how contracts are read.
        cut: openers that were reported as not closed.
    """

    manner: prose.Manner
    cut: tuple[str, ...] = ()


@dataclass(slots=True)
class _Trail:
    """What was read.

    Attributes:
        cut: the text in chunks.
        lines: of each chunk.
        found: each chunk line by line.
        names: of all tasks.
        foreign: whether a chunk has words that nobody knows.
        read: each chunk in blocks with its key, and what was left to it; none where one was mended.
    """

    cut: Cut = field(default_factory=Cut)
    lines: list[Lines] = field(default_factory=list)
    found: list[Parsed] = field(default_factory=list)
    names: frozenset[str] = frozenset()
    foreign: list[bool] = field(default_factory=list)
    read: list[tuple[_Left, Key, Read]] = field(default_factory=list)


@frozen_dataclass
class _Remains:
    """How many chunks are what they were: those above an edit, and those below it."""

    above: int
    below: int

    def of(self, known: Sequence[T], size: int) -> list[T | None]:
        """Return what was known of chunks, for each that there is now; None where it is to be found."""
        if not known:
            return [None] * size
        between = [None] * (size - self.above - self.below)
        return [*known[: self.above], *between, *known[len(known) - self.below :]]


def walk_chunks(source: SourceText, environment: Environment, db: Database) -> list[Step]:
    """Return the chunks of a text in blocks, up to where more lines are wrong than are worth looking at."""
    trail = _trail(db)
    cut = recut(source.lines, trail.cut)
    chunks = cut.chunks()
    lines = [chunk.lines for chunk in chunks]
    remains = _Remains(*ends_alike(lines, trail.lines))
    found = _parsed(lines, remains.of(trail.found, len(lines)), db)
    is_whole = len(found) == len(lines)
    lines = lines[: len(found)]
    names = frozenset(environment.tasks).union(environment.refused, *{one.tasks for one in found})
    db.give({TASK_NAMES: names})
    is_known = is_whole and names == trail.names
    known = remains.of(trail.foreign, len(lines)) if is_known else [None] * len(lines)
    foreign = [
        db.ask(has_foreign, one) if was is None else was for one, was in zip(lines, known, strict=True)
    ]
    keys = _mended(lines, found, foreign, db)
    misspelt = [(one, ends) for one, ends in zip(lines, keys, strict=True) if ends is not None]
    db.give({CALLABLE: names.union(*(db.ask(mended_names, one, ends) for one, ends in misspelt))})
    is_known = is_known and not misspelt
    read = _read(lines, keys, _first_left(found), remains if is_known else _Remains(0, 0), trail.read, db)
    trail.cut, trail.names = cut, names
    trail.lines, trail.found, trail.foreign = (lines, found, foreign) if is_whole else ([], [], [])
    trail.read = read if is_whole and not misspelt else []
    return [Step(chunk, key, one) for chunk, (_, key, one) in zip(chunks, read, strict=False)]


def _parsed(lines: Sequence[Lines], known: Sequence[Parsed | None], db: Database) -> list[Parsed]:
    found: list[Parsed] = []
    faults = 0
    for chunk, was in zip(lines, known, strict=True):
        one = db.ask(parsed, chunk) if was is None else was
        found.append(one)
        faults += one.faults
        if faults > 2 * MAX_FINDINGS:
            break
    return found


def _mended(
    lines: Sequence[Lines], found: Sequence[Parsed], foreign: Sequence[bool], db: Database
) -> list[Ends | None]:
    """Return for each chunk with a word that nobody knows the ends with which it is to be mended."""
    keys: list[Ends | None] = [None] * len(found)
    if not any(foreign):
        return keys
    total: Counter[str] = Counter()
    for one in found:
        total.update(dict(one.ends))
    ends = tuple(sorted((word, count) for word, count in total.items() if count))
    for k, chunk in enumerate(lines):
        if foreign[k]:
            keys[k] = ends
            ends = db.ask(mended, chunk, ends)[1]
    return keys


def _first_left(found: Sequence[Parsed]) -> _Left:
    """Return what is left to the first chunk."""
    is_classic = prose.is_classic(frozenset().union(*{one.modes for one in found}))
    return _Left(prose.Manner(is_classic, is_classic))


def _read(
    lines: Sequence[Lines],
    keys: Sequence[Ends | None],
    left: _Left,
    remains: _Remains,
    known: Sequence[tuple[_Left, Key, Read]],
    db: Database,
) -> list[tuple[_Left, Key, Read]]:
    """Return each chunk in blocks with its key, and what is left to it."""
    is_known = bool(known) and known[0][0] == left
    read = list(known[: remains.above]) if is_known else []
    if read:
        left = _behind(*read[-1])
    below = len(lines) - remains.below
    for k in range(len(read), len(lines)):
        if is_known and k == below:
            rest = known[len(known) - remains.below :]
            if rest[0][0] == left:
                return [*read, *rest]
        key: Key = (lines[k], keys[k], left.manner, ())
        one = db.ask(read_chunk, *key)
        if left.cut and one.looked_above:
            key = (lines[k], keys[k], left.manner, left.cut)
            one = db.ask(read_chunk, *key)
        read.append((left, key, one))
        left = _behind(left, key, one)
    return read


def _behind(left: _Left, key: Key, read: Read) -> _Left:
    """Return what is left to the chunk behind one."""
    cut = read.cut if key[-1] else (*left.cut, *read.cut)
    if cut == left.cut and read.manner == left.manner:
        return left
    return _Left(read.manner, cut)


def _trail(db: Database) -> _Trail:
    """Return the one trail of a text; no answer is made of it."""
    found: _Trail | None = db.read(_TRAIL)
    if found is None:
        found = _Trail()
        db.give({_TRAIL: found})
    return found
