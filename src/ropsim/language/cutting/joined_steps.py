"""Steps put together to units: all of them, or those around an edit while the others stay unchanged."""

from collections import Counter
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.language.blocks import units
from ropsim.language.check.calls.tasks import TaskText
from ropsim.language.cutting.chunk_walk import Step
from ropsim.language.cutting.joining import Joining
from ropsim.program import Places
from ropsim.query import Database, Splice


@dataclass(slots=True)
class Trail:
    """Record of the division.

    Attributes:
        steps: chunks of the text.
        firsts: line at which each begins, from 1, and the one behind the text.
        found: findings in each.
        task_counts: how many tasks each has.
        part_counts: how many parts end with each.
        free: of each, whether no part goes on behind it.
        tasks: names of all tasks.
        parts: units of all parts.
        begins: how each of them begins, which determines its name.
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


@frozen_dataclass
class Made:
    """Units made of the steps, see `Trail` and `Units`, and the tasks with a duplicate name."""

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


def joined_anew(steps: Sequence[Step], firsts: Sequence[int], trail: Trail, db: Database) -> Made:
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
    return Made(
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


def joined_again(
    steps: Sequence[Step], firsts: Sequence[int], trail: Trail, unchanged: Splice, db: Database
) -> Made | None:
    """Put those steps together that are others than before; None where names elsewhere depend on theirs."""
    first = unchanged.above
    while first and not trail.free[first - 1]:
        first -= 1
    joining, more, end = Joining(db), len(steps) - len(trail.steps), len(steps)
    for k in range(first, len(steps)):
        is_below = k >= len(steps) - unchanged.below
        if is_below and not joining.items and (k == more or trail.free[k - more - 1]):
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
    own_parts = _units(trail, of_parts, begins)
    if tasks is None or own_parts is None or not begun + len(begins) + len(trail.parts[of_parts.stop :]):
        return None
    own_tasks = tuple(text.name for text, _ in joining.tasks)
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
    return Made(
        tasks,
        (*trail.parts[: of_parts.start], *own_parts, *trail.parts[of_parts.stop :])
        if own_parts != trail.parts[of_parts]
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


def _units(trail: Trail, place: slice, begins: list[str]) -> tuple[str, ...] | None:
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
    """Return where units lie: the known places of units that have not moved."""
    found = {units.of_task(name): one for name, (_, one) in zip(tasks, joining.tasks, strict=True)}
    found |= {unit: one for unit, (_, _, one) in zip(parts, joining.parts, strict=True)}
    return {unit: known[unit] if known.get(unit) == one else one for unit, one in found.items()}


def _gone(before: Iterable[str], now: Container[str]) -> dict[str, None]:
    return dict.fromkeys(one for one in before if one not in now)


def _shifted(one: Places, by: int) -> Places:
    return Places(one.first + by, one.offsets)
