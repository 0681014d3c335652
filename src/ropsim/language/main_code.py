"""The executable form of the control statements, part by part."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from ropsim import icr
from ropsim.icr import Need, Type
from ropsim.language import questions
from ropsim.language.environment import Environment
from ropsim.language.questions import Group, part_groups
from ropsim.language.task_code import known_names, placed_lines, procedure_name, summary
from ropsim.program import (
    Block,
    Lowered,
    SourceMap,
    draft_of,
    joined,
    jumps_in,
    lower_end,
    lower_part,
    lower_start,
    prologue,
    shifted,
)
from ropsim.query import Database, always_new

HIDDEN = "hidden names before a part"
"""Input with the unit of a part: number of the newest hidden name of each purpose that stands before it."""
REACHED = "groups of parts that are reached"
"""Input with what `lowered_part` is told of axes."""
_TRAIL = "trail of the code of the control statements"
"""Input: what the last lowering has passed."""
START, END = "start of the control statements", "end of the control statements"
"""Stand for the unit of a part in what comes before and behind all of them."""


@dataclass(slots=True)
class _Trail:
    """What hidden names stand before the groups of parts, as the inputs of their parts tell."""

    numbers: dict[Group, dict[str, int]] = field(default_factory=dict)


def lowered_groups(db: Database, guess: int | None) -> dict[Group, Lowered]:
    """Return the groups of parts of the control statements that are reached, each lowered as one."""
    found: dict[Group, Lowered] = {(START,): db.ask(lowered_in, (START,), guess)}
    trail = db.beside(_TRAIL, _Trail)
    before: dict[Group, dict[str, int]] = {}
    numbers: dict[str, int] = {}
    for group in (*db.ask(part_groups), (END,)):
        is_known = group in trail.numbers and trail.numbers[group] == numbers
        before[group] = dict(numbers)
        if not is_known or db.known(lowered_in, group, guess) is None:
            _give_numbers(db, group, guess, numbers)
        one = found[group] = db.ask(lowered_in, group, guess)
        numbers |= one.numbers
        if not one.goes_on:
            break
    trail.numbers = before
    db.give({(REACHED, guess): tuple(found)})
    return found


def _give_numbers(db: Database, group: Group, guess: int | None, before: Mapping[str, int]) -> None:
    """Let the parts of a group be told which hidden names stand before them."""
    numbers = dict(before)
    for unit in group:
        if unit != END and db.read((HIDDEN, unit)) != numbers:
            db.give({(HIDDEN, unit): dict(numbers)})
        one = db.ask(lowered_part, unit, guess)
        numbers |= one.numbers
        if not one.goes_on:
            return


def joined_at(
    db: Database, groups: Mapping[Group, Lowered], guess: int | None, by: int, places: SourceMap
) -> Lowered:
    """Return the control statements as one procedure that begins with its instruction `by`."""
    code: list[icr.Step] = []
    for group, one in groups.items():
        code += db.ask(code_at, group, guess, by)
        by += len(one.code)
    lines = db.ask(main_lines, guess)
    return joined(tuple(groups.values()), tuple(code), lines, places.source)


@always_new
def main_lines(db: Database, guess: int | None) -> tuple[int, ...]:
    """Return the source lines of the code of the control statements."""
    groups: tuple[Group, ...] = db.read((REACHED, guess))
    found: list[int] = []
    for group in groups:
        found += db.ask(lines_in, group, guess)
    return tuple(found)


def unbegun(main: Lowered) -> icr.Procedure:
    """Return the control statements as a procedure in which variables may be read without a value."""
    variables = main.locals + main.hidden
    return icr.Procedure(main.name, main.parameters, variables, main.results, main.code, main.lines)


def begun(
    main: Lowered,
    needs: Sequence[Need],
    variables: Mapping[str, Type],
    axes: int | None,
    moved: Callable[[int], Lowered],
) -> icr.Procedure:
    """Return the control statements as a procedure with values at its start."""
    if not needs:
        return unbegun(main)
    types = {**variables, **{one.name: one.type for one in main.hidden}}
    start = prologue(needs, types, axes)
    code, lines = (*start, *moved(len(start)).code), (0,) * len(start) + main.lines
    return replace(unbegun(main), code=code, lines=lines)


def lowered_start(db: Database, axes: int | None) -> Lowered:
    """Return what stands before the control statements."""
    environment: Environment = db.read(questions.ENVIRONMENT)
    return lower_start(known_names(db, axes), db.ask(questions.basics).frame, environment.default_tool)


def lowered_part(db: Database, unit: str, axes: int | None) -> Lowered:
    """Return a part of the control statements, lowered alone."""
    if unit in {START, END}:
        return db.ask(lowered_start, axes) if unit == START else lower_end(known_names(db, axes))
    block: Block = db.read((questions.BLOCK, unit))
    return lower_part(known_names(db, axes), block, lambda purpose: db.read((HIDDEN, unit)).get(purpose, 0))


@always_new
def lowered_in(db: Database, group: Group, axes: int | None) -> Lowered:
    """Return the parts of a group that are reached, as one part."""
    found = _reached(db, group, axes)
    code: list[icr.Step] = []
    numbers: dict[str, int] = {}
    for unit, one in found:
        code += shifted(one.code, len(code), db.ask(jumps_of, unit, axes))
        numbers |= one.numbers
    parts = [one for _, one in found]
    return replace(joined(parts, tuple(code), ()), numbers=numbers, goes_on=parts[-1].goes_on)


def _reached(db: Database, group: Group, axes: int | None) -> list[tuple[str, Lowered]]:
    """Return the parts of a group that are reached, with their units."""
    found = []
    for unit in group:
        found.append((unit, db.ask(lowered_part, unit, axes)))
        if not found[-1][1].goes_on:
            break
    return found


@always_new
def code_at(db: Database, group: Group, axes: int | None, start: int) -> tuple[icr.Step, ...]:
    """Return the code of a group of parts that begins at an instruction."""
    return shifted(db.ask(lowered_in, group, axes).code, start, db.ask(jumps_in_group, group, axes))


def jumps_of(db: Database, unit: str, axes: int | None) -> tuple[int, ...]:
    """Return which instructions of a part are jumps."""
    return jumps_in(db.ask(lowered_part, unit, axes).code)


def jumps_in_group(db: Database, group: Group, axes: int | None) -> tuple[int, ...]:
    """Return which instructions of a group of parts are jumps."""
    at = 0
    found: list[int] = []
    for unit, one in _reached(db, group, axes):
        found += map(at.__add__, db.ask(jumps_of, unit, axes))
        at += len(one.code)
    return tuple(found)


def lines_in(db: Database, group: Group, axes: int | None) -> tuple[int, ...]:
    """Return the source lines of the code of a group of parts."""
    found: list[int] = []
    for unit in group:
        name, lines, goes_on = db.ask(lines_of, unit, axes)
        found += placed_lines(db, name, lines)
        if not goes_on:
            break
    return tuple(found)


def lines_of(db: Database, unit: str, axes: int | None) -> tuple[str, tuple[int, ...], bool]:
    """Return of the code of a part whose lines it has, which ones, and whether its end is reached."""
    one = db.ask(lowered_part, unit, axes)
    return one.unit, one.lines, one.goes_on


def passage(db: Database, unit: str, axes: int | None) -> icr.Passage:
    """Return what a part does with variables."""
    one = db.ask(lowered_part, unit, axes)
    called = {db.ask(procedure_name, task, axes): db.ask(summary, task, axes) for task in one.callees}
    return icr.passage(draft_of(one), called)


def passage_in(db: Database, group: Group, axes: int | None) -> icr.Passage:
    """Return what a group of parts does with variables."""
    reached = _reached(db, group, axes)
    return icr.joint_passage((db.ask(passage, unit, axes), len(one.code)) for unit, one in reached)
