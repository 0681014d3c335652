"""The executable form of each task of a text separately."""

from dataclasses import replace

from ropsim import icr
from ropsim.icr import Need, Type
from ropsim.language import questions
from ropsim.language.check.scope.table import Table
from ropsim.language.check.scope.types import Type as KnownType
from ropsim.language.check.scope.types import known
from ropsim.language.check.scope.world import Variable
from ropsim.language.environment import Environment
from ropsim.program import Known, Lowered, SignalUse, Task, draft_of, lower_task, started
from ropsim.query import Database

GIVEN = "given at once"
"""Input: the global variables that have a value before any task is called."""


def interface(db: Database, name: str) -> Task | None:
    """Return a task of text or library without its body."""
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
    own: Type | None = db.read((questions.CONTROL_LOCAL, name))
    return own


def lowered(db: Database, name: str, axes: int | None) -> Lowered:
    """Return a task of text or library, lowered alone.

    Args:
        db: holds the text.
        name: of the task.
        axes: number of joint coordinates, if the procedures determine it.
    """
    environment: Environment = db.read(questions.ENVIRONMENT)
    own = db.ask(questions.checked, name).task if db.ask(questions.is_own, name) else None
    return lower_task(known_names(db, axes), own if own is not None else environment.tasks[name].task)


def known_names(db: Database, axes: int | None) -> Known:
    """Return the definitions of the text, name by name."""
    environment: Environment = db.read(questions.ENVIRONMENT)
    return Known(
        Table(lambda one: db.ask(interface, one), lambda: (*db.read(questions.TASKS), *environment.tasks)),
        Table(lambda one: db.ask(signal, one), lambda: db.ask(questions.names_in, "symbols")),
        Table(lambda one: db.ask(variable, one), lambda: db.ask(questions.names_in, "symbols")),
        Table(lambda one: db.ask(questions.frame, one), lambda: db.ask(questions.names_in, "frames")),
        axes,
    )


def procedure_name(db: Database, name: str, axes: int | None) -> str:
    """Return the name of the procedure of a task."""
    return db.ask(lowered, name, axes).name


def draft(db: Database, name: str, axes: int | None) -> icr.Procedure:
    """Return the procedure in which variables may be read before they have a value."""
    return draft_of(db.ask(lowered, name, axes))


def summary(db: Database, name: str, axes: int | None) -> icr.Summary:
    """Return the effect of a procedure and all its callees on variables."""
    one = db.ask(lowered, name, axes)
    called = {db.ask(procedure_name, task, axes): db.ask(summary, task, axes) for task in one.callees}
    given: frozenset[icr.Slot] = db.read((GIVEN, axes))
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
