"""Who calls whom; recursion is refused."""

from collections.abc import Iterator

from ropsim.core import Diagnostic
from ropsim.program.diagnostics import RECURSION
from ropsim.program.program import Program, Task
from ropsim.program.statements import Call
from ropsim.program.walk import walk


def recursion(program: Program) -> tuple[Diagnostic, ...]:
    """Return one diagnostic for each call that closes a cycle of calls, with the chain."""
    return tuple(_cycles({task.name: task for task in program.tasks}))


def _cycles(tasks: dict[str, Task]) -> Iterator[Diagnostic]:
    finished: set[str] = set()
    for root, task in tasks.items():
        path = [] if root in finished else [(root, _calls(task))]
        while path:
            name, calls = path[-1]
            call = next(calls, None)
            active = [one for one, _ in path]
            if call is None:
                finished.add(name)
                path.pop()
            elif call.task in active:
                chain = " -> ".join([*active[active.index(call.task) :], call.task])
                message = f"task `{call.task}` calls itself: {chain}"
                yield RECURSION.at(call.span, message, hint="use a loop instead of the call")
            elif call.task in tasks and call.task not in finished:
                path.append((call.task, _calls(tasks[call.task])))


def _calls(task: Task) -> Iterator[Call]:
    return (statement for statement in walk(task.body) if isinstance(statement, Call))
