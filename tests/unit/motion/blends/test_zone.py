"""Zones: the place whose distance from the end, or from the start, is the zone."""

import math

import numpy as np
import pytest

from ropsim.motion import Line, enter, leave
from ropsim.spatial import Array, Pose
from support.paths import random_pose

LINE = Line(random_pose(np.random.default_rng(10)), random_pose(np.random.default_rng(11)))


def circle(s: Array) -> Array:
    """Return positions on a circle of radius 1 [m] at way s."""
    return np.stack((np.cos(s), np.sin(s), 0.0 * s), axis=1)


@pytest.mark.parametrize("zone", [1e-9, 1e-6, 1e-3, 0.1, 0.4])
def test_zones_of_lines_are_cut_off_the_way(zone: float) -> None:
    middle = LINE.length / 2.0
    assert leave(LINE.positions, LINE.length, zone, middle) == pytest.approx(LINE.length - zone, rel=1e-14)
    assert enter(LINE.positions, LINE.length, zone, middle) == pytest.approx(zone, rel=1e-6, abs=1e-15)


@pytest.mark.parametrize("zone", [1e-5, 0.01, 0.5, 1.0])
def test_zones_of_arcs_are_chords(zone: float) -> None:
    angle = 2.0 * math.asin(zone / 2.0)
    for length in (2.0, math.pi, 2.0 * math.pi):
        place = leave(circle, length, zone, length / 2.0)
        assert place == pytest.approx(max(length - angle, length / 2.0), abs=1e-10 * zone + 1e-15)
        assert enter(circle, length, zone, length / 2.0) == pytest.approx(
            min(angle, length / 2.0), abs=1e-10 * zone + 1e-15
        )


def test_the_crossing_next_to_the_end_counts() -> None:
    # out and back again: a circle passes the zone around its end at its start, too
    assert leave(circle, 2.0 * math.pi, 0.5, 0.0) == pytest.approx(
        2.0 * math.pi - 2.0 * math.asin(0.25), abs=1e-9
    )
    assert enter(circle, 2.0 * math.pi, 0.5, 2.0 * math.pi) == pytest.approx(2.0 * math.asin(0.25), abs=1e-9)


def test_a_zone_that_is_too_large_is_clipped() -> None:
    assert leave(LINE.positions, LINE.length, 100.0, 0.3) == pytest.approx(0.3, abs=1e-15)
    assert enter(LINE.positions, LINE.length, 100.0, 0.3) == 0.3


def test_without_a_zone_the_path_is_left_at_its_end() -> None:
    assert leave(LINE.positions, LINE.length, 0.0, 0.3) == LINE.length
    assert enter(LINE.positions, LINE.length, 0.0, 0.3) == 0.0


def test_where_the_tcp_stands_everything_is_within_the_zone() -> None:
    line = Line(Pose(), Pose(np.zeros(3), np.array([1.0, 1.0, 0.0, 0.0])))
    assert leave(line.positions, line.length, 0.01, 0.5) == pytest.approx(0.5, abs=1e-15)
    assert enter(line.positions, line.length, 0.01, 0.5) == 0.5


def test_ways_in_their_own_unit_are_searched_in_it() -> None:
    def curved(u: Array) -> Array:
        return np.stack((np.square(u), u**3, 0.0 * u), axis=1)

    place = leave(curved, 1.0, 0.2, 0.5)
    assert np.linalg.norm(curved(np.array([place])) - curved(np.ones(1))) == pytest.approx(0.2, rel=1e-10)
    place = enter(curved, 1.0, 0.05, 0.5)  # at u = 0 this way begins without speed
    assert np.linalg.norm(curved(np.array([place]))) == pytest.approx(0.05, rel=1e-9)


def test_a_zone_that_reaches_less_far_is_found_with_fewer_looks() -> None:
    """Beyond twenty places of the grid, and nine between two of them, only those on the way count."""

    def looks(zone: float) -> int:
        seen = list[int]()

        def positions(s: Array) -> Array:
            seen.append(len(s))
            return circle(s)

        enter(positions, 1.0, zone, 1.0)
        return sum(seen)

    near, middle, far = looks(0.01), looks(0.4), looks(0.9)
    assert near <= 20 + 9 + 2
    assert middle == near + 8
    assert far == near + 3 * 8
