"""How long programs stand at waits, from events alone."""

import math

import pytest

from ropsim.core import Span
from ropsim.flow import AwaitEvent, Event, MotionKind, MoveEvent, Origin, WaitEvent, waiting_of


def origin(line: int, visit: int = 1) -> Origin:
    return Origin(Span("main.task", line, 1, line, 9), visit)


def await_(time: float, duration: float, line: int = 7, station: str = "left", visit: int = 1) -> AwaitEvent:
    return AwaitEvent(time, duration, station, origin(line, visit), channel="ready", value=True, came=True)


def looked(time: float, line: int, visit: int, station: str = "left") -> WaitEvent:
    return WaitEvent(time, 0.25, station, origin(line, visit), pause=0.25)


def test_a_run_without_waits_never_waits() -> None:
    move = MoveEvent(0.0, 1.0, "left", origin(3), motion=MotionKind.PTP, ordinal=0)
    found = waiting_of([move], 1.0)
    assert (found.total, found.share, found.longest, found.line) == (0.0, 0.0, 0.0, 0)
    assert math.isnan(found.time)


def test_total_share_and_the_longest_wait_are_told() -> None:
    waits: list[Event] = [await_(0.0, 1.0), looked(2.0, 5, 1), await_(4.0, 2.75, line=9, visit=3)]
    found = waiting_of(waits, 16.0)
    assert (found.total, found.share) == (4.0, 0.25)
    assert (found.longest, found.time, found.line, found.visit) == (2.75, 4.0, 9, 3)


def test_a_condition_that_is_looked_at_again_and_again_is_one_wait() -> None:
    """Another station waits meanwhile, and the same line once more, later."""
    waits: list[Event] = [
        looked(1.0, 5, 1),
        await_(1.1, 0.5, station="right"),
        looked(1.25, 5, 2),
        looked(1.5, 5, 3),
        looked(3.0, 5, 4),
    ]
    found = waiting_of(waits, 10.0)
    assert found.total == pytest.approx(1.5)
    assert (found.longest, found.time, found.visit, found.station) == (0.75, 1.0, 1, "left")


def test_a_run_of_no_length_has_no_share() -> None:
    assert waiting_of([await_(0.0, 0.0)], 0.0).share == 0.0


@pytest.mark.parametrize("gap", [0.004, 0.25, 0.75])
def test_a_wait_on_the_same_line_after_something_else_is_one_of_its_own(gap: float) -> None:
    waits: list[Event] = [looked(1.0, 5, 1), looked(1.25 + gap, 5, 2)]
    found = waiting_of(waits, 10.0)
    assert (found.total, found.longest, found.time) == (0.5, 0.25, 1.0)
