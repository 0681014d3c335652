"""Traces of which joints count from other zeros, by up to 20°."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.calibration.trace.rests import Rests
from ropsim.calibration.trace.shift import shift_of
from ropsim.spatial import Array

ARM = robots.load("scara").axis_joints
"""Two joints that turn, one that slides, one that turns."""
RANDOM = np.random.default_rng(4)
PLACES = RANDOM.uniform(-1.0, 1.0, (7, 4))


def rests(q: Array) -> Rests:
    return Rests(tuple((k, k) for k in range(len(q))), q, np.zeros(4))


@pytest.mark.parametrize("shift", [(0.3, 0.0, 0.0, 0.0), (0.0, -0.05, 0.15, 0.0), (0.03, 0.03, 0.03, 0.03)])
def test_the_shift_is_found_among_stops_that_are_none_of_the_program(shift: tuple[float, ...]) -> None:
    trace = np.vstack((PLACES[[0, 1, 2, 1, 3, 4, 6, 0]], RANDOM.uniform(-1.0, 1.0, (9, 4)))) + shift
    noisy = trace + RANDOM.normal(scale=1e-4, size=trace.shape)
    found = shift_of(rests(noisy), PLACES[[0, 1, 2, 1, 3, 4, 5, 6]], ARM)
    assert found == pytest.approx(shift, abs=3e-4)


@pytest.mark.parametrize("shift", [(0.4, 0.0, 0.0, 0.0), (0.0, 0.0, 0.25, 0.0)])
def test_more_than_twenty_degrees_or_two_hundred_millimetres_are_another_place(
    shift: tuple[float, ...],
) -> None:
    assert shift_of(rests(PLACES + shift), PLACES, ARM) is None


def test_places_of_another_program_have_no_shift() -> None:
    for _ in range(20):
        assert shift_of(rests(RANDOM.uniform(-1.0, 1.0, (30, 4))), PLACES, ARM) is None


def test_three_places_tell_no_shift_and_neither_do_half_of_them() -> None:
    shift = np.array([0.2, 0.0, 0.0, 0.0])
    assert shift_of(rests(PLACES[:3] + shift), PLACES[:3], ARM) is None
    assert shift_of(rests(PLACES[:4] + shift), PLACES, ARM) is None
    assert shift_of(rests(PLACES[:5] + shift), PLACES, ARM) == pytest.approx(shift)


def test_joints_that_are_stretched_have_no_shift() -> None:
    """Another transmission, or degrees that are none, are no zero."""
    assert shift_of(rests(PLACES * 1.05), PLACES, ARM) is None


def test_what_is_looked_at_is_bounded() -> None:
    many = RANDOM.uniform(-1.0, 1.0, (5000, 4))
    assert shift_of(rests(many + 0.1), many, ARM) == pytest.approx([0.1] * 4)  # the first ones tell it
    assert shift_of(rests(many[::-1] + 0.1), many, ARM) is None
    often = np.tile(PLACES, (700, 1))
    assert shift_of(rests(PLACES + 0.1), often, ARM) == pytest.approx([0.1] * 4)
