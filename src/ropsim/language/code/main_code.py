"""The executable form of the control statements, part by part."""

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import accumulate, chain

from ropsim import icr
from ropsim.core import frozen_dataclass
from ropsim.icr import Need, Type
from ropsim.language import questions
from ropsim.language.code.task_code import known_names, procedure_name, summary
from ropsim.language.environment import Environment
from ropsim.language.questions import Group, part_groups
from ropsim.program import (
    Block,
    Lowered,
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
_TRAIL = "trail of the code of the control statements"
"""Input: records of the last lowering."""
START, END = "start of the control statements", "end of the control statements"
"""Names of the units before and behind all parts."""


@dataclass(slots=True)
class _Trail:
    """Records of the lowering: hidden names before the groups of parts, as set as inputs of the parts."""

    numbers: dict[Group, dict[str, int]] = field(default_factory=dict)


@frozen_dataclass
class LoweredParts:
    """Parts of the control statements that follow each other.

    Attributes:
        whole: all of them lowered as one, without lines.
        parts: reachable parts, each lowered alone.
        jumps: which instructions of `whole` are jumps.
    """

    whole: Lowered
    parts: tuple[Lowered, ...]
    jumps: tuple[int, ...]


def lowered_groups(db: Database, guess: int | None) -> dict[Group, LoweredParts]:
    """Return the groups of parts of the control statements that are reached, each lowered as one."""
    found: dict[Group, LoweredParts] = {(START,): db.ask(lowered_in, (START,), guess)}
    trail = db.auxiliary(_TRAIL, _Trail)
    before: dict[Group, dict[str, int]] = {}
    numbers: dict[str, int] = {}
    for group in (*db.ask(part_groups), (END,)):
        is_known = group in trail.numbers and trail.numbers[group] == numbers
        before[group] = dict(numbers)
        if not is_known or db.known(lowered_in, group, guess) is None:
            _give_numbers(db, group, guess, numbers)
        one = found[group] = db.ask(lowered_in, group, guess)
        numbers |= one.whole.numbers
        if not one.whole.goes_on:
            break
    trail.numbers = before
    return found


def _give_numbers(db: Database, group: Group, guess: int | None, before: Mapping[str, int]) -> None:
    """Set the numbers of hidden names before the parts of a group as inputs."""
    numbers = dict(before)
    for unit in group:
        if unit != END and db.read((HIDDEN, unit)) != numbers:
            db.give({(HIDDEN, unit): dict(numbers)})
        one = db.ask(lowered_part, unit, guess)
        numbers |= one.numbers
        if not one.goes_on:
            return


def given_at_once(groups: Iterable[Lowered]) -> frozenset[icr.Slot]:
    """Return the global variables that have a value before any task is called."""
    parts = [*groups]
    hidden = {one.name for part in parts for one in part.hidden}
    return icr.given_at_once(chain.from_iterable(part.code for part in parts), hidden)


def started_by(
    needs: Sequence[Need], groups: Iterable[Lowered], variables: Mapping[str, Type], axes: int | None
) -> tuple[icr.Step, ...]:
    """Return the steps that initialise variables without a value, at the start of the control statements."""
    hidden = {one.name: one.type for part in groups for one in part.hidden} if needs else {}
    return prologue(needs, {**variables, **hidden}, axes)


def with_start(main: Lowered, start: tuple[icr.Step, ...]) -> icr.Procedure:
    """Return the control statements behind the initialising steps as a procedure."""
    variables = main.locals + main.hidden
    code, lines = start + main.code if start else main.code, (0,) * len(start) + main.lines
    return icr.Procedure(main.name, main.parameters, variables, main.results, code, lines)


def lowered_start(db: Database, axes: int | None) -> Lowered:
    """Return the steps before the control statements."""
    environment: Environment = db.read(questions.ENVIRONMENT)
    return lower_start(known_names(db, axes), db.ask(questions.basics).frame, environment.default_tool)


def lowered_part(db: Database, unit: str, axes: int | None) -> Lowered:
    """Return a part of the control statements, lowered alone."""
    if unit in {START, END}:
        return db.ask(lowered_start, axes) if unit == START else lower_end(known_names(db, axes))
    block: Block = db.read((questions.BLOCK, unit))
    return lower_part(known_names(db, axes), block, lambda purpose: db.read((HIDDEN, unit)).get(purpose, 0))


@always_new
def lowered_in(db: Database, group: Group, axes: int | None) -> LoweredParts:
    """Return the parts of a group that are reached."""
    found = reached_parts(db, group, axes)
    code: list[icr.Step] = []
    jumps: list[int] = []
    numbers: dict[str, int] = {}
    for unit, one in found:
        own = db.ask(jumps_of, unit, axes)
        jumps += map(len(code).__add__, own)
        code += shifted(one.code, len(code), own)
        numbers |= one.numbers
    parts = tuple(one for _, one in found)
    whole = replace(joined(parts, tuple(code), ()), numbers=numbers, goes_on=parts[-1].goes_on)
    return LoweredParts(whole, parts, tuple(jumps))


def reached_parts(db: Database, group: Group, axes: int | None) -> list[tuple[str, Lowered]]:
    """Return the parts of a group that are reached, with their units."""
    found = []
    for unit in group:
        found.append((unit, db.ask(lowered_part, unit, axes)))
        if not found[-1][1].goes_on:
            break
    return found


def jumps_of(db: Database, unit: str, axes: int | None) -> tuple[int, ...]:
    """Return which instructions of a part are jumps."""
    return jumps_in(db.ask(lowered_part, unit, axes).code)


def passage(db: Database, unit: str, axes: int | None) -> icr.Passage:
    """Return the effect of a part on variables."""
    one = db.ask(lowered_part, unit, axes)
    called = {db.ask(procedure_name, task, axes): db.ask(summary, task, axes) for task in one.callees}
    return icr.passage(draft_of(one), called)


def passage_in(db: Database, group: Group, axes: int | None) -> icr.Passage:
    """Return the effect of a group of parts on variables."""
    reached = reached_parts(db, group, axes)
    return icr.joint_passage((db.ask(passage, unit, axes), len(one.code)) for unit, one in reached)


def read_in(groups: Iterable[LoweredParts], needs: Sequence[Need]) -> Iterator[tuple[Lowered, Need]]:
    """Yield each variable that may be read before it has a value with the part that reads it, counted there.

    Args:
        groups: of the control statements.
        needs: of them, counted in the code of all.
    """
    parts = [part for one in groups for part in one.parts] if needs else []
    ends = [*accumulate(len(one.code) for one in parts)]
    for need in needs:
        place = bisect_right(ends, need.at)
        before = ends[place - 1] if place else 0
        yield parts[place], need._replace(at=need.at - before)
