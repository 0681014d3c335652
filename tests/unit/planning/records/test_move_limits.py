"""Limits of moves: shares, override and defaults; one record for all moves of which the same is asked."""

from dataclasses import replace

import pytest

from ropsim.motion import JointMotionLimits
from ropsim.planning.testing import move_limits
from support.motion import CELL, FINE, PUMA

CONTROLLER = replace(CELL.first.controller, speed_override=0.8)
JOINTS = JointMotionLimits(PUMA.max_speeds, PUMA.max_accelerations, PUMA.max_jerks)
PATH = CONTROLLER.path


def test_moves_of_which_the_same_is_asked_have_one_record_of_limits() -> None:
    one, other = (replace(FINE, frame=name, path_speed=0.25, ptp_speed=0.5) for name in ("", "pallet"))
    assert move_limits(one, JOINTS, CONTROLLER) is move_limits(other, JOINTS, CONTROLLER)
    assert move_limits(FINE, JOINTS, CONTROLLER) is not move_limits(one, JOINTS, CONTROLLER)


def test_shares_and_override_scale_the_limits_of_the_joints() -> None:
    found = move_limits(replace(FINE, ptp_speed=0.5, ptp_acceleration=0.3), JOINTS, CONTROLLER).joints
    assert found.speed == pytest.approx(JOINTS.speed * 0.4)
    assert found.acceleration == pytest.approx(JOINTS.acceleration * 0.3)
    assert found.jerk == pytest.approx(JOINTS.jerk * 0.3)


def test_what_a_move_does_not_say_the_controller_says() -> None:
    modal = replace(FINE, path_speed=0.25, path_acceleration=2.5, path_jerk=9.0)
    modal = replace(modal, orientation_speed=1.5, orientation_acceleration=4.5)
    asked = move_limits(modal, JOINTS, CONTROLLER).tool
    assert asked.all == pytest.approx((0.2, 2.5, 9.0, 1.2, 4.5, PATH.orientation_jerk))
    found = move_limits(FINE, JOINTS, CONTROLLER).tool
    assert found.all == pytest.approx(
        (
            0.8 * PATH.speed,
            PATH.acceleration,
            PATH.jerk,
            0.8 * PATH.orientation_speed,
            PATH.orientation_acceleration,
            PATH.orientation_jerk,
        )
    )
