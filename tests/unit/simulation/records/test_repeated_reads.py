"""What a program looks at in one pass it sees at one instant; every loop that looks takes time."""

import pytest

from ropsim import robots
from ropsim.flow import MessageEvent, MoveEvent, Recording, WaitEvent
from ropsim.model import Cell, Signal, Station
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Pose
from ropsim.views import CycleParts, summarize_cycle
from support.compiled import station_code

ARM = robots.load("puma560")
CONTROLLER = robots.default_controller(ARM)
TICK = CONTROLLER.rates.interpolation_period  # [s]
NAMES = "abcdef"


def pulse(name: str, *changes: tuple[float, float], initial: float = 0.0) -> Signal:
    return Signal(name, is_input=True, initial=initial, changes=changes)


def ran(signals: list[Signal], *lines: str, longest: float = 60.0) -> Recording:
    station = Station("left", ARM, CONTROLLER, Pose(), program="left")
    cell = Cell("c", {"left": station}, signals={one.name: one for one in signals})
    options = RunOptions(Fidelity.KINEMATIC, longest=longest)
    return run(cell, {"left": station_code(cell, "left", *lines)}, options)


def said(recording: Recording) -> list[tuple[str, float]]:
    return [(one.text, round(one.time, 9)) for one in recording.events_of(MessageEvent)]


def parts(recording: Recording) -> CycleParts:
    return summarize_cycle(recording, recording.facts.stations[0]).whole


@pytest.mark.parametrize("count", [1, 2, 3, 6])
def test_a_pulse_of_two_ticks_is_seen_however_many_inputs_the_condition_has(count: int) -> None:
    others = [pulse(name, initial=1.0) for name in NAMES[1:count]]
    recording = ran(
        [pulse("a", (0.5, 1.0), (0.5 + 2 * TICK, 0.0)), *others],
        f"wait until {' and '.join(NAMES[:count])} timeout 1 s else print 0",
        "print 1",
    )
    ((text, time),) = said(recording)
    assert text == "1"
    assert 0.5 <= time <= 0.5 + TICK


@pytest.mark.parametrize("start", [0.992, 0.996, 1.0])
def test_inputs_that_are_never_on_together_are_not_seen_together(start: float) -> None:
    recording = ran(
        [pulse("a", (1.0, 0.0), initial=1.0), pulse("b", (1.0, 1.0))],
        f"wait {start} s",
        "if a and b then print 1",
        "wait until a and b timeout 1 s else print 2",
    )
    assert [text for text, _ in said(recording)] == ["2"]


def test_looks_with_nothing_between_them_take_no_time() -> None:
    signals = [pulse(name, initial=1.0) for name in NAMES]
    looks = [f"if {name} then print {k}" for k, name in enumerate(NAMES)]
    waits = [f"wait until {name}" for name in NAMES]
    recording = ran(signals, *looks, *waits, "if a and b and c then print 6", "print 7")
    assert said(recording) == [(str(k), 0.0) for k in range(8)]


def test_a_task_that_is_called_twice_looks_twice_at_one_instant() -> None:
    lines = ("look()", "look()", "print 1", "task look()", "if a then print 0", "endp")
    assert said(ran([pulse("a", initial=1.0)], *lines)) == [("0", 0.0), ("0", 0.0), ("1", 0.0)]


@pytest.mark.parametrize("lines", [1, 2, 6])
def test_a_pass_of_a_loop_takes_one_tick_however_many_lines_look(lines: int) -> None:
    looks = [f"if {name} then print 0" for name in NAMES[:lines]]
    recording = ran([pulse(name) for name in NAMES], "repeat 20", *looks, "endr", "print 1")
    assert said(recording) == [("1", round(19 * TICK, 9))]
    assert parts(recording).signals == pytest.approx(19 * TICK)
    assert {one.looked for one in recording.events_of(WaitEvent)} == {tuple(NAMES[:lines])}


@pytest.mark.parametrize("between", [(), ("set lamp on",), ("set lamp on", "set lamp off")])
def test_a_loop_that_looks_sees_a_change_within_a_tick(between: tuple[str, ...]) -> None:
    signals = [pulse("a", (2.0, 1.0)), Signal("lamp", is_input=False)]
    recording = ran(signals, "repeat", "if a then break", *between, "endr", "print 1")
    ((_, time),) = said(recording)
    assert 2.0 <= time <= 2.0 + TICK
    whole = parts(recording)
    assert whole.signals == pytest.approx(time)
    assert whole.other == 0.0


def test_a_loop_of_waits_for_what_is_there_takes_a_tick_in_each_pass() -> None:
    recording = ran([pulse("a", initial=1.0)], "repeat 10", "wait until a", "endr", "print 1")
    assert said(recording) == [("1", round(9 * TICK, 9))]


def test_all_time_of_a_wait_for_two_inputs_with_a_timeout_is_told_as_waiting_for_signals() -> None:
    recording = ran([pulse("a"), pulse("b")], "wait until a and b timeout 20 s else print 1")
    assert said(recording) == [("1", 20.0)]
    whole = parts(recording)
    assert whole.other == 0.0
    assert whole.signals >= 20.0 - TICK  # it has not looked again before its first pause
    assert whole.waits == pytest.approx(20.0)


@pytest.mark.parametrize(
    "loop",
    [
        ("repeat", "if a or b then break", "endr"),
        ("repeat", "wait until not a", "endr"),
        ("repeat", "if a then break", "wait 0 s", "endr"),
        ("repeat", "wait 0 s", "endr"),
        ("repeat 3", "if a then break", "endr", "repeat", "if b then break", "wait 0.1 s", "endr"),
    ],
)
def test_a_loop_that_does_nothing_but_look_is_found_to_wait_in_vain(loop: tuple[str, ...]) -> None:
    recording = ran([pulse("a"), pulse("b")], *loop)
    assert [one.code for one in recording.findings] == ["S742"]
    assert recording.duration < 1.0


def test_a_move_between_two_looks_leaves_nothing_to_stand_for() -> None:
    recording = ran([pulse("a", initial=1.0)], "wait until a", "mov joints(20, 60, -150, 0, -60, 0)")
    (move,) = recording.events_of(MoveEvent)
    assert recording.duration == move.end


def looking(recording: Recording) -> list[WaitEvent]:
    """Return the waits in which the program looks; it is known to do so from its second look on."""
    return [one for one in recording.events_of(WaitEvent) if one.looked]


def test_a_wait_by_looking_is_one_event_however_long_it_lasts() -> None:
    recording = ran([pulse("a", (1.0, 1.0)), pulse("b", (2.0, 1.0))], "wait until a and b", "print 1")
    (wait,) = looking(recording)
    ((_, time),) = said(recording)
    assert wait.looked == ("a", "b")
    assert wait.time <= TICK
    assert wait.time + wait.duration == pytest.approx(time)
    assert wait.pause == pytest.approx(wait.duration)


def test_waits_by_looking_on_two_lines_are_two_events() -> None:
    signals = [pulse("a", (1.0, 1.0)), pulse("b", (2.0, 1.0)), pulse("c", (3.0, 1.0))]
    waits = looking(ran(signals, "wait until a and b", "wait until b and c", "print 1"))
    assert [one.looked for one in waits] == [("a", "b"), ("b", "c")]
    first, second = (one.span.line for one in waits if one.span)
    assert second == first + 1


def test_what_a_loop_does_between_two_looks_parts_its_waits() -> None:
    signals = [pulse("a", (1.0, 1.0)), Signal("lamp", is_input=False)]
    loop = ("for i = 1 to 3", "if a then print 0", "set lamp on", "endf", "print 1")
    assert len(ran(signals, *loop).events_of(WaitEvent)) == 2


def test_a_line_that_waits_for_other_inputs_in_each_pass_tells_which() -> None:
    signals = [pulse("a"), pulse("b"), pulse("c", (0.1, 1.0))]
    loop = (
        "n = 0",
        "while not c",
        "if n = 0 then",
        "if a then print 0",
        "else",
        "if b then print 0",
        "endif",
    )
    waits = looking(ran(signals, *loop, "n = 1 - n", "endw", "print 1"))
    assert {one.looked for one in waits} == {("a", "c"), ("b", "c")}
    assert len({one.span.line for one in waits if one.span}) == 1


def test_a_wait_by_looking_that_the_end_of_the_run_cuts_short_is_told() -> None:
    recording = ran([pulse("a"), pulse("b")], "repeat", "if a or b then break", "endr")
    waits = recording.events_of(WaitEvent)
    assert len(waits) <= 2
    assert waits[-1].time + waits[-1].duration == pytest.approx(recording.duration, abs=2.0 * TICK)
