"""Several stations and devices against one clock."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.flow import AwaitEvent, GripEvent, MoveEvent, OutputEvent, Recording, ReleaseEvent
from ropsim.kinematics import forward
from ropsim.model import (
    Barrier,
    BeltDrive,
    Cell,
    Cylinder,
    Destination,
    Device,
    Gripper,
    IndexDrive,
    Part,
    Rates,
    Shape,
    Signal,
    Station,
    SwitchDrive,
    Tool,
)
from ropsim.simulation import Fidelity, OptionError, RunOptions, RunView, run
from ropsim.spatial import Pose
from support.compiled import station_code

ARM = robots.load("puma560")
CONTROLLER = robots.default_controller(ARM)
JAWS = Tool("jaws", Pose(np.array([0.0, 0.0, 0.1])), 1.0, gripper=Gripper(0.25, 0.25, 0.02))
DOWN = np.array([0.0, 1.0, 0.0, 0.0])
AWAY = Pose(np.array([5.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.0, 1.0]))


def station(name: str, X_WB: Pose | None = None, hz: int = 1000) -> Station:
    controller = replace(CONTROLLER, rates=Rates(hz, 4, CONTROLLER.rates.plant_steps))
    return Station(name, ARM, controller, X_WB or Pose(), {"jaws": JAWS}, "jaws", program=name)


def cell(*stations: Station, **around: Any) -> Cell:
    made = Cell("c", {one.name: one for one in stations})
    return replace(made, **around)


def ran(cell: Cell, options: RunOptions | None = None, **programs: tuple[str, ...]) -> Recording:
    codes = {name: station_code(cell, name, *lines) for name, lines in programs.items()}
    return run(cell, codes, options or RunOptions(Fidelity.KINEMATIC))


def switch(name: str, *, is_input: bool = False) -> Signal:
    return Signal(name, is_input)


TOUR = ("mov joints(20, 60, -150, 0, -60, 0)", "wait 0.5 s", "mov joints(-20, 60, -150, 0, -60, 0)")
SHORT = ("mov joints(10, 60, -150, 0, -60, 0)",)


def test_stations_that_say_nothing_to_each_other_run_as_they_would_alone() -> None:
    """With drives and dynamics, bit for bit, up to the end of the shorter program."""
    both = ran(cell(station("left"), station("right", AWAY)), RunOptions(), left=TOUR, right=SHORT)
    for name, lines in (("left", TOUR), ("right", SHORT)):
        alone = ran(cell(station(name, AWAY if name == "right" else None)), RunOptions(), **{name: lines})
        for quantity in ("q", "tau", "current"):
            values = alone.channels[f"{name}/{quantity}"].values
            np.testing.assert_array_equal(both.channels[f"{name}/{quantity}"].values[: len(values)], values)
        assert [one for one in both.events if one.station == name] == list(alone.events)


def test_the_order_of_the_stations_changes_nothing() -> None:
    left, right = station("left"), station("right", AWAY)
    one = ran(cell(left, right), left=TOUR, right=SHORT)
    other = ran(cell(right, left), left=TOUR, right=SHORT)
    assert set(one.channels) == set(other.channels)
    assert all(one.channels[name] == other.channels[name] for name in one.channels)
    assert one.findings == other.findings


def test_a_program_sees_what_another_one_sets_not_before_it_is_set() -> None:
    """The reader looks every 4 ms; the writer sets at 0.5 s, and again off at 1.25 s."""
    signals = {"go": switch("go")}
    recording = ran(
        cell(station("left"), station("right", AWAY), signals=signals),
        left=("wait 0.5 s", "set go on", "wait 0.75 s", "set go off"),
        right=("wait until go", 'print "on"', "wait until not go", 'print "off"'),
    )
    said = [event.time for event in recording.events if event.kind == "message"]
    assert said[0] == pytest.approx(0.5, abs=0.004 + 1e-9)
    assert said[0] >= 0.5
    assert said[1] == pytest.approx(1.25, abs=0.004 + 1e-9)
    assert said[1] >= 1.25


def test_a_wait_for_a_signal_is_an_event_that_tells_whether_the_signal_came() -> None:
    recording = ran(
        cell(station("left"), station("right", AWAY), signals={"go": switch("go")}),
        left=("wait 0.5 s", "set go on", "wait 1 s"),
        right=("wait until go", "wait until go", 'wait until not go timeout 0.25 s else print "on"'),
    )
    waits = recording.events_of(AwaitEvent)
    assert [(one.channel, one.value, one.came) for one in waits] == [
        ("go", True, True),
        ("go", True, True),
        ("go", False, False),
    ]
    assert {one.station for one in waits} == {"right"}
    came, again, late = waits
    assert came.time == 0.0
    assert came.duration == pytest.approx(0.5, abs=0.004 + 1e-9)
    assert again.duration <= 0.004 + 1e-9
    assert late.duration == pytest.approx(0.25, abs=0.004 + 1e-9)
    assert len({one.line for one in waits}) == 3


def test_the_last_word_on_a_signal_that_two_stations_set_is_the_later_one() -> None:
    recording = ran(
        cell(station("left"), station("right", AWAY), signals={"go": switch("go")}),
        left=("set go on", "wait 1 s", 'if go then print "still on"'),
        right=("wait 0.5 s", "set go off"),
    )
    assert not any(event.kind == "message" for event in recording.events)
    assert [(one.time, one.station) for one in recording.events_of(OutputEvent)] == [
        (0.0, "left"),
        (0.5, "right"),
    ]
    assert recording.at("signal.go", 0.9) == 0.0


def test_the_arm_of_a_program_that_has_ended_stands_until_the_last_one_ends() -> None:
    recording = ran(cell(station("left"), station("right", AWAY)), left=TOUR, right=SHORT)
    (end,) = (one.end for one in recording.events_of(MoveEvent) if one.station == "right")
    rest = recording.channels["right/q"].values[recording.time > end + 0.01]
    assert len(rest) > 100
    assert np.ptp(rest, axis=0).max() < 1e-9
    assert recording.time[-2] < recording.duration <= recording.time[-1]
    assert recording.rows("right/q")[-1].tolist() == rest[0].tolist()


def test_controllers_of_different_rates_share_the_rows_of_one_recording() -> None:
    slow = station("right", AWAY, hz=400)
    recording = ran(cell(station("left"), slow), left=TOUR, right=TOUR)
    alone = ran(cell(slow), right=TOUR)
    assert np.ptp(np.diff(recording.time)) < 1e-9
    times, values = alone.time, alone.channels["right/q"].values
    shown = np.column_stack([np.interp(recording.time, times, one) for one in values.T])
    within = recording.time <= times[-1]
    error = np.abs(recording.channels["right/q"].values - shown)[within]
    assert error.max() < 2e-4  # both are linear between their rows


PLACE = Pose(np.array([0.5, 0.0, 0.5]), DOWN)
POST = Part("post", np.array([0.04, 0.04, 0.12]), 0.4, Pose(np.array([0.5, 0.0, 0.5])))


def handover() -> Recording:
    """The left arm lifts the post, the right one takes it over while it is held, and the left one lets go."""
    right = station("right", Pose(np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.0, 1.0])))
    signals = {name: switch(name) for name in ("up", "mine")}
    where = {"post": PLACE, "high": Pose(np.array([0.5, 0.0, 0.6]), DOWN)}
    return ran(
        cell(station("left"), right, parts=(POST,), signals=signals, locations=where),
        left=("mov post", "close", "lin high", "set up on", "wait until mine", "open", "mov home"),
        right=("wait until up", "mov high", "close", "set mine on", "wait 0.5 s", "lin high above 50 mm"),
    )


def test_a_part_that_another_arm_holds_is_taken_over_where_it_is() -> None:
    recording = handover()
    told = [(one.time, one.parent) for one in recording.placements if one.body == "post"]
    assert [parent for _, parent in told] == ["", "left/tool:jaws", "right/tool:jaws"]
    (grip,) = (one for one in recording.events_of(GripEvent) if one.station == "right")
    assert grip.part == "post"
    assert told[2][0] == pytest.approx(grip.end, abs=1e-9)
    (left,) = recording.events_of(ReleaseEvent)
    assert (left.station, left.part) == ("left", "")  # nothing is in its jaws any more
    assert recording.findings == ()


def test_what_an_arm_carries_weighs_on_it_only() -> None:
    recording = handover()
    grips = {one.station: one.end for one in recording.events_of(GripEvent)}
    between, after = (grips["left"] + grips["right"]) / 2.0, recording.duration - 0.1
    for name, loads in (("left", [1.4, 1.0]), ("right", [1.0, 1.4])):
        found = [float(recording.at(f"{name}/payload", time)) for time in (between, after)]
        assert found == pytest.approx(loads)


def belt(barrier: Barrier | None = None, run: str = "") -> Device:
    drive = BeltDrive(0.25, 1.0, run, 3.0, barrier)
    return Device("belt", robots.conveyor(3.0, 0.2, 0.1), drive, Pose(np.array([-1.0, 0.0, 0.38])))


def test_a_part_rides_on_its_belt_into_the_barrier_and_is_picked_where_it_stands() -> None:
    signals = {"there": switch("there", is_input=True), "belt_on": switch("belt_on")}
    box = Part("box", np.array([0.1, 0.06, 0.04]), 0.5, Pose(np.array([-0.5, 0.0, 0.42])))
    recording = ran(
        cell(
            station("left"),
            parts=(box,),
            signals=signals,
            devices={"belt": belt(Barrier(1.55, "there"), "belt_on")},
            locations={"pick": Pose(np.array([0.5, 0.0, 0.42]), DOWN)},
        ),
        left=(
            "mov pick above 100 mm",
            "set belt_on on",
            "wait until there",
            "lin pick",
            "close",
            "lin pick above 100 mm",
        ),
    )
    assert recording.findings == ()
    (grip,) = recording.events_of(GripEvent)
    assert grip.part == "box"
    (started,) = recording.events_of(OutputEvent)
    # 1 m with 0.25 m/s and 1 m/s²; the program looks every 4 ms
    arrival = started.time + 1.0 / 0.25 + 0.25 / 1.0
    change = recording.channels["signal.there"]
    assert change.times is not None
    assert change.times[1] == pytest.approx(arrival, abs=1e-3)
    assert recording.at("belt/q", grip.time).item() == pytest.approx(1.0, abs=1e-9)
    placed = [one for one in recording.placements if one.body == "box"]
    assert [one.parent for one in placed] == ["belt/link1", "left/tool:jaws"]
    np.testing.assert_allclose(placed[1].X_PB.position, [0.0, 0.0, 0.1], atol=1e-9)


def test_a_part_at_the_end_of_a_belt_leaves_the_cell_and_is_found() -> None:
    box = Part("box", np.array([0.1, 0.06, 0.04]), 0.5, Pose(np.array([1.5, 0.0, 0.42])))
    recording = ran(cell(station("left"), parts=(box,), devices={"belt": belt()}), left=("wait 4 s",))
    (found,) = recording.findings
    assert (found.code, found.data["part"]) == ("S741", "box")
    assert recording.facts.parts_left == ("box",)
    # 0.5 m from rest: v²/2a + the rest at full speed
    assert found.data["time_s"] == pytest.approx(0.25 + (0.5 - 0.03125) / 0.25, abs=1.1e-3)


def test_a_part_with_a_destination_that_ran_off_is_told_to_have_done_so() -> None:
    wanted = Destination(Pose(np.array([0.5, 0.0, 0.42])), 0.005, None)
    box = Part("box", np.array([0.1, 0.06, 0.04]), 0.5, Pose(np.array([1.5, 0.0, 0.42])), destination=wanted)
    recording = ran(cell(station("left"), parts=(box,), devices={"belt": belt()}), left=("wait 4 s",))
    (missing,) = [one for one in recording.findings if one.code == "S738"]
    assert missing.message.startswith("part `box` has run off the end of the belt `belt`, it was to be at ")


def test_a_program_waits_for_a_door_and_a_table_turns_what_lies_on_it() -> None:
    plate = (Shape(Cylinder(0.3, 0.02), Pose(np.array([0.0, 0.0, -0.01]))),)
    table = Device(
        "table",
        robots.rotary(plate),
        IndexDrive("turn", np.pi / 2, 1.0, 4.0, "in_place"),
        Pose(np.array([2.0, 0.0, 0.4])),
    )
    door = Device(
        "door",
        robots.slide(plate),
        SwitchDrive("door_open", 0.0, 0.5, 0.5, 2.0, "", "is_open"),
        Pose(np.array([2.0, 2.0, 0.0])),
    )
    signals = {name: switch(name) for name in ("turn", "door_open")}
    signals |= {name: switch(name, is_input=True) for name in ("in_place", "is_open")}
    box = Part("box", np.array([0.05, 0.05, 0.04]), 0.5, Pose(np.array([2.2, 0.0, 0.44])))
    recording = ran(
        cell(station("left"), parts=(box,), signals=signals, devices={"table": table, "door": door}),
        left=(
            "set door_open on",
            "wait until is_open",
            'print "open"',
            "set turn on",
            "wait until not in_place",
            "wait until in_place",
            'print "turned"',
        ),
    )
    opened, turned = (one.time for one in recording.events if one.kind == "message")
    assert opened == pytest.approx(0.5 / 0.5 + 0.25, abs=5e-3)
    assert turned == pytest.approx(opened + np.pi / 2 + 0.25, abs=1.5e-2)
    assert recording.channels["table/q"].values[-1] == pytest.approx(np.pi / 2, abs=1e-12)
    (placed,) = (one for one in recording.placements if one.body == "box")
    assert placed.parent == "table/link1"


def stack(x: float) -> tuple[Part, Part]:
    low = Part("low", np.array([0.1, 0.06, 0.04]), 0.5, Pose(np.array([x, 0.0, 0.42])))
    return low, replace(low, name="high", X_WO=Pose(np.array([x, 0.0, 0.46])))


def test_a_stack_rides_on_a_belt_and_is_lifted_and_set_down_as_one() -> None:
    signals = {"there": switch("there", is_input=True)}
    recording = ran(
        cell(
            station("left"),
            parts=stack(-0.5),
            signals=signals,
            devices={"belt": belt(Barrier(1.55, "there"))},
            locations={"pick": Pose(np.array([0.5, 0.0, 0.42]), DOWN)},
        ),
        left=(
            "wait until there",
            "mov pick",
            "close",
            "lin pick above 100 mm",
            "lin pick offset (-80, 0, 1)",
            "open",
            "wait 3 s",
        ),
    )
    told = {
        name: [one.parent for one in recording.placements if one.body == name] for name in ("low", "high")
    }
    assert told == {"low": ["belt/link1", "left/tool:jaws", "belt/link1"], "high": ["low"]}
    assert recording.at("left/payload", recording.events_of(GripEvent)[0].end + 0.1) == pytest.approx(2.0)
    assert [found.code for found in recording.findings if found.is_error] == []


def test_a_part_too_near_to_be_stopped_comes_into_the_barrier_and_stops_the_belt_for_the_next() -> None:
    """It is set down 10 mm before the barrier on a belt at full speed, which brakes within 31 mm."""
    here, next_ = stack(0.49)[0], replace(stack(-0.6)[0], name="next")
    signals = {"there": switch("there", is_input=True)}
    recording = ran(
        cell(
            station("left"),
            parts=(replace(here, X_WO=Pose(np.array([0.49, 0.0, 0.5]))), next_),
            signals=signals,
            devices={"belt": belt(Barrier(1.55, "there"))},
            locations={"pick": Pose(np.array([0.49, 0.0, 0.5]), DOWN)},
        ),
        left=("mov pick", "close", "lin pick offset (0, 0, -80)", "open", "wait 8 s"),
    )
    assert [found.code for found in recording.findings] == []
    change = recording.channels["signal.there"]
    assert change.values[-1] == 1.0
    assert np.ptp(recording.channels["belt/q"].values[-250:]) == 0.0


def test_a_device_that_follows_a_scripted_input_moves_at_the_tick_of_the_change() -> None:
    """2.007 s is tick 2007 at 1 kHz, although 2.007 · 1000 is above 2007 in floating-point numbers."""
    signals = {"go": Signal("go", is_input=True, changes=((2.007, 1.0),)), "up": switch("up", is_input=True)}
    drive = SwitchDrive("go", 0.0, 0.5, 0.5, 2.0, "", "up")
    door = Device("door", robots.slide(()), drive, Pose(np.array([2.0, 2.0, 0.0])))
    recording = ran(cell(station("left"), signals=signals, devices={"door": door}), left=("wait 4 s",))
    moved = recording.time[recording.channels["door/q"].values[:, 0] > 0.0]
    assert moved[0] == pytest.approx(2.008)
    up = recording.channels["signal.up"]
    assert up.times is not None
    assert up.times[1] == pytest.approx(2.007 + 0.5 / 0.5 + 0.5 / 2.0, abs=1e-9)


def test_a_device_starts_at_its_position_of_off_and_goes_to_on_from_there() -> None:
    drive = SwitchDrive("go", 0.2, 0.5, 0.5, 2.0, "", "up")
    door = Device("door", robots.slide(()), drive, Pose(np.array([2.0, 2.0, 0.0])))
    signals = {"go": switch("go"), "up": switch("up", is_input=True)}
    made = cell(station("left"), signals=signals, devices={"door": door})
    recording = ran(made, left=("wait 0.5 s", "set go on", "wait 2 s"))
    q = recording.channels["door/q"].values[:, 0]
    assert q[recording.time <= 0.5].tolist() == [0.2] * int((recording.time <= 0.5).sum())
    assert q[-1] == pytest.approx(0.5, abs=1e-12)
    up = recording.channels["signal.up"]
    assert up.times is not None
    assert up.times[1] == pytest.approx(0.5 + (0.5 - 0.2) / 0.5 + 0.5 / 2.0, abs=1e-9)


def test_a_device_that_follows_what_it_tells_itself_lets_time_pass() -> None:
    drive = SwitchDrive("closed", 0.0, 0.1, 0.5, 2.0, "closed", "")
    door = Device("door", robots.slide(()), drive, Pose(np.array([2.0, 2.0, 0.0])))
    signals = {"closed": switch("closed", is_input=True)}
    recording = ran(cell(station("left"), signals=signals, devices={"door": door}), left=("wait 0.2 s",))
    assert recording.duration == pytest.approx(0.2)


def test_a_payload_is_gone_at_once_from_the_arm_from_which_a_part_is_taken() -> None:
    right = station("right", Pose(np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.0, 1.0])))
    where = {"post": PLACE, "high": Pose(np.array([0.5, 0.0, 0.6]), DOWN)}
    recording = ran(
        cell(station("left"), right, parts=(POST,), signals={"up": switch("up")}, locations=where),
        left=("mov post", "close", "lin high", "set up on", "wait 6 s"),
        right=("wait until up", "mov high", "close", "wait 1 s"),
    )
    taken = recording.events_of(GripEvent)[-1].end
    assert recording.at("left/payload", taken - 0.1) == pytest.approx(1.4)
    assert recording.at("left/payload", taken + 1.1) == pytest.approx(1.0)


def test_at_one_time_stations_act_in_the_order_of_their_names() -> None:
    seen = []
    for order in (("a", "b"), ("b", "a")):
        stations = [station(name, AWAY if name == "b" else None) for name in order]
        lines = {"a": ("set go on",), "b": ('if go then print "seen"',)}
        made = cell(*stations, signals={"go": switch("go")})
        codes = {name: station_code(made, name, *lines[name]) for name in order}
        recording = run(made, codes, RunOptions(Fidelity.KINEMATIC))
        seen.append(sorted(event.kind for event in recording.events))
    assert seen == [["message", "output"]] * 2


def test_a_device_follows_what_another_one_tells_at_the_same_tick() -> None:
    first = SwitchDrive("go", 0.0, 0.5, 0.5, 2.0, "", "up")
    doors = {
        name: Device(name, robots.slide(()), drive, Pose(np.array([2.0, 2.0, 0.0])))
        for name, drive in (("one", first), ("two", replace(first, signal="up", is_on="")))
    }
    signals = {"go": switch("go"), "up": switch("up", is_input=True)}
    recording = ran(cell(station("left"), signals=signals, devices=doors), left=("set go on", "wait 3 s"))
    up = recording.channels["signal.up"]
    assert up.times is not None
    q = recording.channels["two/q"].values[:, 0]
    # from rest with 2 m/s² from the very tick at which the first one tells
    row = int(np.searchsorted(recording.time, up.times[1] + 0.1))
    assert q[row] == pytest.approx(0.5 * 2.0 * (recording.time[row] - up.times[1]) ** 2, abs=1e-12)


def test_at_one_tick_a_device_acts_before_the_next_station() -> None:
    table = Device("table", robots.rotary(()), IndexDrive("turn", 1.0, 1.0, 4.0, "in_place"), AWAY)
    signals = {"turn": switch("turn"), "in_place": switch("in_place", is_input=True)}
    recording = ran(
        cell(station("a"), station("b", AWAY), signals=signals, devices={"table": table}),
        a=("wait 0.5 s", "set turn on", "wait 0.1 s"),
        b=("wait 0.5 s", 'if not in_place then print "it moves"'),
    )
    assert [event.time for event in recording.events if event.kind == "message"] == [0.5]


def test_taking_a_part_from_a_moving_hand_does_not_move_it() -> None:
    """The left arm moves the post along while the right one, of another control rate, closes on it."""
    turned = Pose(np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.0, 1.0]))
    where = {
        "post": PLACE,
        "high": Pose(np.array([0.5, -0.1, 0.6]), DOWN),
        "way": Pose(np.array([0.5, 0.0, 0.6]), DOWN),
    }
    made = cell(
        station("left"),
        station("right", turned, hz=400),
        parts=(POST,),
        signals={"up": switch("up")},
        locations=where,
    )
    recording = ran(
        made,
        RunOptions(Fidelity.KINEMATIC, record_hz=1000),
        left=("mov post", "close", "lin high", "set up on", "lin way offset (0, 100, 0) speed 100 mm/s"),
        right=("mov way", "wait until up", "wait 0.8 s", "close", "wait 1 s"),
    )
    grip = recording.events_of(GripEvent)[-1]
    assert (grip.station, grip.part) == ("right", "post")
    told = [one for one in recording.placements if one.body == "post"]
    poses = {}
    for one, name in ((told[1], "left"), (told[2], "right")):
        arm = made.stations[name]
        q = [np.interp(told[2].time, recording.time, row) for row in recording.channels[f"{name}/q"].values.T]
        poses[name] = (arm.X_WB @ forward(arm.robot, np.array(q)) @ one.X_PB).matrix()
    speed = np.abs(np.diff(recording.channels["left/q"].values, axis=0)).max(axis=1)
    row = int(np.searchsorted(recording.time, told[2].time))
    assert speed[row] > 1e-5  # it does move
    np.testing.assert_allclose(poses["left"], poses["right"], rtol=0, atol=2e-6)


def test_what_lies_on_a_part_leaves_with_it_at_the_end_of_a_belt() -> None:
    recording = ran(cell(station("left"), parts=stack(1.5), devices={"belt": belt()}), left=("wait 4 s",))
    assert set(recording.facts.parts_left) == {"low", "high"}


def test_skipped_moves_are_those_of_their_station() -> None:
    recording = ran(cell(station("left"), station("right", AWAY)), left=SHORT, right=("mov (9000, 0, 0)",))
    assert [one.skipped_moves for one in recording.facts.stations] == [0, 1]


class Stopper:
    """Ends the run at a time."""

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


def test_a_run_that_is_ended_by_hand_ends_for_all_stations() -> None:
    options = RunOptions(Fidelity.KINEMATIC, watch=Stopper(0.2))
    recording = ran(cell(station("left"), station("right", AWAY)), options, left=("wait 100 s",), right=TOUR)
    assert {one.code for one in recording.findings} == {"S761"}
    assert recording.duration < 5.0


@pytest.mark.parametrize(
    "wrong",
    [{"longest": np.inf}, {"longest": -1.0}, {"longest_wait": np.nan}, {"record_hz": 0}, {"most_rows": 0}],
)
def test_options_that_cannot_be_are_told(wrong: dict[str, Any]) -> None:
    options = RunOptions(Fidelity.KINEMATIC, **wrong)
    with pytest.raises(OptionError) as caught:
        ran(cell(station("left")), options, left=SHORT)
    assert caught.value.diagnostic.code == "S703"
    assert next(iter(wrong)) in caught.value.diagnostic.message


def test_a_station_without_a_program_stands_still() -> None:
    recording = ran(cell(station("left"), station("right", AWAY)), left=SHORT)
    assert np.ptp(recording.channels["right/q"].values, axis=0).max() == 0.0
    assert [one.program for one in recording.facts.stations] == ["left", ""]
