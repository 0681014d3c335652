"""The tasks of the text, and who calls whom."""

from collections.abc import Iterable, Mapping

from ropsim.language.check.calls import signatures
from ropsim.language.check.calls.tasks import TaskText, callee_first, callees
from ropsim.language.check.scope.world import Signature
from ropsim.language.environment import Environment
from ropsim.language.questions.inputs import ENVIRONMENT, ORDER, TASKS
from ropsim.query import Database


def task(db: Database, name: str) -> TaskText | None:
    """Return a task of the text."""
    found: TaskText | None = db.read(("task", name))
    return found


def is_own(db: Database, name: str) -> bool:
    """Return whether the text has a task of that name."""
    return db.ask(task, name) is not None


def spellings(db: Database) -> Mapping[str, tuple[str, ...]]:
    """Return the tasks of the text by their names in small letters."""
    return _by_small_letters(db.read(TASKS))


def library_spellings(db: Database) -> Mapping[str, tuple[str, ...]]:
    """Return the tasks of the library by their names in small letters."""
    environment: Environment = db.read(ENVIRONMENT)
    return _by_small_letters(environment.tasks)


def _by_small_letters(names: Iterable[str]) -> Mapping[str, tuple[str, ...]]:
    found: dict[str, tuple[str, ...]] = {}
    for name in names:
        found[name.lower()] = (*found.get(name.lower(), ()), name)
    return found


def alike(db: Database, lower: str) -> tuple[str, ...]:
    """Return the tasks that have a name in small letters, tasks of the text first."""
    return (*db.ask(spellings).get(lower, ()), *db.ask(library_spellings).get(lower, ()))


def callees_of(db: Database, name: str) -> tuple[str, ...]:
    """Return the names that a task calls or may call."""
    text = db.ask(task, name)
    return callees(text.block) if text is not None else ()


def order(db: Database) -> tuple[str, ...]:
    """Return the tasks of the text, callees before callers."""
    return tuple(callee_first({name: db.ask(callees_of, name) for name in db.read(TASKS)}))


def ranks(db: Database) -> Mapping[str, int]:
    """Return the place of each task in that order."""
    return {name: rank for rank, name in enumerate(db.read(ORDER))}


def precedes(db: Database, one: str, other: str) -> bool:
    """Return whether a task comes before another one in that order; tasks of the library always do."""
    found = db.ask(ranks)
    return found.get(one, -1) < found.get(other, len(found))


def library(db: Database, name: str) -> Signature | None:
    """Return how a task of the library is called."""
    environment: Environment = db.read(ENVIRONMENT)
    found = environment.tasks.get(name)
    return signatures.of_library(found) if found is not None else None


def all_tasks(db: Database) -> tuple[str, ...]:
    """Return the tasks of library and text."""
    environment: Environment = db.read(ENVIRONMENT)
    return tuple(dict.fromkeys((*environment.tasks, *db.read(ORDER))))
