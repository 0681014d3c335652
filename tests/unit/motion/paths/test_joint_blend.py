"""Blends of the joints: both derivatives go over from the path before and to the path after."""

import numpy as np
import pytest

from ropsim.motion import JointLine, Traced, joint_blend
from support.paths import inner_places, joint_differences

ROUNDING = 1e-12
RNG = np.random.default_rng(12)
BEFORE, AFTER = (
    Traced(0.8, RNG.normal(size=(20, 3)).cumsum(0)),
    Traced(3.0, RNG.normal(size=(15, 3)).cumsum(0)),
)


def test_derivatives_are_those_of_the_neighbours_times_their_rates() -> None:
    c_in, c_out = 0.2, 0.7
    blend = joint_blend(BEFORE, 0.7, c_in, AFTER, 0.35, c_out).joints(np.array([0.0, 1.0]))
    for row, path, place, c in ((0, BEFORE, 0.7, c_in), (1, AFTER, 0.35, c_out)):
        points = path.joints(np.array([place]))
        assert blend.q[row] == pytest.approx(points.q[0], abs=ROUNDING)
        assert blend.d1[row] == pytest.approx(points.d1[0] * c, abs=10.0 * ROUNDING)
        assert blend.d2[row] == pytest.approx(points.d2[0] * c * c, abs=1e-10)


def test_derivatives_are_those_of_the_coordinates() -> None:
    blend, u = joint_blend(BEFORE, 0.7, 0.2, AFTER, 0.35, 0.7), inner_places(1.0)
    u = u[np.abs(u - 0.5) > 0.01]  # the jerk changes there
    d1, d2 = joint_differences(blend, u, 1e-3)
    assert np.abs(blend.joints(u).d1 - d1).max() < 1e-8
    assert np.abs(blend.joints(u).d2 - d2).max() < 1e-8


def test_a_blend_on_one_straight_way_is_that_way_at_even_speed() -> None:
    middle, end = np.array([1.0, 2.0]), np.array([3.0, 6.0])
    blend = joint_blend(JointLine(np.zeros(2), middle), 0.8, 0.4, JointLine(middle, end), 0.1, 0.2)
    points = blend.joints(np.linspace(0.0, 1.0, 11))
    assert points.q == pytest.approx(np.linspace([0.8, 1.6], [1.2, 2.4], 11), abs=ROUNDING)
    assert np.abs(points.d2).max() < ROUNDING


def test_the_corner_of_two_joint_lines_is_flown_past_by_less_than_the_way_to_it() -> None:
    # half way in time each side has 1/6 of its way left or behind it
    blend = joint_blend(
        JointLine(np.array([-1.0, 0.0]), np.zeros(2)),
        0.5,
        1.0,
        JointLine(np.zeros(2), np.array([0.0, 1.0])),
        0.5,
        1.0,
    )
    assert blend.joints(np.array([0.5])).q[0] == pytest.approx([-1.0 / 12.0, 1.0 / 12.0], abs=ROUNDING)


def test_between_straight_paths_the_jerk_is_constant_in_either_half() -> None:
    # no motion from speed 1 to 0 in time 1 with continuous acceleration, 0 at both ends, needs less than 4
    blend = joint_blend(
        JointLine(np.array([-1.0, 0.0]), np.zeros(2)),
        0.5,
        1.0,
        JointLine(np.zeros(2), np.array([0.0, 1.0])),
        0.5,
        1.0,
    )
    d2 = blend.joints(np.linspace(0.0, 1.0, 21)).d2
    jerk = np.diff(d2, axis=0) * 20.0
    assert jerk[:10] == pytest.approx(np.tile([-4.0, 4.0], (10, 1)), abs=1e-10)
    assert jerk[10:] == pytest.approx(np.tile([4.0, -4.0], (10, 1)), abs=1e-10)
