"""What settling after moves costs a run, from events alone."""

import math

import pytest

from ropsim.core import Span
from ropsim.flow import SLOW, MotionKind, MoveEvent, Origin, WaitEvent, settling_of

HERE = Span("main.task", 7, 1, 7, 9)


def move(time: float, duration: float, settle: float, visit: int = 1) -> MoveEvent:
    origin = Origin(HERE, visit)
    return MoveEvent(time, duration, "robot", origin, motion=MotionKind.LIN, ordinal=0, settle=settle)


def test_a_run_without_moves_settles_never() -> None:
    found = settling_of([WaitEvent(0.0, 1.0, "robot", Origin(HERE), pause=1.0)], 1.0)
    assert (found.total, found.share, found.slow, found.line) == (0.0, 0.0, 0, 0)
    assert math.isnan(found.time)


def test_total_share_and_the_longest_settling_are_told() -> None:
    moves = [move(0.0, 2.0, 0.01), move(2.0, 3.0, 0.5, visit=4), move(5.0, 5.0, 0.49)]
    found = settling_of(moves, 10.0)
    assert (found.total, found.share, found.time) == pytest.approx((1.0, 0.1, 4.5))
    assert (found.slow, found.longest, found.line, found.visit) == (2, 0.5, 7, 4)


def test_a_move_is_slow_beyond_the_bound_only() -> None:
    assert settling_of([move(0.0, 1.0, SLOW)], 1.0).slow == 0
    assert settling_of([move(0.0, 1.0, math.nextafter(SLOW, 1.0))], 1.0).slow == 1


@pytest.mark.parametrize("settle", [math.nan, math.inf, -math.inf])
def test_what_is_no_time_does_not_count(settle: float) -> None:
    found = settling_of([move(0.0, 1.0, settle), move(1.0, 1.0, 0.25)], 2.0)
    assert (found.total, found.longest, found.slow) == (0.25, 0.25, 1)


def test_a_run_of_no_length_has_no_share() -> None:
    assert settling_of([move(0.0, 0.0, 0.0)], 0.0).share == 0.0
