"""Courses of devices: they end where they are told, within their limits, without a jump."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.simulation.testing import AxisProfile, ProfileSegment, to_rest, to_speed
from support.examples import examples

NUMBERS = st.floats(-5.0, 5.0)
LIMITS = st.floats(0.05, 5.0)
ROUNDING = 1e-9


def assert_smooth(segments: list[ProfileSegment], most: float) -> None:
    """Coordinate and speed go on from piece to piece; no acceleration is above the limit."""
    for before, after in itertools.pairwise(segments):
        assert after.time >= before.time
        q, qd = before.at(after.time)
        assert (after.q, after.qd) == pytest.approx((q, qd), abs=1e-7)
    assert max(abs(segment.qdd) for segment in segments) <= most * (1.0 + ROUNDING)


@settings(max_examples=examples(300), derandomize=True)
@given(NUMBERS, NUMBERS, NUMBERS, LIMITS, LIMITS)
def test_a_course_to_rest_ends_at_its_target_from_any_state(
    q: float, qd: float, target: float, speed: float, acceleration: float
) -> None:
    segments = to_rest(1.5, q, qd, target, speed, acceleration)
    assert segments[0].time == 1.5
    assert segments[0].at(1.5) == pytest.approx((q, qd), abs=ROUNDING)
    assert (segments[-1].q, segments[-1].qd, segments[-1].qdd) == (target, 0.0, 0.0)
    assert_smooth(segments, acceleration)
    times = np.linspace(1.5, segments[-1].time, 50)
    profile = AxisProfile(list(segments))
    fastest = max(abs(profile.at(float(time))[1]) for time in times)
    assert fastest <= max(speed, abs(qd)) + 1e-7


@pytest.mark.parametrize(
    ("way", "least"), [(2.0, 2.0 / 0.5 + 0.5 / 1.25), (0.1, 2.0 * math.sqrt(0.1 / 1.25))]
)
def test_from_rest_to_rest_takes_the_least_time_of_a_trapezoid(way: float, least: float) -> None:
    for sign in (1.0, -1.0):
        segments = to_rest(0.0, 0.3, 0.0, 0.3 + sign * way, 0.5, 1.25)
        assert segments[-1].time == pytest.approx(least, rel=1e-12)


@settings(max_examples=examples(100), derandomize=True)
@given(NUMBERS, NUMBERS, NUMBERS, LIMITS)
def test_a_course_to_a_speed_keeps_it(q: float, qd: float, speed: float, acceleration: float) -> None:
    segments = to_speed(0.0, q, qd, speed, acceleration)
    assert_smooth(segments, acceleration)
    assert (segments[-1].qd, segments[-1].qdd) == (speed, 0.0)


def test_rows_are_what_single_looks_see_and_a_new_course_forgets_the_old_end() -> None:
    profile = AxisProfile()
    profile.go(to_rest(0.5, 0.0, 0.0, 1.0, 0.5, 2.0))
    profile.go(to_rest(1.0, *profile.at(1.0), 0.0, 0.5, 2.0))
    times = np.linspace(0.0, 3.0, 61)
    singles = [profile.at(float(time))[0] for time in times]
    np.testing.assert_array_equal(profile.rows(times), singles)
    assert singles[0] == 0.0
    assert singles[-1] == 0.0
    assert 0.1 < max(singles) < 0.5
    assert_smooth(profile.segments, 2.0)


def test_the_time_of_a_coordinate_is_found_in_any_piece() -> None:
    profile = AxisProfile()
    profile.go(to_speed(0.0, 0.0, 0.0, 0.5, 1.0))
    for q in (0.05, 0.125, 2.0):
        assert profile.at(profile.time_of(q, 0.0))[0] == pytest.approx(q, abs=ROUNDING)
    profile.go(to_rest(4.0, *profile.at(4.0), 2.0, 0.5, 1.0))
    assert profile.time_of(3.0, 0.0) == math.inf
