"""Whether calls keep the gripper contracts of tasks: each task, and each part, is followed separately."""

from collections.abc import Iterator

from ropsim.core import Diagnostic
from ropsim.language import questions
from ropsim.language.environment import Environment
from ropsim.program import (
    Block,
    Contract,
    Gripper,
    GripperCalls,
    GripperPassage,
    Task,
    callees_first,
    contract_findings,
    has_several_tools,
    tools_in,
)
from ropsim.query import Database


def broken_contracts(db: Database) -> tuple[Diagnostic, ...]:
    """Return a warning for each call that a gripper contract contradicts; places count lines in their unit.

    It is that of `ropsim.program.check_contracts`, for a text without circles of calls.
    """
    environment: Environment = db.read(questions.ENVIRONMENT)
    library = callees_first({name: one.task for name, one in environment.tasks.items()})
    for group in (library, *db.ask(questions.groups)):  # so that no chain of calls becomes one of questions
        db.ask(find_passages, group)
    return db.ask(found_contracts)


def find_passages(db: Database, group: questions.Group) -> None:
    """Let tasks be followed from each state."""
    for name in group:
        for state in Gripper:
            db.ask(task_passage, name, state)


def found_contracts(db: Database) -> tuple[Diagnostic, ...]:
    """Return the findings in reachable code."""
    return contract_findings(db.ask(control_passage), lambda name, state: db.ask(task_passage, name, state))


def control_passage(db: Database) -> GripperPassage:
    """Return the control statements, followed."""
    found: list[GripperPassage] = []
    for group in db.ask(questions.part_groups):
        found.append(db.ask(group_passage, group, found[-1].now if found else Gripper.UNKNOWN))
        if found[-1].now is None:
            break
    return _joined(found)


def group_passage(db: Database, group: questions.Group, state: Gripper | None) -> GripperPassage:
    """Return a group of parts, followed from a state."""
    found: list[GripperPassage] = []
    for unit in group:
        found.append(db.ask(part_passage, unit, found[-1].now if found else state))
        if found[-1].now is None:
            break
    return _joined(found)


def part_passage(db: Database, unit: str, state: Gripper | None) -> GripperPassage:
    """Return a part of the control statements, followed from a state."""
    return _calls(db).followed(db.read((questions.BLOCK, unit)), state)


def task_passage(db: Database, name: str, state: Gripper) -> GripperPassage:
    """Return a task of text or library, followed from a state."""
    task = _task(db, name)
    assert task is not None
    return _calls(db).followed(task.body, state)


def contracts_of(db: Database, name: str) -> tuple[Contract, ...] | None:
    """Return the contracts of a task of text or library, None where there is none of that name."""
    task = _task(db, name)
    return task.contracts if task is not None else None


def has_tools(db: Database) -> bool:
    """Return whether text and library name several tools."""
    return has_several_tools(_tools(db))


def tools_of_tasks(db: Database, group: questions.Group) -> frozenset[str]:
    """Return the tools that tasks of the text name."""
    return frozenset().union(*(db.ask(tools_of_task, name) for name in group))


def tools_of_task(db: Database, name: str) -> frozenset[str]:
    """Return the tools that a task of the text names."""
    task = db.ask(questions.checked, name).task
    return tools_in(task.body) if task is not None else frozenset()


def tools_of_parts(db: Database, group: questions.Group) -> frozenset[str]:
    """Return the tools that parts of the control statements name."""
    return frozenset().union(*(db.ask(tools_of_part, unit) for unit in group))


def tools_of_part(db: Database, unit: str) -> frozenset[str]:
    """Return the tools that a part of the control statements names."""
    block: Block = db.read((questions.BLOCK, unit))
    return tools_in(block)


def _tools(db: Database) -> Iterator[str]:
    environment: Environment = db.read(questions.ENVIRONMENT)
    yield environment.default_tool
    for group in db.ask(questions.part_groups):
        yield from db.ask(tools_of_parts, group)
    for group in db.ask(questions.groups):
        yield from db.ask(tools_of_tasks, group)
    for name, one in environment.tasks.items():
        if not db.ask(questions.is_own, name):
            yield from tools_in(one.task.body)


def _task(db: Database, name: str) -> Task | None:
    if db.ask(questions.is_own, name):
        return db.ask(questions.checked, name).task
    environment: Environment = db.read(questions.ENVIRONMENT)
    return environment.tasks[name].task if name in environment.tasks else None


def _calls(db: Database) -> GripperCalls:
    return GripperCalls(
        lambda name: db.ask(contracts_of, name),
        lambda name, state: db.ask(task_passage, name, state),
        db.ask(has_tools),
    )


def _joined(passages: list[GripperPassage]) -> GripperPassage:
    """Return the combined passage of one or more consecutive ones; only their calls count."""
    found: dict[tuple[str, int, int, str], Diagnostic] = {}
    for one in passages:
        found |= {place: wrong for place, wrong in one.found.items() if place not in found}
    entered = frozenset().union(*(one.entered for one in passages))
    return GripperPassage(passages[-1].now, passages[-1].end, found, entered)
