"""Motions end at control ticks: what comes behind them begins there; the last row shows the arm at rest."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import MoveEvent, OutputEvent, Recording, WaitEvent
from ropsim.model import Cell, Signal, Tool
from ropsim.simulation import Fidelity, RunOptions, run
from support.cells import one_station
from support.compiled import code_of

ROBOT = robots.load("puma560")
CELL: Cell = one_station(
    "c",
    ROBOT,
    robots.default_controller("puma560"),
    tools={"": Tool("")},
    start=ROBOT.home,
    signals={"valve": Signal("valve", is_input=False), "lamp": Signal("lamp", is_input=False)},
)
LINES = (
    "mov (500, 0, 300)",
    "set valve on",
    "lin (500, 0, 263)",
    "wait 0.01 s",
    "lin (500, 31, 263) at 0 s before end do set valve off",
    "set lamp on",
    "mov (500, 30, 301)",
)
BOTH = [Fidelity.KINEMATIC, Fidelity.DYNAMIC]


def recorded(fidelity: Fidelity, record_hz: int = 1000) -> Recording:
    return run(CELL, {"robot": code_of(CELL, *LINES)}, RunOptions(fidelity, record_hz))


def ticks(time: float) -> int:
    count = round(1e3 * time)
    assert time == pytest.approx(1e-3 * count, abs=1e-9)
    return count


@pytest.mark.parametrize("fidelity", BOTH)
def test_a_command_is_at_rest_at_the_tick_at_which_its_move_ends_and_not_before(fidelity: Fidelity) -> None:
    recording = recorded(fidelity)
    q = recording.rows("q_ref")
    ends = []
    for move in recording.events_of(MoveEvent):
        end = ticks(move.time + move.travel)
        assert (q[end] != q[end - 1]).any()
        assert (q[end : ticks(move.end) + 1] == q[end]).all()
        ends.append(end - ticks(move.time))
    assert {one % 4 for one in ends} != {0}  # an interpolation tick has four


@pytest.mark.parametrize("fidelity", BOTH)
def test_outputs_waits_and_moves_behind_a_move_begin_at_the_tick_at_which_it_is_over(
    fidelity: Fidelity,
) -> None:
    recording = recorded(fidelity)
    first, second, third, last = recording.events_of(MoveEvent)
    valve, again, lamp = recording.events_of(OutputEvent)
    (wait,) = recording.events_of(WaitEvent)
    assert ticks(valve.time) == ticks(first.end) == ticks(second.time)
    assert ticks(wait.time) == ticks(second.end)
    assert ticks(third.time) == ticks(second.end) + 10
    assert ticks(again.time) == ticks(third.time + third.travel)
    assert ticks(lamp.time) == ticks(third.end) == ticks(last.time)
    assert ticks(recording.duration) == ticks(last.end)


@pytest.mark.parametrize("fidelity", BOTH)
def test_the_last_row_shows_the_arm_after_the_last_move_however_few_rows_there_are(
    fidelity: Fidelity,
) -> None:
    every, few = recorded(fidelity), recorded(fidelity, 100)
    assert few.duration == every.duration
    assert few.time[-2] < few.duration <= few.time[-1]
    assert few.rows("q_ref")[-1].tolist() == every.rows("q_ref")[-1].tolist()
    assert np.abs(few.rows("q")[-1] - every.rows("q")[-1]).max() < 1e-4
