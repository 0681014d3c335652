"""Parts of the cycle time of real runs, and the limits that set the time of their moves."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

import ropsim
from ropsim import icr, robots
from ropsim.flow import CriticalLimit, LimitQuantity, MoveEvent, Recording
from ropsim.model import Cell, PathDefaults, Signal, Tool
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.views import CycleParts, summarize_cycle
from ropsim.workbench import environment_of
from support.cells import one_station

ROBOT = robots.load("puma560")
CELL = one_station(
    "c",
    ROBOT,
    replace(robots.default_controller("puma560"), path=PathDefaults()),  # the joints can do more
    tools={"": Tool("")},
    start=ROBOT.home,
    signals={"lamp": Signal("lamp", is_input=False)},
)
SQUARE = (
    "mov (500, -200, 300)",
    "lin (500, 0, 300) blend 30 mm",
    "lin (500, 0, 100) blend 30 mm",
    "wait 0.25 s",
    "lin (500, 200, 100)",
)
HZ = 1000


def code(*lines: str, cell: Cell = CELL) -> icr.Program:
    text = "\n".join(("program p", "units mm, deg, s", *lines))
    compiled = ropsim.language.compile(text, environment_of(cell))
    assert [str(found) for found in compiled.diagnostics if found.is_error] == []
    assert compiled.icr is not None
    return compiled.icr


@cache
def recorded(*lines: str, fidelity: Fidelity = Fidelity.KINEMATIC) -> Recording:
    return run(CELL, {"robot": code(*lines)}, RunOptions(fidelity, record_hz=HZ))


def whole(recording: Recording) -> CycleParts:
    return summarize_cycle(recording, recording.facts.stations[0]).whole


def critical(*lines: str) -> CriticalLimit | None:
    return recorded(*lines).events_of(MoveEvent)[-1].critical


@pytest.mark.parametrize("fidelity", list(Fidelity))
def test_parts_of_a_run_sum_to_its_duration_and_nothing_is_left_over(fidelity: Fidelity) -> None:
    recording = recorded(*SQUARE, fidelity=fidelity)
    parts = whole(recording)
    ticks = [
        round(part * HZ)
        for part in (parts.motion, parts.blending, parts.settling, parts.gripper, parts.waits, parts.other)
    ]
    assert sum(ticks) == round(parts.total * HZ) == round(recording.duration * HZ)
    assert parts.timers == 0.25
    assert parts.other == 0.0
    assert (parts.settling > 0.0) is (fidelity is Fidelity.DYNAMIC)


def test_time_in_a_zone_is_that_within_its_distance_of_the_target() -> None:
    recording = recorded(*SQUARE)
    away = np.linalg.norm(recording.channels["command_position"].values - (0.5, 0.0, 0.3), axis=1)
    flown = [event for event in recording.events_of(MoveEvent) if event.flown > 0.0]
    assert len(flown) == 1  # a wait follows the second one
    within = np.count_nonzero(away < 0.03 - 1e-9)
    assert sum(event.blending for event in recording.events_of(MoveEvent)) * HZ == pytest.approx(
        within, abs=2
    )
    assert whole(recording).blending * HZ == pytest.approx(within, abs=2)


def test_zones_between_moves_of_joints_count_while_both_move() -> None:
    parts = whole(recorded("mov (500, -200, 300) blend 50 mm", "mov (500, 200, 300)"))
    assert 0.0 < parts.blending < parts.motion


def test_a_long_move_of_joints_is_set_by_the_speed_of_a_joint() -> None:
    found = critical("mov (500, -400, 300)", "mov (-500, 400, 300)")
    assert found is not None
    assert (found.joint, found.quantity) == ("1", LimitQuantity.SPEED)
    assert 0.3 < found.share < 1.0


def test_a_slow_line_is_set_by_the_speed_of_the_tool() -> None:
    found = critical("mov (500, -200, 300)", "lin (500, 200, 300) speed 50 mm/s")
    assert found is not None
    assert (found.joint, found.quantity) == ("", LimitQuantity.SPEED)
    assert found.share > 0.9


def test_a_short_line_is_set_by_the_jerk_of_the_tool() -> None:
    found = critical("mov (500, -200, 300)", "lin (500, -198, 300)")
    assert found is not None
    assert (found.joint, found.quantity) == ("", LimitQuantity.JERK)


@pytest.mark.parametrize(
    "move",
    [
        "circ via (550, -150, 300) to (500, -100, 300) speed 1000 mm/s",
        "spline via (500, -50, 300), (520, 0, 300), (500, 50, 300) to (500, 200, 300) speed 1000 mm/s",
    ],
)
def test_a_bent_path_on_which_the_tool_is_at_no_limit_is_set_by_its_bend(move: str) -> None:
    found = critical("mov (500, -200, 300)", move)
    assert found is not None
    assert (found.joint, found.quantity) == ("", LimitQuantity.BEND)
    assert found.share > 0.5


def test_a_slow_arc_is_set_by_the_speed_of_the_tool() -> None:
    found = critical("mov (500, -200, 300)", "circ via (700, 0, 300) to (500, 200, 300) speed 50 mm/s")
    assert found is not None
    assert (found.joint, found.quantity) == ("", LimitQuantity.SPEED)


@pytest.mark.parametrize(
    ("move", "is_bent"),
    [("lin (350, 300, 300)", False), ("circ via (400, 0, 500) to (350, 300, 300)", True)],
)
def test_a_path_that_asks_too_much_of_a_joint_is_set_by_that_joint(move: str, is_bent: bool) -> None:
    station = CELL.stations["robot"]
    quick = replace(station.controller, path=PathDefaults(3.0, 60.0, 3e4, 10.0, 600.0, 6e4))
    cell = replace(CELL, stations={"robot": replace(station, controller=quick)})
    program = code("mov (350, -300, 300)", move, cell=cell)
    recording = run(cell, {"robot": program}, RunOptions(Fidelity.KINEMATIC))
    found = recording.events_of(MoveEvent)[-1].critical
    assert found is not None
    assert found.joint
    assert (found.quantity is LimitQuantity.BEND) is is_bent
