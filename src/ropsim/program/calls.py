"""Who calls whom; recursion is refused."""

from collections.abc import Iterable, Iterator, Mapping

from ropsim.core import Diagnostic, Span
from ropsim.program.diagnostics import RECURSION
from ropsim.program.program import Task
from ropsim.program.statements import Call
from ropsim.program.walk import walk


def recursion(tasks: Iterable[Task]) -> tuple[Diagnostic, ...]:
    """Return one diagnostic for each call that closes a cycle of calls among tasks, with the chain."""
    return circles({task.name: tuple((one.task, one.span) for one in _calls(task)) for task in tasks})


def circles(calls: Mapping[str, Iterable[tuple[str, Span]]]) -> tuple[Diagnostic, ...]:
    """Return the same for the calls of each task and their places, by the name of the task."""
    return tuple(_cycles(calls))


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


def _cycles(calls: Mapping[str, Iterable[tuple[str, Span]]]) -> Iterator[Diagnostic]:
    finished: set[str] = set()
    for root, first in calls.items():
        path = {} if root in finished else {root: iter(first)}
        while path:
            name = next(reversed(path))
            called, span = next(path[name], ("", None))
            if span is None:
                finished.add(name)
                del path[name]
            elif called in path:
                active = list(path)
                chain = " -> ".join([*active[active.index(called) :], called])
                message = f"task `{called}` calls itself: {chain}"
                yield RECURSION.at(span, message, hint="use a loop instead of the call")
            elif called in calls and called not in finished:
                path[called] = iter(calls[called])


def _calls(task: Task) -> Iterator[Call]:
    return (statement for statement in walk(task.body) if isinstance(statement, Call))
