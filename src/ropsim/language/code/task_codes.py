"""The executable form of the tasks of a text that its control statements reach, group by group."""

from ropsim import icr
from ropsim.core import frozen_dataclass
from ropsim.icr import Need
from ropsim.language.check.calls.tasks import callee_first
from ropsim.language.code.task_code import lowered, needs_of, ready, summary
from ropsim.language.questions import Group, grouped
from ropsim.program import Usage, joint_usage, reached
from ropsim.query import Database, always_new

FIRST = "tasks that are called first"
"""Input: the part of `lowered` that is known about axes: the tasks that the control statements call."""


def callees_of(db: Database, name: str, axes: int | None) -> tuple[str, ...]:
    """Return the tasks that the code of a task calls."""
    return db.ask(lowered, name, axes).callees


def reached_tasks(db: Database, axes: int | None) -> tuple[str, ...]:
    """Return the tasks of text and library that the control statements reach, depth first."""
    return tuple(reached(db.read((FIRST, axes)), lambda name: db.ask(callees_of, name, axes)))


def reached_groups(db: Database, axes: int | None) -> tuple[Group, ...]:
    """Return the same in groups."""
    return grouped(db.ask(reached_tasks, axes))


def summary_groups(db: Database, axes: int | None) -> tuple[Group, ...]:
    """Return these tasks in groups, callees before callers."""
    calls = {name: db.ask(callees_of, name, axes) for name in db.ask(reached_tasks, axes)}
    return grouped(callee_first(calls))


def usage_in(db: Database, group: Group, axes: int | None) -> Usage:
    """Return the usage of the procedures of a group."""
    return joint_usage(db.ask(lowered, name, axes) for name in group)


def find_summaries(db: Database, group: Group, axes: int | None) -> None:
    """Compute the effects of the procedures of a group on variables, see `summary_groups`."""
    for name in group:  # so that no chain of calls, of text or library, is one of questions
        db.ask(summary, name, axes)


def needs_in(db: Database, group: Group, axes: int | None) -> tuple[tuple[str, tuple[Need, ...]], ...]:
    """Return the tasks of a group with variables that may be read before they have a value, and those."""
    found = ((name, db.ask(needs_of, name, axes)) for name in group)
    return tuple((name, needs) for name, needs in found if needs)


@frozen_dataclass
class Made:
    """A procedure with values at its start.

    Attributes:
        procedure: without source lines.
        unit: name of the unit of the lines in spans.
        lines: lines of the instructions behind the initialising ones, relative to that unit.
    """

    procedure: icr.Procedure
    unit: str
    lines: tuple[int, ...]


@always_new
def made_in(db: Database, group: Group, guess: int | None, axes: int | None) -> tuple[Made, ...]:
    """Return the procedures of a group."""
    found = ((db.ask(lowered, name, guess), db.ask(ready, name, guess, axes)) for name in group)
    return tuple(Made(done, one.unit, one.lines) for one, done in found)
