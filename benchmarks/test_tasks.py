"""Knowledge bases of tasks: a thousand of them are read, calls are checked, goals are planned for."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from measuring import Measure, processor_seconds

from ropsim.cellfile import read_cell
from ropsim.collision import Collisions, bounded_hull
from ropsim.core import SourceText
from ropsim.tasks import KnowledgeBase, Plan, WorldState
from ropsim.workbench import AtStation, CellGeometry, TaskTexts, Workspace, open_project

MANY = 1000
EXAMPLE = Path(__file__).parents[1] / "examples" / "palletizing"
TASK = """\
task(grip_{0}(P, L), [doc("takes a part"), params([P-part, L-location]), pre([gripper(open), at(P, L)]),
  eff([-gripper(open), -at(P, L), +held(P), +free(L)]), geo([reachable(arm, L)]), body([mov(L), close])]).
"""
TEXTS = [SourceText(f"kb/grip_{number}.pl", TASK.format(number)) for number in range(MANY)]
STATE = WorldState.of("gripper(open)", "at(bolt, s1)")


@pytest.fixture(scope="module")
def known() -> KnowledgeBase:
    return KnowledgeBase(())


def row(parts: int) -> tuple[list[str], WorldState]:
    """Return goal and state: parts go from feeders to seats."""
    lying = [f"at(p{k}, f{k})" for k in range(parts)]
    free = [f"free(s{k})" for k in range(parts)]
    return [f"at(p{k}, s{k})" for k in range(parts)], WorldState.of(*lying, *free, "free(b)", "gripper(open)")


def circle(parts: int) -> tuple[list[str], WorldState]:
    """Return goal and state: each part goes where another one lies; two places are free."""
    lying = [f"at(p{k}, s{k})" for k in range(parts)]
    goal = [f"at(p{k}, s{(k + 1) % parts})" for k in range(parts)]
    return goal, WorldState.of(*lying, "free(b1)", "free(b2)", "gripper(open)")


def test_reading(known: KnowledgeBase, benchmark: Any) -> None:
    measure = Measure(benchmark)
    measure(lambda: known.take(TEXTS))
    load, opened = processor_seconds(lambda: known.take(TEXTS), lambda: KnowledgeBase(()))
    measure.figure("reading and checking a clause of a task [ms]", load / MANY * 1e3, most=1.0)
    measure.figure("a base of a thousand tasks, a file each, is read and checked [s]", load, most=0.5)
    measure.figure("a base opens: an engine, our Prolog, the library [s]", opened, most=0.6)

    def all_of_them() -> None:
        known.take(TEXTS)
        known.tasks()

    (records,) = processor_seconds(all_of_them)
    measure.figure("the same with all of its tasks as records [s]", records, most=1.0)


def test_calls(known: KnowledgeBase, benchmark: Any) -> None:
    measure = Measure(benchmark)
    known.take(TEXTS)
    measure(lambda: known.check("grip_500 s1", STATE))
    good, bad = processor_seconds(
        lambda: known.check("grip_500 s1", STATE), lambda: known.check("grip_500 s2", STATE)
    )
    measure.figure("a call is checked among a thousand tasks [ms]", good * 1e3, most=5.0)
    measure.figure("a call is refused, with the tasks that could help [ms]", bad * 1e3, most=20.0)


def test_plans(known: KnowledgeBase, benchmark: Any) -> None:
    measure = Measure(benchmark)
    known.take(())
    assert len(known.plan(*row(8)).calls) == 16
    assert len(known.plan(*circle(8)).calls) == 18
    measure(lambda: known.plan(*row(4)))
    four, eight, blocked = processor_seconds(
        lambda: known.plan(*row(4)), lambda: known.plan(*row(8)), lambda: known.plan(*circle(8))
    )
    measure.figure("a plan for four parts [s]", four, most=1.0)
    measure.figure("a plan for eight parts [s]", eight, most=10.0)
    measure.figure("a plan for eight parts that stand in each other's way [s]", blocked, most=10.0)


ROOM = """
[cell]
name = "c"
[units]
length = "mm"
angle = "deg"
[robot]
model = "puma560"
tool = "jaws"
[tools.jaws]
position = [0, 0, 145]
gripper = {}
shapes = [{ cylinder = { radius = 20, length = 65 }, position = [0, 0, 112.5] }]
[[objects]]
name = "table"
position = [0, 0, -220]
shapes = [{ box = [1200, 1200, 20], position = [0, 0, -10] }]
"""
PLACE = "[locations.{0}]\nposition = [{1}, {2}, -200]\nrpy = [180, 0, 0]\n"
PART = '[[parts]]\nname = "{0}"\nsize = [20, 20, 20]\nmass = 0.1\nposition = [{1}, {2}, -200]\n'
POST = """[[objects]]
name = "{0}"
position = [{1}, {2}, -180]
shapes = [{{ cylinder = {{ radius = 6, length = 80 }} }}]
"""


def room(parts: int) -> CellGeometry:
    """Return the geometry of a cell: parts at places in two rows, posts on two of four other places."""
    rows = [(x, y) for x in (290, 345) for y in (-200, -70, 70, 200)]
    places = {f"s{k}": at for k, at in enumerate(rows[:parts])}
    others = {f"b{k}": (300 + 40 * k, 0) for k in range(4)}
    text = [ROOM]
    text += [PLACE.format(name, *at) for name, at in {**places, **others}.items()]
    text += [PART.format(f"p{k}", *at) for k, at in enumerate(places.values())]
    text += [POST.format(f"post{k}", *others[f"b{k}"]) for k in range(2)]
    cell, findings = read_cell(SourceText("cell.toml", "".join(text)), "c")
    assert cell is not None, findings
    return CellGeometry(cell)


def test_plans_round_obstacles(benchmark: Any) -> None:
    measure = Measure(benchmark)

    def planning(parts: int) -> Callable[[], Plan]:
        geometry = room(parts)
        known = KnowledgeBase((), geometry)
        goal, state = circle(parts)
        facts = WorldState.of(*state.facts, *(f"free(b{k})" for k in (0, 3)))

        def plan() -> Plan:
            geometry.revision = object()  # whatever was asked is asked again
            found = known.plan(goal, facts)
            assert len(found.calls) == 2 * parts + 2
            assert not any(place in str(found) for place in ("b0", "b1"))
            return found

        return plan

    four, eight = planning(4), planning(8)
    measure(four)
    first, second = processor_seconds(four, eight)
    measure.figure("a plan for four parts round two posts, geometry asked anew [s]", first, most=1.0)
    measure.figure("a plan for eight parts round two posts, geometry asked anew [s]", second, most=10.0)


def test_distances(benchmark: Any) -> None:
    measure = Measure(benchmark)
    cell = open_project(EXAMPLE).cell
    assert cell is not None
    ready = Collisions(cell)
    q = cell.first.q_start
    measure(lambda: ready.separation(q))
    points = np.random.default_rng(1).normal(size=(1_000_000, 3))
    points /= np.linalg.norm(points, axis=1)[:, np.newaxis]
    (ball,) = processor_seconds(lambda: bounded_hull(points), rounds=1)
    made, nearest, meetings = processor_seconds(
        lambda: Collisions(cell),
        lambda: ready.separation(q),
        lambda: ready.meetings(q),
    )
    measure.figure("the palletizing cell is made ready for distances [ms]", made * 1e3, most=200.0)
    measure.figure("its smallest distance at one configuration [ms]", nearest * 1e3, most=5.0)
    measure.figure("whether anything is in anything there [ms]", meetings * 1e3, most=5.0)
    measure.figure("a hull of a million points on a ball, the worst there is [s]", ball, most=10.0)


CELL = SourceText(
    "cell.toml",
    '[cell]\nname = "c"\n[robot]\nmodel = "puma560"\n[locations.bin]\nposition = [300, 200, 500]\n',
)
PROGRAM = "program p\nunits mm, deg, s\ngrip_500 bin\npick bin, {0}\npalletize bin, bin, 50, 2\n"


def test_calls_from_programs(benchmark: Any) -> None:
    measure = Measure(benchmark)
    workspace = Workspace()
    count = 0

    def station(one: Workspace, first: str, texts: list[SourceText]) -> AtStation:
        own = (SourceText("kb/a.pl", first), *texts)
        return one.at(CELL, "c", "", tasks=TaskTexts(own))

    def compiled(one: Workspace, at: AtStation) -> None:
        nonlocal count
        count += 1
        found = one.compiled(SourceText("p.task", PROGRAM.format(count)), at)
        assert found.icr is not None, found.diagnostics

    at = station(workspace, "", TEXTS)
    measure(lambda: compiled(workspace, at))

    def other_task() -> None:
        edited = station(workspace, f"home({count}).\n", TEXTS)
        compiled(workspace, edited)

    def fresh() -> None:
        one = Workspace()
        compiled(one, station(one, TASK.format(500), []))

    first, typed, edited = processor_seconds(
        fresh,
        lambda: compiled(workspace, at),
        other_task,
    )
    measure.figure("the first program that calls tasks, with the start of an engine [s]", first, most=1.0)
    measure.figure("a character in a program that calls tasks of a thousand [ms]", typed * 1e3, most=20.0)
    measure.figure("a character in one of a thousand texts of tasks [s]", edited, most=0.8)
