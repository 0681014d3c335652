"""A text divided into units, chunk by chunk."""

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from functools import partial

from ropsim.core import SourceText, Span
from ropsim.language import units
from ropsim.language.check.tasks import TaskText
from ropsim.language.chunk_walk import Step, walk_chunks
from ropsim.language.environment import Environment
from ropsim.language.findings import names as name_kinds
from ropsim.language.reading import Task, alone_of, control_of
from ropsim.language.report import Report
from ropsim.program import Places, SourceMap, placed
from ropsim.query import Database

MOST_ITEMS = 256
"""Of a part of the control statements, unless they are of one piece."""


@dataclass(slots=True)
class Units:
    """A text in units.

    Attributes:
        tasks: by name, in order.
        parts: what stands outside of them.
        map: where they lie.
        opener: where the first line with a statement lies, None where there is none.
    """

    tasks: dict[str, TaskText] = field(default_factory=dict)
    parts: list[units.Part] = field(default_factory=list)
    map: SourceMap = field(default_factory=lambda: SourceMap(""))
    opener: Span | None = None


def divided(source: SourceText, environment: Environment, report: Report, db: Database) -> Units:
    """Return the units of a text; what cannot be read is reported.

    Raises:
        TooManyFindingsError: the list is full.
    """
    return _joined(source, walk_chunks(source, environment, db), report, db)


def _joined(source: SourceText, steps: Iterable[Step], report: Report, db: Database) -> Units:
    """Return the units of all chunks.

    Raises:
        TooManyFindingsError: the list is full.
    """
    result = Units()
    places: dict[str, Places] = {}
    open_part = _OpenPart()
    names: Counter[str] = Counter()
    doubles: list[tuple[str, Span]] = []
    for step in steps:
        chunk, key, one = step.chunk, step.key, step.read
        for finding in one.found:
            report.add(placed(finding, partial(_moved, source=source.name, by=chunk.first - 1)))
        if result.opener is None and one.opener is not None:
            line = one.opener
            span = line.logical.span(source.name, line.start, line.end)
            result.opener = _moved(span, source.name, chunk.first - 1)
        for task in one.tasks:
            name = _entered(result.tasks, task, doubles)
            unit = units.of_task(name)
            places[unit] = _places(unit, chunk.first, task.places, db)
        if not one.control:
            continue
        if not open_part.items:
            alone = db.ask(alone_of, key)
            if chunk.ends_part or alone.ends or len(alone.items) >= MOST_ITEMS:
                unit = _entered_part(alone.name, alone.items, result, names)
                places[unit] = _places(unit, chunk.first + alone.first, alone.offsets, db)
                continue
        items, offsets, ends = db.ask(control_of, key, len(open_part.offsets))
        open_part.items += items
        open_part.offsets += [chunk.first + offset for offset in offsets]
        if chunk.ends_part or ends or len(open_part.items) >= MOST_ITEMS:
            _end_part(open_part, result, places, names)
            open_part = _OpenPart()
    if open_part.items or not result.parts:
        _end_part(open_part, result, places, names)
    result.map = SourceMap(source.name, places)
    for name, span in doubles:
        message = f"task `{name}` is defined twice"
        report.add(name_kinds.DUPLICATE.at(result.map.span(span), message, hint="rename one of them"))
    return result


def _places(unit: str, first: int, offsets: tuple[int, ...], db: Database) -> Places:
    """Return where the lines of a unit lie: what is known of it where it lies as it did."""
    known: Places | None = db.read(("places", unit))
    is_known = known is not None and known.first == first and known.offsets == offsets
    return known if known is not None and is_known else Places(first, offsets)


@dataclass(slots=True)
class _OpenPart:
    """A part of the control statements that more may come to.

    Attributes:
        items: its lines and blocks so far.
        offsets: where its lines lie.
    """

    items: units.Items = ()
    offsets: list[int] = field(default_factory=list)


def _end_part(part: _OpenPart, result: Units, places: dict[str, Places], names: Counter[str]) -> None:
    """Enter a part of several chunks."""
    unit = _entered_part(units.name_of(part.items), part.items, result, names)
    first = part.offsets[0] if part.offsets else 0
    places[unit] = Places(first, tuple(offset - first for offset in part.offsets))


def _entered_part(name: str, items: units.Items, result: Units, names: Counter[str]) -> str:
    """Enter a part and return its unit, by its number where parts of that name stand above it."""
    names[name] += 1
    unit = name if names[name] == 1 else f"{name}.{names[name]}"
    result.parts.append(units.Part(unit, items))
    return unit


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
