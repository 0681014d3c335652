"""Figures of ISO 9283 on motions that are known exactly."""

import math

import numpy as np
import pytest

from ropsim.spatial import Array
from ropsim.views.testing import (
    BAND,
    at,
    cornering,
    largest_angle,
    nearest,
    path_repeatability,
    speed_figures,
    stopping,
)

CHORD = 1e-6
"""Circles are recorded as polygons: of radius 0.1 m and 2000 corners they lie within 1.3e-7 m [m]."""
ROUNDING = 1e-12
"""What sums of a few thousand numbers of order 1 lose."""
TURN = np.linspace(0.0, 2.0 * math.pi, 2001)
CIRCLE = 0.1 * np.column_stack([np.cos(TURN), np.sin(TURN), np.zeros_like(TURN)])


def about_z(angles: Array) -> Array:
    """Return unit quaternions of turns about z, shape (k, 4)."""
    return np.column_stack([np.cos(angles / 2), 0 * angles, 0 * angles, np.sin(angles / 2)])


def test_a_circle_with_a_wrong_radius_is_off_by_the_difference() -> None:
    _, away = nearest(CIRCLE, 1.02 * CIRCLE)
    assert away == pytest.approx(0.002, abs=CHORD)


@pytest.mark.parametrize("delay", [0, 1, 13])
def test_a_turned_tool_is_an_error_of_orientation_and_a_late_one_is_not(delay: int) -> None:
    """The command turns as it goes round; the arm is behind by some rows and turned by 1° more."""
    time, late = TURN, np.maximum(np.arange(len(TURN)) - delay, 0)
    command, attained = (CIRCLE, about_z(TURN)), (CIRCLE[late], about_z(TURN[late] + math.radians(1.0)))
    assert largest_angle(time, command, attained) == pytest.approx(math.radians(1.0), abs=1e-9)


def test_an_arm_may_be_most_of_a_fifth_of_a_second_behind_its_command() -> None:
    hz, turned = 500, about_z(TURN)  # 2 rows are 4 ms: once round takes 4 s
    late = np.maximum(np.arange(len(TURN)) - round(0.19 * hz), 0)
    assert largest_angle(np.arange(len(TURN)) / hz, (CIRCLE, turned), (CIRCLE[late], turned[late])) < ROUNDING


def test_a_quaternion_and_its_negative_are_one_command() -> None:
    flips = np.where(np.arange(len(TURN)) % 2, -1.0, 1.0)[:, None]
    late = np.interp(np.arange(len(TURN)) - 0.5, np.arange(len(TURN)), TURN)  # between two rows
    places = 0.1 * np.column_stack([np.cos(late), np.sin(late), 0.0 * late])
    attained = places, about_z(late + math.radians(1.0))
    plain = largest_angle(TURN, (CIRCLE, about_z(TURN)), attained)
    assert plain == pytest.approx(math.radians(1.0), abs=1e-6)  # a chord of a row is that far from its arc
    assert largest_angle(TURN, (CIRCLE, flips * about_z(TURN)), attained) == pytest.approx(plain, abs=1e-9)


def test_a_tool_that_only_turns_has_no_place_to_be_compared_at() -> None:
    still = np.zeros((10, 3))
    turned = about_z(np.linspace(0.0, 1.0, 10))
    assert math.isnan(largest_angle(np.arange(10.0), (still, turned), (still, turned)))


def beside(offset: float, count: int = 101, to: float = 0.3) -> tuple[Array, Array]:
    """Return a pass along x, attained some way beside it."""
    way = np.linspace(0.0, to, count)[:, None] * np.array([1.0, 0.0, 0.0])
    return way, way + np.array([0.0, offset, 0.0])


@pytest.mark.parametrize("offsets", [(1e-4, -1e-4), (0.0, 3e-4), (1e-4, 2e-4, -5e-4, 0.0)])
def test_repeatability_is_mean_and_three_deviations_about_the_barycentre(offsets: tuple[float, ...]) -> None:
    away = np.abs(np.array(offsets) - np.mean(offsets))
    wanted = away.mean() + 3.0 * away.std(ddof=1)
    passes = [beside(one, count) for one, count in zip(offsets, (101, 57, 300, 80), strict=False)]
    assert path_repeatability(passes) == pytest.approx(wanted, abs=ROUNDING)


def test_passes_of_one_path_at_different_speeds_and_delays_repeat_it() -> None:
    late = np.maximum(np.arange(len(TURN)) - 40, 0)
    assert path_repeatability([(CIRCLE, CIRCLE), (CIRCLE[::2], CIRCLE[late][::2])]) < CHORD


def test_legs_side_by_side_are_each_repeated_on_their_own() -> None:
    """There and back and there again: planes across the third leg cut the first one in the same direction."""
    corners = np.array(
        [[0.0, 0.0, 0.0], [0.3, 0.0, 0.0], [0.3, 0.05, 0.0], [0.0, 0.05, 0.0], [0.0, 0.1, 0.0]]
    )
    way = at(np.vstack([corners, [[0.3, 0.1, 0.0]]]), np.linspace(0.0, 5.0, 1001))
    rows = np.arange(1001)
    third = np.outer((rows > 820) & (rows < 980), [0.0, 0.0, 1e-4])
    assert path_repeatability([(way, way + third), (way, way - third)]) == pytest.approx(1e-4, abs=ROUNDING)


def test_one_pass_and_passes_of_different_paths_have_no_repeatability() -> None:
    assert math.isnan(path_repeatability([beside(0.0)]))
    assert math.isnan(path_repeatability([beside(0.0), beside(0.0, to=0.31)]))


def test_velocity_accuracy_and_fluctuation_are_taken_where_the_command_is_constant() -> None:
    ramp = np.minimum(np.linspace(0.0, 2.0, 400), np.linspace(2.0, 0.0, 400))
    command = 0.2 * np.minimum(ramp, 1.0) / 1.0
    command[100:300] = 0.2
    attained = command - 0.01 + 0.003 * np.where(np.arange(400) % 2, 1.0, -1.0)
    figures = speed_figures(command, attained)
    assert figures.command == pytest.approx(0.2)
    assert figures.accuracy == pytest.approx(-0.05, abs=1e-3)
    assert figures.fluctuation == pytest.approx(0.006, abs=ROUNDING)


RADIUS = 0.05
QUARTER = np.linspace(0.0, math.pi / 2, 401)
ROUND = np.concatenate(
    [
        np.linspace([-0.2, 0.0, 0.0], [-RADIUS, 0.0, 0.0], 200, endpoint=False),
        RADIUS * np.column_stack([np.sin(QUARTER) - 1.0, 1.0 - np.cos(QUARTER), 0.0 * QUARTER]),
        np.linspace([0.0, RADIUS, 0.0], [0.0, 0.3, 0.0], 300)[1:],
    ]
)
"""Along x, a quarter of a circle, along y; the corner is the origin."""
MIDDLE = 400


def test_a_corner_is_as_round_as_its_circle() -> None:
    _, planned, rounding, overshoot = cornering(np.zeros(3), RADIUS, MIDDLE, ROUND, ROUND)
    assert planned == rounding == pytest.approx(RADIUS * (math.sqrt(2.0) - 1.0), abs=CHORD)
    assert overshoot == 0.0


@pytest.mark.parametrize(("side", "found"), [(1.0, 1.0), (-1.0, 0.0)])
def test_a_corner_is_overshot_on_its_outer_side_only(side: float, found: float) -> None:
    attained, height = ROUND.copy(), 8e-4
    bump = np.sin(np.linspace(0.0, math.pi, 101)) ** 2
    attained[650:751, 0] += side * height * bump
    overshoot = cornering(np.zeros(3), RADIUS, MIDDLE, ROUND, attained)[3]
    assert overshoot == pytest.approx(found * height, abs=1e-9)


def test_a_straight_pass_has_no_outer_side() -> None:
    way = np.linspace([-0.2, 0.0, 0.0], [0.2, 0.0, 0.0], 401)
    assert math.isnan(cornering(np.zeros(3), RADIUS, 200, way, way)[3])


def swing(amplitude: float) -> tuple[Array, Array, Array]:
    """Return a step of the command at 1 s, and an arm that swings about its end and comes to rest."""
    time = np.arange(0.0, 3.0, 1e-3)
    since = np.maximum(time - 1.0, 0.0)
    place = np.where(time < 1.0, time - 1.0, amplitude * np.sin(20.0 * since) * np.exp(-3.0 * since))
    place[time > 2.9] = 0.0
    command = np.minimum(time - 1.0, 0.0)
    wanted, attained = (np.column_stack([one, 0.0 * one, 0.0 * one]) for one in (command, place))
    return time, wanted, attained


def test_overshoot_and_stabilization_are_those_of_a_damped_swing() -> None:
    amplitude = 2e-3
    time, command, attained = swing(amplitude)
    came, stabilization, overshoot = stopping(time, command, attained)
    peak = math.atan(20.0 / 3.0) / 20.0  # where the derivative of sin(20 t)·exp(−3 t) is 0
    assert overshoot == pytest.approx(amplitude * math.sin(20.0 * peak) * math.exp(-3.0 * peak), rel=1e-3)
    assert came == pytest.approx(1.0, abs=2e-3)
    last = time[np.flatnonzero(np.abs(attained[:, 0]) > BAND)[-1]]
    assert stabilization == pytest.approx(last - came, abs=2e-3)


def test_an_arm_that_stays_within_the_limit_band_does_not_overshoot() -> None:
    assert stopping(*swing(0.9 * BAND))[1:] == (0.0, 0.0)
