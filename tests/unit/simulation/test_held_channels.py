"""What holds its value between changes is recorded with the very ticks at which instructions acted."""

from dataclasses import replace

import numpy as np
import pytest

import ropsim
from ropsim.flow import (
    ChannelGroup,
    GripEvent,
    InputChange,
    MoveEvent,
    OutputEvent,
    Recording,
    TaskEvent,
    WaitEvent,
)
from ropsim.model import ROBOT, Cell, Gripper, Part, Signal, Tool
from ropsim.robots import default_controller, load
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Pose
from ropsim.workbench import environment_of
from support.cells import one_station

PLACE = (0.45, -0.15, 0.1)
JAWS = Tool("jaws", Pose(np.array([0.0, 0.0, 0.12])), 2.0, gripper=Gripper(0.2, 0.301, 0.005))
HELD = {"line", "move", "gripper", "payload", "signal.lamp", "signal.start"}
PROGRAM = """program p
units mm, deg, s
task Carry()
  mov (450, -150, 100)
  close
  set lamp on
  lin (450, -150, 200)
  wait 0.123 s
  set lamp off
  open
endp
Carry
wait until start timeout 5 s else print "late"
print "end"
"""


@pytest.fixture(scope="module")
def cell() -> Cell:
    robot = load("puma560")
    part = Part("box", np.full(3, 0.06), 0.5, Pose(np.array(PLACE)))
    return one_station(
        "c",
        robot,
        default_controller("puma560"),
        tools={"jaws": JAWS},
        default_tool="jaws",
        parts=(part,),
        signals={name: Signal(name, is_input) for name, is_input in (("lamp", False), ("start", True))},
        start=robot.home,
    )


def ran(cell: Cell, record_hz: int, fidelity: Fidelity = Fidelity.KINEMATIC) -> Recording:
    compiled = ropsim.language.compile(PROGRAM, environment_of(cell))
    assert compiled.icr is not None, compiled.diagnostics
    given = (InputChange(1.001, "start", 1.0), InputChange(900.0, "start", 0.0))
    return run(cell, {"robot": compiled.icr}, RunOptions(fidelity, record_hz=record_hz, inputs=given))


@pytest.fixture(scope="module")
def recording(cell: Cell) -> Recording:
    """Return the run with a row at every 250th tick."""
    return ran(cell, 4)


def changes(recording: Recording, name: str) -> list[tuple[float, float]]:
    channel = recording.channels[name]
    assert channel.times is not None
    return list(zip(channel.times.tolist(), channel.values.tolist(), strict=True))


def test_what_holds_its_value_is_kept_as_changes_and_all_else_as_rows(recording: Recording) -> None:
    assert {name for name, channel in recording.channels.items() if channel.held} == HELD
    rows = len(recording.time)
    assert {len(one.values) for one in recording.channels.values() if not one.held} == {rows}


@pytest.mark.parametrize("fidelity", Fidelity)
def test_changes_are_the_same_however_sparse_the_rows_are(cell: Cell, fidelity: Fidelity) -> None:
    every, few = ran(cell, 1000, fidelity), ran(cell, 4, fidelity)
    assert len(few.time) < len(every.time) / 100
    assert {name: changes(few, name) for name in HELD} == {name: changes(every, name) for name in HELD}


def test_each_change_is_at_the_very_tick_at_which_its_instruction_acted(recording: Recording) -> None:
    first, second = recording.events_of(OutputEvent)
    assert changes(recording, "signal.lamp") == [(0.0, 0.0), (first.time, 1.0), (second.time, 0.0)]
    taken, left = (one.time for one in recording.placements if one.body == "box" and one.time > 0.0)
    assert changes(recording, "gripper") == [(0.0, 0.0), (taken, 1.0), (left, 0.0)]
    assert changes(recording, "payload") == [(0.0, 2.0), (taken, 2.5), (left, 2.0)]
    assert dict(changes(recording, "line"))[second.time] == 10.0  # no time passes between lines 9 and 10
    assert dict(changes(recording, "line"))[recording.events_of(WaitEvent)[0].time] == 8.0


def test_moves_hold_from_their_begin_to_the_tick_at_which_the_arm_has_settled(recording: Recording) -> None:
    begins = [(one.time, float(one.ordinal)) for one in recording.events_of(MoveEvent)]
    found = changes(recording, "move")
    assert [change for change in found if change[1] >= 0.0] == begins
    hz = recording.facts.stations[0].control_hz
    assert [round(time * hz) for time, value in found[1:] if value < 0.0] == [
        round(one.end * hz) for one in recording.events_of(MoveEvent)
    ]


def test_every_change_is_a_whole_tick_within_the_run(recording: Recording) -> None:
    hz = recording.facts.stations[0].control_hz
    for name in HELD:
        times = np.array([time for time, _ in changes(recording, name)])
        assert (times == np.round(times * hz) / hz).all(), name
        assert (np.diff(times) > 0.0).all()
        assert times[-1] <= recording.duration
    assert changes(recording, "signal.start")[-1] == (1.001, 1.0)


def test_rows_tell_the_value_of_the_control_period_that_ends_with_them(cell: Cell) -> None:
    every = ran(cell, 1000)
    (gripped,) = every.events_of(GripEvent)
    end = round(gripped.end * 1000)
    assert every.rows("gripper")[[end, end + 1]].tolist() == [0.0, 1.0]


def test_channels_say_whose_they_are_and_where_lists_show_them(recording: Recording) -> None:
    for name, channel in recording.channels.items():
        assert channel.subject == ("" if name.startswith("signal.") else ROBOT), name
        assert (channel.group is ChannelGroup.SIGNALS) == name.startswith("signal."), name
    groups = {name: recording.channels[name].group for name in ("q", "path_error", "line")}
    assert groups == {"q": ChannelGroup.JOINTS, "path_error": ChannelGroup.TCP, "line": ChannelGroup.PROGRAM}


def test_every_event_of_an_instruction_names_its_station(recording: Recording) -> None:
    assert {event.station for event in recording.events if event.origin} == {ROBOT}
    assert {event.station for event in recording.events if event.kind == "input"} == {""}
    (task,) = recording.events_of(TaskEvent)
    assert (task.station, task.name, task.depth) == (ROBOT, "Carry", 1)


def test_a_change_of_a_held_value_makes_another_recording(recording: Recording) -> None:
    lamp = recording.channels["signal.lamp"]
    assert lamp.times is not None
    later = replace(lamp, times=lamp.times + np.array([0.0, 0.001, 0.001]))
    assert recording != replace(recording, channels={**recording.channels, "signal.lamp": later})
