"""Stops of a trace are found, and are those of the program in order."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.calibration import Trace
from ropsim.calibration.trace.matching import Passage, match
from ropsim.calibration.trace.rests import Rests, rests_of
from ropsim.spatial import Array

ARM = robots.load("two_link").axis_joints


def rests(*places: float) -> Rests:
    q = np.array([[place, -place] for place in places])
    return Rests(tuple((k, k) for k in range(len(places))), q, np.zeros(2))


def ends(*places: float) -> Array:
    return np.array([[place, -place] for place in places])


def sequences(passages: tuple[Passage, ...]) -> list[tuple[int, int, int]]:
    return [(one.sequence, one.start, one.end) for one in passages]


def test_stops_of_the_program_are_found_in_order() -> None:
    found = match(rests(0.0, 1.0, 0.5), ends(0.0, 1.0, 0.5), ARM)
    assert sequences(found) == [(0, 0, 1), (1, 1, 2)]


def test_pauses_at_a_stop_belong_to_no_motion() -> None:
    found = match(rests(0.0, 0.001, 1.0, 1.001, 0.5), ends(0.0, 1.0, 0.5), ARM)
    assert sequences(found) == [(0, 1, 2), (1, 3, 4)]


def test_stops_before_and_behind_the_program_are_passed_over() -> None:
    found = match(rests(0.7, 0.2, 0.0, 1.0, 0.5, 0.9), ends(0.0, 1.0, 0.5), ARM)
    assert sequences(found) == [(0, 2, 3), (1, 3, 4)]


def test_a_stop_on_the_way_lies_within_its_motion() -> None:
    found = match(rests(0.0, 0.3, 1.0, 0.5), ends(0.0, 1.0, 0.5), ARM)
    assert sequences(found) == [(0, 0, 2), (1, 2, 3)]


def test_of_two_visits_of_a_place_the_one_next_to_the_others_is_taken_though_it_fits_a_little_less() -> None:
    found = match(rests(0.0, 0.7, 0.2, 0.002, 1.0, 0.5), ends(0.0, 1.0, 0.5), ARM)
    assert sequences(found) == [(0, 3, 4), (1, 4, 5)]


def test_motions_to_a_stop_that_is_not_there_are_left_out() -> None:
    found = match(rests(0.0, 0.5, 0.2, 0.8), ends(0.0, 1.0, 0.5, 0.2, 0.8), ARM)
    assert [one[0] for one in sequences(found)] == [2, 3]


def test_one_cycle_of_several_is_taken_whole() -> None:
    places = (0.0, 1.0, 0.5)
    found = match(rests(*places, *places, *places), ends(*places), ARM)
    assert len(found) == 2
    assert found[0].end == found[1].start == found[0].start + 1


def test_none_of_many_stops_is_lost_by_rounding() -> None:
    places = np.random.default_rng(3).uniform(-2.0, 2.0, 300)
    nearly = places + np.random.default_rng(4).uniform(-0.01, 0.01, 300)
    assert len(match(rests(*nearly), ends(*places), ARM)) == 299


@pytest.mark.parametrize("noise", [0.0, 2e-5])
@pytest.mark.parametrize("stand", [0.0, 0.02, 1.0])
def test_stops_are_found_whether_long_or_of_a_moment(stand: float, noise: float) -> None:
    """Three smooth motions s = 10x³ - 15x⁴ + 6x⁵ with a slow one between quick ones."""
    x = np.linspace(0.0, 1.0, 101)
    way = 10 * x**3 - 15 * x**4 + 6 * x**5
    standing = np.ones(max(1, int(stand / 0.008)))
    q = np.concatenate(
        (0 * standing, way, standing, 1 + 0.05 * way, 1.05 * standing, 1.05 - way, 0.05 * standing)
    )
    rows = np.array([q, 0.5 * q]).T + np.random.default_rng(5).normal(0.0, 1.0, (len(q), 2)) * noise
    times: Array = np.arange(float(len(q))) * 0.008
    found = rests_of(Trace(times, rows))
    taken = match(found, np.array([[0.0, 0.0], [1.0, 0.5], [1.05, 0.525], [0.05, 0.025]]), ARM)
    assert [one.sequence for one in taken] == [0, 1, 2]
