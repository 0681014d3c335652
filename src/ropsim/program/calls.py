"""Who calls whom; recursion is refused."""

from collections.abc import Iterator, Mapping

from ropsim.core import Diagnostic
from ropsim.program.diagnostics import RECURSION
from ropsim.program.program import Program, Task
from ropsim.program.statements import Call
from ropsim.program.walk import walk


def recursion(program: Program) -> tuple[Diagnostic, ...]:
    """Return one diagnostic for each call that closes a cycle of calls, with the chain."""
    return tuple(_cycles({task.name: task for task in program.tasks}))


def callees_first(tasks: Mapping[str, Task]) -> tuple[str, ...]:
    """Return the names of the tasks, callees before callers as far as no circle is closed."""
    order: list[str] = []
    seen: set[str] = set()
    for root in tasks:
        path = [] if root in seen else [(root, _calls(tasks[root]))]
        seen.add(root)
        while path:
            name, calls = path[-1]
            call = next(calls, None)
            if call is None:
                order.append(name)
                path.pop()
            elif call.task in tasks and call.task not in seen:
                seen.add(call.task)
                path.append((call.task, _calls(tasks[call.task])))
    return tuple(order)


def _cycles(tasks: dict[str, Task]) -> Iterator[Diagnostic]:
    finished: set[str] = set()
    for root, task in tasks.items():
        path = {} if root in finished else {root: _calls(task)}
        while path:
            name = next(reversed(path))
            call = next(path[name], None)
            if call is None:
                finished.add(name)
                del path[name]
            elif call.task in path:
                active = list(path)
                chain = " -> ".join([*active[active.index(call.task) :], call.task])
                message = f"task `{call.task}` calls itself: {chain}"
                yield RECURSION.at(call.span, message, hint="use a loop instead of the call")
            elif call.task in tasks and call.task not in finished:
                path[call.task] = _calls(tasks[call.task])


def _calls(task: Task) -> Iterator[Call]:
    return (statement for statement in walk(task.body) if isinstance(statement, Call))
