"""Executable form of a checked text, each procedure separately, and findings in its instructions."""

from collections.abc import Iterable, Iterator
from functools import partial
from itertools import chain

from ropsim import icr
from ropsim.core import Diagnostic
from ropsim.language import questions
from ropsim.language.checked import Checked
from ropsim.language.code.main_code import (
    LoweredParts,
    given_at_once,
    lowered_groups,
    passage_in,
    read_in,
    started_by,
)
from ropsim.language.code.placing import PlacedCode
from ropsim.language.code.program_code import Code, CodeParts, put_together
from ropsim.language.code.task_code import GIVEN, lowered, procedure_name, ready
from ropsim.language.code.task_codes import (
    FIRST,
    find_summaries,
    made_in,
    needs_in,
    reached_groups,
    summary_groups,
    usage_in,
)
from ropsim.language.environment import Environment
from ropsim.language.questions import Group
from ropsim.program import (
    SourceMap,
    Usage,
    axes_of,
    axes_with_starts,
    declared_of,
    findings_of,
    joint_usage,
    linked,
)
from ropsim.query import Database

Groups = tuple[Group, ...]

VARIABLES = "global variables"
"""Input: spans of the whole text and of the control statements."""
_PLACED = "placed code"
"""Input: result of the last placing."""


def code_of(checked: Checked, places: SourceMap, db: Database) -> tuple[Code, tuple[Diagnostic, ...]]:
    """Return the ICR of a checked text without errors and without circles of calls, and the findings in it.

    It is that of `ropsim.program.lower_with_findings`.
    """
    guess: int | None = None
    parts, groups, usage = _lowered_all(db, guess)
    if usage.has_guessed_axes:
        guess = axes_of((usage,)) or 1
        parts, groups, usage = _lowered_all(db, guess)
    axes = axes_of((usage,))
    wholes = [one.whole for one in parts.values()]
    db.give({(GIVEN, guess): given_at_once(wholes) if groups else frozenset()})
    for group in db.ask(summary_groups, guess):
        db.ask(find_summaries, group, guess)
    passages = ((db.ask(passage_in, group, guess), len(one.whole.code)) for group, one in parts.items())
    needs = icr.needs_of_passages(passages)
    missing = tuple(chain.from_iterable(db.ask(needs_in, group, guess) for group in groups))
    variables = {one.name: one.type for one in checked.program.main_locals} if needs or missing else {}
    start = started_by(needs, wholes, variables, axes)
    findings: list[Diagnostic] = []
    for part, need in read_in(parts.values(), needs):
        findings += findings_of(part, (need,), variables, places)
    for name, own in missing:
        findings += findings_of(db.ask(lowered, name, guess), own, variables, places)
    tasks = {group: db.ask(made_in, group, guess, axes) for group in groups}
    begun_ones = ((db.ask(lowered, name, guess), db.ask(ready, name, guess, axes)) for name, _ in missing)
    starts = (one.code[: len(one.code) - len(draft.code)] for draft, one in begun_ones)
    every_axes = axes_with_starts(axes, (start, *starts))
    libraries = tuple(_libraries(chain.from_iterable(groups), guess, db))
    db.give({VARIABLES: checked.program.main_locals})
    declared = db.ask(declared_variables)
    header = linked(checked.program, usage, (), every_axes, declared, places.source, libraries)
    made_of = CodeParts(start, parts, tasks, places, db.auxiliary(_PLACED, PlacedCode))
    return Code(header, partial(put_together, header, made_of)), tuple(findings)


def declared_variables(db: Database) -> tuple[icr.Variable, ...]:
    """Return the global variables as the code declares them."""
    return declared_of(db.read(VARIABLES))


def _lowered_all(db: Database, guess: int | None) -> tuple[dict[Group, LoweredParts], Groups, Usage]:
    """Return the control statements and the tasks that are reached, in groups, and the combined usage."""
    parts = lowered_groups(db, guess)
    wholes = [one.whole for one in parts.values()]
    db.give({(FIRST, guess): tuple(dict.fromkeys(name for one in wholes for name in one.callees))})
    groups = db.ask(reached_groups, guess)
    used = (db.ask(usage_in, group, guess) for group in groups)
    return parts, groups, joint_usage((*wholes, *used))


def _libraries(names: Iterable[str], guess: int | None, db: Database) -> Iterator[icr.LibraryText]:
    """Yield of which text each procedure of a library was made."""
    environment: Environment = db.read(questions.ENVIRONMENT)
    for task in names if environment.tasks else ():
        found = environment.tasks.get(task)
        if found is not None and found.version and not db.ask(questions.is_own, task):
            yield icr.LibraryText(db.ask(procedure_name, task, guess), found.source, found.version)
