"""What a live run tells while it goes on: layout, frames, parts, states."""

import struct
from pathlib import Path

import numpy as np
import pytest

from ropsim.studio.desk.line import Cancelled
from ropsim.studio.desk.live.run import Clocks, run_live
from ropsim.studio.jobs import (
    Cancel,
    LiveControl,
    LiveFrame,
    LiveSpeed,
    LiveStart,
    Order,
    RunReply,
    SetSignal,
)
from ropsim.workbench import open_overlaid
from support.live import KEYS, FakeLine, project

DAY = 1_700_000_000.0
GRIP = """\
program grip
units mm, deg
mov (500, -150, 180) speed 50 %
lin (500, -150, 150) speed 100 mm/s
close
mov (500, -150, 180)
open
"""
WAITING = "program p\nunits mm, deg\nwait until start\n"


def live(folder: Path, program: str, line: FakeLine, speed: float = 1.0) -> RunReply:
    job = LiveStart(str(folder), {"programs/main.task": program}, "", speed)
    return run_live(job, line, Clocks(line.now, lambda: DAY))


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return project(tmp_path, KEYS)


def header(frame: bytes) -> tuple[bytes, int, int, int, float, float, int, int, int]:
    fields: tuple[bytes, int, int, int, float, float, int, int, int] = struct.unpack_from(
        "<2sBBIddHHI", frame
    )
    return fields


def test_the_layout_comes_first_and_names_every_number_of_a_frame(folder: Path) -> None:
    line = FakeLine([(1.0, SetSignal("start", 1.0))])
    live(folder, WAITING, line)
    (layout,) = line.messages("layout")
    channels, bodies = layout["channels"], layout["bodies"]
    assert isinstance(channels, tuple)
    assert bodies == (1, 2, 3, 4, 5, 6)
    for frame in line.frames:
        magic, version, kind, _, _, wall, values, count, events = header(frame)
        assert (magic, version, kind, wall, events) == (b"RS", 1, 1, DAY * 1e3, 0)
        assert (values, count) == (len(channels), 6)
        assert len(frame) == 32 + 4 * values + 28 * count <= 2000
    assert line.reports.index(next(one for one in line.reports if isinstance(one, LiveFrame))) >= 2


def test_frames_come_60_times_a_second_with_rising_numbers_and_times(folder: Path) -> None:
    line = FakeLine([(2.0, SetSignal("start", 1.0))])
    live(folder, WAITING, line)
    times = [header(frame)[4] for frame in line.frames]
    numbers = [header(frame)[3] for frame in line.frames]
    assert numbers == list(range(1, len(numbers) + 1))
    assert np.diff(times) == pytest.approx(1 / 60, abs=1e-3)
    assert len(times) == pytest.approx(2.0 * 60, abs=8)


def test_a_part_is_placed_when_the_clock_comes_to_its_grasp_and_does_not_jump(folder: Path) -> None:
    line = FakeLine()
    assert live(folder, GRIP, line).state == "done"
    taken, supplied, left = line.messages("placed")
    assert (taken["body"], taken["parent"], taken["visible"]) == (8, 6, True)
    assert (supplied["body"], supplied["parent"], supplied["visible"]) == (9, -1, True)
    assert (left["body"], left["parent"], left["visible"]) == (8, -1, True)
    assert supplied["pose"] == pytest.approx([0.5, -0.15, 0.15, 1, 0, 0, 0], abs=1e-12)
    pose = left["pose"]
    assert isinstance(pose, tuple)
    assert pose[:3] == pytest.approx([0.5, -0.15, 0.18], abs=1e-3)
    at = line.reports.index(next(one for one in line.reports if getattr(one, "payload", None) == taken))
    before = next(one for one in reversed(line.reports[:at]) if isinstance(one, LiveFrame))
    assert header(before.content)[4] <= float(str(taken["time"])) + 1 / 60


def test_the_channels_are_those_of_the_recording_but_for_the_path_error(folder: Path) -> None:
    line = FakeLine()
    live(folder, GRIP, line)
    (layout,) = line.messages("layout")
    channels = layout["channels"]
    assert isinstance(channels, tuple)
    project_ = open_overlaid(folder, {"programs/main.task": GRIP})
    recorded = project_.simulate().channels
    told = {(one["name"], one["column"], one["unit"], one["description"]) for one in channels}
    assert told == {
        (name, column, channel.unit, channel.description)
        for name, channel in recorded.items()
        for column in channel.columns or ("",)
        if name != "path_error"
    }


def test_pause_and_speed_are_told_and_no_frame_comes_while_it_stands(folder: Path) -> None:
    plan: list[tuple[float, Order]] = [
        (0.5, LiveControl("pause")),
        (20.0, LiveControl("resume")),
        (20.5, LiveSpeed(2.0)),
        (21.0, SetSignal("start", 1.0)),
    ]
    line = FakeLine(plan)
    reply = live(folder, WAITING, line)
    states = [(one["state"], one["speed"]) for one in line.messages("live")]
    assert states == [("running", 1.0), ("paused", 1.0), ("running", 1.0), ("running", 2.0)]
    assert len(line.frames) == pytest.approx(1.5 * 60, abs=8)
    assert reply.inputs[0].time == pytest.approx(2.0, abs=0.02)


def test_a_key_for_something_else_is_told_in_words_and_changes_nothing(folder: Path) -> None:
    plan = [
        (0.1, SetSignal("strat", 1.0)),
        (0.2, SetSignal("lamp", 1.0)),
        (0.3, SetSignal("start", float("nan"))),
        (0.5, SetSignal("start", 1.0)),
    ]
    line = FakeLine(plan)
    reply = live(folder, WAITING, line)
    assert [one["code"] for one in line.messages("notice")] == ["U980"] * 3
    assert "did you mean `start`?" in str(line.messages("notice")[0]["hint"])
    assert [one.signal for one in reply.inputs] == ["start"]


def test_a_run_can_be_given_up_while_it_waits(folder: Path) -> None:
    with pytest.raises(Cancelled):
        live(folder, WAITING, FakeLine([(1.0, Cancel())]))
