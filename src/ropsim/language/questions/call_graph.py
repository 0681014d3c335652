"""Who calls whom in a checked text: which tasks nothing calls, and calls that close a circle."""

from collections.abc import Mapping

from ropsim.core import Diagnostic
from ropsim.language.check.reached import uncalled
from ropsim.language.questions.bodies import calls_of
from ropsim.language.questions.callers import ranks
from ropsim.language.questions.groups import Group, groups
from ropsim.language.questions.inputs import CONTROL_CALLS, TASKS
from ropsim.program import circles
from ropsim.query import Database


def called_in(db: Database, group: Group) -> Mapping[str, tuple[str, ...]]:
    """Return which tasks each task of a group calls."""
    return {name: tuple(called for called, _ in db.ask(calls_of, name)) for name in group}


def call_graph(db: Database) -> Mapping[str, tuple[str, ...]]:
    """Return which tasks each task of the text calls."""
    found: dict[str, tuple[str, ...]] = {}
    for group in db.ask(groups):
        found.update(db.ask(called_in, group))
    return found


def uncalled_tasks(db: Database) -> tuple[str, ...]:
    """Return the tasks that the control statements do not reach."""
    return tuple(uncalled(db.ask(call_graph), db.read(CONTROL_CALLS)))


def is_in_order(db: Database) -> bool:
    """Return whether each task calls only such that come before it, so that no calls close a circle."""
    rank = db.ask(ranks)
    return all(
        rank.get(one, -1) < rank[name] for name, called in db.ask(call_graph).items() for one in called
    )


def circles_of(db: Database) -> tuple[Diagnostic, ...]:
    """Return a finding for each call that closes a circle; for a text whose tasks call no library."""
    if db.ask(is_in_order):
        return ()
    return circles({name: db.ask(calls_of, name) for name in db.read(TASKS)})
