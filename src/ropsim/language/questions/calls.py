"""How a task is called, with all types."""

from dataclasses import replace

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.language.blocks.units import of_task
from ropsim.language.check.calls import signatures
from ropsim.language.check.expressions.expression import EXPRESSIONS
from ropsim.language.check.scope.body import Body
from ropsim.language.check.scope.world import Signature
from ropsim.language.questions.callers import is_own, library, task
from ropsim.language.questions.declarations import basics
from ropsim.language.questions.groups import Group, groups
from ropsim.language.questions.headers import header, with_types
from ropsim.language.questions.inference import types
from ropsim.language.questions.inputs import JOINT_COUNT
from ropsim.language.questions.walks import untold_of
from ropsim.language.questions.worlds import open_symbols, world_with
from ropsim.language.report import Report, TooManyFindingsError
from ropsim.language.task_form import TaskForm
from ropsim.query import Database


@frozen_dataclass
class Called:
    """How a task is called, with all types, and findings of its defaults."""

    signature: Signature
    found: tuple[Diagnostic, ...]


def signature(db: Database, name: str) -> Called | None:
    """Return how a task of text or library is called, None where there is none of that name."""
    text = db.ask(task, name)
    if text is None:
        of_library = db.ask(library, name)
        return Called(of_library, ()) if of_library is not None else None
    report = Report(of_task(name))
    world = world_with(db, lambda _: None, open_symbols(db), frozenset(), db.read(JOINT_COUNT))
    body = Body(world, report, EXPRESSIONS, None, name)
    start = db.ask(header, name).signature
    kinds = db.ask(types, name).formals
    untold = () if db.ask(basics).is_classic else db.ask(untold_of, name)
    try:
        found = signatures.final(body, text, start, kinds)
        signatures.report_untold(body, text, untold)
    except TooManyFindingsError:
        found = with_types(start, kinds)
    return Called(replace(found, is_known=False) if untold else found, tuple(report.log))


def joint_count(db: Database) -> int:
    """Return the number of coordinates of the first `joints(…)` in the text, for cells without it."""
    world = db.ask(basics)
    if world.environment.axes or world.joint_count:
        return world.joint_count
    found = db.ask(groups)
    counts = (db.ask(told_joints_in, group) for group in found)
    used = (db.ask(walked_joints_in, group) for group in (*found, ("",)))
    return next(filter(None, (*counts, *used)), 0)


def told_joints_in(db: Database, group: Group) -> int:
    """Return how many coordinates `joints(…)` has first in the headers of a group of tasks."""
    return next(filter(None, (db.ask(header, name).joint_count for name in group)), 0)


def walked_joints_in(db: Database, group: Group) -> int:
    """Return how many coordinates `joints(…)` has first in the bodies of a group of tasks."""
    return next(filter(None, (db.ask(walked_joints, name) for name in group)), 0)


def walked_joints(db: Database, name: str) -> int:
    """Return how many coordinates `joints(…)` has in a body."""
    return db.ask(types, name).joint_count


def lacks_result(db: Database, name: str) -> bool:
    """Return whether a task returns a value for which its header has no type."""
    return db.ask(is_own, name) and db.ask(types, name).lacks_result


def form(db: Database, name: str) -> TaskForm | None:
    """Return how a task is called, in words of the language."""
    found = db.ask(signature, name)
    return signatures.form_of(found.signature, db.ask(basics).units) if found is not None else None
