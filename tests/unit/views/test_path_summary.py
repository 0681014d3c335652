import math
from dataclasses import replace

import numpy as np
import pytest

from ropsim.flow import Channel, MotionKind, MoveEvent, Origin, Recording
from ropsim.views import summarize
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
