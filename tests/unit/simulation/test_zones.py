"""Runs with zones: what is recorded of corners, lines in force, messages and moves that are left out."""

from collections.abc import Sequence
from functools import cache
from itertools import pairwise

import numpy as np
import pytest

import ropsim
from ropsim import icr, robots
from ropsim.flow import MessageEvent, MoveEvent, Recording, SkipEvent
from ropsim.model import Cell, Signal, Tool
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.workbench import environment_of
from support.arms import random_arm
from support.cells import one_station

ROBOT = robots.load("puma560")
CELL = one_station(
    "c",
    ROBOT,
    robots.default_controller("puma560"),
    tools={"": Tool("")},
    start=ROBOT.home,
    signals={"lamp": Signal("lamp", is_input=False)},
)
SQUARE = (
    "mov (500, -200, 300)",
    "lin (500, 0, 300) blend 30 mm",
    "lin (500, 0, 100) blend 30 mm",
    "lin (500, 200, 100)",
)
CORNERS = np.array([[0.5, 0.0, 0.3], [0.5, 0.0, 0.1]])


def code(*lines: str, cell: Cell = CELL) -> icr.Program:
    text = "\n".join(("program p", "units mm, deg, s", *lines))
    compiled = ropsim.language.compile(text, environment_of(cell))
    assert [str(found) for found in compiled.diagnostics if found.is_error] == []
    assert compiled.icr is not None
    return compiled.icr


@cache
def recorded(lines: Sequence[str], fidelity: Fidelity = Fidelity.KINEMATIC) -> Recording:
    return run(CELL, {"robot": code(*lines)}, RunOptions(fidelity, record_hz=1000))


def codes(recording: Recording) -> list[str]:
    return [found.code for found in recording.findings]


def test_the_zone_that_is_flown_is_in_the_recording() -> None:
    recording = recorded(SQUARE)
    moves = recording.events_of(MoveEvent)
    assert [event.zone for event in moves] == pytest.approx([0.0, 0.03, 0.03, 0.0])
    assert [event.flown for event in moves] == pytest.approx([0.0, 0.03, 0.03, 0.0])
    assert codes(recording) == []


def test_a_corner_is_passed_within_its_zone_at_speed() -> None:
    recording = recorded(SQUARE)
    places = recording.channels["command_position"].values
    speeds = np.linalg.norm(np.gradient(places, recording.time, axis=0), axis=1)
    for corner in CORNERS:
        away = np.linalg.norm(places - corner, axis=1)
        nearest = int(np.argmin(away))
        assert 1e-3 < away[nearest] < 0.03
        assert speeds[nearest] > 0.02


def test_the_line_in_force_changes_in_the_middle_of_the_corner() -> None:
    recording = recorded(SQUARE)
    line = recording.channels["line"]
    assert line.times is not None
    assert line.values.tolist()[:4] == [3.0, 4.0, 5.0, 6.0]
    places = recording.channels["command_position"].values
    for number, corner in ((5, CORNERS[0]), (6, CORNERS[1])):
        away = np.linalg.norm(places - corner, axis=1)
        changed = float(line.times[line.values.tolist().index(number)])
        assert changed == pytest.approx(recording.time[int(np.argmin(away))], abs=3e-3)


def test_moves_of_a_stretch_follow_each_other_without_a_gap_and_only_the_last_settles() -> None:
    moves = recorded(SQUARE, Fidelity.DYNAMIC).events_of(MoveEvent)[1:]
    assert [event.settle > 0.0 for event in moves] == [False, False, True]
    for before, behind in pairwise(moves):
        assert behind.time == pytest.approx(before.time + before.duration, abs=1e-9)


def test_a_corner_that_is_flown_well_is_no_path_error() -> None:
    moves = recorded(SQUARE).events_of(MoveEvent)
    errors = [event.path_error_max for event in moves]
    assert errors[0] is None
    assert max(error for error in errors if error is not None) < 1e-8
    real = [event.path_error_max for event in recorded(SQUARE, Fidelity.DYNAMIC).events_of(MoveEvent)]
    assert 1e-6 < max(error for error in real if error is not None) < 2e-3


def test_corners_save_time() -> None:
    fine = tuple(line.replace(" blend 30 mm", "") for line in SQUARE)
    assert recorded(SQUARE).duration < recorded(fine).duration


def test_a_message_does_not_stop_the_arm_and_is_said_where_its_move_begins() -> None:
    spoken = (*SQUARE[:2], 'print "half"', *SQUARE[2:])
    recording, silent = recorded(spoken), recorded(SQUARE)
    assert recording.duration == silent.duration
    (said,) = recording.events_of(MessageEvent)
    assert said.text == "half"
    assert said.time == pytest.approx(recording.events_of(MoveEvent)[2].time)


def test_a_message_behind_the_last_move_of_a_stretch_is_said_when_that_has_ended() -> None:
    lines = ("mov (500, -200, 300)", "lin (500, 0, 300) blend 30 mm", 'print "there"', "wait 1 s")
    recording = recorded(lines)
    (said,) = recording.events_of(MessageEvent)
    last = recording.events_of(MoveEvent)[-1]
    assert said.time == pytest.approx(last.time + last.duration)


def test_a_message_before_a_move_that_is_left_out_is_said() -> None:
    lines = (*SQUARE[:2], 'print "far"', "lin (5000, 0, 100) blend 30 mm", 'print "back"', SQUARE[3])
    assert [one.text for one in recorded(lines).events_of(MessageEvent)] == ["far", "back"]


def test_messages_behind_each_other_are_all_said() -> None:
    lines = (*SQUARE[:2], 'print "one"', 'print "two"', *SQUARE[2:])
    assert [one.text for one in recorded(lines).events_of(MessageEvent)] == ["one", "two"]


STOPS = {
    "set lamp on": "output `lamp` is set next",
    "wait 0.1 s": "the program waits next",
}


@pytest.mark.parametrize("line", ["set lamp on", "wait 0.1 s"])
def test_where_the_arm_has_to_stand_the_zone_is_a_hint_with_the_reason(line: str) -> None:
    recording = recorded((*SQUARE[:2], line, *SQUARE[2:]))
    assert codes(recording) == ["M560"]
    found = recording.findings[0]
    assert found.span is not None
    assert found.span.line == 4
    assert STOPS[line] in found.message
    assert [event.flown for event in recording.events_of(MoveEvent)] == pytest.approx([0.0, 0.0, 0.03, 0.0])


def test_a_zone_on_the_last_move_of_a_program_is_a_hint() -> None:
    recording = recorded((*SQUARE[:3], "lin (500, 200, 100) blend 30 mm"))
    assert codes(recording) == ["M560"]
    assert recording.findings[0].message.endswith("is not flown: the program ends")


def test_a_move_that_is_left_out_ends_the_stretch_before_it_and_begins_one_behind_it() -> None:
    lines = (*SQUARE[:2], "lin (5000, 0, 300) blend 30 mm", *SQUARE[2:])
    recording = recorded(lines)
    assert [event.line for event in recording.events_of(SkipEvent)] == [5]
    assert [event.flown for event in recording.events_of(MoveEvent)] == pytest.approx([0.0, 0.0, 0.03, 0.0])
    attained = recording.channels["command_position"].values
    assert np.abs(attained[-1] - np.array([0.5, 0.2, 0.1])).max() < 1e-9
    assert np.linalg.norm(attained - CORNERS[0], axis=1).min() < 1e-9  # it stops at the corner


def test_a_zone_in_a_loop_is_told_once() -> None:
    lines = (SQUARE[0], "repeat 3", "lin (500, 0, 300) blend 30 mm", "wait 0.1 s", SQUARE[0], "endr")
    assert codes(recorded(lines)) == ["M560"]


def unflown(recording: Recording) -> list[tuple[int, str]]:
    """Return the lines with a zone that is not flown, and why."""
    found = (one for one in recording.findings if one.code == "M560" and one.span is not None)
    return [(one.span.line, one.message.rpartition(": ")[2]) for one in found if one.span is not None]


def test_a_line_whose_zone_only_the_last_pass_does_not_fly_is_listed_once() -> None:
    loop = ("repeat 3", "lin (500, 0, 300)", "lin (500, 200, 300)", "lin (500, 0, 100) blend 30 mm", "endr")
    assert unflown(recorded((SQUARE[0], *loop))) == [(7, "the program ends")]


def test_a_zone_before_a_move_that_is_left_out_is_listed() -> None:
    lines = (SQUARE[0], "lin (500, 0, 300) blend 30 mm", "lin (900, 900, 900)", "lin (500, 0, 100)")
    assert unflown(recorded(lines)) == [(4, "the next move is left out")]


def test_the_zone_of_a_move_that_is_left_out_is_not_listed() -> None:
    assert unflown(recorded((SQUARE[0], "lin (900, 900, 900) blend 30 mm"))) == []


def test_a_finding_of_a_later_pass_only_is_listed_once_with_its_pass() -> None:
    """The first way is 110 mm long, those of the other passes 10 mm."""
    lines = (
        "mov (500, -200, 300)",
        "for i = 1 to 4",
        "  lin (500, -100 + 10 * i, 300) speed 100 mm/s at 50 mm after start do set lamp on",
        "endf",
    )
    (found,) = recorded(lines).findings
    assert (found.code, found.data["pass"]) == ("M565", 2)
    assert found.message.startswith("3 of 4 passes, first pass 2: ")
    assert found.span is not None
    assert found.span.line == 5
    assert "the move is 10 mm long" in found.message


@pytest.mark.parametrize("lines", [("for i = 1 to 4", "  mov q", "endf"), ("mov q", "mov q")])
def test_a_finding_that_every_pass_has_is_listed_once_for_each_line(lines: Sequence[str]) -> None:
    arm = random_arm(3, "RRPRRR")  # solved numerically, which every move to a pose says
    cell = one_station("free", arm, CELL.first.controller, tools={"": Tool("")}, start=arm.home)
    program = code("q = here", *lines, cell=cell)
    found = run(cell, {"robot": program}, RunOptions(Fidelity.KINEMATIC)).findings
    written = [number for number, line in enumerate(lines, 4) if "mov" in line]
    assert [(one.code, one.label, one.span and one.span.line) for one in found] == [
        ("M550", "", line) for line in written
    ]


def test_each_trigger_beside_its_way_is_listed() -> None:
    triggers = "at 100 mm before end do set lamp on at 50 mm after start do set lamp off"
    lines = ("mov (500, -200, 300)", f"lin (500, -190, 300) speed 100 mm/s {triggers}")
    found = recorded(lines).findings
    assert [one.code for one in found] == ["M565", "M565"]
    assert ["100 mm before" in found[0].message, "50 mm after" in found[1].message] == [True, True]
