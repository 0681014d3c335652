import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import Posture, forward, posture, singular_distances
from support.dc_drives import dc_motor, voltage_amplifier

PUMA = robots.load("puma560")


def test_limits_are_those_of_fu_gonzalez_and_lee() -> None:
    """Table 2.1 of their book has θ2 -225..45, θ3 -45..225, θ5 ±100; here q2 = -θ2, q3 = -θ3, q5 = -θ5."""
    np.testing.assert_allclose(np.degrees(PUMA.lower_limits), [-160, -45, -225, -110, -100, -266])
    np.testing.assert_allclose(np.degrees(PUMA.upper_limits), [160, 225, 45, 170, 100, 266])


def test_the_limits_leave_the_elbow_free_to_bend_either_way() -> None:
    stretched = -np.pi / 2.0
    assert PUMA.upper_limits[2] - stretched == pytest.approx(stretched - PUMA.lower_limits[2])


def test_home_points_the_tool_straight_down_in_front_of_the_arm() -> None:
    X_BM = forward(PUMA, PUMA.home)
    np.testing.assert_allclose(X_BM.rotation()[:, 2], [0.0, 0.0, -1.0], atol=1e-12)
    assert X_BM.position[0] > 0.4
    assert posture(PUMA, PUMA.home) == Posture(("right", "up", "noflip"))


def test_home_is_clear_of_all_limits() -> None:
    margin = np.minimum(PUMA.home - PUMA.lower_limits, PUMA.upper_limits - PUMA.home)
    assert np.degrees(margin.min()) >= 20.0


def test_home_is_far_from_every_singular_posture() -> None:
    distances = singular_distances(PUMA, PUMA.home)
    assert distances is not None
    assert distances.shoulder > 0.3
    assert min(np.degrees([distances.elbow, distances.wrist])) > 45.0


@pytest.mark.parametrize("index", range(6))
def test_the_amplifier_can_drive_the_joint_at_its_speed_limit(index: int) -> None:
    """Back-EMF, friction and, at joints 2 and 3, gravity at full speed need no more than the voltage."""
    joint, drive = PUMA.joints[index], PUMA.drives[index]
    ratio, motor, friction = abs(drive.ratio_at(0.0)), dc_motor(drive), drive.friction
    gravity = (0.0, 60.0, 10.0, 0.0, 0.0, 0.0)[index]  # arm stretched out, generously rounded [N·m]
    coulomb = max(friction.coulomb_positive, -friction.coulomb_negative)
    torque = friction.viscous * ratio**2 * joint.max_speed + coulomb * ratio + gravity
    current = torque / (motor.torque_constant * ratio)
    voltage = motor.back_emf_constant * ratio * joint.max_speed + motor.resistance * current
    assert current < voltage_amplifier(drive).max_current
    assert voltage < voltage_amplifier(drive).max_voltage


def test_the_largest_current_gives_the_torque_limit() -> None:
    for joint, drive in zip(PUMA.joints, PUMA.drives, strict=True):
        torque = (
            voltage_amplifier(drive).max_current * dc_motor(drive).torque_constant * abs(drive.ratio_at(0.0))
        )
        assert torque == pytest.approx(joint.max_effort, rel=0.03)
