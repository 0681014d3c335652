"""What a live run tells while it goes on: layout, frames, parts, states."""

import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from ropsim.flow import MoveEvent, OutputEvent, OverrideChange, Recording, TaskEvent, WaitEvent
from ropsim.simulation import Fidelity, RunOptions, RunView, run
from ropsim.studio.testing import (
    Cancel,
    Cancelled,
    Clocks,
    LiveBegin,
    LiveControl,
    LiveFrame,
    LiveOverride,
    LivePace,
    LiveSpeed,
    LiveStart,
    Order,
    PacedClock,
    RunReply,
    SetSignal,
    Shelf,
    run_live,
)
from ropsim.views import packed_event
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
LONG = "program p\nunits mm, deg, s\nmov joints (150, 60, -150, 0, -60, 0) speed 20 %\n"
STEPS = """\
program p
units mm, deg, s
mov joints (20, 60, -150, 0, -60, 0)
wait 0.5 s
set lamp on
mov joints (0, 60, -150, 0, -60, 0)
"""
PASSING = """\
program p
units mm, deg
lin (500, -150, 250) blend 20 speed 200
lin (500, 0, 250) blend 20 speed 200
lin (500, 0, 150) speed 200
"""
SLICE = 4e-3
"""Interpolation tick of the controller [s]."""

WAITING = "program p\nunits mm, deg\nwait until start\n"


def live(
    folder: Path, program: str, line: FakeLine, speed: float = 1.0, begin: LiveBegin = "running"
) -> RunReply:
    job = LiveStart(str(folder), {"programs/main.task": program}, "", speed, begin)
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


def test_events_are_told_when_they_are_over_and_tasks_grow_with_them(folder: Path) -> None:
    tasks = "task Pick\n  lin (500, -150, 150) speed 100 mm/s\n  close\nendp\n"
    program = GRIP.replace("lin (500, -150, 150) speed 100 mm/s\nclose\n", "Pick\n").replace(
        "units mm, deg\n", f"units mm, deg\n{tasks}"
    )
    line, shelf = FakeLine(), Shelf()
    job = LiveStart(str(folder), {"programs/main.task": program}, "", 1.0)
    assert run_live(job, line, Clocks(line.now, lambda: DAY), shelf).state == "done"
    told = [one["event"] for one in line.messages("happened")]
    kinds = [one["kind"] for one in told if isinstance(one, dict) and one["kind"] != "task"]
    assert kinds == ["move", "move", "grip", "move", "release"]
    _, lin, grip, *_ = (one for one in told if isinstance(one, dict) and one["kind"] != "task")
    first, *longer = (one for one in told if isinstance(one, dict) and one["kind"] == "task")
    assert told.index(first) < told.index(lin)
    assert (first["time"], first["duration"]) == (lin["time"], pytest.approx(0.0, abs=2 * SLICE))
    assert sorted(one["duration"] for one in longer) == [one["duration"] for one in longer]
    begun = next(one for one in longer if one["duration"] >= lin["duration"] - 1e-9)
    whole = longer[-1]
    assert grip["data"]["part"] == "box_1"
    assert begun["data"]["name"] == whole["data"]["name"] == "Pick"
    assert begun["duration"] == pytest.approx(lin["duration"])
    assert whole["duration"] == pytest.approx(lin["duration"] + grip["duration"])
    assert shelf.run is not None
    (kept,) = shelf.run.recording.events_of(TaskEvent)
    assert packed_event(kept) == whole
    at = next(k for k, one in enumerate(line.reports) if getattr(one, "payload", {}).get("event") == grip)
    before = next(one for one in reversed(line.reports[:at]) if isinstance(one, LiveFrame))
    assert header(before.content)[4] == pytest.approx(grip["time"] + grip["duration"], abs=1 / 60)


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


def test_the_channels_are_those_of_the_recording_the_override_and_no_path_error(
    folder: Path,
) -> None:
    line = FakeLine()
    live(folder, GRIP, line)
    (layout,) = line.messages("layout")
    channels = layout["channels"]
    assert isinstance(channels, tuple)
    project_ = open_overlaid(folder, {"programs/main.task": GRIP})
    recorded = project_.simulate().channels
    told = {(one["name"], one["column"], one["unit"], one["description"]) for one in channels}
    override = {one for one in told if one[0] == "override"}
    assert [one[1:3] for one in override] == [("", "")]
    assert told - override == {
        (name, column, channel.unit, channel.description)
        for name, channel in recorded.items()
        for column in channel.columns or ("",)
        if name != "path_error"
    }


def test_holds_overrides_and_speeds_are_told_and_frames_go_on(folder: Path) -> None:
    plan: list[tuple[float, Order]] = [
        (0.5, LiveControl("hold")),
        (0.6, LiveOverride(0.25)),
        (1.0, LiveControl("continue")),
        (1.5, LiveSpeed(2.0)),
        (2.0, SetSignal("start", 1.0)),
    ]
    line = FakeLine(plan)
    reply = live(folder, WAITING, line)
    states = [(one["state"], one["speed"], one["override"]) for one in line.messages("live")]
    assert states == [
        ("running", 1.0, 1.0),
        ("held", 1.0, 1.0),
        ("held", 1.0, 0.25),
        ("running", 1.0, 0.25),
        ("running", 2.0, 0.25),
    ]
    assert len(line.frames) == pytest.approx(2.0 * 60, abs=8)
    assert reply.inputs[0].time == pytest.approx(2.5, abs=0.02)


def test_a_run_may_be_held_at_its_start_and_make_single_steps(folder: Path) -> None:
    """The first step is the first move; what is held meanwhile takes the time of the clock."""
    plan: list[tuple[float, Order]] = [(1.0, LiveControl("step")), (6.0, LiveControl("continue"))]
    line = FakeLine(plan)
    shelf = Shelf()
    job = LiveStart(str(folder), {"programs/main.task": STEPS}, "", 1.0, "held")
    assert run_live(job, line, Clocks(line.now, lambda: DAY), shelf).state == "done"
    assert [one["state"] for one in line.messages("live")] == ["held", "running", "held", "running"]
    assert shelf.run is not None
    recording = shelf.run.recording
    first, wait = recording.events_of(MoveEvent)[0], recording.events_of(WaitEvent)[0]
    assert 1.0 <= first.time < 1.0 + 2.0 * SLICE
    assert wait.time == pytest.approx(6.0, abs=2.0 * SLICE)
    assert recording.facts.overrides[0] == OverrideChange(0.0, 0.0)
    opened = open_overlaid(folder, {"programs/main.task": STEPS})
    cell, codes = opened.runnable(opened.programs())
    again = run(cell, codes, RunOptions(overrides=recording.facts.overrides))
    assert again.events_of(MoveEvent) == recording.events_of(MoveEvent)


@dataclass(slots=True)
class Lead:
    """Looks how far what is computed is ahead of what is shown."""

    pace: LivePace
    most: float = 0.0

    @property
    def may_press(self) -> bool:
        return True

    def advanced(self, run: RunView) -> None:
        self.most = max(self.most, run.farthest / run.hz - self.pace.clock.now())
        self.pace.advanced(run)

    def reading(self, run: RunView) -> None:
        self.pace.reading(run)

    def ended(self, run: RunView) -> None:
        self.pace.ended(run)


def watched(folder: Path, program: str, line: FakeLine, speed: float = 1.0) -> tuple[Recording, Lead]:
    """Return the recording of a live run of an ideal arm, and how far it was ahead."""
    opened = open_overlaid(folder, {"programs/main.task": program})
    cell, codes = opened.runnable(opened.programs())
    lead = Lead(LivePace("main", codes, PacedClock(line.now, speed), line, line.now, line.now))
    return run(cell, codes, RunOptions(Fidelity.KINEMATIC, watch=lead)), lead


@pytest.mark.parametrize("speed", [0.5, 1.0, 4.0])
def test_the_run_is_never_ahead_of_what_is_shown_by_more_than_a_slice(folder: Path, speed: float) -> None:
    line = FakeLine(work=1e-5)
    _, lead = watched(folder, LONG, line, speed)
    assert 0.0 < lead.most <= SLICE + 1e-9


def test_the_frames_of_a_long_move_have_no_gap(folder: Path) -> None:
    line = FakeLine(work=1e-5)
    recording, _ = watched(folder, LONG, line)
    times = np.array([header(frame)[4] for frame in line.frames])
    (move,) = recording.events_of(MoveEvent)
    assert move.duration > 5.0
    assert np.diff(times).max() < 0.05
    assert len(times) > 0.9 * 60 * move.duration


@pytest.mark.parametrize("order", [LiveControl("hold"), LiveOverride(0.3), LiveControl("stop")])
def test_an_order_acts_within_a_slice_of_what_is_shown(folder: Path, order: Order) -> None:
    asked = 1.2345
    line = FakeLine([(asked, order), (4.0, LiveControl("stop"))])
    recording, _ = watched(folder, LONG, line)
    acts = recording.facts.overrides[0].time if recording.facts.overrides else recording.facts.stopped
    assert acts is not None
    assert asked < acts <= asked + SLICE + 2e-3  # the clock of the test, and the tick behind the slice
    if order == LiveControl("stop"):
        assert recording.duration - asked < 0.5


def test_a_step_ends_with_the_next_instruction_that_takes_time(folder: Path) -> None:
    plan: list[tuple[float, Order]] = [(0.3, LiveControl("hold")), (1.0, LiveControl("step"))]
    plan += [(5.0, LiveControl("step")), (7.0, LiveControl("step")), (10.0, LiveControl("stop"))]
    line = FakeLine(plan)
    recording, _ = watched(folder, STEPS, line)
    first, second = recording.events_of(MoveEvent)
    (wait,) = recording.events_of(WaitEvent)
    assert first.time < 0.3
    assert 1.0 < first.time + first.duration < 5.0
    assert wait.time == pytest.approx(5.0, abs=0.02)
    assert second.time == pytest.approx(7.0, abs=0.02)
    assert [event.time for event in recording.events_of(OutputEvent)] == pytest.approx([7.0], abs=0.02)
    states = [one["state"] for one in line.messages("live")]
    assert states == [*(4 * ["running", "held"]), "held"]


def test_a_step_among_moves_that_pass_by_ends_on_the_path_behind_the_target(folder: Path) -> None:
    plan: list[tuple[float, Order]] = [(0.1, LiveControl("hold")), (1.0, LiveControl("step"))]
    line = FakeLine([*plan, (10.0, LiveControl("continue"))])
    recording, _ = watched(folder, PASSING, line)
    plain, _ = watched(folder, PASSING, FakeLine())
    moves = recording.channels["move"]
    assert moves.times is not None
    assert moves.values[(moves.times > 1.0) & (moves.times < 10.0)].tolist() == [1.0]
    stands = (recording.time > 8.0) & (recording.time < 10.0)
    assert np.ptp(recording.channels["q"].values[stands], axis=0).max() == 0.0
    ends = [one.channels["q"].values[-1] for one in (recording, plain)]
    assert ends[0].tolist() == ends[1].tolist()
    (told,) = line.messages("notice")
    assert "behind the target of line 3, which the path passes by (zone 20 mm)" in str(told["text"])


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
