"""Guarded moves of a run: a condition ends them on their way, and is told where it never came true."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import Severity
from ropsim.flow import MoveEvent, Recording
from ropsim.kinematics import forward
from ropsim.model import Cell, Signal, Tool
from ropsim.simulation import Fidelity, NobodyWatches, RunOptions, RunView, run
from support.cells import one_station
from support.compiled import code_of

ROBOT = robots.load("puma560")
SIGNALS = {
    "touch": Signal("touch", is_input=True, changes=((3.0, 1.0),)),
    "never": Signal("never", is_input=True),
    "force": Signal("force", is_input=True, analog=True, changes=((3.0, 20.0),)),
}
CELL: Cell = one_station(
    "c",
    ROBOT,
    robots.default_controller("puma560"),
    tools={"": Tool("")},
    start=ROBOT.home,
    signals=SIGNALS,
)
APPROACH = "mov (500, 0, 300)"
SLOW = "speed 20 mm/s"
TICKS = 0.008
"""Within which a condition is seen: two interpolation ticks [s]."""
STARTING = 0.2
"""Within which the arm starts; within twice this the motion clock has braked it [s]."""


def recorded(*lines: str) -> Recording:
    return run(CELL, {"robot": code_of(CELL, *lines)}, RunOptions(Fidelity.KINEMATIC))


def guards(recording: Recording) -> list[tuple[int, str]]:
    return [
        (found.span.line if found.span else 0, found.message)
        for found in recording.findings
        if found.code == "S746"
    ]


@pytest.mark.parametrize("condition", ["touch", "force > 15"])
def test_a_condition_that_comes_true_ends_the_motion_there(condition: str) -> None:
    recording = recorded(APPROACH, f"lin (500, 0, 200) {SLOW} until {condition}", "wait 1 s")
    moves = recording.events_of(MoveEvent)
    way = np.linalg.norm(forward(ROBOT, recording.rows("q")[-1]).position - [0.5, 0.0, 0.3])
    seen = 3.0 - (moves[0].time + moves[0].duration)
    assert 0.0 < 0.02 * (seen - STARTING) < way < 0.02 * (seen + TICKS + 2.0 * STARTING)
    assert guards(recording) == []


@pytest.mark.parametrize(
    ("condition", "told"),
    [
        ("never", "`never is on`"),
        ("touch is off", ""),
        ("force > 25", "`force > 25`"),
        ("force < -1", "`force < -1`"),
    ],
)
def test_a_motion_that_came_to_its_target_without_its_condition_is_told_at_its_line(
    condition: str, told: str
) -> None:
    recording = recorded(APPROACH, f"lin (500, 0, 200) {SLOW} until {condition}")
    if not told:
        assert guards(recording) == []
        return
    ((line, message),) = guards(recording)
    assert line == 4
    assert f"{told} never came true" in message
    (found,) = (one for one in recording.findings if one.code == "S746")
    assert (found.severity, found.label) == (Severity.HINT, "pass 1")
    move = recording.events_of(MoveEvent)[1]
    assert found.data["time_s"] == move.time + move.travel


def test_a_motion_with_a_timeout_has_said_what_it_expects() -> None:
    assert guards(recorded(APPROACH, f"lin (500, 0, 200) {SLOW} until never timeout 1 s")) == []
    assert guards(recorded(APPROACH, f"lin (500, 0, 200) {SLOW} until never timeout 100 s")) == []


def test_a_condition_that_comes_true_in_the_last_slice_has_been_met() -> None:
    first = recorded(APPROACH, f"lin (500, 0, 200) {SLOW} until never")
    move = first.events_of(MoveEvent)[1]
    end = move.time + move.travel
    late = Signal("touch", is_input=True, changes=((end - 0.5e-3, 1.0),))
    cell = one_station(
        "c", ROBOT, CELL.first.controller, tools={"": Tool("")}, start=ROBOT.home, signals={"touch": late}
    )
    code = code_of(cell, APPROACH, f"lin (500, 0, 200) {SLOW} until touch")
    assert guards(run(cell, {"robot": code}, RunOptions(Fidelity.KINEMATIC))) == []


class Stopping(NobodyWatches):
    """Ends the run on the way of the guarded motion."""

    def advanced(self, run: RunView) -> None:
        if run.time > 2.0:
            run.stop()

    @property
    def may_press(self) -> bool:
        return True


def test_a_motion_that_was_ended_by_hand_says_nothing_of_its_condition() -> None:
    code = code_of(CELL, APPROACH, f"lin (500, 0, 200) {SLOW} until never")
    recording = run(CELL, {"robot": code}, RunOptions(Fidelity.KINEMATIC, watch=Stopping()))
    assert recording.duration < 3.0
    assert guards(recording) == []


@pytest.mark.parametrize(
    ("condition", "seen"),
    [("touch", "touch is on"), ("force > 15", "force > 15"), ("not never", "never is off")],
)
def test_a_condition_that_is_true_before_the_motion_begins_is_told(condition: str, seen: str) -> None:
    recording = recorded("wait 4 s", APPROACH, "", f"lin (500, 0, 200) {SLOW} until {condition}")
    (found,) = [one for one in recording.findings if one.code == "S754"]
    assert found.span is not None
    assert found.span.line == 6
    assert found.message == f"`{seen}` was true before the motion began: the arm did not go"
    search = recording.events_of(MoveEvent)[-1]
    assert (search.motion, search.travel) == ("LIN", 0.0)


def test_a_condition_that_comes_true_on_the_way_or_a_time_that_is_over_says_nothing_of_that() -> None:
    on_the_way = recorded(APPROACH, f"lin (500, 0, 200) {SLOW} until touch", "wait 1 s")
    over = recorded(APPROACH, f"lin (500, 0, 200) {SLOW} until never timeout 0.5 s")
    assert not {"S754", "S746"} & {one.code for one in (*on_the_way.findings, *over.findings)}


def test_of_a_motion_that_begins_in_a_zone_it_is_told_that_the_arm_brakes() -> None:
    way = (
        f"lin (500, 0, 250) {SLOW} blend 20",
        f"lin (500, 100, 250) {SLOW} until not never store seen",
        "print seen",
    )
    recording = recorded(APPROACH, *way)
    (found,) = [one for one in recording.findings if one.code == "S754"]
    assert found.message.endswith(
        "was true before the motion began: the arm came through a zone and braked at once"
    )
    gone = recording.events_of(MoveEvent)[-1]
    assert gone.travel > 0.0
