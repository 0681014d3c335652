"""How much torque the joints may be asked for."""

from dataclasses import replace
from math import inf

import numpy as np
import pytest

from ropsim import dynamics, robots
from ropsim.dynamics import effort_limits, steady_drive
from ropsim.model import (
    CurrentLimitedAmplifier,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Gear,
    IdealMotor,
    RobotModel,
    VoltageAmplifier,
    ideal_drive,
)
from support.arms import MOTOR, drive, random_arm

KT, R = MOTOR.torque_constant, MOTOR.resistance


def _arm(*drives: Drive, most: float = inf) -> RobotModel:
    arm = random_arm(3, "R" * len(drives), drives)
    return replace(arm, joints=tuple(replace(joint, max_effort=most) for joint in arm.joints))


@pytest.mark.parametrize(
    ("one", "expected"),
    [
        (Drive(VoltageAmplifier(40.0, 10.0), MOTOR, Gear(-60.0)), 60.0 * KT * 10.0),
        (Drive(CurrentLimitedAmplifier(40.0, 10.0), MOTOR, Gear(-60.0)), 60.0 * KT * 10.0),
        (Drive(VoltageAmplifier(12.0, 10.0), MOTOR, Gear(-60.0)), 60.0 * KT * 12.0 / R),
        (Drive(VoltageAmplifier(12.0, inf), MOTOR, Gear(60.0)), 60.0 * KT * 12.0 / R),
        (Drive(VoltageAmplifier(40.0, 10.0), MOTOR, ElasticGear(-80.0, 1e4, 5.0)), 80.0 * KT * 10.0),
        (Drive(EffortAmplifier(3.0), IdealMotor(1e-4), Gear(-20.0)), 60.0),
        (ideal_drive(), inf),
    ],
    ids=["current", "held current", "voltage", "open current", "elastic gear", "ideal motor", "open"],
)
def test_a_drive_gives_what_its_first_limit_leaves(one: Drive, expected: float) -> None:
    assert effort_limits(_arm(one)).tolist() == pytest.approx([expected])


def test_the_joint_may_allow_less_than_its_drive_can_give() -> None:
    both = _arm(drive(), ideal_drive(30.0), most=50.0)
    assert 60.0 * KT * 10.0 > 50.0
    assert effort_limits(both).tolist() == [50.0, 30.0]


def test_without_drives_the_joints_alone_set_the_limits() -> None:
    assert effort_limits(_arm(drive())).tolist() != [inf]
    assert effort_limits(replace(_arm(drive()), drives=())).tolist() == [inf]
    assert effort_limits(replace(_arm(drive(), most=7.0), drives=())).tolist() == [7.0]


def test_at_its_limit_a_drive_in_a_steady_state_is_at_the_limit_of_its_amplifier() -> None:
    one = drive(ratio=-60.0)
    (limit,) = effort_limits(_arm(one))
    held = steady_drive(one, 0.0, 0.0, limit)
    assert abs(held.states[0]) == pytest.approx(10.0)
    assert abs(held.output) < 40.0


def test_the_puma_has_the_published_limits_of_its_joints() -> None:
    """Its drives can give a little more: their currents are estimated from these."""
    puma = robots.load("puma560")
    np.testing.assert_array_equal(effort_limits(puma), [97.6, 186.4, 89.4, 24.2, 20.1, 21.3])


def test_a_drive_that_cannot_exist_is_refused() -> None:
    broken = replace(drive(), motor=replace(MOTOR, torque_constant=0.0))
    with pytest.raises(dynamics.ModelNumberError, match="torque_constant"):
        effort_limits(_arm(broken, most=9.0))


def test_an_arm_that_cannot_be_is_refused() -> None:
    with pytest.raises(dynamics.JointCountError):
        effort_limits(replace(random_arm(0, "RR"), links=()))
