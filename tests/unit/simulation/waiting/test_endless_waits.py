"""Waits that nothing can end any more are found at once; all others go on as before."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import Diagnostic
from ropsim.flow import AwaitEvent, Event, Recording, WaitEvent
from ropsim.model import Barrier, BeltDrive, Cell, Device, IndexDrive, Part, Signal, Station, SwitchDrive
from ropsim.planning import Sample, SensedCell
from ropsim.simulation import Fidelity, InputChange, RunOptions, RunView, run
from ropsim.spatial import Pose
from support.compiled import station_code

ARM = robots.load("puma560")
BELT_AT = Pose(np.array([-1.0, 2.0, 0.38]))
AWAY = Pose(np.array([5.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.0, 1.0]))
SWITCHES = {name: Signal(name, is_input=False) for name in ("a", "b", "c")}
TOUR = ("mov joints(20, 60, -150, 0, -60, 0)", "mov joints(-20, 60, -150, 0, -60, 0)")


def cell(*names: str, inputs: tuple[Signal, ...] = (), devices: tuple[Device, ...] = ()) -> Cell:
    controller = robots.default_controller(ARM)
    stations = {
        name: Station(name, ARM, controller, AWAY if k else Pose(), program=name)
        for k, name in enumerate(names)
    }
    signals = {**SWITCHES, **{one.name: one for one in inputs}}
    return Cell("c", stations, signals=signals, devices={one.name: one for one in devices})


def ran(cell: Cell, options: RunOptions | None = None, **programs: tuple[str, ...]) -> Recording:
    codes = {name: station_code(cell, name, *lines) for name, lines in programs.items()}
    return run(cell, codes, options or RunOptions(Fidelity.KINEMATIC))


class Keyboard:
    """Somebody who may press a key, and does so once."""

    may_press = True

    def __init__(self, signal: str, time: float) -> None:
        self.signal, self.time = signal, time

    def advanced(self, run: RunView) -> None:
        pass

    def reading(self, run: RunView) -> None:
        if self.signal and run.time >= self.time:
            run.press(self.signal, run.tick, 1.0)
            self.signal = ""

    def ended(self, run: RunView) -> None:
        pass


def why(found: Diagnostic) -> tuple[str, ...]:
    """Return what a finding says of each channel that is waited for."""
    return tuple(found.message.split(" s on: ")[1].split("; "))


def codes_of(recording: Recording) -> list[str]:
    return [one.code for one in recording.findings]


def test_two_programs_that_wait_for_each_other_are_found_at_once_each_at_its_line() -> None:
    recording = ran(
        cell("left", "right"),
        left=(*TOUR, "wait until a", "set b on"),
        right=("wait until b", "set a on"),
    )
    assert codes_of(recording) == ["S742", "S742"]
    left, right = recording.findings
    assert (left.span.source, left.span.line) == ("left", 5) if left.span else False
    assert (right.span.source, right.span.line) == ("right", 3) if right.span else False
    assert why(left) == ("`a` is set by the program of `right`, which waits for `b` to come on on line 3",)
    assert why(right) == ("`b` is set by the program of `left`, which waits for `a` to come on on line 5",)
    alone = ran(cell("left"), left=TOUR)
    assert alone.duration <= recording.duration <= alone.duration + 0.01


def test_a_wait_for_a_program_that_has_ended_says_so() -> None:
    recording = ran(
        cell("left", "right"), left=("wait until not a", "wait until a"), right=("set a on", "set a off")
    )
    (found,) = recording.findings
    assert (found.code, found.data["channel"]) == ("S742", "a")
    assert "`right` waits" not in found.message
    assert "`a` to come on" in found.message
    assert why(found) == ("`a` is set by the program of `right`, which has ended",)


@pytest.mark.parametrize(
    ("signal", "note"),
    [
        ("b", "`b` is an output that no program sets"),
        ("key", "`key` is an input, and no change of it lies ahead"),
    ],
)
def test_a_wait_for_what_nobody_sets_says_so(signal: str, note: str) -> None:
    recording = ran(cell("left", inputs=(Signal("key", is_input=True),)), left=(f"wait until {signal}",))
    assert codes_of(recording) == ["S742"]
    assert why(recording.findings[0]) == (note,)
    assert recording.duration < 0.01


BELT = "`there` is set by the device `belt` when a part comes to its barrier"
THERE = Signal("there", is_input=True)


def on_a_belt(run: str, box_at: float | None, *lines: str) -> Diagnostic:
    """Return what is found where a program waits beside a belt with a barrier at 2 m."""
    belt = Device(
        "belt", robots.conveyor(3.0, 0.2, 0.1), BeltDrive(0.5, 1.0, run, 3.0, Barrier(2.0, "there")), BELT_AT
    )
    where = BELT_AT.position + np.array([box_at or 0.0, 0.0, 0.04])
    parts = (Part("box", np.array([0.1, 0.06, 0.04]), 0.5, Pose(where)),) if box_at is not None else ()
    made = replace(cell("left", inputs=(THERE,), devices=(belt,)), parts=parts)
    (found,) = ran(made, left=lines).findings
    assert found.code == "S742"
    return found


def test_a_wait_for_a_belt_says_what_would_set_the_signal_and_what_lies_on_it() -> None:
    empty = on_a_belt("", None, "wait until there")
    assert why(empty) == (f"{BELT}, and nothing lies on it",)
    assert empty.hint == "let a program or a supply put a part onto `belt`"
    stands = on_a_belt("c", 0.5, "wait until there")
    assert why(stands) == (f"{BELT}, but it stands, as `c` is off (`box` lies on it)",)
    assert stands.hint == "let `c` come on"
    passed = on_a_belt("", 0.5, "wait until there", "wait until not there")
    assert why(passed) == ("`there` stays on as long as a part is in the barrier of the device `belt`",)
    assert passed.hint == "let a gripper take the part off `belt`"


def test_a_wait_for_a_door_or_a_table_says_what_it_follows() -> None:
    door = Device("door", robots.slide(()), SwitchDrive("c", 0.0, 0.5, 1.0, 2.0, is_on="there"), AWAY)
    (found,) = ran(cell("left", inputs=(THERE,), devices=(door,)), left=("wait until there",)).findings
    assert why(found) == ("`there` is set by the device `door`, which stands, as `c` is off",)
    assert found.hint == "let `c` come on, which `door` follows"
    table = Device("table", robots.rotary(()), IndexDrive("c", 1.0, 1.0, 2.0, "there"), AWAY)
    (found,) = ran(cell("left", inputs=(THERE,), devices=(table,)), left=("wait until not there",)).findings
    assert why(found) == ("`there` is set by the device `table`, which stands until `c` comes on",)


def test_a_signal_that_is_only_ever_set_off_is_told() -> None:
    (found,) = ran(cell("left", "right"), left=("wait until a",), right=("set a off",)).findings
    assert why(found) == ("no program ever sets `a` on",)
    assert found.hint == "let the program of another station set it on"


def test_who_sets_the_signal_to_the_other_level_is_not_named() -> None:
    left, _ = ran(
        cell("left", "right", "third"),
        left=("wait until a",),
        right=("wait until b", "set a on"),
        third=("set a off",),
    ).findings
    assert why(left) == ("`a` is set by the program of `right`, which waits for `b` to come on on line 3",)


def test_a_level_that_is_worked_out_as_the_program_runs_may_be_either() -> None:
    (found,) = ran(cell("left", "right"), left=("wait until a",), right=("set a = b or c",)).findings
    assert why(found) == ("`a` is set by the program of `right`, which has ended",)


def test_to_speak_first_is_the_advice_where_two_wait_for_each_other_only() -> None:
    first = "let one program speak before it waits for the other, or give the wait a timeout"
    both = ran(cell("left", "right"), left=("wait until a", "set b on"), right=("wait until b", "set a on"))
    assert [one.hint for one in both.findings] == [first, first]
    ring = ran(
        cell("left", "right", "third"),
        left=("wait until a", "set b on"),
        right=("wait until b", "set c on"),
        third=("wait until c", "set a on"),
    )
    assert [one.hint for one in ring.findings] == [first] * 3
    chain = ran(cell("left", "right"), left=("wait until a",), right=("wait until b", "set a on"))
    assert chain.findings[0].hint == "look at what the program of `right` waits for"
    alone = ran(cell("left"), left=("wait until a", "set a on"))
    assert alone.findings[0].hint.startswith("set `a` in the program of another station")


def test_whoever_waits_for_one_that_has_ended_may_serve_it() -> None:
    (found,) = ran(
        cell("left", "right"), left=("wait until not a", "wait until a"), right=("set a on", "set a off")
    ).findings
    assert found.hint == (
        "let the program of `right` set `a` as often as this one waits for it; "
        "if this one serves the others, write `serves = true` in `[stations.left]`"
    )


def _that_came(recording: Recording) -> list[Event]:
    """Return the events but for waits in vain, which end elsewhere."""
    return [one for one in recording.events if not isinstance(one, AwaitEvent) or one.came]


def test_what_happened_before_is_what_happens_in_a_run_that_waits_on() -> None:
    """The same programs where a key might be pressed: the waits end after the longest wait, with I462."""
    made = cell("left", "right")
    programs = {"left": (*TOUR, "set c on", "wait until a"), "right": ("wait until c", "wait until b")}
    found = ran(made, None, **programs)
    waiting = RunOptions(Fidelity.KINEMATIC, watch=Keyboard("", 0.0), longest_wait=3.0)
    waited = ran(made, waiting, **programs)
    assert (codes_of(found), codes_of(waited)) == (["S742"] * 2, ["I462"] * 2)
    rows = len(found.time)
    assert rows < len(waited.time)
    for name in ("left/q", "right/q", "left/qd"):
        np.testing.assert_array_equal(found.channels[name].values, waited.channels[name].values[:rows])
    assert _that_came(found) == _that_came(waited)


def test_a_change_that_lies_ahead_is_waited_for() -> None:
    late = Signal("late", is_input=True, changes=((30.0, 1.0),))
    recording = ran(
        cell("left", "right", inputs=(late,)), left=("wait until late", "set a on"), right=("wait until a",)
    )
    assert codes_of(recording) == []
    assert recording.duration == pytest.approx(30.0, abs=0.01)


def test_a_recorded_input_is_waited_for() -> None:
    key = Signal("key", is_input=True)
    options = RunOptions(Fidelity.KINEMATIC, inputs=(InputChange(20.0, "key", 1.0),))
    recording = ran(cell("left", inputs=(key,)), options, left=("wait until key",))
    assert codes_of(recording) == []


def test_a_device_that_still_moves_is_waited_for() -> None:
    drive = IndexDrive("turn", np.pi, 0.5, 4.0, "in_place")
    table = Device("table", robots.rotary(()), drive, AWAY)
    signals = (Signal("turn", is_input=True, changes=((3.0, 1.0),)), Signal("in_place", is_input=True))
    recording = ran(
        cell("left", inputs=signals, devices=(table,)),
        left=("wait until not in_place", "wait until in_place"),
    )
    assert codes_of(recording) == []
    assert recording.duration > 3.0 + 2.0 * np.pi


def test_a_part_that_still_rides_to_its_barrier_is_waited_for() -> None:
    drive = BeltDrive(0.1, 1.0, "", 3.0, Barrier(2.0, "there"))
    belt = Device("belt", robots.conveyor(3.0, 0.2, 0.1), drive, Pose(np.array([-1.0, 2.0, 0.38])))
    box = Part("box", np.array([0.1, 0.06, 0.04]), 0.5, Pose(np.array([-0.5, 2.0, 0.42])))
    made = cell("left", inputs=(Signal("there", is_input=True),), devices=(belt,))
    recording = ran(replace(made, parts=(box,)), left=("wait until there",))
    assert codes_of(recording) == []
    assert recording.duration > 14.0


def test_one_wait_with_a_timeout_lets_the_others_wait() -> None:
    recording = ran(
        cell("left", "right"),
        left=("wait until a", "set b on"),
        right=("wait until b timeout 5 s else set a on", "wait until b"),
    )
    assert codes_of(recording) == []
    assert recording.duration == pytest.approx(5.0, abs=0.02)


def test_a_program_that_only_stands_may_still_speak() -> None:
    recording = ran(cell("left", "right"), left=("wait until a",), right=("wait 50 s", "set a on"))
    assert codes_of(recording) == []


def test_a_key_may_be_pressed_at_any_time_in_a_live_run() -> None:
    options = RunOptions(Fidelity.KINEMATIC, watch=Keyboard("key", 40.0))
    recording = ran(cell("left", inputs=(Signal("key", is_input=True),)), options, left=("wait until key",))
    assert codes_of(recording) == []
    assert recording.duration == pytest.approx(40.0, abs=0.02)


class Clockwork:
    """A sensor interface of a user's own, whose channel comes on at 12 s."""

    def read(self, channel: str, time: float, cell: SensedCell) -> Sample:
        del cell
        return Sample(channel == "key" and time >= 12.0, valid=True, age=0.0)


def test_what_a_sensor_interface_of_ones_own_delivers_is_waited_for() -> None:
    options = RunOptions(Fidelity.KINEMATIC, sensors=Clockwork())
    recording = ran(cell("left", inputs=(Signal("key", is_input=True),)), options, left=("wait until key",))
    assert codes_of(recording) == []
    assert recording.duration == pytest.approx(12.0, abs=0.02)


def test_the_last_program_at_work_is_enough() -> None:
    """The left one has ended; what the right one waits for at 2 s comes never."""
    recording = ran(cell("left", "right"), left=("wait 2 s",), right=("wait 1 s", "wait until a"))
    assert codes_of(recording) == ["S742"]
    assert recording.duration == pytest.approx(2.0, abs=0.02)
    assert [one.duration for one in recording.events_of(WaitEvent) if one.station == "left"] == [2.0]


@pytest.mark.parametrize(
    "wait",
    [
        ("wait until a and not b",),
        ("repeat", "wait 0.1 s", "until a or b"),
        ("while not a", "wait 0.25 s", "if b then break", "endw"),
    ],
)
def test_a_loop_that_only_looks_at_channels_waits_too(wait: tuple[str, ...]) -> None:
    recording = ran(cell("left", "right"), left=(*wait, "set b on"), right=("wait until b", "set a on"))
    assert codes_of(recording) == ["S742", "S742"]
    assert "waits for a change of `a` or `b`" in recording.findings[0].message
    assert "`a` is set by the program of `right`, which waits for `b` to come on on line 3" in (
        why(recording.findings[0])
    )
    assert recording.duration < 1.0


@pytest.mark.parametrize(
    "loop",
    [("wait until false",), ("n = 1", "wait until n > 3"), ("while true", "wait 0.1 s", "endw")],
)
def test_a_loop_that_looks_at_nothing_is_found_at_once(loop: tuple[str, ...]) -> None:
    recording = ran(cell("left", "right"), left=loop, right=("wait 5 s",))
    (found,) = recording.findings
    assert (found.code, found.data["station"]) == ("S742", "left")
    assert "it looks at nothing that could change" in found.message
    assert recording.duration == pytest.approx(5.0, abs=0.2)


def test_a_wait_for_what_nothing_changes_passes_its_time_without_looking_again() -> None:
    waits = ("n = 1", "wait until n > 3 timeout 900 s else print n", "wait until n = 1 timeout 900 s")
    recording = ran(cell("left"), left=waits)
    assert recording.findings == ()
    assert recording.duration == 900.0
    assert len(recording.events_of(WaitEvent)) == 1


@pytest.mark.parametrize(
    "loop",
    [
        ("n = 0", "while not a and n < 100", "n = n + 1", "wait 0.1 s", "endw"),
        ("wait until a and b timeout 10 s else set c on",),
    ],
)
def test_a_loop_that_counts_or_looks_at_the_time_goes_on(loop: tuple[str, ...]) -> None:
    recording = ran(cell("left", "right"), left=(*loop, "set b on"), right=("wait until b",))
    assert codes_of(recording) == []
    assert recording.duration >= 10.0


def test_two_loops_that_look_at_each_other_are_found_whatever_their_pace() -> None:
    recording = ran(
        cell("left", "right"),
        left=("while not a", "wait 0.07 s", "endw", "set b on"),
        right=("wait 0.5 s", "while not b", "wait 0.11 s", "endw", "set a on"),
    )
    assert codes_of(recording) == ["S742", "S742"]
    assert recording.duration < 2.0


def test_a_loop_that_looks_at_a_channel_sees_it_change() -> None:
    late = Signal("late", is_input=True, changes=((8.0, 1.0),))
    recording = ran(cell("left", inputs=(late,)), left=("wait until late and not a", "set b on"))
    assert codes_of(recording) == []
    assert recording.duration == pytest.approx(8.0, abs=0.05)
