"""Combined results of a group of tasks; each is queried for callees first, see `groups`."""

from collections.abc import Mapping
from itertools import chain

from ropsim.core import Diagnostic, Span, frozen_dataclass
from ropsim.language.questions.bodies import checked
from ropsim.language.questions.calls import form, signature
from ropsim.language.questions.groups import Group, groups, text_groups
from ropsim.language.questions.headers import header
from ropsim.language.questions.inference import types, words
from ropsim.language.task_form import TaskForm
from ropsim.program import SignalUse, Task
from ropsim.query import Database, always_new


@frozen_dataclass
class Bodies:
    """The outcomes of some tasks, put together. Places count lines in their unit.

    Attributes:
        found: findings, in the order in which they were made.
        unread: hints at variables that nothing reads.
        signals: that they name, by name.
        late: unreachable statements, and the statements before them.
        impossible: arcs and curves whose points make none.
        has_contracts: whether one of them says in which state the gripper must be.
    """

    found: tuple[Diagnostic, ...]
    unread: tuple[Diagnostic, ...]
    signals: Mapping[str, SignalUse]
    late: tuple[tuple[Span, Span], ...]
    impossible: tuple[Diagnostic, ...]
    has_contracts: bool


def found_in_headers(db: Database, group: Group) -> tuple[Diagnostic, ...]:
    """Return the findings of headers."""
    return tuple(chain.from_iterable(db.ask(header, name).found for name in group))


def find_types(db: Database, group: Group) -> None:
    """Let the types of the tasks be found."""
    for name in group:
        db.ask(types, name)


def found_in_signatures(db: Database, group: Group) -> tuple[Diagnostic, ...]:
    """Return the findings of defaults and of types that nothing determines."""
    called = (db.ask(signature, name) for name in group)
    return tuple(chain.from_iterable(one.found for one in called if one is not None))


@always_new
def bodies_in(db: Database, group: Group) -> Bodies:
    """Return the tasks, checked."""
    found = [db.ask(checked, name) for name in group]
    contracts = (one for body in found if body.task is not None for one in body.task.contracts)
    return Bodies(
        tuple(chain.from_iterable(one.found for one in found)),
        tuple(chain.from_iterable(one.unread for one in found)),
        {signal.name: signal for one in found for signal in one.signals},
        tuple(chain.from_iterable(one.late for one in found)),
        tuple(chain.from_iterable(one.impossible for one in found)),
        any(one.gripper for one in contracts),
    )


@always_new
def tasks_in(db: Database, group: Group) -> tuple[Task, ...]:
    """Return the callable tasks of a group."""
    found = (db.ask(checked, name).task for name in group)
    return tuple(one for one in found if one is not None)


@always_new
def own_tasks(db: Database) -> tuple[Task, ...]:
    """Return the tasks of the text that can be called, in its order."""
    return tuple(chain.from_iterable(db.ask(tasks_in, group) for group in db.ask(text_groups)))


def forms_in(db: Database, group: Group) -> Mapping[str, TaskForm]:
    """Return how the tasks are called, by name."""
    forms = ((name, db.ask(form, name)) for name in group)
    return {name: form for name, form in forms if form is not None}


def all_forms(db: Database) -> Mapping[str, TaskForm]:
    """Return how the tasks of the text are called, by name."""
    return dict(chain.from_iterable(db.ask(forms_in, group).items() for group in db.ask(groups)))


def words_in(db: Database, group: Group) -> Mapping[str, Mapping[str, str]]:
    """Return the types of the variables of the tasks in words, by the name of the task."""
    return {name: db.ask(words, name) for name in group}


def all_words(db: Database) -> Mapping[str, Mapping[str, str]]:
    """Return the same for the control statements, by the empty name, and all tasks of the text."""
    forms = chain.from_iterable(db.ask(words_in, group).items() for group in db.ask(groups))
    return {"": db.ask(words, ""), **dict(forms)}
