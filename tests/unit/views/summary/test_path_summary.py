import math
from dataclasses import replace

import numpy as np
import pytest

from ropsim.flow import Channel, MotionKind, MoveEvent, Origin, Recording
from ropsim.model import Signal, Tool
from ropsim.robots import default_controller, load
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.views import Style, summarize
from ropsim.views.testing import accuracy_lines
from support.cells import one_station
from support.compiled import code_of
from support.recordings import empty_recording, facts, pick_and_place

RATE = 100.0
DIFFERENCING = 1e-9
"""Central differences of straight motion at constant speed are exact but for rounding."""


def line_run(attained_speed: float) -> Recording:
    """One LIN move of 1 s at 0.2 m/s along x, attained at another speed, 1 mm beside the line."""
    time = np.arange(101) / RATE
    command, attained = np.zeros((101, 3)), np.zeros((101, 3))
    command[:, 0], attained[:, 0], attained[:, 1] = 0.2 * time, attained_speed * time, 1e-3
    channels = {
        "command_position": Channel(command, "m"),
        "attained_position": Channel(attained, "m"),
        "path_error": Channel(attained[:, 1], "m"),
        "move": Channel(np.full(101, 4.0), ""),
        "line": Channel(np.full(101, 14.0), ""),
    }
    event = MoveEvent(0.0, 1.0, "robot", Origin(visit=7), motion=MotionKind.LIN, ordinal=4)
    return Recording(time, channels, (event,), (), 1.0, facts())


def test_path_velocity_accuracy_is_the_relative_speed_error() -> None:
    move = summarize(line_run(0.19)).path.moves[0]
    assert move.speeds.command == pytest.approx(0.2, abs=DIFFERENCING)
    assert move.speeds.accuracy == pytest.approx(-0.05, abs=DIFFERENCING)


def test_worst_move_names_line_and_pass() -> None:
    worst = summarize(line_run(0.2)).path.worst
    assert worst is not None
    assert (worst.ordinal, worst.line, worst.visit) == (4, 14, 7)
    assert worst.max_error == 1e-3


def test_move_that_stands_still_has_no_speed_accuracy() -> None:
    recording = line_run(0.2)
    still = {**recording.channels, "command_position": Channel(np.zeros((101, 3)), "m")}
    summary = summarize(replace(recording, channels=still))
    assert math.isnan(summary.path.moves[0].speeds.accuracy)
    assert summary.path.worst_speed is None


def test_samples_outside_straight_moves_do_not_count() -> None:
    recording = line_run(0.2)
    error = np.full(101, np.nan)
    error[10:20], error[50:60] = 1e-3, 3e-3
    move = np.where(np.arange(101) < 30, 4.0, 5.0)
    channels = {**recording.channels, "path_error": Channel(error, "m"), "move": Channel(move, "")}
    path = summarize(replace(recording, channels=channels)).path
    assert [one.ordinal for one in path.moves] == [4, 5]
    assert path.mean_error == pytest.approx(2e-3)
    assert path.rms_error == pytest.approx(math.sqrt(5.0) * 1e-3)
    assert path.max_error == 3e-3


def test_moves_are_gathered_by_source_line() -> None:
    path = summarize(pick_and_place(3)).path
    assert [(line.line, len(line.moves)) for line in path.lines] == [(10, 3), (12, 3), (17, 3), (19, 3)]


def test_run_without_straight_moves_has_no_path_figures() -> None:
    path = summarize(empty_recording()).path
    assert path.worst is None
    assert math.isnan(path.max_error)


@pytest.mark.parametrize(("given", "slow"), [(0.2, 0), (0.25, 1), (None, 0)])
def test_a_move_whose_given_speed_its_command_does_not_come_to_is_told(
    given: float | None, slow: int
) -> None:
    recording = line_run(0.19)
    (event,) = recording.events_of(MoveEvent)
    summary = summarize(replace(recording, events=(replace(event, path_speed=given),)))
    assert len(summary.path.slow) == slow
    told = "\n".join(accuracy_lines(summary, Style.PLAIN)).replace("\xa0", " ")
    assert ("given speed not reached in 1 move: 200 mm/s of 250 mm/s" in told) == bool(slow)


@pytest.mark.parametrize(("words", "speed"), [("speed 600 mm/s", 0.6), ("", 0.25)])
def test_a_move_tells_the_speed_that_program_or_cell_give(words: str, speed: float) -> None:
    cell = one_station("c", load("puma560"), default_controller("puma560"), tools={"": Tool("")})
    code = code_of(cell, "mov (500, 0, 300)", f"lin (500, 60, 300) {words}")
    recording = run(cell, {"robot": code}, RunOptions(Fidelity.KINEMATIC))
    assert [one.path_speed for one in recording.events_of(MoveEvent)] == [None, speed]
    assert len(summarize(recording).path.slow) == (1 if words else 0)


@pytest.mark.parametrize(
    ("condition", "slow"), [("", 1), ("until touch", 0), ("until never timeout 0.5 s", 0), ("until never", 1)]
)
def test_a_move_that_its_condition_ended_is_not_told_to_be_slow(condition: str, slow: int) -> None:
    signals = {
        "touch": Signal("touch", is_input=True, changes=((2.5, 1.0),)),
        "never": Signal("never", is_input=True),
    }
    robot, controller = load("puma560"), default_controller("puma560")
    cell = one_station("c", robot, controller, tools={"": Tool("")}, start=robot.home, signals=signals)
    code = code_of(cell, "mov (500, 0, 300)", f"lin (500, 0, 100) speed 900 mm/s acc 100 mm/s2 {condition}")
    (move,) = (path := summarize(run(cell, {"robot": code}, RunOptions(Fidelity.KINEMATIC))).path).moves
    assert move.given == 0.9
    assert len(path.slow) == slow


def test_figures_of_accuracy_have_their_conditions_and_no_name_of_the_standard() -> None:
    """Two passes of one line at 200 mm/s, and one of another at 300 mm/s."""
    one = line_run(0.2)
    events = tuple(
        MoveEvent(
            0.3 * ordinal,
            0.3 * ordinal + 0.3,
            "robot",
            Origin(visit=visit),
            motion=MotionKind.LIN,
            ordinal=ordinal,
            path_speed=speed,
        )
        for ordinal, (visit, speed) in enumerate([(1, 0.2), (2, 0.2), (1, 0.3)])
    )
    numbers = np.minimum(np.arange(101) // 34, 2)
    channels = {
        **one.channels,
        "move": Channel(numbers.astype(float), ""),
        "line": Channel(np.where(numbers < 2, 14.0, 15.0), ""),
    }
    summary = summarize(replace(one, channels=channels, events=events))
    found = summary.path.conditions
    assert (found.cycles, found.least_speed, found.most_speed) == (2, 0.2, 0.3)
    assert not found.is_standard_test
    text = "\n".join(accuracy_lines(summary, Style.PLAIN)).replace("\xa0", " ")
    assert "paths and stops of the program, at most 2 passes of one\n" in text
    assert "given speed: 200 mm/s to 300 mm/s\n" in text
    assert "load: tool and parts that the program carries" in text
    assert "no test after ISO 9283" in text
    for name in ("AT", "RT", "AV", "FV", "OV", "CR", "CO", "accuracy AV", "repeatability"):
        assert name not in text.split()
