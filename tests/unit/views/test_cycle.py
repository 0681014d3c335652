"""Of what cycle times consist: parts by task and line sum to the cycle time, to the tick."""

import math
from dataclasses import astuple, replace

import pytest

from ropsim.flow import (
    AwaitEvent,
    CriticalLimit,
    Event,
    GripEvent,
    LimitQuantity,
    MotionKind,
    MoveEvent,
    Origin,
    OutputEvent,
    Recording,
    WaitEvent,
)
from ropsim.views import CycleParts, CycleTime, Style, summarize, summarize_cycle, terminal_report
from support.recordings import SOURCE, empty_recording, facts, pick_and_place, station

HZ = 1000.0


def ticks(parts: CycleParts) -> list[int]:
    return [round(part * HZ) for part in astuple(parts)]


def made(*events: Event, stations: tuple[str, ...] = ("robot",)) -> Recording:
    known = tuple(replace(station(), name=name, control_hz=HZ) for name in stations)
    return replace(empty_recording(), events=events, facts=facts(stations=known))


def cycle(*events: Event, stations: tuple[str, ...] = ("robot",)) -> CycleTime:
    recording = made(*events, stations=stations)
    return summarize_cycle(recording, recording.facts.stations[0])


def origin(line: int, *calls: str) -> Origin:
    return Origin(SOURCE.span(line), 1, ("main", *calls), tuple(range(len(calls) + 1)))


def move(time: float, line: int, travel: float, settle: float = 0.0, blending: float = 0.0) -> MoveEvent:
    return MoveEvent(
        time,
        travel + settle,
        "robot",
        origin(line, "pick"),
        motion=MotionKind.PTP,
        ordinal=0,
        travel=travel,
        settle=settle,
        blending=blending,
    )


def test_a_move_is_motion_zones_and_settling() -> None:
    assert ticks(cycle(move(0.0, 9, 0.7, 0.1, 0.2)).whole) == [800, 500, 200, 100, 0, 0, 0, 0, 0]


def test_a_move_cannot_spend_more_time_in_zones_than_it_takes() -> None:
    assert ticks(cycle(move(0.0, 9, 0.2, 0.1, 0.5)).whole) == [300, 0, 200, 100, 0, 0, 0, 0, 0]


@pytest.mark.parametrize("flown", [(0.01, 0.05), (0.05, 0.01), (0.0, 0.05)])
def test_the_zone_of_a_line_is_the_largest_that_was_flown(flown: tuple[float, float]) -> None:
    moves = [replace(move(float(k), 9, 1.0), flown=zone) for k, zone in enumerate(flown)]
    assert cycle(*moves).lines[0].zone == 0.05


def test_waits_are_for_a_time_for_signals_or_for_partners() -> None:
    events = (
        WaitEvent(0.0, 0.1, "robot", origin(2), pause=0.1),
        WaitEvent(0.1, 0.2, "robot", origin(3), pause=0.2, looked=("button",)),
        AwaitEvent(0.3, 0.4, "robot", origin(4), channel="ready", value=True, came=True),
        OutputEvent(0.5, 0.0, "other", origin(1), channel="ready", value=True),
    )
    whole = cycle(*events, stations=("robot", "other")).whole
    assert (whole.timers, whole.signals, whole.partners) == (0.1, 0.2, 0.4)
    assert whole.waits == pytest.approx(0.7)


def test_a_signal_that_the_program_sets_itself_is_no_partner() -> None:
    events = (
        OutputEvent(0.0, 0.0, "robot", origin(1), channel="ready", value=True),
        AwaitEvent(0.0, 0.4, "robot", origin(4), channel="ready", value=True, came=True),
    )
    assert cycle(*events).whole.signals == 0.4


def test_time_between_events_is_other_and_of_no_line() -> None:
    found = cycle(move(0.5, 9, 0.5))
    assert ticks(found.whole) == [1000, 500, 0, 0, 0, 0, 0, 0, 500]
    assert [line.line for line in found.lines] == [0, 9]


def test_a_task_is_counted_without_those_that_it_calls() -> None:
    grip = GripEvent(1.0, 0.2, "robot", origin(11, "pick", "squeeze"), part="")
    found = {task.name: task.parts.total for task in cycle(move(0.0, 9, 1.0), grip).tasks}
    assert found == {"pick": 1.0, "squeeze": 0.2}


def test_the_limit_of_a_line_is_that_of_most_of_its_time() -> None:
    slow = CriticalLimit("1", LimitQuantity.SPEED, 0.5)
    quick = CriticalLimit("2", LimitQuantity.JERK, 1.0)
    moves = (
        replace(move(0.0, 9, 0.4), critical=quick),
        replace(move(0.4, 9, 0.9), critical=slow),
        replace(move(1.3, 9, 0.7), critical=None),
    )
    critical = cycle(*moves).lines[0].critical
    assert critical is not None
    assert (critical.joint, critical.quantity) == ("1", LimitQuantity.SPEED)
    assert critical.share == pytest.approx(0.45 / 2.0)


@pytest.mark.parametrize("passes", [1, 3])
def test_parts_of_tasks_and_of_lines_sum_to_the_cycle_time(passes: int) -> None:
    summary = summarize(pick_and_place(passes))
    (one,) = summary.stations
    assert ticks(one.cycle.whole)[0] == round(summary.cycle_time * HZ)
    for parts in ([task.parts for task in one.cycle.tasks], [line.parts for line in one.cycle.lines]):
        assert [sum(column) for column in zip(*map(ticks, parts), strict=True)] == ticks(one.cycle.whole)
    for part in (one.cycle.whole, *(line.parts for line in one.cycle.lines)):
        assert sum(ticks(part)[1:]) == ticks(part)[0]


def test_times_that_are_no_numbers_spoil_nothing_else() -> None:
    found = cycle(move(math.nan, 9, 1.0), move(0.0, 10, math.inf, 0.25), move(0.0, 11, 0.5))
    assert ticks(found.whole)[0] == 500


def test_no_events_take_no_time_and_are_not_shown() -> None:
    assert cycle().whole == CycleParts()
    assert "slowest lines" not in terminal_report(summarize(empty_recording()), Style.PLAIN)
