"""The executable form of a checked text: each procedure by itself, then all of them linked."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from ropsim import icr
from ropsim.core import Diagnostic
from ropsim.language import questions
from ropsim.language.check.tasks import callee_first
from ropsim.language.checked import Checked
from ropsim.language.environment import Environment
from ropsim.language.main_code import begun, joined_at, lowered_parts, passage
from ropsim.language.task_code import GIVEN, lowered, needs_of, procedure, summary
from ropsim.program import Lowered, SourceMap, axes_of, draft_of, findings_of, linked, reached
from ropsim.query import Database


def code_of(checked: Checked, places: SourceMap, db: Database) -> tuple[icr.Program, tuple[Diagnostic, ...]]:
    """Return the ICR of a checked text without errors and without circles of calls, and what is found in it.

    It is that of `ropsim.program.lower_with_findings`.
    """
    guess: int | None = None
    parts, every = _lowered_all(db, guess)
    if any(one.has_guessed_axes for one in (*parts.values(), *every.values())):
        guess = axes_of((*parts.values(), *every.values())) or 1
        parts, every = _lowered_all(db, guess)
    axes = axes_of((*parts.values(), *every.values()))
    main = joined_at(db, parts, guess, 0, places)
    given = icr.given_at_once(draft_of(main)) if every else frozenset()
    db.give({(GIVEN, guess): given})
    calls = {name: one.callees for name, one in every.items()}
    for name in callee_first(calls):  # so that no chain of calls, of text or library, is one of questions
        db.ask(summary, name, guess)
    passages = [(db.ask(passage, unit, guess), len(one.code)) for unit, one in parts.items()]
    needs = icr.needs_of_passages(passages)
    variables = {one.name: one.type for one in checked.program.main_locals}
    findings = findings_of(main, needs, variables, places) if needs else ()
    for name, one in every.items():
        own = db.ask(needs_of, name, guess)
        findings += findings_of(one, own, variables, places) if own else ()
    main_procedure = begun(main, needs, variables, axes, lambda by: joined_at(db, parts, guess, by, places))
    procedures = (main_procedure, *(db.ask(procedure, name, guess, axes) for name in every))
    code = linked(checked.program, (main, *every.values()), procedures, places.source)
    return replace(code, libraries=tuple(_libraries(every.values(), db))), findings


def _lowered_all(db: Database, guess: int | None) -> tuple[dict[str, Lowered], dict[str, Lowered]]:
    """Return the parts of the control statements that are reached, by unit, and the tasks, by name."""
    parts = lowered_parts(db, guess)
    first = dict.fromkeys(name for one in parts.values() for name in one.callees)
    return parts, {one.task: one for one in reached(first, lambda name: db.ask(lowered, name, guess))}


def _libraries(every: Iterable[Lowered], db: Database) -> Iterator[icr.LibraryText]:
    """Yield of which text each procedure of a library was made."""
    environment: Environment = db.read(questions.ENVIRONMENT)
    for one in every:
        found = environment.tasks.get(one.task)
        if found is not None and found.version and not db.ask(questions.is_own, one.task):
            yield icr.LibraryText(one.name, found.source, found.version)
