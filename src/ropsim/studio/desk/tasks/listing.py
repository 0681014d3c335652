"""Tasks and places to choose from, for a page."""

from collections.abc import Iterator, Mapping

from ropsim.studio.desk.tasks.known_project import KnownProject
from ropsim.studio.wire.task_messages import (
    PartPlace,
    PlaceChoice,
    TaskChoice,
    TaskList,
    TaskParameter,
    WorldNow,
)
from ropsim.tasks import (
    UNITS,
    Given,
    KnownTask,
    Parameter,
    WorldState,
    default_text,
    fact_words,
    group_of,
    typed_numbers,
    words,
    world_table,
)
from ropsim.views import plain_findings

MOST_PARTS = 200
"""Number of parts whose places are listed."""


def task_list(known: KnownProject, revision: int) -> TaskList:
    """Return tasks, places and the world before the first step."""
    tasks = tuple(map(_choice, known.knowledge.base.tasks()))
    begin = world_now(known.knowledge.state, {})
    return TaskList(
        revision, tasks, words.KINDS, tuple(_places(known)), begin, plain_findings(known.findings), ""
    )


def world_now(state: WorldState, names: Mapping[Given, str]) -> WorldNow:
    """Return the facts of a state.

    Args:
        state: the facts.
        names: of points that were given by their numbers.
    """
    table = world_table(state, names)
    parts = tuple(PartPlace(part, place) for part, place in table.parts[:MOST_PARTS])
    return WorldNow(table.gripper, table.held, parts, table.others)


def _choice(task: KnownTask) -> TaskChoice:
    needs = tuple(fact_words(one).replace("`", "") for one in task.needs)
    return TaskChoice(task.name, task.doc, group_of(task), needs, tuple(map(_parameter, task.parameters)))


def _parameter(one: Parameter) -> TaskParameter:
    default = "" if one.is_symbolic else default_text(one)
    units = tuple(sorted(UNITS.get(one.kind, ()), key=lambda unit: (unit != one.unit, unit)))
    sentence = ", ".join(filter(None, (one.sentence, *map(str, one.bounds))))
    return TaskParameter(one.name, one.kind, default, units, one.is_symbolic, one.label, sentence)


def _places(known: KnownProject) -> Iterator[PlaceChoice]:
    for name in known.cell.locations if known.cell is not None else ():
        yield PlaceChoice("", name, name, 1)
    for name in known.cell.frames if known.cell is not None else ():
        yield PlaceChoice("", name, f"0, 0, 0 in {name}", 1, frame=True)
    for name, found in known.lists.items():
        yield PlaceChoice(name, "", name, len(found.points))
        for point, numbers in found.points:
            yield PlaceChoice(name, point, " ".join(f"{one:.10g}" for one in typed_numbers(numbers)), 1)
