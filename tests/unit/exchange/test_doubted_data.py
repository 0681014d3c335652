"""Numbers of robot files that cannot be right are doubted: efforts, ranges, units, copies."""

from math import inf, pi

import numpy as np
import pytest

from ropsim import dynamics, robots
from ropsim.core import Diagnostic, SourceText
from ropsim.dynamics import gravity_loads
from ropsim.exchange import read_urdf
from ropsim.model import ReadRobot, audit

G = 9.81
LINK = (
    '<link name="l{k}"><inertial><origin xyz="0.2 0 0"/><mass value="2"/>'
    '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.03" iyz="0" izz="0.03"/></inertial></link>'
)
JOINT = (
    '<joint name="j{k}" type="revolute"><parent link="l{before}"/><child link="l{k}"/>'
    '<origin xyz="{x} 0 0"/><axis xyz="0 1 0"/>'
    '<limit lower="{lower}" upper="{upper}" effort="{effort}" velocity="1"/></joint>'
)


def arm(*efforts: float, lower: float = -1.0, upper: float = 1.0, more: str = "") -> ReadRobot:
    """Return an arm of links of 2 kg and 0.4 m that turn about level axes, stretched at zero."""
    numbers = range(1, len(efforts) + 1)
    links = '<link name="l0"/>' + "".join(LINK.format(k=k) for k in numbers)
    joints = "".join(
        JOINT.format(k=k, before=k - 1, x=0.4 if k > 1 else 0.0, lower=lower, upper=upper, effort=effort)
        for k, effort in zip(numbers, efforts, strict=True)
    )
    return read_urdf(SourceText("arm.urdf", f'<robot name="arm">{links}{joints}{more}</robot>'))


def only(found: ReadRobot, code: str) -> Diagnostic:
    assert found.robot is not None, found.findings
    (one,) = [one for one in found.findings if one.code == code]
    return one


def test_an_effort_that_cannot_carry_the_arm_is_no_limit_and_said() -> None:
    needed = 2.0 * G * (0.2 + 0.6)  # stretched
    found = arm(10.0, 10.0)
    one = only(found, "X979")
    assert one.data == {"efforts": ("j1",)}
    assert "`j1` has 10 N·m, its weight needs" in one.message
    assert found.robot is not None
    assert [joint.max_effort for joint in found.robot.joints] == [inf, 10.0]
    assert any("cannot carry the weight: joints j1" in origin.source for origin in found.robot.origins)
    largest = float(np.abs(gravity_loads(found.robot, np.zeros((1, 2)))).max())
    assert largest == pytest.approx(needed)
    assert float(one.message.rpartition("needs ")[2].removesuffix(" N·m")) == pytest.approx(needed, rel=1e-3)


@pytest.mark.parametrize(
    ("lower", "upper", "home"),
    [(-1.0, 1.0, 0.0), (0.0, 2.5, 0.05), (-3.0718, -0.0698, -0.0698 - 0.02 * 3.002), (0.2, 0.25, 0.225)],
)
def test_a_rest_position_that_no_file_says_keeps_room_to_the_limits(
    lower: float, upper: float, home: float
) -> None:
    """Two per cent of the range and two degrees at least, or the middle; joint 4 of the Panda ends at -4°."""
    robot = arm(60.0, 20.0, lower=lower, upper=upper).robot
    assert robot is not None
    np.testing.assert_allclose(robot.home, home, atol=1e-12)


def test_an_effort_that_carries_the_arm_is_kept() -> None:
    found = arm(16.0, 4.0)
    assert found.robot is not None
    assert not [one for one in found.findings if one.code == "X979"]
    assert [joint.max_effort for joint in found.robot.joints] == [16.0, 4.0]


@pytest.mark.parametrize("name", ["puma560", "panda", "scara", "m410ib_700", "ur5e"])
def test_loads_of_gravity_are_those_of_the_compiled_dynamics(name: str) -> None:
    robot = robots.load(name)
    Q = np.random.default_rng(3).uniform(-1.0, 1.0, (5, robot.n))
    expected = [dynamics.gravity(robot, q) for q in Q]
    scale = float(np.abs(expected).max())
    np.testing.assert_allclose(gravity_loads(robot, Q), expected, rtol=0.0, atol=1e-9 * max(scale, 1.0))


def test_limits_in_degrees_are_doubted_and_read_as_the_format_says() -> None:
    found = arm(90.0, 90.0, lower=-170.0, upper=170.0)
    one = only(found, "X999")
    assert one.data == {"limits like degrees": ("j1", "j2")}
    assert "`j1` has -170 to 170 rad" in one.message
    assert found.robot is not None
    assert found.robot.joints[0].upper == 170.0


@pytest.mark.parametrize(("lower", "upper"), [(-2.0 * pi, 2.0 * pi), (-100.0, 100.0), (-47.123, 47.123)])
def test_wide_ranges_of_real_joints_and_stand_ins_are_not(lower: float, upper: float) -> None:
    assert not [one for one in arm(90.0, 90.0, lower=lower, upper=upper).findings if one.code == "X999"]


def test_a_joint_that_follows_and_cuts_the_range_is_said_with_the_range_left() -> None:
    rod = (
        '<link name="rod"/><joint name="r" type="revolute"><parent link="l0"/><child link="rod"/>'
        '<axis xyz="0 1 0"/><limit lower="-1" upper="0.5" effort="1" velocity="1"/>'
        '<mimic joint="j1" multiplier="-2" offset="0.1"/></joint>'
    )
    one = only(arm(90.0, 90.0, more=rod), "X999")
    assert one.data == {"cut ranges": ("j1",)}
    assert "of `j1` is left -0.2 to 0.55 rad of -1 to 1 rad" in one.message
    wide = rod.replace('lower="-1" upper="0.5"', 'lower="-3" upper="3"')
    assert not [one for one in arm(90.0, 90.0, more=wide).findings if one.code == "X999"]


def test_one_effort_and_one_rotor_on_all_axes_are_copies() -> None:
    found = arm(*[1000.0] * 6)
    assert found.robot is not None
    said = [one.message for one in audit(found.robot) if one.code == "X866"]
    assert "all 6 turning joints of `arm` have 1000 as their greatest effort" in said
    other = arm(*[1000.0] * 5, 500.0)
    assert other.robot is not None
    assert not [one for one in audit(other.robot) if "greatest effort" in one.message]


@pytest.mark.parametrize(("reach", "share"), [(2.0, 1.5), (2.0, 0.9), (0.5, 1.1), (0.5, 0.8)])
def test_moments_are_those_of_a_longer_body_beyond_the_mass_times_the_square_of_the_reach(
    reach: float, share: float
) -> None:
    """No point of a body within the reach adds more than its mass times the square of the distance."""
    moment = share * 2.0 * reach**2
    inertia = f'<inertia ixx="{0.1 * moment}" iyy="{moment}" izz="{moment}" ixy="0" ixz="0" iyz="0"/>'
    link = f'<inertial><mass value="2"/>{inertia}</inertial>'
    turn = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1" effort="900"/>'
    found = read_urdf(
        SourceText(
            "arm.urdf",
            f'<robot name="r"><link name="base"/><link name="a"/><link name="tool0">{link}</link>'
            f'<joint name="j" type="revolute"><parent link="base"/><child link="a"/>{turn}</joint>'
            f'<joint name="k" type="revolute"><parent link="a"/><child link="tool0"/>'
            f'<origin xyz="{reach} 0 0"/>{turn}</joint></robot>',
        )
    )
    told = any("longer than the robot" in f"{one.message} {one.notes}" for one in found.findings)
    assert told == (share > 1.0)


def test_a_sound_file_has_at_most_three_findings() -> None:
    found = arm(90.0, 60.0, 30.0)
    assert found.robot is not None
    assert len(found.findings) <= 3, found.findings
