"""Numbers of arms that are most often slips."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import Kind, Severity
from ropsim.model import DOUBTS, Joint, Link, RobotModel, audit
from ropsim.model.findings import doubt_diagnostics
from ropsim.spatial import Pose

CODES = {kind.code for kind in DOUBTS}


def doubted(robot: RobotModel) -> list[str]:
    return [one.code for one in audit(robot) if one.code in CODES]


def with_links(robot: RobotModel, *links: Link) -> RobotModel:
    return replace(robot, links=links)


def with_joint(robot: RobotModel, number: int, joint: Joint) -> RobotModel:
    joints = list(robot.joints)
    joints[number] = joint
    return replace(robot, joints=tuple(joints))


@pytest.mark.parametrize("name", robots.names())
def test_nothing_of_the_built_in_arms_is_doubted(name: str) -> None:
    assert doubted(robots.load(name)) == []


@pytest.mark.parametrize(
    ("name", "joint", "key", "factor", "unit"),
    [
        ("patu655", 0, "supply_pressure", 1e-5, "bar"),
        ("patu655", 1, "rated_pressure_drop", 1e-6, "MPa"),
        ("patu655", 0, "bulk_modulus", 1e-6, "MPa"),
        ("patu655", 1, "rated_flow", 6e4, "l/min"),
        ("patu655", 0, "area_a", 1e6, "mm²"),
        ("patu655", 0, "area_b", 1e4, "cm²"),
        ("patu655", 1, "stroke", 1e3, "mm"),
        ("patu655", 1, "dead_volume_a", 1e6, "cm³"),
        ("puma560", 2, "inductance", 1e3, "mH"),
        ("puma560", 3, "torque_constant", 1e3, "mN·m/A"),
        ("puma560", 4, "rotor_inertia", 1e7, "g·cm²"),
    ],
)
def test_numbers_of_drives_in_units_of_data_sheets_are_doubted(
    name: str, joint: int, key: str, factor: float, unit: str
) -> None:
    robot = robots.load(name)
    drives = list(robot.drives)
    motor = drives[joint].motor
    drives[joint] = replace(drives[joint], motor=replace(motor, **{key: factor * getattr(motor, key)}))
    (found,) = [one for one in audit(replace(robot, drives=tuple(drives))) if one.code in CODES]
    assert found.code == "X917"
    assert f"`{key}`" in found.message
    assert unit in found.hint
    assert f"joint `{robot.axis_joints[joint].name}`" in found.message


def test_masses_that_are_all_the_same_are_doubted_from_three_links_on() -> None:
    scara, two_link = robots.load("scara"), robots.load("two_link")
    ones = [replace(link, mass=1.0) for link in scara.links]
    assert doubted(with_links(scara, *ones)) == ["X863"]
    assert {link.mass for link in two_link.links} == {1.0}  # both, and nothing is said of them
    unit = [replace(link, inertia=0.01 * np.eye(3)) for link in scara.links]
    assert doubted(with_links(scara, *unit)) == ["X863"]


def test_masses_in_grams_and_inertias_in_square_millimetres_are_doubted() -> None:
    scara = robots.load("scara")
    grams = [replace(link, mass=1e3 * link.mass) for link in scara.links]
    assert doubted(with_links(scara, *grams)) == ["X864"]
    first, *others = scara.links
    assert doubted(with_links(scara, replace(first, inertia=1e6 * first.inertia), *others)) == ["X865"]
    assert doubted(with_links(scara, replace(first, com=1e3 * first.com), *others)) == ["X865"]


def test_one_row_of_limits_copied_to_all_is_a_hint() -> None:
    puma = robots.load("puma560")
    keys = ("lower", "upper", "max_speed", "max_acceleration")
    first = {key: getattr(puma.joints[0], key) for key in keys}
    copied = replace(puma, joints=tuple(replace(joint, **first) for joint in puma.joints), home=np.zeros(6))
    (found,) = [one for one in audit(copied) if one.code in CODES]
    assert (found.code, found.severity) == ("X866", Severity.HINT)


def test_two_joints_about_one_axis_and_one_that_stands_still_are_doubted() -> None:
    puma = robots.load("puma560")
    last = puma.joints[5]
    doubled = with_joint(puma, 5, replace(last, placement=Pose(np.array([0.0, 0.0, 0.1]))))
    assert doubted(doubled) == ["X867"]
    assert doubted(with_joint(puma, 5, replace(last, lower=0.0, upper=1e-3))) == ["X868"]


@pytest.mark.parametrize("scale", [1e-3, 1e3])
def test_arms_of_another_unit_of_length_are_doubted(scale: float) -> None:
    arm = robots.load("two_link")
    joints = tuple(
        replace(joint, placement=Pose(scale * joint.placement.position, joint.placement.orientation))
        for joint in arm.joints
    )
    X_nM = Pose(scale * arm.X_nM.position)
    massless = tuple(Link(0.0, np.zeros(3), np.zeros((3, 3))) for _ in joints)
    assert doubted(replace(arm, joints=joints, X_nM=X_nM, links=massless)) == ["X869"]


def test_centres_of_mass_beside_their_links_are_one_finding() -> None:
    """Files of a maker had all centres of mass in the frame of the base."""
    arm = robots.load("irb120")
    assert "X865" not in doubted(arm)
    moved = [replace(link, com=link.com + np.array([0.2, 0.2, 0.2])) for link in arm.links]
    (found,) = (one for one in audit(with_links(arm, *moved)) if one.code == "X865")
    assert "`1`, `2`, `3`, `4`, `5`, `6`" in found.message
    assert "the longest link has" in found.message


def test_an_arm_that_weighs_less_than_it_carries_is_doubted() -> None:
    arm = robots.load("irb120")
    total = sum(link.mass for link in arm.links)
    assert doubted(replace(arm, rated_payload=1.2 * total)) == []
    (found,) = (one for one in audit(replace(arm, rated_payload=1.3 * total)) if one.code in CODES)
    assert found.code == "X926"
    assert found.data["payload_kg"] == 1.3 * total


def test_an_arm_that_weighs_three_times_what_its_size_says_is_doubted() -> None:
    """A file of the KR 210 adds up to 3.3 t over 3.9 m; the arm has 1.1 t."""
    arm = robots.load("kr210_r2700_2")
    heavy = [replace(link, mass=3.3e3 / 851.5 * link.mass) for link in arm.links]
    assert doubted(with_links(arm, *heavy)) == ["X864"]
    assert doubted(arm) == []


def test_every_doubt_of_the_module_is_in_the_table() -> None:
    defined = {kind for kind in vars(doubt_diagnostics).values() if isinstance(kind, Kind)}
    assert set(DOUBTS) == defined
    assert len(DOUBTS) == len(defined)


def test_no_library_arm_has_a_centre_beside_its_link() -> None:
    for name in robots.names():
        assert [one for one in audit(robots.load(name)) if "beside them" in one.message] == [], name
