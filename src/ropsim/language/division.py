"""A text divided into units, chunk by chunk; what is known of the chunks on both sides of an edit stays."""

from collections import Counter
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import accumulate, compress, count
from operator import is_not
from typing import TypeVar

from ropsim.core import Diagnostic, SourceText, Span, frozen_dataclass
from ropsim.language import units
from ropsim.language.check.tasks import TaskText
from ropsim.language.chunk_walk import Step, walk_chunks
from ropsim.language.environment import Environment
from ropsim.language.findings import names as name_kinds
from ropsim.language.joining import Joining
from ropsim.language.report import Report
from ropsim.program import Places, SourceMap, placed
from ropsim.query import Database

T = TypeVar("T")

_TRAIL = "trail of the division"
"""Input: what the last division has passed."""


@frozen_dataclass
class Units:
    """A text in units.

    Attributes:
        tasks: names of its tasks, in order.
        parts: names of the units of what stands outside of them, in order.
        map: where all units lie.
        opener: where the first line with a statement lies, None where there is none.
        new_tasks: tasks that may be others than before, by name; None for one that is gone.
        new_parts: the same of the parts, by unit: their lines and blocks.
        new_places: where units lie that may lie elsewhere than before, by name; None for one that is gone.
    """

    tasks: tuple[str, ...]
    parts: tuple[str, ...]
    map: SourceMap
    opener: Span | None
    new_tasks: Mapping[str, TaskText | None]
    new_parts: Mapping[str, units.Items | None]
    new_places: Mapping[str, Places | None]


@dataclass(slots=True)
class _Trail:
    """What was divided.

    Attributes:
        steps: chunks of the text.
        firsts: line at which each begins, from 1, and the one behind the text.
        found: what is wrong in each.
        task_counts: how many tasks each has.
        part_counts: how many parts end with each.
        free: of each, whether no part goes on behind it.
        tasks: names of all tasks.
        parts: units of all parts.
        begins: how each of them begins, which gives it its name.
        places: where all units lie.
        is_simple: whether each task has a name of its own and some part is not empty.
    """

    steps: list[Step] = field(default_factory=list)
    firsts: list[int] = field(default_factory=lambda: [1])
    found: list[tuple[Diagnostic, ...]] = field(default_factory=list)
    task_counts: list[int] = field(default_factory=list)
    part_counts: list[int] = field(default_factory=list)
    free: list[bool] = field(default_factory=list)
    tasks: tuple[str, ...] = ()
    parts: tuple[str, ...] = ()
    begins: list[str] = field(default_factory=list)
    places: dict[str, Places] = field(default_factory=dict)
    is_simple: bool = False


def divided(source: SourceText, environment: Environment, report: Report, db: Database) -> Units:
    """Return the units of a text; what cannot be read is reported.

    Raises:
        TooManyFindingsError: the list is full.
    """
    steps = walk_chunks(source, environment, db)
    trail: _Trail | None = db.read(_TRAIL)
    if trail is None:
        trail = _Trail()
        db.give({_TRAIL: trail})
    above, below = _remaining(steps, trail.steps)
    firsts = _firsts(steps, trail.firsts, above, below)
    found = _spliced(trail.found, above, [one.found for one in steps[above : len(steps) - below]], below)
    for k in compress(count(), found):
        for finding in found[k]:
            report.add(placed(finding, partial(_moved, source=source.name, by=firsts[k] - 1)))
    opener = _opener(source, steps, firsts)
    made = _again(steps, firsts, trail, above, below, db) if trail.is_simple else None
    made = made or _anew(steps, firsts, trail, db)
    now = SourceMap(source.name, made.places)
    for name, span in made.doubles:
        message = f"task `{name}` is defined twice"
        report.add(name_kinds.DUPLICATE.at(now.span(span), message, hint="rename one of them"))
    trail.steps, trail.firsts, trail.found = steps, firsts, found
    trail.task_counts, trail.part_counts, trail.free = made.task_counts, made.part_counts, made.free
    trail.tasks, trail.parts, trail.begins = made.tasks, made.parts, made.begins
    trail.places, trail.is_simple = made.places, made.is_simple
    return Units(made.tasks, made.parts, now, opener, made.new_tasks, made.new_parts, made.new_places)


def _remaining(steps: Sequence[Step], before: Sequence[Step]) -> tuple[int, int]:
    """Return with how many steps that are the same objects two rows begin, and then end."""
    least = min(len(steps), len(before))
    above = next(compress(count(), map(is_not, steps, before)), least)
    below = next(compress(count(), map(is_not, reversed(steps), reversed(before))), least)
    return above, min(below, least - above)


def _spliced(known: Sequence[T], above: int, between: Sequence[T], below: int) -> list[T]:
    return [*known[:above], *between, *known[len(known) - below :]]


def _firsts(steps: Sequence[Step], known: Sequence[int], above: int, below: int) -> list[int]:
    """Return the line at which each step begins, and the one behind the last."""
    between = (len(one.chunk.lines) for one in steps[above : len(steps) - below])
    found = [*known[:above], *accumulate(between, initial=known[above])]
    rest = known[len(known) - below :] if below else []
    shift = found[-1] - known[len(known) - 1 - below]
    return [*found, *(map(shift.__add__, rest) if shift else rest)]


def _opener(source: SourceText, steps: Sequence[Step], firsts: Sequence[int]) -> Span | None:
    for step, first in zip(steps, firsts, strict=False):
        line = step.read.opener
        if line is not None:
            return _moved(line.logical.span(source.name, line.start, line.end), source.name, first - 1)
    return None


@frozen_dataclass
class _Made:
    """What becomes of the steps, see `_Trail` and `Units`, and the tasks whose name another one has."""

    tasks: tuple[str, ...]
    parts: tuple[str, ...]
    begins: list[str]
    task_counts: list[int]
    part_counts: list[int]
    free: list[bool]
    places: dict[str, Places]
    new_tasks: dict[str, TaskText | None]
    new_parts: dict[str, units.Items | None]
    new_places: dict[str, Places | None]
    is_simple: bool
    doubles: list[tuple[str, Span]]


def _anew(steps: Sequence[Step], firsts: Sequence[int], trail: _Trail, db: Database) -> _Made:
    """Put all steps together."""
    joining = Joining(db)
    for step, first in zip(steps, firsts, strict=False):
        joining.step(step, first)
    if joining.items or not joining.parts:
        joining.end()
    doubles: list[tuple[str, Span]] = []
    tasks: dict[str, TaskText] = {}
    for text, _ in joining.tasks:
        name = text.name
        if name in tasks or not name:
            name = f"#{len(tasks)}"
            if text.name:
                line = text.block.opener
                doubles.append((text.name, line.logical.span(units.of_task(name), line.start, line.end)))
        tasks[name] = replace(text, name=name) if name != text.name else text
    begins = [begin for begin, _, _ in joining.parts]
    parts = _numbered(begins)
    lying = _lying(tuple(tasks), parts, joining, trail.places)
    return _Made(
        tuple(tasks),
        parts,
        begins,
        joining.task_counts,
        joining.part_counts,
        joining.free,
        lying,
        {**_gone(trail.tasks, tasks), **tasks},
        {**_gone(trail.parts, frozenset(parts)), **_items(parts, joining)},
        {**_gone(trail.places, lying), **lying},
        all(name == text.name for name, (text, _) in zip(tasks, joining.tasks, strict=True))
        and bool(joining.parts[-1][1]),
        doubles,
    )


def _again(
    steps: Sequence[Step], firsts: Sequence[int], trail: _Trail, above: int, below: int, db: Database
) -> _Made | None:
    """Put those steps together that are others than before; None where names elsewhere depend on theirs."""
    first = above
    while first and not trail.free[first - 1]:
        first -= 1
    joining, more, end = Joining(db), len(steps) - len(trail.steps), len(steps)
    for k in range(first, len(steps)):
        if k >= len(steps) - below and not joining.items and (k == more or trail.free[k - more - 1]):
            end = k
            break
        joining.step(steps[k], firsts[k])
    last = end - more
    begun = sum(trail.part_counts[:first])
    if end == len(steps) and (joining.items or not begun + len(joining.parts)):
        joining.end()
    of_tasks = slice(sum(trail.task_counts[:first]), sum(trail.task_counts[:last]))
    of_parts = slice(begun, sum(trail.part_counts[:last]) if end < len(steps) else len(trail.parts))
    begins = [begin for begin, _, _ in joining.parts]
    tasks = _named(trail.tasks, of_tasks, tuple(text.name for text, _ in joining.tasks))
    parts = _units(trail, of_parts, begins)
    if tasks is None or parts is None or not begun + len(begins) + len(trail.parts[of_parts.stop :]):
        return None
    own_tasks, own_parts = tuple(text.name for text, _ in joining.tasks), parts
    moved = {}
    shift = firsts[end] - trail.firsts[last]
    if shift and end < len(steps):
        names = (*map(units.of_task, trail.tasks[of_tasks.stop :]), *trail.parts[of_parts.stop :])
        moved = {one: _shifted(trail.places[one], shift) for one in names}
    lying = _lying(own_tasks, own_parts, joining, trail.places)
    gone_tasks = _gone(trail.tasks[of_tasks], frozenset(own_tasks))
    gone_parts = _gone(trail.parts[of_parts], frozenset(own_parts))
    gone = dict.fromkeys((*map(units.of_task, gone_tasks), *gone_parts))
    places = {**trail.places, **lying, **moved}
    for one in gone:
        del places[one]
    return _Made(
        tasks,
        (*trail.parts[: of_parts.start], *parts, *trail.parts[of_parts.stop :])
        if parts != trail.parts[of_parts]
        else trail.parts,
        [*trail.begins[: of_parts.start], *begins, *trail.begins[of_parts.stop :]],
        [*trail.task_counts[:first], *joining.task_counts, *trail.task_counts[last:]],
        [*trail.part_counts[:first], *joining.part_counts, *trail.part_counts[last:]],
        [*trail.free[:first], *joining.free, *trail.free[last:]],
        places,
        {**gone_tasks, **{text.name: text for text, _ in joining.tasks}},
        {**gone_parts, **_items(own_parts, joining)},
        {**gone, **lying, **moved},
        bool(joining.parts[-1][1]) if end == len(steps) and joining.parts else True,
        [],
    )


def _named(before: tuple[str, ...], place: slice, names: tuple[str, ...]) -> tuple[str, ...] | None:
    """Return the names of all tasks with others in a place; None where one is none or another task's."""
    if names == before[place]:
        return before
    others = {*before[: place.start], *before[place.stop :]}
    if "" in names or len(set(names)) < len(names) or not others.isdisjoint(names):
        return None
    return (*before[: place.start], *names, *before[place.stop :])


def _units(trail: _Trail, place: slice, begins: list[str]) -> tuple[str, ...] | None:
    """Return the units of parts in a place; None where others begin as they do, or as those there."""
    known = trail.begins[place]
    if begins == known:
        return trail.parts[place]
    others = {*trail.begins[: place.start], *trail.begins[place.stop :]}
    return _numbered(begins) if others.isdisjoint((*begins, *known)) else None


def _numbered(begins: Sequence[str]) -> tuple[str, ...]:
    """Return the units of parts: how they begin, by a number where parts of that name stand above."""
    names: Counter[str] = Counter()
    found = []
    for name in begins:
        names[name] += 1
        found.append(name if names[name] == 1 else f"{name}.{names[name]}")
    return tuple(found)


def _items(parts: tuple[str, ...], joining: Joining) -> dict[str, units.Items]:
    return {unit: items for unit, (_, items, _) in zip(parts, joining.parts, strict=True)}


def _lying(
    tasks: tuple[str, ...], parts: tuple[str, ...], joining: Joining, known: Mapping[str, Places]
) -> dict[str, Places]:
    """Return where units lie: what is known of one where it lies as it did."""
    found = {units.of_task(name): one for name, (_, one) in zip(tasks, joining.tasks, strict=True)}
    found |= {unit: one for unit, (_, _, one) in zip(parts, joining.parts, strict=True)}
    return {unit: known[unit] if known.get(unit) == one else one for unit, one in found.items()}


def _gone(before: Iterable[str], now: Container[str]) -> dict[str, None]:
    return dict.fromkeys(one for one in before if one not in now)


def _shifted(one: Places, by: int) -> Places:
    return Places(one.first + by, one.offsets)


def _moved(span: Span, source: str, by: int) -> Span:
    return Span(source, span.line + by, span.column, span.end_line + by, span.end_column)
