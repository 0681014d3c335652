"""Types that use in one body determines in another one."""

from collections.abc import Mapping
from dataclasses import replace

from ropsim.language.blocks.units import of_task
from ropsim.language.check import one_body
from ropsim.language.check.calls import signatures
from ropsim.language.check.expressions.expression import EXPRESSIONS
from ropsim.language.check.scope.body import Body, settled
from ropsim.language.check.scope.types import is_open
from ropsim.language.check.scope.world import Variable
from ropsim.language.cutting.reading import CALLABLE, Names
from ropsim.language.environment import Environment
from ropsim.language.questions.callers import task
from ropsim.language.questions.declarations import _declared, basics, names_in, statements, symbol, untyped
from ropsim.language.questions.headers import header, with_types
from ropsim.language.questions.inputs import ENVIRONMENT, ORDER
from ropsim.language.questions.told import Inferred, Walked, inferred, told
from ropsim.language.questions.walks import walked, walked_control
from ropsim.language.questions.worlds import of_body
from ropsim.language.report import Report
from ropsim.query import Database


def is_inferred(db: Database) -> bool:
    """Return whether use in one body determines types in another one.

    That is where a variable of the whole text has no type of its own, and in classic texts where a parameter
    lacks a type.
    """
    world = _declared(db).world
    if db.ask(untyped):
        return True
    headers = (db.ask(header, name).signature for name in db.read(ORDER)) if world.is_classic else ()
    return any(is_open(formal.type) for signature in headers for formal in signature.formals)


def inference(db: Database) -> Inferred | None:
    """Return the types inferred by a pass through all bodies; None if each body determines its own."""
    if not db.ask(is_inferred):
        return None
    world = _declared(db).world
    symbols = {name: of_body(one) for name, one in world.symbols.items()}
    environment: Environment = db.read(ENVIRONMENT)
    called = {name: signatures.of_library(one) for name, one in environment.tasks.items()}
    names = db.read(ORDER)
    own = frozenset(names)
    world = replace(world, symbols=symbols, signatures=called, untyped=db.ask(untyped), own=own)
    texts = {name: text for name in names if (text := db.ask(task, name)) is not None}
    for name, text in texts.items():
        if world.is_classic:
            report = Report(of_task(name))
            report.muted = True
            of_text = Body(world, report, EXPRESSIONS, None, name)
            called[name] = signatures.of_text(of_text, text, Names(db, CALLABLE))
        else:
            called[name] = with_types(db.ask(header, name).signature, db.ask(walked, name).formals)
    bodies = {name: one_body.walked_task(world, text, called[name]) for name, text in texts.items()}
    control = one_body.walked_control(world, db.ask(statements))
    found = {name: told(body, called[name]) for name, body in bodies.items()}
    found[""] = told(control, None)
    variables = {name: settled(one.type) for name, one in symbols.items() if isinstance(one, Variable)}
    return Inferred(found, variables)


def types(db: Database, name: str) -> Walked:
    """Return the types of a task, or of the control statements by the empty name."""
    everywhere = inferred(db)
    if everywhere is None:
        return db.ask(walked, name) if name else db.ask(walked_control)
    found = everywhere.bodies[name]
    if name and not db.ask(basics).is_classic:
        return replace(found, formals=db.ask(walked, name).formals)
    return found


def words(db: Database, name: str) -> Mapping[str, str]:
    """Return the types of a task's variables in words; under the empty name, of global ones."""
    found = dict(db.ask(types, name).types)
    if not name:
        symbols = {one: db.ask(symbol, one) for one in db.ask(names_in, "symbols")}
        found = {**{n: settled(s.type) for n, s in symbols.items() if isinstance(s, Variable)}, **found}
    return {one: signatures.word_of(kind) for one, kind in found.items()}
