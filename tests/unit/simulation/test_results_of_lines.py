"""Results of lines in a recording: of text and cell, whatever a hand did, as far as the run came."""

from collections.abc import Mapping

import pytest

import ropsim
from ropsim import icr, robots
from ropsim.flow import OverrideChange
from ropsim.model import Cell, Signal, Tool
from ropsim.simulation import Fidelity, InputChange, RunOptions, run
from ropsim.workbench import environment_of
from support.cells import one_station

PROGRAM = """\
program p
units mm, deg, s
wait 0.5 s
for i = 1 to 2
  wait 1 s
endf
wait until go
wait 0.25 s
go_on
task go_on
  wait 0.5 s
endp
"""
LINES = {3, 5, 7, 8, 11}


@pytest.fixture(scope="module")
def cell() -> Cell:
    signals = {"go": Signal("go", is_input=True, changes=((3.0, 1.0),))}
    robot = robots.load("puma560")
    controller = robots.default_controller("puma560")
    return one_station("c", robot, controller, tools={"": Tool("")}, start=robot.home, signals=signals)


@pytest.fixture(scope="module")
def program(cell: Cell) -> icr.Program:
    compiled = ropsim.language.compile(PROGRAM, environment_of(cell))
    assert compiled.icr is not None
    return compiled.icr


def results(cell: Cell, program: icr.Program, **options: object) -> Mapping[int, str]:
    """Return by line the key of its result in an ideal run."""
    made = RunOptions(Fidelity.KINEMATIC, longest=20.0, **options)  # type: ignore[arg-type]  # those of the record
    return dict(run(cell, {"robot": program}, made).content.results["robot"])


def test_a_key_press_and_an_override_are_no_change_of_the_text(cell: Cell, program: icr.Program) -> None:
    plain = results(cell, program)
    assert plain.keys() == LINES
    assert results(cell, program, inputs=(InputChange(2.75, "go", 1.0),)) == plain
    assert results(cell, program, overrides=(OverrideChange(0.25, 0.5),)) == plain
    assert results(cell, program, stopped=19.0) == plain  # it had come to its own end


@pytest.mark.parametrize(
    ("stopped", "done"),
    [
        (0.25, set()),
        (0.75, {3}),
        (1.75, {3}),  # the loop goes round again
        (2.75, {3, 5}),
        (3.1, {3, 5, 7}),
        (3.5, {3, 5, 7, 8}),  # in the task, at line 11
    ],
)
def test_a_run_that_is_ended_early_has_results_of_the_lines_that_are_done(
    cell: Cell, program: icr.Program, stopped: float, done: set[int]
) -> None:
    found = results(cell, program, stopped=stopped)
    assert found.keys() == done
    assert found.items() <= results(cell, program).items()


LOOPED = """\
program p
units mm, deg, s
for i = 1 to 3
  mov joints (30, 60, -150, 0, -60, 0) speed 20 %
  wait 0.5 s
  mov joints (0, 60, -150, 0, -60, 0) speed 20 %
endf
wait until go
wait 0.25 s
wait 0.5 s
"""
HELD = (OverrideChange(0.25, 0.5), OverrideChange(0.5, 0.0))
"""In the first move: it is held before its target."""


@pytest.mark.parametrize(
    ("stopped", "overrides", "done"),
    [
        (0.5, (), set()),
        (2.0, (), {4}),
        (3.0, (), {4, 5}),
        (4.5, (), {5, 6}),  # line 4 again
        (2.0, (OverrideChange(1.6, 0.0),), {4}),
        (4.0, HELD, set()),
        (11.0, (), {4, 5, 6, 8, 9}),  # line 8 took no time; line 10 hangs on the same look at an input
    ],
)
def test_lines_of_a_loop_that_are_behind_have_a_result_and_the_one_under_way_has_none(
    cell: Cell, stopped: float, overrides: tuple[OverrideChange, ...], done: set[int]
) -> None:
    compiled = ropsim.language.compile(LOOPED, environment_of(cell))
    assert compiled.icr is not None
    found = results(cell, compiled.icr, stopped=stopped, overrides=overrides)
    assert found.keys() == done
    whole = results(cell, compiled.icr)
    assert found.items() <= whole.items()
    assert len(set(whole.values())) == len(whole), "a line that was reached vouches for one that was not"
