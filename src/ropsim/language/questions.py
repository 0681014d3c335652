"""What is asked of a text in units: declarations, how tasks are called, and what is found in each body.

Each function is pure: the database notes what it looks at, so that a change reaches only what depends on
it. A task depends on its own text, on the declarations that it names and on how the tasks that it calls are
called; never on its callers, unless the text is a classic one, whose use of a task may tell types of its
parameters.
"""

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial

from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.language.check import declarations, fold, one_body, signatures
from ropsim.language.check.body import Body, settled
from ropsim.language.check.declarations import Declared
from ropsim.language.check.expressions import EXPRESSIONS
from ropsim.language.check.outcome import Outcome
from ropsim.language.check.table import Marked, Table
from ropsim.language.check.tasks import TaskText, callee_first, callees
from ropsim.language.check.types import Type, Unknown, closed, is_open, is_untold, opened
from ropsim.language.check.units import UnitSystem
from ropsim.language.check.world import Formal, Signature, Symbol, Variable, World
from ropsim.language.environment import Environment
from ropsim.language.reading import CALLABLE, Names
from ropsim.language.report import Report, TooManyFindingsError
from ropsim.language.task_form import TaskForm
from ropsim.language.text import Line
from ropsim.language.units import CONTROL, Items, of_task
from ropsim.query import Database
from ropsim.spatial import PoseTuple

ENVIRONMENT = "environment"
"""Input: what cell and library give names to."""
TASKS = "tasks"
"""Input: names of the tasks of the text, in order."""
STATEMENTS = "control statements"
"""Input: what stands outside of tasks."""
DECLARED = "declarations"
"""Input, as `declared` tells it: where it is the same nothing that depends on it is looked at."""
ORDER = "order"
"""Input, as `order` tells it."""
INFERRED = "inferred types"
"""Input, as `inference` tells it."""
CONTROL_LOCALS = "variables of the control statements"
"""Input, as `checked_control` tells them."""
JOINT_COUNT = "joint count"
"""Input, as `joint_count` tells it."""


@frozen_dataclass
class Header:
    """How a task is called, as far as its header tells.

    Attributes:
        signature: with open types where only use tells them.
        found: findings.
        joint_count: how many coordinates `joints(…)` has in it.
    """

    signature: Signature
    found: tuple[Diagnostic, ...]
    joint_count: int


@frozen_dataclass
class Walked:
    """What the silent walk through a body tells.

    Attributes:
        formals: types of its parameters.
        types: of all its variables.
        joint_count: how many coordinates `joints(…)` has in it.
        lacks_result: whether it returns a value for which its header has no type.
        untold: parameters whose types neither header nor body tell.
    """

    formals: tuple[Type, ...]
    types: Mapping[str, Type]
    joint_count: int
    lacks_result: bool
    untold: tuple[str, ...] = ()


@frozen_dataclass
class Inferred:
    """What a walk through all bodies tells, where use in one tells types in another."""

    bodies: Mapping[str, Walked]
    variables: Mapping[str, Type]


@frozen_dataclass
class Called:
    """How a task is called, with all types, and findings of its defaults."""

    signature: Signature
    found: tuple[Diagnostic, ...]


# --- declarations


def declared(db: Database) -> Declared:
    """Return what the text declares outside of tasks."""
    environment: Environment = db.read(ENVIRONMENT)
    report = Report(CONTROL)
    try:
        return declarations.world(db.read(STATEMENTS), environment, report)
    except TooManyFindingsError:
        return Declared(_nothing(environment), tuple(report.log))


def _nothing(environment: Environment) -> World:
    system = UnitSystem(environment.length, environment.angle)
    return World(
        environment,
        system,
        is_strict=False,
        is_classic=False,
        frame="",
        X_BK=fold.IDENTITY,
        frames={},
        tools={},
    )


def _declared(db: Database) -> Declared:
    found: Declared = db.read(DECLARED)
    return found


def basics(db: Database) -> World:
    """Return what holds for the whole text, without any names."""
    return replace(_declared(db).world, frames={}, tools={}, symbols={})


def frame(db: Database, name: str) -> PoseTuple | None:
    """Return a frame."""
    return _declared(db).world.frames.get(name)


def tool(db: Database, name: str) -> PoseTuple | None:
    """Return a tool."""
    return _declared(db).world.tools.get(name)


def declared_symbol(db: Database, name: str) -> Symbol | None:
    """Return what a name is declared as; the type of a variable may be open."""
    return _declared(db).world.symbols.get(name)


def names_in(db: Database, table: str) -> tuple[str, ...]:
    """Return the names of all `frames`, `tools` or `symbols`."""
    return tuple(getattr(_declared(db).world, table))


def symbol(db: Database, name: str) -> Symbol | None:
    """Return what a name means everywhere; the types of variables are known."""
    found = db.ask(declared_symbol, name)
    if isinstance(found, Variable) and is_open(found.type):
        inferred = _inferred(db)
        assert inferred is not None
        return replace(found, type=inferred.variables[name])
    return found


def statements(db: Database) -> Items:
    """Return the control statements without the declarations among them."""
    return tuple(
        item
        for item in db.read(STATEMENTS)
        if not isinstance(item, Line) or not isinstance(item.statement, declarations.WITHOUT_CODE)
    )


# --- who calls whom


def task(db: Database, name: str) -> TaskText | None:
    """Return a task of the text."""
    found: TaskText | None = db.read(("task", name))
    return found


def is_own(db: Database, name: str) -> bool:
    """Return whether the text has a task of that name."""
    return db.ask(task, name) is not None


def callees_of(db: Database, name: str) -> tuple[str, ...]:
    """Return the names that a task calls or may call."""
    text = db.ask(task, name)
    return callees(text.block) if text is not None else ()


def order(db: Database) -> tuple[str, ...]:
    """Return the tasks of the text, those called before those that call them."""
    return tuple(callee_first({name: db.ask(callees_of, name) for name in db.read(TASKS)}))


def ranks(db: Database) -> Mapping[str, int]:
    """Return the place of each task in that order."""
    return {name: rank for rank, name in enumerate(db.read(ORDER))}


def precedes(db: Database, one: str, other: str) -> bool:
    """Return whether a task comes before another one in that order; those of the library always do."""
    found = db.ask(ranks)
    return found.get(one, -1) < found.get(other, len(found))


# --- how tasks are called


def header(db: Database, name: str) -> Header:
    """Return how a task is called, as far as its own header tells."""
    text = db.ask(task, name)
    assert text is not None
    report = Report(of_task(name))
    body = Body(_world(db, partial(_header_before, db, name)), report, EXPRESSIONS, None, name)
    try:
        signature = signatures.of_text(body, text, Names(db, CALLABLE))
    except TooManyFindingsError:
        signature = Signature(name, (), (), None, is_known=False)
    formals = tuple(replace(one, type=closed(one.type)) for one in signature.formals)
    return Header(replace(signature, formals=formals), tuple(report.log), body.joint_count)


def library(db: Database, name: str) -> Signature | None:
    """Return how a task of the library is called."""
    environment: Environment = db.read(ENVIRONMENT)
    found = environment.tasks.get(name)
    return signatures.of_library(found) if found is not None else None


def walked(db: Database, name: str) -> Walked:
    """Return what a task tells of its types when it is looked at alone."""
    text = db.ask(task, name)
    assert text is not None
    signature = _opened(db.ask(header, name).signature)
    body = one_body.walked_task(_world(db, partial(_signature_before, db, name)), text, signature)
    return _told(body, signature)


def is_inferred(db: Database) -> bool:
    """Return whether use in one body tells types in another one.

    That is where a variable of the whole text has no type of its own, and in classic texts where a parameter
    has none.
    """
    world = _declared(db).world
    if any(isinstance(one, Variable) and is_open(one.type) for one in world.symbols.values()):
        return True
    headers = (db.ask(header, name).signature for name in db.read(ORDER)) if world.is_classic else ()
    return any(is_open(formal.type) for signature in headers for formal in signature.formals)


def inference(db: Database) -> Inferred | None:
    """Return what a silent walk through all bodies tells of types; None where each body tells its own."""
    if not db.ask(is_inferred):
        return None
    world = _declared(db).world
    symbols = {name: of_body(one) for name, one in world.symbols.items()}
    environment: Environment = db.read(ENVIRONMENT)
    called = {name: signatures.of_library(one) for name, one in environment.tasks.items()}
    world = replace(world, symbols=symbols, signatures=called)
    names = db.read(ORDER)
    texts = {name: text for name in names if (text := db.ask(task, name)) is not None}
    for name, text in texts.items():
        if world.is_classic:
            report = Report(of_task(name))
            report.muted = True
            of_text = Body(world, report, EXPRESSIONS, None, name)
            called[name] = signatures.of_text(of_text, text, Names(db, CALLABLE))
        else:
            called[name] = _with_types(db.ask(header, name).signature, db.ask(walked, name).formals)
    bodies = {name: one_body.walked_task(world, text, called[name]) for name, text in texts.items()}
    control = one_body.walked_control(world, db.ask(statements))
    found = {name: _told(body, called[name]) for name, body in bodies.items()}
    found[""] = _told(control, None)
    variables = {name: settled(one.type) for name, one in symbols.items() if isinstance(one, Variable)}
    return Inferred(found, variables)


def _inferred(db: Database) -> Inferred | None:
    found: Inferred | None = db.read(INFERRED)
    return found


def types(db: Database, name: str) -> Walked:
    """Return the types of a task, or of the control statements by the empty name."""
    inferred = _inferred(db)
    if inferred is None:
        return db.ask(walked, name) if name else db.ask(walked_control)
    found = inferred.bodies[name]
    if name and not db.ask(basics).is_classic:
        return replace(found, formals=db.ask(walked, name).formals)
    return found


def walked_control(db: Database) -> Walked:
    """Return what the control statements tell of their own types."""
    body = one_body.walked_control(_world(db, partial(_own_signature, db)), db.ask(statements))
    return _told(body, None)


def words(db: Database, name: str) -> Mapping[str, str]:
    """Return the types of the variables of a task in words; by the empty name of those that all tasks see."""
    found = dict(db.ask(types, name).types)
    if not name:
        symbols = {one: db.ask(symbol, one) for one in db.ask(names_in, "symbols")}
        found = {**{n: settled(s.type) for n, s in symbols.items() if isinstance(s, Variable)}, **found}
    return {one: signatures.word_of(kind) for one, kind in found.items()}


def signature(db: Database, name: str) -> Called | None:
    """Return how a task of text or library is called, None where there is none of that name."""
    text = db.ask(task, name)
    if text is None:
        of_library = db.ask(library, name)
        return Called(of_library, ()) if of_library is not None else None
    report = Report(of_task(name))
    world = replace(_world(db, lambda _: None), joint_count=db.read(JOINT_COUNT))
    body = Body(world, report, EXPRESSIONS, None, name)
    start = db.ask(header, name).signature
    kinds = db.ask(types, name).formals
    untold = () if db.ask(basics).is_classic else db.ask(untold_of, name)
    try:
        found = signatures.final(body, text, start, kinds)
        signatures.report_untold(body, text, untold)
    except TooManyFindingsError:
        found = _with_types(start, kinds)
    return Called(replace(found, is_known=found.is_known and not untold), tuple(report.log))


def joint_count(db: Database) -> int:
    """Return how many coordinates `joints(…)` has where the cell does not say so: what the text has first."""
    world = db.ask(basics)
    if world.environment.axes or world.joint_count:
        return world.joint_count
    names = db.read(ORDER)
    told = (db.ask(header, name).joint_count for name in names)
    used = (db.ask(walked_joints, name) for name in (*names, ""))
    return next(filter(None, (*told, *used)), 0)


def walked_joints(db: Database, name: str) -> int:
    """Return how many coordinates `joints(…)` has in a body."""
    return db.ask(types, name).joint_count


def untold_of(db: Database, name: str) -> tuple[str, ...]:
    """Return the parameters of a task whose types it does not tell."""
    return db.ask(walked, name).untold


def lacks_result(db: Database, name: str) -> bool:
    """Return whether a task returns a value for which its header has no type."""
    return db.ask(is_own, name) and db.ask(types, name).lacks_result


# --- what is found


def checked(db: Database, name: str) -> Outcome:
    """Return a task of the text, checked."""
    text = db.ask(task, name)
    found = db.ask(signature, name)
    assert text is not None
    assert found is not None
    own = replace(found.signature, is_known=db.ask(header, name).signature.is_known)
    return one_body.checked_task(_final_world(db), text, own, db.ask(types, name).types)


def calls_of(db: Database, name: str) -> tuple[tuple[str, Span], ...]:
    """Return the tasks that a task of the text calls, and where."""
    return db.ask(checked, name).calls


def form(db: Database, name: str) -> TaskForm | None:
    """Return how a task is called, in words of the language."""
    found = db.ask(signature, name)
    return signatures.form_of(found.signature, db.ask(basics).units) if found is not None else None


def checked_control(db: Database) -> Outcome:
    """Return the control statements, checked."""
    return one_body.checked_control(_final_world(db), db.ask(statements), db.ask(types, "").types)


# --- what a body sees


def _world(db: Database, called: Callable[[str], Signature | None]) -> World:
    """Return the world as a body sees it while types are not known."""

    def symbol_of(name: str) -> Symbol | None:
        found = db.ask(declared_symbol, name)
        return of_body(found) if found is not None else None

    return replace(
        db.ask(basics),
        frames=Table(lambda name: db.ask(frame, name), lambda: db.ask(names_in, "frames")),
        tools=Table(lambda name: db.ask(tool, name), lambda: db.ask(names_in, "tools")),
        symbols=Table(symbol_of, lambda: db.ask(names_in, "symbols")),
        signatures=Table(called, lambda: _all_tasks(db)),
    )


def _final_world(db: Database) -> World:
    return replace(
        _world(db, lambda name: _signature(db, name)),
        symbols=Table(lambda name: db.ask(symbol, name), lambda: db.ask(names_in, "symbols")),
        without_result=Marked(lambda name: db.ask(lacks_result, name)),
        joint_count=db.read(JOINT_COUNT),
    )


def _all_tasks(db: Database) -> tuple[str, ...]:
    environment: Environment = db.read(ENVIRONMENT)
    return tuple(dict.fromkeys((*environment.tasks, *db.read(ORDER))))


def _signature(db: Database, name: str) -> Signature | None:
    found = db.ask(signature, name)
    return found.signature if found is not None else None


def _header_before(db: Database, caller: str, name: str) -> Signature | None:
    """Return how a task is called as its header tells; None for one that comes later, in a circle."""
    if not db.ask(is_own, name):
        return db.ask(library, name)
    return _opened(db.ask(header, name).signature) if db.ask(precedes, name, caller) else None


def _signature_before(db: Database, caller: str, name: str) -> Signature | None:
    """Return how a task is called; of one that comes later, in a circle, what its header tells."""
    if db.ask(is_own, name) and not db.ask(precedes, name, caller):
        return _opened(db.ask(header, name).signature)
    return _own_signature(db, name)


def _own_signature(db: Database, name: str) -> Signature | None:
    """Return how a task is called by what it tells alone."""
    if not db.ask(is_own, name):
        return db.ask(library, name)
    found = _with_types(db.ask(header, name).signature, db.ask(formals_of, name))
    untold = db.ask(untold_of, name)
    formals = (replace(one, type=Unknown()) if one.name in untold else one for one in found.formals)
    return replace(found, formals=tuple(formals))


def formals_of(db: Database, name: str) -> tuple[Type, ...]:
    """Return the types of the parameters of a task as it tells them alone."""
    return db.ask(walked, name).formals


def of_body(found: Symbol) -> Symbol:
    """Return a symbol as one body sees it: a variable of open type with a cell of its own."""
    return replace(found, type=opened(found.type)) if isinstance(found, Variable) else found


def _opened(found: Signature) -> Signature:
    return replace(found, formals=tuple(replace(one, type=opened(one.type)) for one in found.formals))


def _with_types(found: Signature, kinds: tuple[Type, ...]) -> Signature:
    formals = tuple(replace(one, type=kind) for one, kind in zip(found.formals, kinds, strict=True))
    return replace(found, formals=formals)


def _told(body: Body, called: Signature | None) -> Walked:
    formals: tuple[Formal, ...] = called.formals if called is not None else ()
    told = tuple(settled(one.type) for one in formals)
    untold = tuple(one.name for one in formals if is_untold(one.type))
    return Walked(told, body.types(), body.joint_count, body.lacks_result, untold)
