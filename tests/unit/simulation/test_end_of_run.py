"""Every run ends: standing still and waiting stop at the longest time, a diverged arm at its source line."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import icr, robots
from ropsim.controller import CompiledLaw, LawTraits
from ropsim.core import Category
from ropsim.flow import MoveEvent, Recording
from ropsim.model import Cell, DcMotor, InputKind, Link, Rates, Signal, Tool
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.simulation.testing import SPEED_TIME
from support.cells import one_station, with_station
from support.compiled import code_of, station_code

LONGEST = 2.0
SIGNALS = {
    "never": Signal("never", is_input=True),
    "late": Signal("late", is_input=True, changes=((1.0, 1.0),)),
}


@pytest.fixture(scope="module")
def cell() -> Cell:
    robot = robots.load("puma560")
    controller = robots.default_controller("puma560")
    return one_station("c", robot, controller, tools={"": Tool("")}, start=robot.home, signals=SIGNALS)


def ideal(cell: Cell, *lines: str) -> Recording:
    return run(cell, {"robot": code_of(cell, *lines)}, RunOptions(Fidelity.KINEMATIC, longest=LONGEST))


@pytest.mark.parametrize(
    "wait",
    [
        "wait 1e9 s",
        "wait until never timeout 1e9 s",
        "wait until never timeout 1e9 s else mov home",
        "wait until never and late timeout 1e9 s",
    ],
)
def test_a_wait_beyond_the_longest_time_is_a_finding_at_its_line(cell: Cell, wait: str) -> None:
    recording = ideal(cell, "mov home", wait, "mov home")
    assert [(found.code, found.span.line if found.span else 0) for found in recording.findings] == [
        ("S723", 4)
    ]
    assert recording.duration == pytest.approx(LONGEST, abs=1e-9)


def test_waits_within_the_longest_time_are_no_finding(cell: Cell) -> None:
    recording = ideal(cell, "wait 0.5 s", "wait until late", "wait until never timeout 0.25 s else mov home")
    assert recording.findings == ()
    assert recording.duration == pytest.approx(1.25, abs=0.01)


def test_a_long_stand_is_the_same_in_one_piece_and_in_slices(
    cell: Cell, monkeypatch: pytest.MonkeyPatch
) -> None:
    program = code_of(cell, "mov joints (0, 60, -150, 0, -60, 0)", "wait 0.5 s")
    whole = run(cell, {"robot": program}, RunOptions())
    monkeypatch.setattr("ropsim.simulation.state.station_run._SLICE", 7)
    sliced = run(cell, {"robot": program}, RunOptions())
    assert np.array_equal(whole.channels["q"].values, sliced.channels["q"].values)
    assert np.array_equal(whole.time, sliced.time)


def test_an_output_of_the_program_alone_is_off_until_it_is_set(cell: Cell) -> None:
    recording = ideal(cell, "signal lamp = output 7", "wait 0.5 s", "set lamp on", "wait 0.5 s")
    lamp = recording.rows("signal.lamp")
    assert (lamp[recording.time <= 0.5] == 0.0).all()
    assert (lamp[recording.time > 0.51] == 1.0).all()


def test_a_diverged_arm_is_reported_at_the_line_and_pass_that_it_was_in(cell: Cell) -> None:
    controller = cell.first.controller
    coarse = with_station(cell, controller=replace(controller, rates=Rates(50, 4, plant_steps=2)))
    program = code_of(coarse, "mov home", "repeat 2", "  mov joints (90, 60, -150, 0, -60, 0)", "endr")
    recording = run(coarse, {"robot": program}, RunOptions())
    (found,) = (one for one in recording.findings if one.is_error)
    assert found.span is not None
    assert (found.code, found.span.line, found.label) == ("S701", 5, "pass 1")
    assert found.category is Category.UNFINISHED


GONE = """\
def law(par, state, ref, meas, load, aux, out):
    state[0, 0] += 1.0
    for j in range(out.shape[0]):
        out[j] = 1000.0 * (ref[0, j] - meas[0, j]) - 3.0 * meas[1, j]
        if state[0, 0] > par[0, j]:
            out[j] = math.nan
"""


def gone_after(ticks: float) -> CompiledLaw:
    traits = LawTraits(InputKind.VOLTAGE, ("k",))
    return CompiledLaw("gone", GONE, ("ticks",), np.full((1, 6), ticks), traits)


def test_what_was_until_a_state_is_no_number_is_kept(cell: Cell) -> None:
    """The law puts out NaN at tick 700 of the move: rows until then are those of a run where it does not."""
    program = code_of(cell, "wait 0.5 s", "mov joints (90, 60, -150, 0, -60, 0)")
    name = cell.first.name
    lost, whole = (
        run(cell, {name: program}, RunOptions(laws={name: gone_after(ticks)})) for ticks in (700.0, 1e9)
    )
    (found,) = (one for one in lost.findings if one.is_error)
    assert (found.code, found.data["tick"]) == ("S701", 701)
    assert 0.7 <= lost.duration <= 0.704 < whole.duration  # up to the next row
    sound = int(np.flatnonzero(lost.time <= 0.7)[-1]) + 1
    for channel in ("q", "qd", "current", "q_ref"):
        assert np.isfinite(lost.rows(channel)).all()
        np.testing.assert_array_equal(lost.rows(channel)[:sound], whole.rows(channel)[:sound])


@pytest.mark.parametrize("lost", ["robot", "zother"])
def test_other_stations_go_on_until_then(cell: Cell, lost: str) -> None:
    """The one whose state is lost is ahead by a slow line, or behind."""
    both = replace(cell, stations={one: replace(cell.first, name=one) for one in ("robot", "zother")})
    start = "mov (400, -200, 300; rpy 180 0 0)"
    slow, quick = "lin (400, -100, 300; rpy 180 0 0) speed 20", "lin (400, -100, 300; rpy 180 0 0) speed 100"
    lines = {one: (start, slow if one == lost else quick, "wait 8 s") for one in both.stations}
    programs = {
        "robot": code_of(both, *lines["robot"]),
        "zother": station_code(both, "zother", *lines["zother"]),
    }
    ends, whole = (run(both, programs, RunOptions(laws={lost: gone_after(ticks)})) for ticks in (5000.0, 1e9))
    assert {one.code for one in ends.findings if one.is_error} == {"S701"}
    assert 5.0 <= ends.duration < 6.0  # what others did until they came so far
    sound = int(np.flatnonzero(ends.time <= 5.0)[-1]) + 1
    for name in ("q", "zother/q"):
        np.testing.assert_array_equal(ends.rows(name)[:sound], whole.rows(name)[:sound])


BREAKS = """\
def law(par, state, ref, meas, load, aux, out):
    state[0, 0] += 1.0
    for j in range(out.shape[0]):
        out[j] = 1000.0 * (ref[0, j] - meas[0, j]) - 3.0 * meas[1, j]
    if state[0, 0] > par[0, 0]:
        out[int(state[0, 0])] = 0.0
"""


def test_what_was_until_a_law_fails_is_kept(cell: Cell) -> None:
    program = code_of(cell, "wait 0.5 s", "mov joints (90, 60, -150, 0, -60, 0)")
    traits, name = LawTraits(InputKind.VOLTAGE, ("k",)), cell.first.name
    law = CompiledLaw("breaks", BREAKS, ("ticks",), np.full((1, 6), 733.0), traits)
    recording = run(cell, {name: program}, RunOptions(laws={name: law}))
    (found,) = (one for one in recording.findings if one.is_error)
    assert found.code == "C601"
    assert 0.733 <= recording.duration <= 0.737


@pytest.mark.parametrize("number", [1, 2, 3])
def test_a_state_that_is_no_number_is_told_on_the_move_of_the_stretch_in_which_it_came(
    cell: Cell, number: int
) -> None:
    places = ((400, -200), (400, 0), (500, 0), (500, 100))
    flown = [f"lin ({x}, {y}, 300; rpy 180 0 0) speed 100 blend 10" for x, y in places[1:]]
    program = code_of(cell, "mov (400, -200, 300; rpy 180 0 0)", *flown, "lin (400, 100, 300; rpy 180 0 0)")
    name = cell.first.name

    def ran(ticks: float) -> Recording:
        return run(cell, {name: program}, RunOptions(laws={name: gone_after(ticks)}))

    move = ran(1e9).events_of(MoveEvent)[number]
    (found,) = (one for one in ran((move.time + 0.5 * move.duration) * 1000.0).findings if one.is_error)
    assert move.origin is not None
    assert (found.code, found.span) == ("S701", move.origin.span)


def test_how_far_an_arm_is_from_its_target_is_told_in_degrees(cell: Cell) -> None:
    window = np.full(6, 1e-5)  # so narrow that no arm is within it when a move ends
    controller = replace(cell.first.controller, settle_timeout=0.0, in_position=window)
    hasty = with_station(cell, controller=controller)
    recording = run(hasty, {"robot": code_of(hasty, "mov joints (60, 60, -150, 0, -60, 0)")}, RunOptions())
    (found,) = (one for one in recording.findings if one.code == "S720")
    degrees = np.degrees(float(str(found.data["error_rad"])))
    assert f"is {degrees:.4g}° from its target" in found.message


def test_a_move_ends_when_every_joint_is_in_position(cell: Cell) -> None:
    window = np.full(6, 1e-5)  # an arm that has just been moved needs a while until it is within this
    strict = with_station(cell, controller=replace(cell.first.controller, in_position=window))
    # joint 1 stands where it stands: it is in position all the time
    program = code_of(strict, "mov joints (0, 60, -150, 0, -60, 0)", "mov joints (0, 60, -150, 60, -30, 0)")
    recording = run(strict, {"robot": program}, RunOptions(record_hz=1000))
    last = recording.events_of(MoveEvent)[-1]
    assert last.settle > 0.0
    row = np.searchsorted(recording.time, last.end - 1e-9)
    assert (abs(recording.channels["q_error"].values[row]) <= window).all()


@pytest.fixture(scope="module")
def passing(cell: Cell) -> tuple[Cell, icr.Program]:
    """A cell whose first joint is near enough when its reference ends, but passes by too fast, and a move."""
    loops = robots.cascaded_controller(cell.first.robot, Rates())  # slower at the end than computed torque
    wide = replace(loops, settle_time=0.0, in_position=np.ones(6))
    loose = with_station(cell, controller=wide)
    program = code_of(loose, "mov joints (60, 60, -150, 0, -60, 0)")
    recording = run(loose, {"robot": program}, RunOptions(record_hz=1000))
    row = np.searchsorted(recording.time, recording.events_of(MoveEvent)[-1].end - 1e-9)
    error, speed = (abs(recording.channels[name].values[row, 0]) for name in ("q_error", "qd"))
    assert error < 0.9 * SPEED_TIME * speed
    window = np.array([0.5 * (error + SPEED_TIME * speed), 1.0, 1.0, 1.0, 1.0, 1.0])
    return with_station(cell, controller=replace(wide, in_position=window)), program


def test_a_move_does_not_end_while_a_joint_passes_its_target_too_fast(
    passing: tuple[Cell, icr.Program],
) -> None:
    cell, program = passing
    recording = run(cell, {"robot": program}, RunOptions(record_hz=1000))
    last = recording.events_of(MoveEvent)[-1]
    row = np.searchsorted(recording.time, last.end - 1e-9)
    most = cell.first.controller.in_position / SPEED_TIME
    assert last.settle > 0.0
    assert (abs(recording.channels["qd"].values[row]) <= most).all()


def test_a_joint_that_is_near_but_does_not_rest_is_told_with_its_speed(
    passing: tuple[Cell, icr.Program],
) -> None:
    cell, program = passing
    hasty = with_station(cell, controller=replace(cell.first.controller, settle_timeout=0.0))
    (found,) = run(hasty, {"robot": program}, RunOptions()).findings
    most = np.degrees(cell.first.controller.in_position[0] / SPEED_TIME)
    assert (found.code, found.data["joint"]) == ("S720", 1)
    assert "joint `1` still moves at" in found.message
    assert f"in position means not faster than {most:.4g}°/s; the tool is " in found.message


def test_a_kinematic_run_needs_no_inertia(cell: Cell) -> None:
    """Nothing is integrated, so nobody asks for the poles of drives and arm."""
    robot = cell.first.robot
    last = robot.drives[-1]
    assert isinstance(last.motor, DcMotor)
    motor = replace(last.motor, rotor_inertia=0.0)
    nothing = Link(0.0, np.zeros(3), np.zeros((3, 3)))
    drives = (*robot.drives[:-1], replace(last, motor=motor))
    light = replace(robot, links=(*robot.links[:-1], nothing), drives=drives)
    bare = with_station(cell, robot=light)
    options = RunOptions(Fidelity.KINEMATIC)
    recording = run(bare, {"robot": code_of(bare, "mov joints (60, 60, -150, 0, -60, 0)")}, options)
    assert not [one for one in recording.findings if one.is_error]
    assert recording.facts.stations[0].plant_steps == 1
