"""Inputs from outside: what the cell cannot take is left out, the rest is merged and recorded."""

from dataclasses import replace

import numpy as np
import pytest

import ropsim
from ropsim import icr, robots
from ropsim.flow import InputEvent, Interventions, MoveEvent, Recording
from ropsim.model import Cell, Signal, Tool
from ropsim.records import with_inputs as with_recorded
from ropsim.simulation import Fidelity, InputChange, RunOptions, RunView, run
from ropsim.simulation.testing import usable_inputs, with_inputs
from ropsim.workbench import environment_of
from support.cells import one_station, with_station

SIGNALS = {
    "go": Signal("go", is_input=True, changes=((2.0, 0.0),)),
    "level": Signal("level", is_input=True, analog=True),
    "lamp": Signal("lamp", is_input=False),
}
PROGRAM = """\
program p
units mm, deg, s
wait until go
set lamp on
wait 0.5 s
"""


@pytest.fixture(scope="module")
def cell() -> Cell:
    robot = robots.load("puma560")
    controller = robots.default_controller("puma560")
    return one_station("c", robot, controller, tools={"": Tool("")}, start=robot.home, signals=SIGNALS)


@pytest.fixture(scope="module")
def program(cell: Cell) -> icr.Program:
    compiled = ropsim.language.compile(PROGRAM, environment_of(cell))
    assert compiled.icr is not None
    return compiled.icr


def ideal(cell: Cell, program: icr.Program, *inputs: InputChange) -> Recording:
    return run(cell, {"robot": program}, RunOptions(Fidelity.KINEMATIC, inputs=inputs, longest=5.0))


def test_a_run_goes_on_at_the_time_of_the_input(cell: Cell, program: icr.Program) -> None:
    recording = ideal(cell, program, InputChange(1.0, "go", 1.0))
    assert recording.duration == pytest.approx(1.5, abs=0.01)
    assert recording.findings == ()


def test_an_input_is_an_event_a_channel_and_a_fact_of_the_run(cell: Cell, program: icr.Program) -> None:
    recording = ideal(cell, program, InputChange(1.0, "go", 1.0))
    assert recording.events_of(InputEvent) == (InputEvent(1.0, signal="go", value=1.0),)
    assert recording.facts.inputs == (InputChange(1.0, "go", 1.0),)
    np.testing.assert_array_equal(recording.rows("signal.go"), recording.time > 1.0)


def test_inputs_beyond_the_end_of_the_run_are_not_part_of_it(cell: Cell, program: icr.Program) -> None:
    recording = ideal(cell, program, InputChange(1.0, "go", 1.0), InputChange(4.0, "level", 2.0))
    assert [one.signal for one in recording.events_of(InputEvent)] == ["go"]
    assert len(recording.facts.inputs) == 1


def test_at_one_time_the_input_holds_and_not_the_change_of_the_cell(cell: Cell) -> None:
    merged = with_inputs(cell, [InputChange(2.0, "go", 1.0), InputChange(1.0, "go", 1.0)])
    assert merged.signals["go"].changes == ((1.0, 1.0), (2.0, 1.0))


@pytest.mark.parametrize(("first", "last"), [(0.25, 0.75), (0.75, 0.25)])
def test_of_two_values_at_one_time_the_one_given_last_holds(
    cell: Cell, program: icr.Program, first: float, last: float
) -> None:
    both = (InputChange(1.0, "level", first), InputChange(1.0, "level", last))
    recording = ideal(cell, program, InputChange(2.5, "go", 1.0), *both)
    assert recording.rows("signal.level")[-1] == last
    assert recording.facts.inputs == (*both, InputChange(2.5, "go", 1.0))
    assert recording == ideal(cell, program, *recording.facts.inputs)


@pytest.mark.parametrize(
    ("change", "reason", "hint"),
    [
        (InputChange(1.0, "goo", 1.0), "no such signal", "did you mean `go`?"),
        (InputChange(1.0, "xyz", 1.0), "no such signal", "inputs of the cell are `go`, `level`"),
        (InputChange(1.0, "lamp", 1.0), "output", "inputs of the cell are `go`, `level`"),
        (InputChange(-1.0, "go", 1.0), "-1 s", "mend its `time`"),
        (InputChange(float("nan"), "go", 1.0), "nan s", "mend its `time`"),
        (InputChange(1.0, "go", 0.5), "0 or 1", "mend its `value`"),
        (InputChange(1.0, "level", float("inf")), "needed is a number", "mend its `value`"),
    ],
)
def test_what_the_cell_cannot_take_is_left_out_with_a_finding(
    cell: Cell, change: InputChange, reason: str, hint: str
) -> None:
    kept, (finding,) = usable_inputs(cell, [change, change, InputChange(3.0, "level", 0.5)])
    assert kept == (InputChange(3.0, "level", 0.5),)
    assert finding.code == "S760"
    assert reason in finding.message
    assert hint in finding.hint


class Stopper:
    """Ends a run by hand once a time has come."""

    def __init__(self, time: float) -> None:
        self.time = time

    def advanced(self, run: RunView) -> None:
        if run.time >= self.time:
            run.stop()

    @property
    def may_press(self) -> bool:
        return False

    def reading(self, run: RunView) -> None:
        pass

    def ended(self, run: RunView) -> None:
        pass


@pytest.mark.parametrize("line", ["wait 3000 s", "wait until go timeout 3000 s else mov home"])
def test_a_run_that_is_ended_by_hand_says_so_and_keeps_what_it_has(cell: Cell, line: str) -> None:
    text = f"program p\nunits mm, deg, s\n{line}\nmov home\n"
    compiled = ropsim.language.compile(text, environment_of(cell))
    assert compiled.icr is not None
    recording = run(cell, {"robot": compiled.icr}, RunOptions(Fidelity.KINEMATIC, watch=Stopper(2.0)))
    assert [found.code for found in recording.findings] == ["S761"]
    assert 2.0 <= recording.duration <= 3.0
    assert not [event for event in recording.events if event.kind == "move"]


def test_many_rows_are_thinned_and_the_facts_tell_the_rate(cell: Cell, program: icr.Program) -> None:
    options = RunOptions(Fidelity.KINEMATIC, inputs=(InputChange(1.0, "go", 1.0),))
    full, thin = (
        run(cell, {"robot": program}, options),
        run(cell, {"robot": program}, replace(options, most_rows=100)),
    )
    assert len(thin.time) <= 100
    assert thin.facts.record_hz == pytest.approx(full.facts.record_hz / 4)
    rows = np.minimum(np.searchsorted(full.time, thin.time), len(full.time) - 1)  # at the end it stands
    np.testing.assert_array_equal(full.channels["q"].values[rows], thin.channels["q"].values)
    assert thin.duration == full.duration


def test_a_run_may_be_ended_while_the_arm_settles(cell: Cell) -> None:
    compiled = ropsim.language.compile(
        "program p\nunits mm, deg\nmov joints (60, 60, -150, 0, -60, 0)\n", environment_of(cell)
    )
    assert compiled.icr is not None
    narrow = with_station(cell, controller=replace(cell.first.controller, in_position=np.full(6, 1e-6)))
    whole = run(narrow, {"robot": compiled.icr}, RunOptions())
    (move,) = whole.events_of(MoveEvent)
    settling = move.travel + 0.01
    assert move.settle > 0.01
    for options in (RunOptions(watch=Stopper(settling)), RunOptions(longest=settling)):
        recording = run(narrow, {"robot": compiled.icr}, options)
        assert recording.duration < whole.duration
        assert {found.code for found in recording.findings} <= {"S761", "S723"}


def test_a_wait_for_an_input_ends_after_the_longest_wait(cell: Cell, program: icr.Program) -> None:
    options = RunOptions(Fidelity.KINEMATIC, inputs=(InputChange(1.5, "go", 1.0),))
    waited = run(cell, {"robot": program}, options)
    given_up = run(cell, {"robot": program}, replace(options, longest_wait=1.0))
    assert waited.findings == ()
    assert given_up.duration == pytest.approx(1.0, abs=0.01)
    assert [found.is_error for found in given_up.findings] == [True]


def test_a_run_with_inputs_waits_for_the_last_of_them(cell: Cell) -> None:
    given = Interventions((InputChange(7000.0, "go", 1.0), InputChange(1.0, "go", 0.0)))
    options = with_recorded(RunOptions(), given)
    assert options.longest_wait > 7000.0
    assert options.longest > 7000.0
