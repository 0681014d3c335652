"""Inference results of bodies alone."""

from dataclasses import replace
from functools import partial

from ropsim.language.check import one_body
from ropsim.language.check.scope.types import Type, Unknown
from ropsim.language.check.scope.world import Signature
from ropsim.language.questions.callers import is_own, library, precedes, task
from ropsim.language.questions.headers import header, opened_formals, with_types
from ropsim.language.questions.inputs import WALKED_CONTROL
from ropsim.language.questions.told import Walked, told
from ropsim.language.questions.worlds import world_of
from ropsim.query import Database


def walked(db: Database, name: str) -> Walked:
    """Return the inference result of a task alone."""
    text = db.ask(task, name)
    assert text is not None
    signature = opened_formals(db.ask(header, name).signature)
    body = one_body.walked_task(world_of(db, partial(_signature_before, db, name)), text, signature)
    return told(body, signature)


def walked_control(db: Database) -> Walked:
    """Return the types of the variables of the control statements."""
    found: Walked = db.read(WALKED_CONTROL)
    return found


def _signature_before(db: Database, caller: str, name: str) -> Signature | None:
    """Return the signature of a task; of a later one, in a circle, the part in its header."""
    if db.ask(is_own, name) and not db.ask(precedes, name, caller):
        return opened_formals(db.ask(header, name).signature)
    return own_signature(db, name)


def own_signature(db: Database, name: str) -> Signature | None:
    """Return the signature of a task, inferred from it alone."""
    if not db.ask(is_own, name):
        return db.ask(library, name)
    found = with_types(db.ask(header, name).signature, db.ask(formals_of, name))
    untold = db.ask(untold_of, name)
    if not untold:
        return found
    formals = (replace(one, type=Unknown()) if one.name in untold else one for one in found.formals)
    return replace(found, formals=tuple(formals))


def formals_of(db: Database, name: str) -> tuple[Type, ...]:
    """Return the types of the parameters of a task inferred from it alone."""
    return db.ask(walked, name).formals


def untold_of(db: Database, name: str) -> tuple[str, ...]:
    """Return the parameters of a task whose types it does not determine."""
    return db.ask(walked, name).untold
