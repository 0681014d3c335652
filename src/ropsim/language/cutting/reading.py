"""A chunk of a text, read line by line and in blocks; again only after a change of it or its inputs."""

from collections import Counter
from collections.abc import Iterator

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.language.blocks import matching as blocks
from ropsim.language.blocks import missing_ends, misspelt, prose, units
from ropsim.language.blocks.matching import Block
from ropsim.language.blocks.taken import task_names
from ropsim.language.blocks.then_bodies import placed
from ropsim.language.check.calls.tasks import TaskText, task_of
from ropsim.language.check.calls.tasks import is_task as stands_for_task
from ropsim.language.cutting.line_kinds import is_marked
from ropsim.language.report import Report, TooManyFindingsError
from ropsim.language.syntax import text as texts
from ropsim.language.syntax.text import Line
from ropsim.query import Database

TASK_NAMES = "names of tasks"
"""Input: the tasks of text and library."""
CALLABLE = "names of tasks, with those whose header is misspelt"
"""Input: the same after misspelt lines were mended."""
PARSER = "parser"
"""Input: parser of a line, which returns the statement and the fault, and may remember them."""

Ends = tuple[tuple[str, int], ...]
"""How many more ends than beginnings of blocks there are, by the word that opens them."""

Key = tuple[tuple[str, ...], Ends | None, prose.Manner, tuple[str, ...]]
"""Arguments of `read_chunk`."""


@frozen_dataclass
class Parsed:
    """A chunk line by line.

    Attributes:
        lines: lines that are not empty, and possible prose; numbers count from the chunk's first line.
        tasks: names of the tasks that it has.
        ends: how many more ends than beginnings of blocks it has, by the word that opens them.
        faults: how many of its lines are wrong.
        modes: which of `classic`, `strict` and `program` it says.
    """

    lines: tuple[Line, ...]
    tasks: frozenset[str]
    ends: Ends
    faults: int
    modes: frozenset[str]


@frozen_dataclass
class Task:
    """A task of a chunk.

    Attributes:
        text: its lines, counted from its header.
        places: where they lie in the chunk.
    """

    text: TaskText
    places: tuple[int, ...]


@frozen_dataclass
class Read:
    """A chunk in blocks.

    Attributes:
        tasks: of the chunk, in order.
        control: statements outside tasks, lines counted as in the chunk.
        found: findings; places count from the chunk's first line.
        manner: how contracts are read behind it.
        cut: openers that were reported as not closed.
        looked_above: whether that of the lines before it may have changed anything.
        opener: whether anything stands in it at all, and its first line.
    """

    tasks: tuple[Task, ...]
    control: units.Items
    found: tuple[Diagnostic, ...]
    manner: prose.Manner
    cut: tuple[str, ...]
    looked_above: bool
    opener: Line | None


def parsed(db: Database, lines: tuple[str, ...]) -> Parsed:
    """Return the lines of a chunk."""
    read = tuple(line for line in texts.read_lines(lines, db.read(PARSER)) if line.statement is not None)
    ends = misspelt.ends_of(read)
    return Parsed(
        read,
        task_names(read),
        tuple(sorted((word, count) for word, count in ends.items() if count)),
        sum(line.fault is not None for line in read),
        prose.modes(read),
    )


def has_foreign(db: Database, lines: tuple[str, ...]) -> bool:
    """Return whether a line of a chunk begins with a word that is none of the language and no task."""
    return misspelt.foreign(db.ask(parsed, lines).lines, Names(db, TASK_NAMES))


def mended(db: Database, lines: tuple[str, ...], ends: Ends) -> tuple[tuple[Line, ...], Ends]:
    """Return the lines of a chunk with misspelt ones mended, and the ends of the text after that."""
    counter = Counter(dict(ends))
    read = tuple(misspelt.mended(db.ask(parsed, lines).lines, Names(db, TASK_NAMES), counter))
    return read, tuple(sorted((word, count) for word, count in counter.items() if count))


def mended_names(db: Database, lines: tuple[str, ...], ends: Ends) -> frozenset[str]:
    """Return the tasks of a chunk, including tasks with a misspelt header."""
    return task_names(db.ask(mended, lines, ends)[0])


def read_chunk(
    db: Database,
    lines: tuple[str, ...],
    ends: Ends | None,
    manner: prose.Manner,
    cut: tuple[str, ...],
) -> Read:
    """Return a chunk in blocks.

    Args:
        db: database of other results.
        lines: of the chunk.
        ends: of the text, where some line of the chunk may be misspelt.
        manner: how contracts are read at its beginning.
        cut: openers before it that were reported as not closed.
    """
    report = Report("")
    try:
        read = db.ask(parsed, lines).lines if ends is None else db.ask(mended, lines, ends)[0]
        absorbed, manner = prose.absorb(placed(read), Names(db, CALLABLE), report, manner)
        tree = blocks.build(absorbed, report, cut)
    except TooManyFindingsError:
        return Read((), (), tuple(report.log), manner, (), looked_above=False, opener=None)
    found = tuple(missing_ends.with_ends(report.log, tree.items))
    tasks = tuple(_task(item) for item in tree.items if isinstance(item, Block) and stands_for_task(item))
    control = tuple(item for item in tree.items if not stands_for_task(item))
    opener = next((one.opener if isinstance(one, Block) else one for one in tree.items), None)
    return Read(tasks, control, found, manner, tree.cut, tree.looked_above, opener)


def control_of(db: Database, key: Key, before: int) -> tuple[units.Items, tuple[int, ...], bool]:
    """Return the control statements of a chunk, counted on from `before`, where they lie, if a part ends."""
    items, offsets = units.renumbered(db.ask(read_chunk, *key).control, before)
    return items, offsets, begins_marked(items)


@frozen_dataclass
class Alone:
    """The control statements of a chunk if they form a complete part.

    Attributes:
        items: lines and blocks, counted from the first one.
        name: of the part.
        first: where its first line lies in the chunk, from 0.
        offsets: where each of its lines lies, from the first one.
        ends: whether a part ends with the chunk, regardless of the content of the chunk.
    """

    items: units.Items
    name: str
    first: int
    offsets: tuple[int, ...]
    ends: bool


def alone_of(db: Database, key: Key) -> Alone:
    """Return the control statements of a chunk, which exist, as a complete part."""
    items, offsets = units.renumbered(db.ask(read_chunk, *key).control)
    first = offsets[0]
    lying = tuple(offset - first for offset in offsets)
    return Alone(items, units.name_of(items), first, lying, begins_marked(items))


def begins_marked(items: units.Items) -> bool:
    """Return whether the first line of a chunk is one with which a part ends."""
    return is_marked(next(units.lines_of(items)).logical.text)


def _task(item: Block) -> Task:
    (block,), places = units.renumbered((item,))
    assert isinstance(block, Block)
    return Task(task_of(block), places)


class Names:
    """Names of tasks that record which ones are looked up."""

    def __init__(self, db: Database, table: str) -> None:
        self._db = db
        self._table = table

    def __contains__(self, name: object) -> bool:
        return self._db.ask(is_task, self._table, str(name))

    def __iter__(self) -> Iterator[str]:
        return iter(self._db.read(self._table))

    def __len__(self) -> int:
        return len(self._db.read(self._table))


def is_task(db: Database, table: str, name: str) -> bool:
    """Return whether a task of that name can be called."""
    return name in db.read(table)
