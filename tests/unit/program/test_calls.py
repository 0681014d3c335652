from itertools import pairwise

from ropsim.core import Span
from ropsim.program import Block, Call, Repeat, Statement, Task, recursion


def at(line: int) -> Span:
    return Span.on_line("t.task", line, 1)


def call(name: str, line: int) -> Call:
    return Call(name, (), at(line))


def messages(**tasks: Block) -> list[str]:
    made = tuple(Task(name, (), (), None, body, (), at(1)) for name, body in tasks.items())
    return [f"{one.span}: {one.message}" for one in recursion(made)]


def test_calls_without_a_cycle_are_accepted() -> None:
    assert messages(a=(call("b", 2), call("c", 3)), b=(call("c", 4),), c=()) == []


def test_a_cycle_is_reported_once_with_its_chain() -> None:
    found = messages(a=(call("b", 2),), b=(call("c", 3),), c=(call("b", 4),))
    assert found == ["t.task:4:1: task `b` calls itself: b -> c -> b"]


def test_a_call_inside_a_loop_counts() -> None:
    body: tuple[Statement, ...] = (Repeat(None, (call("a", 3),), None, at(2)),)
    assert messages(a=body) == ["t.task:3:1: task `a` calls itself: a -> a"]


def test_each_call_that_closes_a_cycle_is_reported() -> None:
    assert len(messages(a=(call("a", 2), call("b", 3)), b=(call("a", 4),))) == 2


def test_unknown_tasks_are_no_concern_of_this_check() -> None:
    assert messages(a=(call("nobody", 2),)) == []


def test_a_long_chain_does_not_exhaust_the_python_stack() -> None:
    names = [f"t{k}" for k in range(3000)]
    tasks: dict[str, Block] = {name: (call(following, 1),) for name, following in pairwise(names)}
    assert messages(**tasks, t2999=(call("t0", 9),))[0].startswith("t.task:9:1: task `t0` calls itself")
