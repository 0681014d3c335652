"""A text divided into units, chunk by chunk."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import partial

from ropsim.core import SourceText, Span
from ropsim.language import prose, units
from ropsim.language.check.tasks import TaskText
from ropsim.language.chunks import Chunk, chunks
from ropsim.language.environment import Environment
from ropsim.language.findings import names as name_kinds
from ropsim.language.reading import (
    CALLABLE,
    TASK_NAMES,
    Ends,
    Key,
    Parsed,
    Read,
    Task,
    control_of,
    has_foreign,
    mended,
    mended_names,
    parsed,
    read_chunk,
)
from ropsim.language.report import MAX_FINDINGS, Report
from ropsim.program import Places, SourceMap, placed
from ropsim.query import Database


@dataclass(slots=True)
class Units:
    """A text in units.

    Attributes:
        tasks: by name, in order.
        control: what stands outside of them.
        map: where they lie.
        opener: where the first line with a statement lies, None where there is none.
    """

    tasks: dict[str, TaskText] = field(default_factory=dict)
    control: units.Items = ()
    map: SourceMap = field(default_factory=lambda: SourceMap(""))
    opener: Span | None = None


def divided(source: SourceText, environment: Environment, report: Report, db: Database) -> Units:
    """Return the units of a text; what cannot be read is reported.

    Raises:
        TooManyFindingsError: the list is full.
    """
    found: list[tuple[Chunk, Parsed]] = []
    faults = 0
    for chunk in chunks(source.lines):
        one = db.ask(parsed, chunk.lines)
        found.append((chunk, one))
        faults += one.faults
        if faults > 2 * MAX_FINDINGS:
            break
    names = frozenset(environment.tasks).union(environment.refused, *(one.tasks for _, one in found))
    db.give({TASK_NAMES: names})
    keys = _mended(found, db)
    misspelt = [(chunk, ends) for (chunk, _), ends in zip(found, keys, strict=True) if ends is not None]
    db.give({CALLABLE: names.union(*(db.ask(mended_names, chunk.lines, ends) for chunk, ends in misspelt))})
    return _joined(source, list(_read(found, keys, db)), report, db)


def _mended(found: list[tuple[Chunk, Parsed]], db: Database) -> list[Ends | None]:
    """Return for each chunk with a word that nobody knows the ends with which it is to be mended."""
    foreign = [db.ask(has_foreign, chunk.lines) for chunk, _ in found]
    keys: list[Ends | None] = [None] * len(found)
    if not any(foreign):
        return keys
    total: Counter[str] = Counter()
    for _, one in found:
        total.update(dict(one.ends))
    ends = tuple(sorted((word, count) for word, count in total.items() if count))
    for k, (chunk, _) in enumerate(found):
        if foreign[k]:
            keys[k] = ends
            ends = db.ask(mended, chunk.lines, ends)[1]
    return keys


def _read(
    found: list[tuple[Chunk, Parsed]], keys: list[Ends | None], db: Database
) -> Iterator[tuple[Chunk, Key, Read]]:
    """Yield the chunks in blocks."""
    is_classic = prose.is_classic(frozenset().union(*(one.modes for _, one in found)))
    manner = prose.Manner(is_classic, is_classic)
    cut: tuple[str, ...] = ()
    for (chunk, _), ends in zip(found, keys, strict=True):
        key: Key = (chunk.lines, ends, manner, cut)
        one = db.ask(read_chunk, *key)
        yield chunk, key, one
        manner, cut = one.manner, one.cut


def _joined(source: SourceText, read: list[tuple[Chunk, Key, Read]], report: Report, db: Database) -> Units:
    """Return the units of all chunks.

    Raises:
        TooManyFindingsError: the list is full.
    """
    result = Units()
    places: dict[str, Places] = {}
    control: list[int] = []
    doubles: list[tuple[str, Span]] = []
    for chunk, key, one in read:
        for finding in one.found:
            report.add(placed(finding, partial(_moved, source=source.name, by=chunk.first - 1)))
        if result.opener is None and one.opener is not None:
            line = one.opener
            span = line.logical.span(source.name, line.start, line.end)
            result.opener = _moved(span, source.name, chunk.first - 1)
        for task in one.tasks:
            name = _entered(result.tasks, task, doubles)
            places[units.of_task(name)] = Places(chunk.first, task.places)
        if one.control:
            items, offsets = db.ask(control_of, key, len(control))
            result.control += items
            control += [chunk.first + offset for offset in offsets]
    places[units.CONTROL] = Places(0, tuple(control))
    result.map = SourceMap(source.name, places)
    for name, span in doubles:
        message = f"task `{name}` is defined twice"
        report.add(name_kinds.DUPLICATE.at(result.map.span(span), message, hint="rename one of them"))
    return result


def _entered(tasks: dict[str, TaskText], task: Task, doubles: list[tuple[str, Span]]) -> str:
    """Enter a task and return its name: one that no text can write where its own is taken or none."""
    name = task.text.name
    if name in tasks or not name:
        unnamed = f"#{len(tasks)}"
        if name:
            line = task.text.block.opener
            doubles.append((name, line.logical.span(units.of_task(unnamed), line.start, line.end)))
        name = unnamed
    tasks[name] = replace(task.text, name=name) if name != task.text.name else task.text
    return name


def _moved(span: Span, source: str, by: int) -> Span:
    return Span(source, span.line + by, span.column, span.end_line + by, span.end_column)
