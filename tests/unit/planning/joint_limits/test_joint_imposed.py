"""How slow a path must be walked where joints cannot follow: by speed, bend, acceleration, jerk or torque."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim.motion import JointBounds, Quantity
from ropsim.planning.testing import (
    ACCELERATION,
    JERK,
    SPEED,
    ArmBounds,
    EvaluatedPath,
    JointImposedLimits,
    imposed_limits,
)
from ropsim.spatial import Array

TICK = 1e-3
ENDLESS = 1e9
NUMBERS = list(Quantity)


def bounds(
    speed: float = ENDLESS, acceleration: float = ENDLESS, jerk: float = ENDLESS, effort: float | None = None
) -> ArmBounds:
    torque = None if effort is None else np.array([effort])
    joints = JointBounds(np.array([speed]), np.array([acceleration]), np.array([jerk]), torque)
    return ArmBounds(joints, None if effort is None else lambda _q, _qd, qdd: 3.0 * qdd + 2.0)


def walked(
    v: tuple[float, float],
    a: tuple[float, float],
    d1: tuple[float, float] = (1.0, 1.0),
    d2: tuple[float, float] = (0.0, 0.0),
    others: float = 0.0,
    jerks: tuple[float, float] = (0.0, 0.0),
) -> EvaluatedPath:
    """Return a path of one joint at one tick and at the one before it, beside the motion of `others`."""

    def pair(values: tuple[float, float]) -> Array:
        return np.array(values)[:, None]

    first, second = pair(d1)[:, :, None], pair(d2)[:, :, None]
    speeds, accelerations = pair(v)[:, :, None], pair(a)[:, :, None]
    qdd = second * speeds**2 + first * accelerations + others
    qd = (first * speeds)[1]
    return EvaluatedPath(
        pair((0.3, 0.31)),
        pair(v),
        pair(a),
        pair(jerks),
        first,
        second,
        np.zeros((1, 1)),
        qd,
        qdd,
        3.0 * qdd[1] + 2.0,
    )


def only(caps: JointImposedLimits) -> tuple[int, object, Quantity]:
    assert caps.count == 1
    assert caps.parameters.tolist() == [[0.3], [0.31]]
    kind, value, tick, joint, quantity = caps.rows[:, 0].tolist()
    assert (tick, joint) == (0.0, 0.0)
    return int(kind), value, NUMBERS[int(quantity)]


def test_a_joint_that_is_too_fast_bounds_the_speed() -> None:
    found = only(imposed_limits(walked((2.0, 2.0), (0.0, 0.0), d1=(3.0, 3.0)), bounds(speed=5.0), TICK, 1.0))
    assert found == (SPEED, pytest.approx(5.0 / 3.0), Quantity.SPEED)


def test_what_is_left_of_an_excess_is_aimed_at_a_share_of_the_limit() -> None:
    found = only(imposed_limits(walked((2.0, 2.0), (0.0, 0.0), d1=(3.0, 3.0)), bounds(speed=5.0), TICK, 0.9))
    assert found[1] == pytest.approx(4.5 / 3.0)


def test_an_acceleration_that_the_bend_asks_for_bounds_the_speed() -> None:
    """q" v² + q' a is 4 v² + 1: with the limit 13, v² may be 3."""
    found = only(
        imposed_limits(walked((2.0, 2.0), (1.0, 1.0), d2=(4.0, 4.0)), bounds(acceleration=13.0), TICK, 1.0)
    )
    assert found == (SPEED, pytest.approx(np.sqrt(3.0)), Quantity.ACCELERATION)


def test_an_acceleration_along_the_path_bounds_that_alone() -> None:
    """With q" v² = -1 and q' = 2, the limit 7 leaves an acceleration of -3 of -4 along the path."""
    way = walked((1.0, 1.0), (-4.0, -4.0), d1=(2.0, 2.0), d2=(-1.0, -1.0))
    found = only(imposed_limits(way, bounds(acceleration=7.0), TICK, 1.0))
    assert found == (ACCELERATION, pytest.approx(3.0), Quantity.ACCELERATION)


def test_no_more_than_a_half_is_given_up_at_once() -> None:
    found = only(imposed_limits(walked((1.0, 1.0), (8.0, 8.0)), bounds(acceleration=1.0), TICK, 1.0))
    assert found[1] == pytest.approx(4.0)


def test_a_change_of_the_bend_in_a_tick_bounds_the_speed_by_its_cube() -> None:
    way = walked((2.0, 2.0), (0.0, 0.0), d2=(0.0, 0.01))  # q" v² changes by 0.04 in a tick
    found = only(imposed_limits(way, bounds(jerk=32.0), TICK, 1.0))
    assert found == (SPEED, pytest.approx(2.0 * np.cbrt(0.8)), Quantity.JERK)


def test_a_change_of_speed_on_a_bend_bounds_the_acceleration() -> None:
    """q" (v² - v₀²) is 5 · 0.0004 · 2 (to second order); a is -1.5 and 2 there."""
    way = walked((1.0, 1.0004), (2.0, 2.0), d2=(5.0, 5.0))
    share = 3.0 / (5.0 * (1.0004**2 - 1.0) / TICK)
    found = only(imposed_limits(way, bounds(jerk=3.0), TICK, 1.0))
    assert found == (ACCELERATION, pytest.approx(2.0 * share, rel=1e-6), Quantity.JERK)


def test_a_change_of_acceleration_along_the_path_bounds_the_jerk() -> None:
    found = only(imposed_limits(walked((1.0, 1.0), (2.0, 2.05), d1=(2.0, 2.0)), bounds(jerk=80.0), TICK, 1.0))
    assert found == (JERK, pytest.approx(40.0), Quantity.JERK)


def test_of_a_torque_only_what_motion_takes_can_be_given_up() -> None:
    """3 q̈ + 2 with q̈ = a = 4 is 14; with the limit 8, a may be 2."""
    found = only(imposed_limits(walked((1.0, 1.0), (4.0, 4.0)), bounds(effort=8.0), TICK, 1.0))
    assert found == (ACCELERATION, pytest.approx(2.0), Quantity.TORQUE)


def test_of_a_torque_in_a_bend_what_holds_the_arm_has_no_part() -> None:
    """3 q̈ + 2 with q̈ = q" v² = 4 is 14: of the 12 that the bend takes 6 are too much with the limit 8."""
    found = only(imposed_limits(walked((2.0, 2.0), (0.0, 0.0), d2=(1.0, 1.0)), bounds(effort=8.0), TICK, 1.0))
    assert found == (SPEED, pytest.approx(2.0 * np.sqrt(0.5), rel=1e-6), Quantity.TORQUE)


def test_what_works_against_an_excess_is_not_brought_down() -> None:
    """q" v² is -16, and q' a takes 1 of that away: with the limit 12, 3 of the 16 are too much."""
    way = walked((2.0, 2.0), (1.0, 1.0), d2=(-4.0, -4.0))
    found = only(imposed_limits(way, bounds(acceleration=12.0), TICK, 1.0))
    assert found == (SPEED, pytest.approx(2.0 * np.sqrt(13.0 / 16.0)), Quantity.ACCELERATION)


def test_a_change_of_the_slope_in_a_tick_bounds_the_acceleration() -> None:
    """Q' goes from 1 to 1.01 while a is 2: 0.02 in a tick, of which 0.01 is allowed."""
    way = walked((1.0, 1.0), (2.0, 2.0), d1=(1.0, 1.01))
    found = only(imposed_limits(way, bounds(jerk=10.0), TICK, 1.0))
    assert found == (ACCELERATION, pytest.approx(1.0), Quantity.JERK)


def test_where_motions_overlap_the_other_one_may_have_to_be_slower() -> None:
    """Nearly all of the acceleration is that of another motion: nothing here could mend it."""
    caps = imposed_limits(walked((1.0, 1.0), (0.01, 0.01), others=9.0), bounds(acceleration=5.0), TICK, 1.0)
    assert caps.count == 0


@pytest.mark.parametrize(("own", "others"), [(4.0, 4.0), (6.0, 2.0), (2.0, 6.0)])
def test_motions_that_overlap_take_an_excess_together(own: float, others: float) -> None:
    """Of a sum of 8 with the limit 6, 2 are too much: a motion with a half of the sum gives up 1 of them."""
    caps = imposed_limits(walked((1.0, 1.0), (own, own), others=others), bounds(acceleration=6.0), TICK, 1.0)
    assert only(caps) == (ACCELERATION, pytest.approx(own * 6.0 / 8.0), Quantity.ACCELERATION)


def test_a_motion_that_another_one_works_against_takes_all_of_an_excess() -> None:
    """Of 9 another motion takes 1 away: with the limit 6, 2 of the sum are too much, and nobody else's."""
    caps = imposed_limits(walked((1.0, 1.0), (9.0, 9.0), others=-1.0), bounds(acceleration=6.0), TICK, 1.0)
    assert only(caps) == (ACCELERATION, pytest.approx(7.0), Quantity.ACCELERATION)


@pytest.mark.parametrize("jerks", [(0.0, 60.0), (60.0, 0.0), (60.0, -60.0)])
def test_beside_another_motion_a_jerk_counts_as_if_it_filled_its_tick(jerks: tuple[float, float]) -> None:
    """30 beside 90 are 60 for a part of the tick: of 150 with the limit 100, 40 of the 60 may be left."""
    way = walked((1.0, 1.0), (2.0, 2.03), jerks=jerks)
    beside = replace(way, qdd=way.qdd + np.array([0.0, 0.09])[:, None, None])
    caps = imposed_limits(beside, bounds(jerk=100.0), TICK, 1.0)
    assert only(caps) == (JERK, pytest.approx(40.0), Quantity.JERK)


def test_a_motion_with_nearly_all_of_a_sum_takes_all_of_its_excess() -> None:
    caps = imposed_limits(walked((1.0, 1.0), (7.9, 7.9), others=0.1), bounds(acceleration=6.0), TICK, 1.0)
    assert only(caps) == (ACCELERATION, pytest.approx(5.9), Quantity.ACCELERATION)


def test_within_the_limits_nothing_is_bounded() -> None:
    caps = imposed_limits(walked((1.0, 1.0), (1.0, 1.001)), bounds(2.0, 2.0, 2.0, 9.0), TICK, 1.0)
    assert caps.count == 0
