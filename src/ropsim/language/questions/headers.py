"""Signature of a task, as far as its header determines it."""

from dataclasses import replace
from functools import partial

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.language.blocks.units import of_task
from ropsim.language.check.calls import signatures
from ropsim.language.check.expressions.expression import EXPRESSIONS
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.types import AnyType, Unknown, closed, opened
from ropsim.language.check.scope.world import Signature
from ropsim.language.cutting.reading import CALLABLE, Names
from ropsim.language.questions.callers import is_own, library, precedes, task
from ropsim.language.questions.worlds import world_of
from ropsim.language.report import Report, TooManyFindingsError
from ropsim.query import Database


@frozen_dataclass
class Header:
    """Signature of a task, as far as its header determines it.

    Attributes:
        signature: with open types where only use determines them.
        found: findings.
        joint_count: how many coordinates `joints(…)` has in it.
    """

    signature: Signature
    found: tuple[Diagnostic, ...]
    joint_count: int


def header(db: Database, name: str) -> Header:
    """Return the signature of a task, as far as its own header determines it."""
    text = db.ask(task, name)
    assert text is not None
    report = Report(of_task(name))
    body = Body(world_of(db, partial(_header_before, db, name)), report, EXPRESSIONS, None, name)
    try:
        signature = signatures.of_text(body, text, Names(db, CALLABLE))
    except TooManyFindingsError:
        signature = Signature(name, (), (), None, is_known=False)
    closed_ones = with_types(signature, tuple(closed(one.type) for one in signature.formals))
    return Header(closed_ones, tuple(report.log), body.joint_count)


def _header_before(db: Database, caller: str, name: str) -> Signature | None:
    """Return the signature of a task by its header; None for one that comes later, in a circle."""
    if not db.ask(is_own, name):
        return db.ask(library, name)
    return opened_formals(db.ask(header, name).signature) if db.ask(precedes, name, caller) else None


def opened_formals(found: Signature) -> Signature:
    """Return a signature whose open types have cells of their own."""
    if not any(isinstance(one.type, Unknown) for one in found.formals):
        return found
    return replace(found, formals=tuple(replace(one, type=opened(one.type)) for one in found.formals))


def with_types(found: Signature, kinds: tuple[AnyType, ...]) -> Signature:
    """Return a signature with the types of its parameters."""
    pairs = tuple(zip(found.formals, kinds, strict=True))
    if all(one.type is kind for one, kind in pairs):
        return found
    return replace(found, formals=tuple(replace(one, type=kind) for one, kind in pairs))
