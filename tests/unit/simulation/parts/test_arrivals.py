"""Whether parts are at their destinations when a run ends."""

from dataclasses import replace

import numpy as np
import pytest

import ropsim
from ropsim.flow import Destinations, Recording
from ropsim.kinematics import NO_BLOCKS
from ropsim.model import Cell, Destination, Gripper, Part, Signal, Sink, Tool
from ropsim.robots import default_controller, load
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.simulation.testing import Moment, arrivals, initial_parts
from ropsim.spatial import Pose
from ropsim.views import Style, summarize, terminal_report
from ropsim.workbench import environment_of
from support.cells import one_station

ARM = load("puma560")


def goal(x: float, y: float, yaw: float = 0.0, turn: float | None = 0.1) -> Destination:
    X_WO = Pose(np.array([x, y, 0.3]), np.array([np.cos(yaw / 2), 0.0, 0.0, np.sin(yaw / 2)]))
    return Destination(X_WO, 0.005, turn)


def part(name: str, y: float, destination: Destination | None) -> Part:
    return Part(name, np.full(3, 0.05), 0.2, Pose(np.array([0.5, y, 0.3])), destination=destination)


CELL = one_station(
    "c",
    ARM,
    default_controller("puma560"),
    tools={"jaws": Tool("jaws", Pose(np.array([0.0, 0.0, 0.12])), 1.0, gripper=Gripper(0.2, 0.2, 0.005))},
    default_tool="jaws",
    parts=(part("a", 0.1, goal(0.5, -0.1)), part("b", 0.2, None)),
    start=ARM.home,
)
CARRY = ("mov (500, 100, 300)", "close", "mov (500, -100, 300)", "open")


def ran(*lines: str, cell: Cell = CELL, longest: float = 1e3) -> Recording:
    text = "\n".join(("program p", "units mm, deg, s", *lines))
    compiled = ropsim.language.compile(text, environment_of(cell))
    assert compiled.icr is not None
    return run(cell, {"robot": compiled.icr}, RunOptions(Fidelity.KINEMATIC, longest=longest))


def with_goal(destination: Destination | None) -> Cell:
    return replace(CELL, parts=(part("a", 0.1, destination), CELL.parts[1]))


def report(recording: Recording) -> str:
    return terminal_report(summarize(recording), Style.PLAIN)


def test_a_part_that_is_there_is_counted_and_nothing_is_found() -> None:
    recording = ran(*CARRY)
    assert recording.ok
    assert recording.findings == ()
    assert recording.facts.destinations == Destinations(1, 1)
    assert "parts        1 of 1 part at its destination\n" in report(recording)


@pytest.mark.parametrize(
    ("destination", "words"),
    [
        (
            goal(0.5, -0.12),
            "is at (500.0, -100.0, 300.0) mm, its destination is (500.0, -120.0, 300.0) mm: 20.0 mm",
        ),
        (goal(0.5, -0.1, yaw=0.2), ": turned by 11.5°, allowed are 5.72958°"),
        (goal(0.5, -0.11, yaw=-0.2), "10.0 mm away, allowed are 5 mm and turned by 11.5°"),
    ],
)
def test_a_part_that_is_elsewhere_or_turned_is_an_error(destination: Destination, words: str) -> None:
    recording = ran(*CARRY, cell=with_goal(destination))
    (found,) = recording.findings
    assert (found.code, found.is_error) == ("S738", True)
    assert found.message.startswith("part `a` is at (")
    assert words in found.message
    assert not recording.ok
    assert "parts        0 of 1 part at its destination\n" in report(recording)


def test_where_only_the_place_counts_a_turn_does_not() -> None:
    assert ran(*CARRY, cell=with_goal(goal(0.5, -0.1, yaw=2.0, turn=None))).ok


def test_a_part_in_the_gripper_is_not_there() -> None:
    (found,) = ran(*CARRY[:-1]).findings
    assert "part `a`, still in the gripper, is at" in found.message
    assert found.message.endswith(": not released")


def test_a_part_that_nobody_has_moved_and_one_that_is_gone_are_found() -> None:
    (found,) = ran("open").findings
    assert "200.0 mm away" in found.message
    gone = ran(*CARRY, cell=replace(CELL, sinks=(Sink("bin", (0.5, -0.1, 0.3), 0.05),)))
    assert [one.message for one in gone.findings] == [
        "part `a` has left the cell by the sink `bin`, it was to be at (500.0, -100.0, 300.0) mm"
    ]


def test_a_part_that_waits_in_its_supply_is_found() -> None:
    second = replace(CELL.parts[0], name="a2", supply="s", turn=1)
    cell = replace(CELL, parts=(replace(CELL.parts[0], supply="s"), second))
    found = arrivals(initial_parts(cell), {one.name: one for one in cell.parts}, (), Moment({}, NO_BLOCKS))
    assert found.wanted == 2
    assert "part `a2` still waits in its supply" in found.findings[1].message


def test_a_program_that_never_uses_a_gripper_has_nothing_to_do_with_parts() -> None:
    recording = ran("mov (500, 100, 300)", "mov (500, -100, 300)")
    assert recording.findings == ()
    assert recording.facts.destinations == Destinations(0, 0)


def test_without_destinations_nothing_is_said() -> None:
    recording = ran("open", cell=with_goal(None))
    assert recording.facts.destinations == Destinations(0, 0)
    assert "at its destination" not in report(recording)


def test_a_run_that_waits_in_vain_says_nothing() -> None:
    never = replace(CELL, signals={"never": Signal("never", is_input=True)})
    recording = ran("wait until never", cell=never)
    assert [one.code for one in recording.findings] == ["S742"]
    assert recording.facts.destinations == Destinations(0, 0)


def test_a_run_that_was_cut_short_says_nothing() -> None:
    recording = ran("wait 10 s", longest=1.0)
    assert [one.code for one in recording.findings] == ["S723"]
    assert recording.facts.destinations == Destinations(0, 0)
