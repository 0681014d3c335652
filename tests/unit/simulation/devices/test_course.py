"""Courses of devices: they end where they are told, within their limits, without a jump."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.simulation.devices.course import Course, Piece, to_rest, to_speed
from support.examples import examples

NUMBERS = st.floats(-5.0, 5.0)
LIMITS = st.floats(0.05, 5.0)
ROUNDING = 1e-9


def assert_smooth(pieces: list[Piece], most: float) -> None:
    """Coordinate and speed go on from piece to piece; no acceleration is above the limit."""
    for before, after in itertools.pairwise(pieces):
        assert after.time >= before.time
        q, qd = before.at(after.time)
        assert (after.q, after.qd) == pytest.approx((q, qd), abs=1e-7)
    assert max(abs(piece.qdd) for piece in pieces) <= most * (1.0 + ROUNDING)


@settings(max_examples=examples(300), derandomize=True)
@given(NUMBERS, NUMBERS, NUMBERS, LIMITS, LIMITS)
def test_a_course_to_rest_ends_at_its_target_from_any_state(
    q: float, qd: float, target: float, speed: float, acceleration: float
) -> None:
    pieces = to_rest(1.5, q, qd, target, speed, acceleration)
    assert pieces[0].time == 1.5
    assert pieces[0].at(1.5) == pytest.approx((q, qd), abs=ROUNDING)
    assert (pieces[-1].q, pieces[-1].qd, pieces[-1].qdd) == (target, 0.0, 0.0)
    assert_smooth(pieces, acceleration)
    times = np.linspace(1.5, pieces[-1].time, 50)
    course = Course(list(pieces))
    fastest = max(abs(course.at(float(time))[1]) for time in times)
    assert fastest <= max(speed, abs(qd)) + 1e-7


@pytest.mark.parametrize(
    ("way", "least"), [(2.0, 2.0 / 0.5 + 0.5 / 1.25), (0.1, 2.0 * math.sqrt(0.1 / 1.25))]
)
def test_from_rest_to_rest_takes_the_least_time_of_a_trapezoid(way: float, least: float) -> None:
    for sign in (1.0, -1.0):
        pieces = to_rest(0.0, 0.3, 0.0, 0.3 + sign * way, 0.5, 1.25)
        assert pieces[-1].time == pytest.approx(least, rel=1e-12)


@settings(max_examples=examples(100), derandomize=True)
@given(NUMBERS, NUMBERS, NUMBERS, LIMITS)
def test_a_course_to_a_speed_keeps_it(q: float, qd: float, speed: float, acceleration: float) -> None:
    pieces = to_speed(0.0, q, qd, speed, acceleration)
    assert_smooth(pieces, acceleration)
    assert (pieces[-1].qd, pieces[-1].qdd) == (speed, 0.0)


def test_rows_are_what_single_looks_see_and_a_new_course_forgets_the_old_end() -> None:
    course = Course()
    course.go(to_rest(0.5, 0.0, 0.0, 1.0, 0.5, 2.0))
    course.go(to_rest(1.0, *course.at(1.0), 0.0, 0.5, 2.0))
    times = np.linspace(0.0, 3.0, 61)
    singles = [course.at(float(time))[0] for time in times]
    np.testing.assert_array_equal(course.rows(times), singles)
    assert singles[0] == 0.0
    assert singles[-1] == 0.0
    assert 0.1 < max(singles) < 0.5
    assert_smooth(course.pieces, 2.0)


def test_the_time_of_a_coordinate_is_found_in_any_piece() -> None:
    course = Course()
    course.go(to_speed(0.0, 0.0, 0.0, 0.5, 1.0))
    for q in (0.05, 0.125, 2.0):
        assert course.at(course.time_of(q, 0.0))[0] == pytest.approx(q, abs=ROUNDING)
    course.go(to_rest(4.0, *course.at(4.0), 2.0, 0.5, 1.0))
    assert course.time_of(3.0, 0.0) == math.inf
