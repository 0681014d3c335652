"""Results of each body."""

from dataclasses import replace

from ropsim.core import Span
from ropsim.language.check import one_body
from ropsim.language.check.scope.table import Marked, Table
from ropsim.language.check.scope.world import Outcome, Signature, TaskOrigins, World
from ropsim.language.questions.callers import is_own, precedes, task
from ropsim.language.questions.calls import lacks_result, signature
from ropsim.language.questions.declarations import names_in, symbol
from ropsim.language.questions.headers import header
from ropsim.language.questions.inference import types
from ropsim.language.questions.inputs import JOINT_COUNT
from ropsim.language.questions.worlds import world_with
from ropsim.query import Database


def checked(db: Database, name: str) -> Outcome:
    """Return a task of the text, checked."""
    text = db.ask(task, name)
    found = db.ask(signature, name)
    assert text is not None
    assert found is not None
    own, is_known = found.signature, db.ask(header, name).signature.is_known
    own = own if own.is_known is is_known else replace(own, is_known=is_known)
    return one_body.checked_task(final_world(db, name), text, own, db.ask(types, name).types)


def calls_of(db: Database, name: str) -> tuple[tuple[str, Span], ...]:
    """Return the tasks that a task of the text calls, and where."""
    return db.ask(checked, name).calls


def origins_of(db: Database, name: str) -> TaskOrigins:
    """Return the origins of plain numbers in a task of the text."""
    return db.ask(checked, name).origins


def _origins(db: Database, caller: str, name: str) -> TaskOrigins | None:
    """Return the same for a caller; None for a task of the library, and one that comes later, in a circle."""
    is_told = db.ask(is_own, name) and (not caller or db.ask(precedes, name, caller))
    return db.ask(origins_of, name) if is_told else None


def final_world(db: Database, caller: str = "") -> World:
    """Return the world as a body sees it when all types are known; `caller` is the task, empty for none."""
    return world_with(
        db,
        lambda name: _signature(db, name),
        Table(lambda name: db.ask(symbol, name), lambda: db.ask(names_in, "symbols")),
        Marked(lambda name: db.ask(lacks_result, name)),
        db.read(JOINT_COUNT),
        Table(lambda name: _origins(db, caller, name), tuple),
    )


def _signature(db: Database, name: str) -> Signature | None:
    found = db.ask(signature, name)
    return found.signature if found is not None else None
