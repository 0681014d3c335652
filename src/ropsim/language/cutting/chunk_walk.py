"""The chunks of a text, read one after the other.

Results of reading are kept in a record. A chunk is not queried again as long as the names of tasks and the
effects of the chunks above are unchanged.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from operator import attrgetter

from ropsim.core import Diagnostic, SourceText, frozen_dataclass
from ropsim.language.blocks import prose
from ropsim.language.cutting.chunks import Chunk
from ropsim.language.cutting.reading import (
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
from ropsim.language.cutting.recut import Cut, recut
from ropsim.language.environment import Environment
from ropsim.language.report import MAX_FINDINGS
from ropsim.query import NOTHING_UNCHANGED, Database, Splice

MOST_FAULTS = 2 * MAX_FINDINGS
"""Wrong lines; a text that has more of them is not read to its end."""

_TRAIL = "trail of the chunks"
"""Input: records of the last reading."""
_FAULTS, _TASKS, _MODES = attrgetter("faults"), attrgetter("tasks"), attrgetter("modes")


@frozen_dataclass
class Left:
    """Effect of the chunks above on a chunk.

    Attributes:
        manner: how contracts are read.
        cut: openers that were reported as not closed.
    """

    manner: prose.Manner
    cut: tuple[str, ...] = ()


@frozen_dataclass
class Step:
    """A chunk on the way.

    Attributes:
        chunk: its lines.
        left: effect of the chunks above.
        key: arguments of its reading.
        read: its blocks.
        found: findings in it.
    """

    chunk: Chunk
    left: Left
    key: Key
    read: Read
    found: tuple[Diagnostic, ...]


@dataclass(slots=True)
class _Trail:
    """Record of the reading.

    Attributes:
        cut: the text in chunks.
        found: each chunk line by line.
        names: of all tasks.
        foreign: whether a chunk has words that are unknown.
        steps: of all chunks; none where one was mended.
    """

    cut: Cut = field(default_factory=Cut)
    found: list[Parsed] = field(default_factory=list)
    names: frozenset[str] = frozenset()
    foreign: list[bool] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)


def walk_chunks(source: SourceText, environment: Environment, db: Database) -> list[Step]:
    """Return the chunks of a text in blocks, up to the limit of wrong lines.

    Chunks with an unchanged reading, on both sides of an edit, are the same objects.
    """
    trail = db.auxiliary(_TRAIL, _Trail)
    cut = recut(source.with_line_feeds(), trail.cut)
    found = _parsed(cut, trail.found, db)
    is_whole = len(found) == len(cut.chunks)
    chunks = cut.chunks if is_whole else cut.chunks[: len(found)]
    names = _names(environment, found, trail.names)
    db.give({TASK_NAMES: names})
    is_known = is_whole and names is trail.names
    unchanged = cut.unchanged if is_known and trail.foreign else NOTHING_UNCHANGED
    new_foreign = [db.ask(has_foreign, one.lines) for one in unchanged.between(chunks)]
    foreign = unchanged.spliced(trail.foreign, new_foreign)
    keys = _mended(chunks, found, foreign, db)
    misspelt = [(one.lines, ends) for one, ends in zip(chunks, keys, strict=False) if ends is not None]
    callable_ones = names.union(*(db.ask(mended_names, *one) for one in misspelt)) if misspelt else names
    db.give({CALLABLE: callable_ones})
    unchanged = cut.unchanged if is_known and not misspelt else NOTHING_UNCHANGED
    steps = _read(chunks, keys, _first_left(found), unchanged, trail.steps, db)
    trail.cut, trail.names = cut, names
    trail.found, trail.foreign = (found, foreign) if is_whole else ([], [])
    trail.steps = steps if is_whole and not misspelt else []
    return steps


def _parsed(cut: Cut, known: Sequence[Parsed], db: Database) -> list[Parsed]:
    """Return the chunks line by line, up to the limit of wrong lines."""
    if known:
        new = [db.ask(parsed, one.lines) for one in cut.unchanged.between(cut.chunks)]
        found = cut.unchanged.spliced(known, new)
        if sum(map(_FAULTS, found)) <= MOST_FAULTS:
            return found
    found = []
    faults = 0
    for chunk in cut.chunks:
        found.append(db.ask(parsed, chunk.lines))
        faults += found[-1].faults
        if faults > MOST_FAULTS:
            break
    return found


def _names(environment: Environment, found: Sequence[Parsed], before: frozenset[str]) -> frozenset[str]:
    """Return the names of all tasks, the same object as before if they are unchanged."""
    names = frozenset(environment.tasks).union(environment.refused, *map(_TASKS, found))
    return before if names == before else names


def _mended(
    chunks: Sequence[Chunk], found: Sequence[Parsed], foreign: Sequence[bool], db: Database
) -> Sequence[Ends | None]:
    """Return for each chunk with an unknown word the ends that are used to mend it."""
    if not any(foreign):
        return ()
    keys: list[Ends | None] = [None] * len(found)
    total: Counter[str] = Counter()
    for one in found:
        total.update(dict(one.ends))
    ends = tuple(sorted((word, count) for word, count in total.items() if count))
    for k, chunk in enumerate(chunks):
        if foreign[k]:
            keys[k] = ends
            ends = db.ask(mended, chunk.lines, ends)[1]
    return keys


def _first_left(found: Sequence[Parsed]) -> Left:
    """Return the effects before the first chunk."""
    is_classic = prose.is_classic(frozenset().union(*map(_MODES, found)))
    return Left(prose.Manner(is_classic, is_classic))


def _read(
    chunks: Sequence[Chunk],
    keys: Sequence[Ends | None],
    left: Left,
    unchanged: Splice,
    known: Sequence[Step],
    db: Database,
) -> list[Step]:
    """Return each chunk in blocks; `keys` says with which ends they are mended, where some are."""
    is_known = bool(known) and known[0].left == left
    steps = list(unchanged.known_above(known)) if is_known else []
    if steps:
        left = _behind(steps[-1])
    below = len(chunks) - unchanged.below
    for k in range(len(steps), len(chunks)):
        if is_known and k == below:
            rest = unchanged.known_below(known)
            if rest[0].left == left:
                return [*steps, *rest]
        ends = keys[k] if keys else None
        key: Key = (chunks[k].lines, ends, left.manner, ())
        one = db.ask(read_chunk, *key)
        if left.cut and one.looked_above:
            key = (chunks[k].lines, ends, left.manner, left.cut)
            one = db.ask(read_chunk, *key)
        steps.append(Step(chunks[k], left, key, one, one.found))
        left = _behind(steps[-1])
    return steps


def _behind(step: Step) -> Left:
    """Return the effects before the next chunk."""
    left, read = step.left, step.read
    cut = read.cut if step.key[-1] else (*left.cut, *read.cut)
    if cut == left.cut and read.manner == left.manner:
        return left
    return Left(read.manner, cut)
