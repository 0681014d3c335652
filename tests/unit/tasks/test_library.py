"""The built-in library: nothing is wrong with it, and each task compiles and runs."""

import pytest

from ropsim.icr import StillWorld, run
from ropsim.language import compile
from ropsim.tasks import KnownTask, Quantity, TaskCall, Value, program_text
from support.knowledge import CELL, INPUTS, base

TASKS = {
    "grip", "release", "palletize", "pick", "place", "move_over", "depalletize", "insert", "screw",
    "dispense", "inspect", "load_machine", "unload_machine", "tool_change", "park",
}  # fmt: skip
VALUES: dict[str, Value] = {"length": Quantity(10, "mm"), "int": 2}


def call_of(task: KnownTask) -> TaskCall:
    """Return a call of a task, with what it needs and no more."""
    passed = [one for one in task.passed if one.default is None]
    points = ("s1", "s2")[: sum(one.kind == "location" for one in passed)]
    return TaskCall(task.name, points, tuple(VALUES[one.kind] for one in passed if one.kind != "location"))


def test_the_library_has_its_tasks_and_nothing_is_wrong_with_them() -> None:
    known = base()
    assert known.findings == ()
    assert set(known.names) == TASKS
    assert all(one.doc and one.is_built_in for one in known.tasks())


@pytest.mark.parametrize("name", sorted(TASKS))
def test_a_task_of_the_library_compiles_and_runs(name: str) -> None:
    task = base().task(name)
    assert task is not None
    compiled = compile(program_text(base().task, [call_of(task)], "main"), CELL)
    assert compiled.diagnostics == ()
    assert compiled.icr is not None
    assert run(compiled.icr, StillWorld(dict.fromkeys(INPUTS, True))).moves
