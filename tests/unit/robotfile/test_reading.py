"""Robot files: the same arm as built in, both conventions, and what a row leaves out."""

from dataclasses import replace
from math import inf

import numpy as np
import pytest

from ropsim import kinematics, robots
from ropsim.core import SourceText
from ropsim.dynamics import gravity
from ropsim.model import (
    BacklashGear,
    CurrentLoopMotor,
    DcMotor,
    EffortAmplifier,
    ElasticGear,
    Friction,
    FrictionLaw,
    GuardedAmplifier,
    HydraulicMotor,
    HydraulicVane,
    JointType,
    LaggingMotor,
    Linkage,
    LoadFriction,
    LugreFriction,
    RobotModel,
    StribeckFriction,
    ThermalDcMotor,
    ValveAmplifier,
    audit,
    capsule,
    check_counts,
)
from ropsim.robotfile import read_robot_file, robot_file_places, write_robot_file
from ropsim.spatial import Pose
from support.robot_files import PUMA560, TWO_JOINTS

ROUNDING = 1e-12
"""Of sums and products of lengths of 1 m [m, entries of the rotation]."""


def arm(text: str) -> RobotModel:
    read = read_robot_file(SourceText("robots/arm.toml", text))
    assert [one.code for one in read.findings if one.is_error] == []
    assert read.robot is not None
    return read.robot


def test_the_puma_of_its_papers_is_the_built_in_one() -> None:
    robot, built_in = arm(PUMA560), robots.load("puma560")
    Q = np.random.default_rng(1).uniform(built_in.lower_limits, built_in.upper_limits, (100, 6))
    difference = kinematics.forward_batch(robot, Q) - kinematics.forward_batch(built_in, Q)
    assert np.abs(difference).max() <= ROUNDING
    assert robot.drives == built_in.drives
    assert robot.dh == built_in.dh
    bare = [replace(link, shapes=()) for link in built_in.links]
    assert list(robot.links) == bare
    np.testing.assert_array_equal(gravity(robot, Q[0]), gravity(built_in, Q[0]))


STANDARD = """
convention = "standard"
base = { position = [0, 0, 100] }
flange = { position = [10, 20, 30], rpy = [0, 40, 0] }
joints = [
  { a = 150, alpha = 90, d = 445, theta = 10, limits = [-180, 180] },
  { type = "prismatic", a = 20, alpha = -35, d = 50, theta = 25, limits = [-100, 700] },
  { a = 115, alpha = -90, d = 3, theta = -90, limits = [-175, 90] },
]
"""
MODIFIED = """
convention = "modified"
base = { position = [0, 0, 100] }
flange = { position = [127.0, -30, 20], quaternion = [QUATERNION] }
joints = [
  { d = 445, theta = 10, limits = [-180, 180] },
  { type = "prismatic", a = 150, alpha = 90, d = 50, theta = 25, limits = [-100, 700] },
  { a = 20, alpha = -35, d = 3, theta = -90, limits = [-175, 90] },
]
"""


def as_modified() -> str:
    """Return the arm of `STANDARD` in the other form: its last a and α come before the flange.

    Tx(115)·Rx(-90°) applied to (10, 20, 30) is (125, 30, -20).
    """
    half = np.radians([-45.0, 20.0])
    (sx, sy), (cx, cy) = np.sin(half), np.cos(half)
    turned = ", ".join(repr(float(one)) for one in (cx * cy, sx * cy, cx * sy, sx * sy))
    return MODIFIED.replace("127.0, -30, 20", "125, 30, -20").replace("QUATERNION", turned)


def test_standard_and_modified_tables_of_one_arm_have_the_same_forward_kinematics() -> None:
    standard, modified = arm(STANDARD), arm(as_modified())
    Q = np.random.default_rng(2).uniform(standard.lower_limits, standard.upper_limits, (50, 3))
    one, other = kinematics.forward_batch(standard, Q), kinematics.forward_batch(modified, Q)
    np.testing.assert_allclose(one, other, rtol=0.0, atol=ROUNDING)
    assert standard.joints[1].type is JointType.PRISMATIC


def test_data_of_links_stand_in_the_frames_of_their_table() -> None:
    links = "links = [{ mass = 3, com = [1, 2, 3] }, { mass = 2, com = [4, 5, 6] }, { mass = 1 }]"
    standard = arm(f"{links}\n{STANDARD}")
    frames = kinematics.frames_batch(standard, np.zeros((1, 3)))[0]
    # frame 1 of the table is X_{01} = Rz(10°)·Tz(445)·Tx(150)·Rx(90°), 100 mm above the base
    c, s = np.cos(np.radians(10.0)), np.sin(np.radians(10.0))
    X_01 = np.array([[c, 0.0, s], [s, 0.0, -c], [0.0, 1.0, 0.0]])
    expected = X_01 @ np.array([0.001, 0.002, 0.003]) + np.array([0.15 * c, 0.15 * s, 0.545])
    found = frames[0][:3, :3] @ standard.links[0].com + frames[0][:3, 3]
    np.testing.assert_allclose(found, expected, rtol=0.0, atol=ROUNDING)


def test_a_bare_table_is_an_arm_without_masses_that_says_what_is_estimated() -> None:
    robot = arm(TWO_JOINTS)
    check_counts(robot)
    assert (robot.name, robot.n, robot.drives) == ("arm", 2, ())
    assert sum(link.mass for link in robot.links) == 0.0
    joint = robot.joints[0]
    np.testing.assert_allclose(joint.max_acceleration, joint.max_speed / 0.25)
    np.testing.assert_allclose(joint.max_jerk, 10.0 * joint.max_acceleration)
    assert [one.parameters for one in robot.origins if one.kind == "estimated"] == [
        "joint accelerations and jerks"
    ]


def test_the_mass_of_the_arm_is_shared_by_its_links_with_inertias_that_can_be() -> None:
    robot = arm("mass = 12\n" + TWO_JOINTS)
    assert sum(link.mass for link in robot.links) == pytest.approx(12.0)
    assert robot.links[0].mass > robot.links[1].mass > 0.0
    np.testing.assert_allclose(robot.links[0].com, [0.2, 0.0, 0.0])
    mass, length = robot.links[0].mass, 0.4
    # a cylinder along x: little about x, the same about y and z
    xx, yy, zz = np.diag(robot.links[0].inertia)
    assert 0.0 < xx < yy == pytest.approx(zz)
    radius = (mass / (np.pi * 1500.0 * length)) ** 0.5
    assert xx == pytest.approx(mass * radius**2 / 2.0)
    assert not [one for one in audit(robot) if one.code in {"X853", "X854", "X865"}]
    estimated = [one.parameters for one in robot.origins if one.kind == "estimated"]
    assert "masses of the links, centres of mass and moments of inertia" in estimated


def test_a_link_keeps_its_own_mass_and_the_others_get_the_rest() -> None:
    robot = arm("mass = 12\nlinks = [{ mass = 9 }, {}]\n" + TWO_JOINTS)
    assert [link.mass for link in robot.links] == [9.0, pytest.approx(3.0)]


def test_the_mass_with_the_base_leaves_the_share_of_the_moving_links() -> None:
    robot = arm("total_mass = 40\n" + TWO_JOINTS)
    assert sum(link.mass for link in robot.links) == pytest.approx(0.71 * 40.0)


def test_all_masses_and_the_mass_with_the_base_stand_beside_each_other() -> None:
    robot = arm("total_mass = 40\nlinks = [{ mass = 22 }, { mass = 11 }]\n" + TWO_JOINTS)
    assert [link.mass for link in robot.links] == [22.0, 11.0]


@pytest.mark.parametrize(
    ("rows", "key"),
    [("[{ mass = 30 }, { mass = 11 }]", "total_mass"), ("[{ mass = 30 }, {}]", "total_mass")],
)
def test_links_with_more_mass_than_the_arm_are_an_error_at_its_mass(rows: str, key: str) -> None:
    text = f"total_mass = 40\nlinks = {rows}\n{TWO_JOINTS}"
    (found,) = [one for one in read_robot_file(SourceText("a.toml", text)).findings if one.is_error]
    assert found.code == "X906"
    assert f"`{key}` with the base is 40 kg" in found.message
    assert found.span
    assert found.span.line == 1


def test_home_is_zero_or_the_middle_of_a_range_without_zero() -> None:
    robot = arm(TWO_JOINTS.replace("[-150, 150]", "[20, 60]"))
    np.testing.assert_allclose(np.degrees(robot.home), [0.0, 40.0])


def test_drives_may_be_servos_with_elastic_gears() -> None:
    servo = '{ kind = "servo", ratio = 100, max_torque = 2, stiffness = 2e4, coulomb = 0.1 }'
    robot = arm(f"mass = 12\ndrives = [{servo}, {servo}]\n" + TWO_JOINTS)
    transmission = robot.drives[0].transmission
    assert isinstance(transmission, ElasticGear)
    assert (transmission.ratio, transmission.stiffness) == (100.0, 2e4)
    assert robot.drives[0].friction.coulomb_negative == -0.1


@pytest.mark.parametrize(("more", "torque"), [("", 0.9), (", max_torque = 0.7", 0.7)])
def test_a_motor_may_be_in_a_current_loop(more: str, torque: float) -> None:
    row = (
        '{ kind = "dc", ratio = 50, torque_constant = 0.1, back_emf_constant = 0.11, resistance = 0.9, '
        "inductance = 1e-3, rotor_inertia = 2e-4, max_voltage = 48, max_current = 9, "
        f"current_bandwidth = 2e3{more} }}"
    )
    robot = arm(f"mass = 12\ndrives = [{row}, {row}]\n" + TWO_JOINTS)
    assert robot.drives[0].motor == CurrentLoopMotor(0.1, 0.11, 0.9, 1e-3, 2e-4, 48.0, 9.0, 2e3)
    amplifier = robot.drives[0].amplifier
    assert isinstance(amplifier, EffortAmplifier)
    assert amplifier.max_effort == pytest.approx(torque)
    assert arm(write_robot_file(robot).text).drives == robot.drives


def test_a_servo_may_have_a_lag() -> None:
    servo = '{ kind = "servo", ratio = 100, max_torque = 2, rotor_inertia = 1e-4, current_bandwidth = 900 }'
    robot = arm(f"mass = 12\ndrives = [{servo}, {servo}]\n" + TWO_JOINTS)
    assert robot.drives[0].motor == LaggingMotor(900.0, 1e-4)
    assert arm(write_robot_file(robot).text).drives == robot.drives


def test_a_motor_may_grow_warm() -> None:
    row = (
        '{ kind = "dc", ratio = 50, torque_constant = 0.1, resistance = 0.9, inductance = 1e-3, '
        "rotor_inertia = 2e-4, max_voltage = 48, max_current = 9, winding_thermal_resistance = 0.6, "
        "housing_thermal_resistance = 2.4, winding_time_constant = 20, housing_time_constant = 900"
    )
    more = f"{row}, torque_drift = 2e-3, resistance_drift = 4e-3, start_rise = 30, max_rise = 100 }}"
    robot = arm(f"mass = 12\ndrives = [{row} }}, {more}]\n" + TWO_JOINTS)
    first = ThermalDcMotor(0.1, 0.1, 0.9, 1e-3, 2e-4, 0.6, 2.4, 20.0, 900.0)
    assert robot.drives[0].motor == first
    assert robot.drives[0].amplifier == GuardedAmplifier(48.0, 9.0, inf)
    second = replace(first, torque_drift=-2e-3, resistance_drift=4e-3, start_rise=30.0)
    assert robot.drives[1].motor == second
    assert robot.drives[1].amplifier == GuardedAmplifier(48.0, 9.0, 100.0)
    assert arm(write_robot_file(robot).text).drives == robot.drives


def test_an_elastic_gear_may_have_play() -> None:
    servo = '{ kind = "servo", ratio = 100, max_torque = 2, stiffness = 2e4, damping = 3, backlash = 2e-4 }'
    robot = arm(f"mass = 12\ndrives = [{servo}, {servo}]\n" + TWO_JOINTS)
    assert robot.drives[0].transmission == BacklashGear(100.0, 2e4, 3.0, 2e-4)
    copy = read_robot_file(SourceText("arm.toml", write_robot_file(robot).text)).robot
    assert copy is not None
    assert copy.drives == robot.drives


@pytest.mark.parametrize(
    ("keys", "law"),
    [
        ("coulomb = [0.1, 0.2]", Friction(0.01, 0.1, -0.2)),
        ("coulomb = 0.1, breakaway = 0.15, stribeck_speed = 4", StribeckFriction(0.01, 0.1, 0.15, 4.0)),
        (
            "breakaway = 0.15, stribeck_speed = 4, stribeck_exponent = 1, smoothing_speed = 1e-3",
            StribeckFriction(0.01, 0.0, 0.15, 4.0, 1.0, 1e-3),
        ),
        ("coulomb = 0.1, load_share = 0.2", LoadFriction(0.01, 0.1, 0.2)),
        (
            "coulomb = 0.1, breakaway = 0.2, stribeck_speed = 4, bristle_stiffness = 80, bristle_damping = 2",
            LugreFriction(0.01, 0.1, 0.2, 4.0, 80.0, 2.0),
        ),
    ],
)
def test_the_keys_of_friction_say_its_law(keys: str, law: FrictionLaw) -> None:
    servo = f'{{ kind = "servo", ratio = 100, max_torque = 2, viscous = 0.01, {keys} }}'
    robot = arm(f"mass = 12\ndrives = [{servo}, {servo}]\n" + TWO_JOINTS)
    assert robot.drives[0].friction == law
    written = write_robot_file(robot)
    copy = read_robot_file(SourceText("arm.toml", written.text)).robot
    assert copy is not None
    assert copy.drives == robot.drives


VALVE = {
    "supply_pressure": 21e6,
    "return_pressure": 0.0,
    "bulk_modulus": 1.4e9,
    "rated_flow": 6e-4,
    "rated_pressure_drop": 7e6,
    "rated_input": 0.05,
    "natural_frequency": 630.0,
    "damping_ratio": 0.7,
}


def test_drives_may_be_hydraulic() -> None:
    keys = (
        "displacement = 2e-4, chamber_volume = 3e-4, leakage = 1e-12, supply_pressure = 21e6, "
        "bulk_modulus = 1.4e9, rated_flow = 6e-4, rated_pressure_drop = 7e6, rated_input = 0.05, "
        "natural_frequency = 630"
    )
    one, other = (
        f'{{ kind = "hydraulic", {keys} }}',
        f'{{ kind = "hydraulic", max_input = 0.04, ratio = 2, {keys} }}',
    )
    robot = arm(f"mass = 12\ndrives = [{one}, {other}]\n" + TWO_JOINTS)
    first, second = robot.drives
    assert isinstance(first.motor, HydraulicMotor)
    assert first.motor == HydraulicMotor(2e-4, 3e-4, 1e-12, 0.0, **VALVE)
    assert (first.amplifier, second.amplifier) == (ValveAmplifier(0.05), ValveAmplifier(0.04))
    assert arm(write_robot_file(robot).text).drives == robot.drives
    edges = one.replace("leakage", "null_flow = 2e-5, overlap = 0.03, leakage")
    leaking = arm(f"mass = 12\ndrives = [{edges}, {other}]\n" + TWO_JOINTS)
    assert leaking.drives[0].motor == replace(first.motor, null_flow=2e-5, overlap=0.03)
    assert arm(write_robot_file(leaking).text).drives == leaking.drives


VANE = (
    '{ kind = "vane", displacement = 2e-4, swing = 5.3, first_angle = -2.65, dead_volume = 3e-5, '
    "supply_pressure = 21e6, bulk_modulus = 1.4e9, rated_flow = 6e-4, rated_pressure_drop = 7e6, "
    "rated_input = 0.05, natural_frequency = 630 }"
)


def test_drives_may_be_vanes_that_swing_over_the_ranges_of_their_joints() -> None:
    text = f"mass = 12\ndrives = [{VANE}, {VANE}]\n" + TWO_JOINTS
    robot = arm(text.replace("[-170, 170]", "[-150, 150]"))
    assert robot.drives[0].motor == HydraulicVane(2e-4, 5.3, -2.65, 3e-5, 0.0, 0.0, **VALVE)
    assert arm(write_robot_file(robot).text).drives == robot.drives
    found = read_robot_file(SourceText("a.toml", text)).findings
    (error,) = [one for one in found if one.is_error]
    assert "its stops are at -2.65 and 2.65 rad" in error.message
    assert error.span
    assert error.span.line == 2


CYLINDER = (
    '{ kind = "cylinder", area_a = 7.9e-3, area_b = 5.4e-3, stroke = 0.54, retracted_length = 0.82, '
    "dead_volume_a = 4e-4, dead_volume_b = 3e-4, moving_mass = 14, leakage = 3e-12, "
    "carrier_pin = [0.26, -1.04, 0], link_pin = [-2.5, -0.1, 0], "
    "supply_pressure = 16e6, bulk_modulus = 1.1e9, rated_flow = 4e-4, "
    "rated_pressure_drop = 7e6, rated_input = 0.7, natural_frequency = 300 }"
)
BOOM = """
convention = "standard"
base = { position = [0, 0, 300], rpy = [90, 0, 0] }
joints = [
  { a = 2800, alpha = 10, theta = 5, limits = [-15, 60] },
  { a = 1500, limits = [-120, -10] },
]
mass = 200
"""


@pytest.mark.parametrize(
    ("before", "after", "word"),
    [
        ("area_b = 5.4e-3", "area_b = 8e-3", "area_b"),
        ("supply_pressure = 16e6", "supply_pressure = 16e6, return_pressure = 16e6", "return_pressure"),
        ("carrier_pin = [0.26, -1.04, 0]", "carrier_pin = [0.26, -1.04]", "carrier_pin"),
        ("leakage = 3e-12", "null_flow = 5e-4", "the rated flow is 0.0004"),
        ("leakage = 3e-12", "overlap = 0.95", "0.9"),
        ("natural_frequency = 300", "natural_frequency = 1e-9", "0.1 to 1e+06"),
    ],
)
def test_what_is_wrong_in_the_row_of_a_cylinder_is_told_alone(before: str, after: str, word: str) -> None:
    row = CYLINDER.replace(before, after)
    assert row != CYLINDER
    text = f'{BOOM}drives = [{row}, {{ kind = "servo" }}]\n'
    found = read_robot_file(SourceText("robots/arm.toml", text))
    assert [word in one.message for one in found.findings] == [True]


def test_a_cylinder_has_its_pins_in_the_frames_of_the_table() -> None:
    robot = arm(f'{BOOM}drives = [{CYLINDER}, {{ kind = "servo" }}]\n')
    gear = robot.drives[0].transmission
    assert isinstance(gear, Linkage)
    q = 0.4
    tip = Pose.from_matrix(kinematics.joint_frames(robot, np.array([q, 0.0]))[0]) @ Pose(
        np.array(gear.link_pin)
    )
    turn = np.radians(5.0) + q
    x, y = 2.8 - 2.5, -0.1 * np.cos(np.radians(10.0))  # of the pin beside axis 1, before it turns
    away = -0.1 * np.sin(np.radians(10.0))
    across, up = x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn)
    np.testing.assert_allclose(tip.position, [across, -away, 0.3 + up], atol=ROUNDING)
    length = np.sqrt((across - 0.26) ** 2 + (up + 1.04) ** 2 + away**2)
    assert gear.length_at(q) == pytest.approx(length)
    assert arm(write_robot_file(robot).text).drives == robot.drives
    bent = replace(robot, dh=())
    assert arm(write_robot_file(bent).text).drives[0].ratio_at(q) == pytest.approx(gear.ratio_at(q))


@pytest.mark.parametrize(
    ("before", "after", "words", "key", "hint"),
    [
        (
            "[-15, 60]",
            "[-80, 60]",
            "dead centre within the range of its joint, at -",
            "carrier_pin",
            "narrow",
        ),
        (
            "link_pin = [-2.5, -0.1, 0]",
            "link_pin = [-2.8, 0, 0]",
            "a pin on the axis",
            "link_pin",
            "pins are",
        ),
        ("stroke = 0.54", "stroke = 0.2", "its cylinder is 0.82 to 1.02 m long", "stroke", "make it 0.45"),
        ("h = 0.82", "h = 1.1", "its cylinder is 1.1 to 1.64 m long", "retracted_length", "make it 0.8"),
        (
            "[-15, 60] }",
            "[-15, 60], type = 'prismatic' }",
            "turns a turning joint",
            "kind",
            "which turns",
        ),
    ],
)
def test_a_cylinder_that_cannot_turn_its_joint_is_told_on_its_line(
    before: str, after: str, words: str, key: str, hint: str
) -> None:
    text = f'{BOOM}drives = [{CYLINDER}, {{ kind = "servo" }}]\n'.replace(before, after)
    read = read_robot_file(SourceText("robots/arm.toml", text))
    (found,) = [one for one in read.findings if one.code == "X916"]
    assert words in found.message
    assert hint in found.hint
    assert found.span is not None
    assert text.splitlines()[found.span.line - 1][: found.span.column - 1].endswith(f"{key} = ")
    assert read.robot is None


def test_a_torque_constant_is_the_back_emf_constant_where_only_one_is_given() -> None:
    motor = arm(PUMA560).drives[0].motor
    assert isinstance(motor, DcMotor)
    assert motor.back_emf_constant == motor.torque_constant == 0.19


def test_shapes_stand_in_the_frame_of_the_table_too() -> None:
    looks = "[{ capsule = { radius = 40, length = 300 }, position = [-150, 0, 0] }]"
    robot = arm(
        f"base = {{ shapes = [{{ box = [100, 100, 50] }}] }}\nlinks = [{{ shapes = {looks} }}, {{}}]\n"
        + TWO_JOINTS
    )
    (shape,) = robot.links[0].shapes
    np.testing.assert_allclose(shape.pose.position, [0.25, 0.0, 0.0])
    assert shape.solid == capsule(0.04, 0.3)
    assert len(robot.base_shapes) == 1


def test_findings_of_an_audit_point_into_the_file() -> None:
    text = PUMA560.replace("mass = 17.4", "mass = 9000")
    source = SourceText("robots/arm.toml", text)
    robot = read_robot_file(source).robot
    assert robot is not None
    (found,) = [one for one in audit(robot, robot_file_places(source)) if one.code == "X864"]
    assert found.span is not None
    line = source.line(found.span.line)
    assert line[found.span.column - 1 :].startswith("9000")


def test_a_doubt_about_a_drive_stands_at_its_number() -> None:
    text = f'{BOOM}drives = [{CYLINDER}, {{ kind = "servo" }}]\n'.replace("e = 16e6", "e = 160")
    source = SourceText("robots/arm.toml", text)
    robot = read_robot_file(source).robot
    assert robot is not None
    (found,) = [one for one in audit(robot, robot_file_places(source)) if one.code == "X917"]
    assert found.span is not None
    assert text.splitlines()[found.span.line - 1][: found.span.column - 1].endswith("supply_pressure = ")
