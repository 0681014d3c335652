"""The executable form of a checked text: each procedure by itself, then all of them linked."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from ropsim import icr
from ropsim.core import Diagnostic
from ropsim.icr import Need, Type
from ropsim.language import questions
from ropsim.language.check.table import Table
from ropsim.language.check.tasks import callee_first
from ropsim.language.check.types import Type as KnownType
from ropsim.language.check.types import known
from ropsim.language.check.world import Variable
from ropsim.language.checked import Checked
from ropsim.language.environment import Environment
from ropsim.program import (
    Known,
    Local,
    Lowered,
    Places,
    SignalUse,
    SourceMap,
    Task,
    axes_of,
    draft_of,
    findings_of,
    linked,
    lower_control,
    lower_task,
    placed_lines,
    reached,
    started,
)
from ropsim.query import Database

MAIN = ""
"""Stands for the control statements where others give the name of a task."""
GIVEN = "given at once"
"""Input, as `given_at_once` tells it."""


def code_of(checked: Checked, places: SourceMap, db: Database) -> tuple[icr.Program, tuple[Diagnostic, ...]]:
    """Return the ICR of a checked text without errors and without circles of calls, and what is found in it.

    It is that of `ropsim.program.lower_with_findings`.
    """
    guess: int | None = None
    every = reached(db.ask(lowered, MAIN, guess), lambda name: db.ask(lowered, name, guess))
    if any(one.has_guessed_axes for one in every.values()):
        guess = axes_of(every.values()) or 1
        every = reached(db.ask(lowered, MAIN, guess), lambda name: db.ask(lowered, name, guess))
    axes = axes_of(every.values())
    tasks = {one.task: one for one in every.values()}
    db.give({(GIVEN, guess): db.ask(given_at_once, guess)})
    calls = {name: one.callees for name, one in tasks.items()}
    for name in callee_first(calls):  # so that no chain of calls, of text or library, is one of questions
        db.ask(summary, name, guess)
    procedures = tuple(db.ask(procedure, name, guess, axes) for name in tasks)
    findings: tuple[Diagnostic, ...] = ()
    variables = {one.name: one.type for one in checked.program.main_locals}
    for name, one in tasks.items():
        needs = db.ask(needs_of, name, guess)
        findings += findings_of(one, needs, variables, places) if needs else ()
    code = linked(checked.program, tuple(every.values()), procedures, places.source)
    return replace(code, libraries=tuple(_libraries(every.values(), db))), findings


def _libraries(every: Iterable[Lowered], db: Database) -> Iterator[icr.LibraryText]:
    """Yield of which text each procedure of a library was made."""
    environment: Environment = db.read(questions.ENVIRONMENT)
    for one in every:
        found = environment.tasks.get(one.task)
        if found is not None and found.version and not db.ask(questions.is_own, one.task):
            yield icr.LibraryText(one.name, found.source, found.version)


def interface(db: Database, name: str) -> Task | None:
    """Return a task of text or library without what is inside of it."""
    if db.ask(questions.is_own, name):
        task = db.ask(questions.checked, name).task
    else:
        environment: Environment = db.read(questions.ENVIRONMENT)
        task = environment.tasks[name].task if name in environment.tasks else None
    return replace(task, body=(), locals=(), contracts=()) if task is not None else None


def signal(db: Database, name: str) -> SignalUse | None:
    """Return a signal of the text or its cell."""
    found = db.ask(questions.symbol, name)
    return found if isinstance(found, SignalUse) else None


def variable(db: Database, name: str) -> Type | None:
    """Return the type of a global variable, or of one of the control statements."""
    found = db.ask(questions.symbol, name)
    if isinstance(found, Variable):
        kind = known(found.type)
        assert isinstance(kind, KnownType)
        return kind.value
    return db.ask(control_types).get(name)


def control_types(db: Database) -> Mapping[str, Type]:
    """Return the types of the variables of the control statements."""
    own: tuple[Local, ...] = db.read(questions.CONTROL_LOCALS)
    return {one.name: one.type for one in own}


def lowered(db: Database, name: str, axes: int | None) -> Lowered:
    """Return a task of text or library, or the control statements, lowered alone.

    Args:
        db: holds the text.
        name: of the task.
        axes: how many joint coordinates there are, where the procedures have told.
    """
    environment: Environment = db.read(questions.ENVIRONMENT)
    names = Known(
        Table(lambda one: db.ask(interface, one), lambda: (*db.read(questions.TASKS), *environment.tasks)),
        Table(lambda one: db.ask(signal, one), lambda: db.ask(questions.names_in, "symbols")),
        Table(lambda one: db.ask(variable, one), lambda: db.ask(questions.names_in, "symbols")),
        Table(lambda one: db.ask(questions.frame, one), lambda: db.ask(questions.names_in, "frames")),
        axes,
    )
    if name == MAIN:
        frame = db.ask(questions.basics).frame
        return lower_control(names, db.ask(questions.checked_control).block, frame, environment.default_tool)
    own = db.ask(questions.checked, name).task if db.ask(questions.is_own, name) else None
    return lower_task(names, own if own is not None else environment.tasks[name].task)


def procedure_name(db: Database, name: str, axes: int | None) -> str:
    """Return the name of the procedure of a task."""
    return db.ask(lowered, name, axes).name


def draft(db: Database, name: str, axes: int | None) -> icr.Procedure:
    """Return the procedure in which variables may be read before they have a value."""
    return draft_of(db.ask(lowered, name, axes))


def given_at_once(db: Database, axes: int | None) -> frozenset[icr.Slot]:
    """Return the global variables that have a value before any task is called."""
    return icr.given_at_once(db.ask(draft, MAIN, axes))


def summary(db: Database, name: str, axes: int | None) -> icr.Summary:
    """Return what a procedure, and all that it calls, does with variables."""
    one = db.ask(lowered, name, axes)
    called = {db.ask(procedure_name, task, axes): db.ask(summary, task, axes) for task in one.callees}
    given: frozenset[icr.Slot] = db.read((GIVEN, axes)) if name != MAIN else frozenset()
    return icr.summary(db.ask(draft, name, axes), called, given)


def needs_of(db: Database, name: str, axes: int | None) -> tuple[Need, ...]:
    """Return the variables of a procedure that may be read before they have a value."""
    return icr.refused_needs(db.ask(lowered, name, axes).name, db.ask(summary, name, axes))


def ready(db: Database, name: str, guess: int | None, axes: int | None) -> icr.Procedure:
    """Return a procedure with values at its start, without source lines."""
    needs = db.ask(needs_of, name, guess)
    names = dict.fromkeys(need.slot.name for need in needs)
    found = {one: db.ask(variable, one) for one in names}
    types = {one: kind for one, kind in found.items() if kind is not None}
    return started(db.ask(draft, name, guess), needs, types, axes)


def procedure(db: Database, name: str, guess: int | None, axes: int | None) -> icr.Procedure:
    """Return a procedure with its source lines."""
    one, done = db.ask(lowered, name, guess), db.ask(ready, name, guess, axes)
    places: Places | None = db.read(("places", one.unit))
    units = {one.unit: places} if places is not None else {}
    return replace(done, lines=placed_lines(one, done, SourceMap("", units)))
