"""Knowledge bases: engines start, clauses are checked, a thousand tasks loaded, goals asked."""

from typing import Any

import pytest
from measuring import Measure, processor_seconds

from ropsim.core import SourceText
from ropsim.prolog import Engine, Sort, question
from ropsim.tasks import KnowledgeBase

TASKS, RULES, MANY = 1000, 500, 1000
TASK = """\
task(grip_{0}(P, L), [doc("takes a part"), params([P-part, L-location]), pre([gripper(open), at(P, L)]),
  eff([-gripper(open), -at(P, L), +held(P), +free(L)]), geo([reachable(arm, L)]), body([mov(L), close])]).
"""
RULE = "rule_{0}(X, Y) :- member(X, [1, 2, 3]), Y is X + {0}, \\+ X = Y.\n"


def text(name: str, clause: str, count: int) -> SourceText:
    return SourceText(f"kb/{name}.pl", "".join(clause.format(number) for number in range(count)))


@pytest.fixture(scope="module")
def engine() -> Engine:
    engine = Engine()
    engine.register(question("reachable", (Sort.INTEGER,), lambda _: True))
    return engine


def test_start(benchmark: Any) -> None:
    measure = Measure(benchmark)
    measure(lambda: Engine().once("true"))
    start, tasks = processor_seconds(lambda: Engine().once("true"), lambda: KnowledgeBase(()))
    measure.figure("an engine starts and answers, all files at hand [s]", start, most=0.15)
    measure.figure("a knowledge base starts, with the tasks of the library [s]", tasks, most=0.2)


def test_clauses(engine: Engine, benchmark: Any) -> None:
    measure = Measure(benchmark)
    rules, tasks = text("rules", RULE, RULES), text("tasks", TASK, TASKS)
    measure(lambda: engine.check(rules))
    rule, task, load = processor_seconds(
        lambda: engine.check(rules), lambda: engine.check(tasks), lambda: engine.consult(tasks)
    )
    measure.figure("checking a rule [ms]", rule / RULES * 1e3, most=1.0)
    measure.figure("checking a task [ms]", task / TASKS * 1e3, most=1.0)
    measure.figure("checking and loading a thousand tasks in the sandbox [s]", load, most=0.5)
    (asked,) = processor_seconds(lambda: engine.once("task(grip_500(a, b), _)", module="tasks"))
    measure.figure("a goal about one of them, looked through first [ms]", asked * 1e3, most=5.0)
    engine.forget(tasks.name)


def test_goals(engine: Engine, benchmark: Any) -> None:
    measure = Measure(benchmark)
    measure(lambda: engine.once("X is 1 + 2"))
    goal, solutions, calls = processor_seconds(
        lambda: [engine.once("X is 1 + 2") for _ in range(MANY)],
        lambda: sum(1 for _ in engine.query(f"between(1, {MANY}, X)")),
        lambda: engine.once(f"forall(between(1, {MANY}, X), reachable(X))"),
    )
    measure.figure("a goal [µs]", goal / MANY * 1e6, most=2000)
    measure.figure("one more answer [µs]", solutions / MANY * 1e6, most=1000)
    measure.figure("a function of Python is called [µs]", calls / MANY * 1e6, most=1000)
