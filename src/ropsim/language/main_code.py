"""The executable form of the control statements, part by part."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from ropsim import icr
from ropsim.icr import Need, Type
from ropsim.language import questions
from ropsim.language.environment import Environment
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
from ropsim.query import Database

HIDDEN = "hidden names before a part"
"""Input with the unit of a part: number of the newest hidden name of each purpose that stands before it."""
START, END = "start of the control statements", "end of the control statements"
"""Stand for the unit of a part in what comes before and behind all of them."""


def lowered_parts(db: Database, guess: int | None) -> dict[str, Lowered]:
    """Return the parts of the control statements that are reached, lowered, by their units."""
    parts = {START: db.ask(lowered_start, guess)}
    numbers: dict[str, int] = {}
    for unit in (*db.read(questions.PARTS), END):
        if unit != END and db.read((HIDDEN, unit)) != numbers:
            db.give({(HIDDEN, unit): dict(numbers)})
        one = db.ask(lowered_part, unit, guess)
        parts[unit] = one
        numbers |= one.numbers
        if not one.goes_on:
            break
    return parts


def joined_at(
    db: Database, parts: Mapping[str, Lowered], guess: int | None, by: int, places: SourceMap
) -> Lowered:
    """Return the control statements as one procedure that begins with its instruction `by`."""
    found = []
    for unit, one in parts.items():
        found.append((one, db.ask(code_at, unit, guess, by), db.ask(lines_of, unit, guess)))
        by += len(one.code)
    return joined(found, places.source)


def begun(
    main: Lowered,
    needs: Sequence[Need],
    variables: Mapping[str, Type],
    axes: int | None,
    moved: Callable[[int], Lowered],
) -> icr.Procedure:
    """Return the control statements as a procedure with values at its start."""
    if not needs:
        return replace(draft_of(main), lines=main.lines)
    types = {**variables, **{one.name: one.type for one in main.hidden}}
    start = prologue(needs, types, axes)
    draft = draft_of(main)
    return replace(draft, code=(*start, *moved(len(start)).code), lines=(0,) * len(start) + main.lines)


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


def code_at(db: Database, unit: str, axes: int | None, start: int) -> tuple[icr.Step, ...]:
    """Return the code of a part that begins at an instruction."""
    return shifted(db.ask(lowered_part, unit, axes).code, start, db.ask(jumps_of, unit, axes))


def jumps_of(db: Database, unit: str, axes: int | None) -> tuple[int, ...]:
    """Return which instructions of a part are jumps."""
    return jumps_in(db.ask(lowered_part, unit, axes).code)


def lines_of(db: Database, unit: str, axes: int | None) -> tuple[int, ...]:
    """Return the source lines of the code of a part."""
    return placed_lines(db, db.ask(lowered_part, unit, axes))


def passage(db: Database, unit: str, axes: int | None) -> icr.Passage:
    """Return what a part does with variables."""
    one = db.ask(lowered_part, unit, axes)
    called = {db.ask(procedure_name, task, axes): db.ask(summary, task, axes) for task in one.callees}
    return icr.passage(draft_of(one), called)
