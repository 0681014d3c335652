"""Robots through NIROX files and back are equal to the last bit, texts through robots the same bytes."""

import re
from collections.abc import Callable
from dataclasses import replace
from math import inf

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import SourceText
from ropsim.exchange import read_urdf, write_urdf
from ropsim.kinematics import forward
from ropsim.model import (
    ALL_DIRECTIONS,
    BASE_LINK,
    ArmClass,
    BacklashGear,
    CurrentLimitedAmplifier,
    CurrentLoopMotor,
    DcMotor,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    FrictionLaw,
    Gear,
    GuardedAmplifier,
    HydraulicMotor,
    HydraulicVane,
    JointSpring,
    JointType,
    LaggingMotor,
    LoadFriction,
    LoopCut,
    LugreFriction,
    Material,
    Mesh,
    Polyline,
    PublishedPathLimits,
    RobotModel,
    Shape,
    Sphere,
    Spring,
    StribeckFriction,
    ThermalDcMotor,
    ValveAmplifier,
    VoltageAmplifier,
    beside,
    on_track,
)
from ropsim.nirox import ConformanceClass, ReadNirox, read_nirox, write_nirox
from ropsim.spatial import Pose
from support.built_in import WRITTEN
from support.closed_arms import delta, five_bar, palletizer, two_link_with_cylinders
from support.cylinders import CYLINDER, lifted
from support.cylinders import DRIVE as CYLINDER_DRIVE
from support.nirox_texts import TEXT
from support.trees import random_tree

PAIRS = {
    JointType.REVOLUTE: "REVOLUTE",
    JointType.PRISMATIC: "PRISMATIC",
    JointType.SCREW: "SCREW",
    JointType.CYLINDRICAL: "CYLINDRICAL",
    JointType.UNIVERSAL: "UNIVERSAL",
    JointType.SPHERICAL: "SPHERICAL",
    JointType.PLANAR: "PLANAR",
    JointType.FIXED: "FULLY_CONSTRAINED",
}
PLACE = Pose(np.array([0.1, 0.2, 0.3]), np.array([0.4, 0.3, -0.2, 0.84]))


def read(text: str) -> ReadNirox:
    return read_nirox(SourceText("arm.stp", text))


def again(robot: RobotModel) -> RobotModel:
    """Return a robot that has gone through a file; its text is the same when it is written once more."""
    written = write_nirox(robot)
    assert written.losses == ()
    found = read(written.text)
    assert found.robot is not None, found.findings
    assert not any(one.is_error for one in found.findings)
    assert write_nirox(found.robot, found.further).text == written.text
    return found.robot


@pytest.mark.parametrize("name", WRITTEN)
def test_built_in_robots_come_back_to_the_last_bit(name: str) -> None:
    assert again(robots.load(name)) == robots.load(name)


SPRINGS = (
    Spring("balance", BASE_LINK, np.array([0.1, 0.2, 0.3]), 1, np.array([0.0, -0.1, 0.05]), 2e4, 0.3, 50.0),
    Spring("damper", 0, np.zeros(3), 2, np.array([0.3, 0.0, 0.1]), 0.0, damping=12.5),
)
ON_JOINTS = (JointSpring("return", 1, 30.0, 0.2, 0.5), JointSpring("stop", 0, 1.0 / 3.0))


def test_springs_and_dampers_come_back() -> None:
    robot = replace(robots.load("puma560"), springs=SPRINGS, joint_springs=ON_JOINTS)
    assert again(robot) == robot


def test_points_of_springs_stand_in_the_frames_of_their_links() -> None:
    """A file that describes a link elsewhere than at its joint says its points there, too."""
    robot = replace(robots.load("two_link"), springs=(replace(SPRINGS[0], link_2=1),))
    written = write_nirox(robot).text
    bodies = re.findall(r"#(\d+)=REVOLUTE_PAIR\S*\('[^']*',\*,\$,#\d+,#(\d+)", written)
    moved = re.sub(
        rf"#{bodies[1][1]}=AXIS2_PLACEMENT_3D\('',#\d+",
        f"#{bodies[1][1]}=AXIS2_PLACEMENT_3D('',#9999",
        written,
    ).replace("ENDSEC;\nEND-ISO", "#9999=CARTESIAN_POINT('',(0.5,0.,0.));\nENDSEC;\nEND-ISO")
    found = read(moved)
    assert found.robot is not None, found.findings
    np.testing.assert_allclose(found.robot.springs[0].point_2, SPRINGS[0].point_2 - [0.5, 0.0, 0.0])


@pytest.mark.parametrize("make", [palletizer, two_link_with_cylinders, five_bar, delta])
def test_arms_with_closed_chains_come_back(make: Callable[[], RobotModel]) -> None:
    robot = replace(make(), drives=())
    assert again(robot) == robot


def test_robots_on_a_track_and_beside_a_positioner_come_back() -> None:
    arm = on_track(robots.load("puma560"), robots.linear_track(2.0), PLACE)
    both = replace(
        beside(arm, robots.tilting_turntable(0.4), PLACE), rated_payload=2.5, arm_class=ArmClass.SEVEN_AXIS
    )
    both = replace(both, path_limits=PublishedPathLimits(acceleration=7.0, orientation_jerk=250.0))
    assert both.external == (6, 7, 8)
    assert again(both) == both


def test_an_arm_on_a_gantry_comes_back() -> None:
    robot = on_track(robots.load("scara"), robots.gantry(3.0, 2.0, 1.5))
    assert again(robot) == robot


@pytest.mark.parametrize("seed", range(8))
def test_trees_of_joints_of_all_types_with_couplings_come_back(seed: int) -> None:
    robot = random_tree(seed, 7).robot
    found = again(robot)
    assert found == _symmetric(robot)


def _symmetric(robot: RobotModel) -> RobotModel:
    """Return a robot with the upper halves of its inertias on both sides: products leave rounding in them."""
    links = []
    for link in robot.links:
        upper = np.triu(link.inertia)
        links.append(replace(link, inertia=upper + np.triu(link.inertia, 1).T))
    return replace(robot, links=tuple(links))


@pytest.mark.parametrize(
    "free", [(), (2,), (5,), (2, 5), (3, 4, 5), (0,), (0, 1, 5), (4, 5), (3, 5), (0, 2, 4)]
)
def test_closed_chains_come_back_whatever_they_leave_free(free: tuple[int, ...]) -> None:
    held = tuple(one for place, one in enumerate(ALL_DIRECTIONS) if place not in free)
    robot = replace(random_tree(5, 4).robot, couplings=(), axes=(), home=np.zeros(0), tip=3)
    robot = replace(robot, home=np.zeros(robot.n), links=_symmetric(robot).links)
    cut = LoopCut(-1, PLACE, 3, PLACE.inverse(), held)
    robot = replace(robot, cuts=(cut, replace(cut, first=1 if robot.joints[3].parent != 1 else 0)))
    assert again(robot) == robot


def test_drives_of_all_kinds_and_drawn_things_come_back() -> None:
    robot = robots.load("two_link")
    limited = Drive(
        CurrentLimitedAmplifier(48.0, 9.0),
        DcMotor(0.1, 0.11, 0.9, 1e-3, 2e-4),
        ElasticGear(-80.0, 2e4, 0.0),
        Friction(1e-4, 0.02, -0.03, 0.01),
    )
    plain = replace(limited, amplifier=VoltageAmplifier(48.0, 9.0), friction=Friction(1e-4, 0.02, -0.02))
    shapes = (
        Shape(Mesh("meshes/hand.stl", 0.001), PLACE, "#ff0000", 0.5, Material.STEEL),
        Shape(Mesh("meshes/arm.stl")),
        Shape(Sphere(0.1), PLACE),
        Shape(Polyline(((0.0, 0.0, 0.0), (1.0, 0.0, 0.1)))),
    )
    links = (replace(robot.links[0], shapes=shapes), robot.links[1])
    joints = (replace(robot.joints[0], offset=0.3, lower=-1e-3), robot.joints[1])
    changed = replace(
        robot, drives=(limited, plain), links=links, joints=joints, gravity=np.array([1.0, 0.0, -9.0])
    )
    assert again(changed) == changed


@pytest.mark.parametrize("effort", [0.9, 0.5, inf])
def test_motors_in_current_loops_come_back(effort: float) -> None:
    robot = robots.load("two_link")
    motor = CurrentLoopMotor(0.1, 0.11, 0.9, 1e-3, 2e-4, 48.0, 9.0, 2e3)
    if effort == 0.9:
        effort = motor.torque_constant * motor.max_current
    drive = Drive(EffortAmplifier(effort), motor, Gear(-60.0))
    changed = replace(robot, drives=(drive, robot.drives[1]))
    found = again(changed)
    assert found.drives[0].motor == motor
    own = motor.torque_constant * motor.max_current
    assert found.drives[0].amplifier == EffortAmplifier(min(effort, own))


@pytest.mark.parametrize("rise", [100.0, inf])
def test_motors_that_grow_warm_come_back(rise: float) -> None:
    robot = robots.load("two_link")
    motor = ThermalDcMotor(0.1, 0.11, 0.9, 1e-3, 2e-4, 0.6, 2.4, 20.0, 900.0, 3.9e-3, -2e-3, 30.0)
    drive = Drive(GuardedAmplifier(48.0, 9.0, rise), motor, Gear(-60.0))
    plain = replace(drive, motor=replace(motor, torque_drift=0.0, start_rise=0.0))
    changed = replace(robot, drives=(drive, plain))
    assert again(changed) == changed


def test_motors_with_a_lag_come_back() -> None:
    robot = robots.load("two_link")
    drives = tuple(replace(one, motor=LaggingMotor(1200.0, 0.03)) for one in robot.drives)
    assert again(replace(robot, drives=drives)) == replace(robot, drives=drives)


def test_gears_with_play_come_back() -> None:
    robot = robots.load("two_link")
    gear = BacklashGear(-80.0, 2e4, 3.0, 2e-4)
    changed = replace(robot, drives=tuple(replace(one, transmission=gear) for one in robot.drives))
    assert again(changed) == changed


@pytest.mark.parametrize(
    "law",
    [
        StribeckFriction(1e-4, 0.02, 0.03, 5.0, 1.5, 2e-3),
        LoadFriction(1e-4, 0.02, 0.11),
        LugreFriction(1e-4, 0.02, 0.03, 5.0, 40.0, 0.01),
    ],
)
def test_laws_of_friction_come_back(law: FrictionLaw) -> None:
    robot = robots.load("two_link")
    changed = replace(robot, drives=tuple(replace(one, friction=law) for one in robot.drives))
    assert again(changed) == changed


VALVE = {
    "supply_pressure": 2.1e7,
    "return_pressure": 2e5,
    "bulk_modulus": 1.4e9,
    "rated_flow": 40e-3 / 60.0,
    "rated_pressure_drop": 7e6,
    "rated_input": 0.05,
    "natural_frequency": 630.0,
    "damping_ratio": 0.8,
    "oil_density": 860.0,
}
OIL_MOTOR = HydraulicMotor(2e-4, 3e-4, 1e-12, 0.1, **VALVE)
HYDRAULIC = Drive(
    ValveAmplifier(0.05),
    OIL_MOTOR,
    Gear(-1.5),
    Friction(20.0),
)


def test_hydraulic_drives_come_back() -> None:
    robot = replace(robots.load("two_link"), drives=(HYDRAULIC,) * 2)
    assert again(robot) == robot


def test_vanes_come_back() -> None:
    robot = robots.load("two_link")
    ends = [(-1.5 * one.upper, -1.5 * one.lower) for one in robot.joints]
    vanes = [
        HydraulicVane(2e-4, last - first + 0.1, first - 0.04, 3e-5, 1e-12, 0.1, **VALVE)
        for first, last in ends
    ]
    drives = tuple(replace(HYDRAULIC, motor=one) for one in vanes)
    changed = replace(robot, drives=drives)
    assert again(changed) == changed
    short = replace(vanes[0], swing=0.5)
    found = read(write_nirox(replace(robot, drives=(replace(HYDRAULIC, motor=short), drives[1]))).text)
    assert found.robot is not None
    assert found.robot.drives == ()
    assert any("does not swing over the limits" in one.message for one in found.findings)


def test_edges_of_valves_come_back() -> None:
    motor = replace(OIL_MOTOR, null_flow=2e-5, overlap=0.03)
    robot = replace(robots.load("two_link"), drives=(replace(HYDRAULIC, motor=motor),) * 2)
    assert again(robot) == robot
    assert again(lifted(replace(CYLINDER_DRIVE, motor=replace(CYLINDER, null_flow=1e-5)))).drives[
        0
    ].motor == (replace(CYLINDER, null_flow=1e-5))


@pytest.mark.parametrize(
    ("entity", "words"),
    [
        ("VALVE_NULL_FLOW(#7,1.)", "less than the rated"),
        ("VALVE_NULL_FLOW(#7,0.)", "positive_real"),
    ],
)
def test_a_null_flow_that_cannot_be_is_an_error(entity: str, words: str) -> None:
    text = write_nirox(replace(robots.load("two_link"), drives=(HYDRAULIC,) * 2)).text
    found = re.search(r"#(\d+)=SERVO_VALVE", text)
    assert found
    told = read(
        text.replace("ENDSEC;\nEND-ISO", f"#9999={entity.replace('#7', f'#{found[1]}')};\nENDSEC;\nEND-ISO")
    )
    (error,) = [one for one in told.findings if one.is_error]
    assert words in error.message


def test_an_underlap_is_told_as_lost() -> None:
    text = write_nirox(replace(robots.load("two_link"), drives=(HYDRAULIC,) * 2)).text
    assert ",630.,0.8,0.,0.,$)" in text
    found = read(text.replace(",630.,0.8,0.,0.,$)", ",630.,0.8,-0.02,0.,$)", 1))
    assert found.robot is not None
    assert found.robot.drives[0] == HYDRAULIC
    assert any("underlap" in one.message for one in found.findings)


def test_a_valve_that_never_opens_as_far_as_its_data_say_is_told() -> None:
    weak = replace(HYDRAULIC, amplifier=ValveAmplifier(0.04))
    written = write_nirox(replace(robots.load("two_link"), drives=(weak, HYDRAULIC)))
    assert any("rated current" in (one.hint or "") for one in written.losses)


def test_a_hydraulic_motor_without_a_valve_is_told() -> None:
    text = write_nirox(replace(robots.load("two_link"), drives=(HYDRAULIC,) * 2)).text
    found = read(re.sub(r"(DRIVE_TRAIN\('drive [^']*',#\d+,#\d+,#\d+,)#\d+", r"\1$", text))
    assert found.robot is not None
    assert found.robot.drives == ()
    assert any("servo valve" in one.message for one in found.findings)


def test_cylinders_come_back_with_their_pins() -> None:
    robot = lifted()
    assert again(robot) == robot
    turned = replace(
        robot,
        joints=(
            replace(
                robot.joints[0],
                placement=Pose(np.array([0.1, 0.2, 0.3]), np.array([0.1, 0.7, -0.2, 0.5])),
                offset=0.3,
            ),
        ),
    )
    assert again(turned) == turned
    assert write_nirox(again(turned)).text == write_nirox(turned).text


@pytest.mark.parametrize(
    ("pattern", "by", "words"),
    [
        (r"('linkage 2',)#\d+", r"\1#13", "between the two links"),
        (r"\(0\.26,0\.,-1\.04\)", "(0.29,0.,0.1166)", "in line within the limits"),
        (r"\(0\.30419,-0\.10001,0\.\)", "(0.,0.,0.5)", "a pin lies on the axis"),
        (r",0\.535,", ",0.1,", "does not reach over the limits"),
        (r",0\.82\)", ",1.2)", "does not reach over the limits"),
        (
            r"HYDRAULIC_CYLINDER\([^;]*",
            "HYDRAULIC_ROTARY_MOTOR('m',1.E-4,1.E-4,0.,0.)",
            "moves a joint by a linkage",
        ),
    ],
)
def test_a_linkage_that_turns_no_joint_is_told(pattern: str, by: str, words: str) -> None:
    (drive,) = lifted().drives
    narrow = [replace(one, lower=0.1, upper=1.4) for one in robots.load("two_link").joints]
    text = write_nirox(replace(robots.load("two_link"), joints=tuple(narrow), drives=(drive,) * 2)).text
    changed = re.sub(pattern, by, text)
    assert changed != text
    found = read(changed)
    assert [one.message for one in found.findings if words in one.message], found.findings
    assert found.robot is None or found.robot.drives == ()


def test_a_robot_without_drives_keeps_its_limits() -> None:
    robot = replace(robots.load("scara"), drives=(), origins=())
    assert again(robot) == robot
    assert read(write_nirox(robot).text).conformance is ConformanceClass.CC2


@pytest.mark.parametrize("name", ["scara", "two_link"])
def test_urdf_to_nirox_and_back_has_the_same_poses(name: str) -> None:
    urdf = read_urdf(SourceText("a.urdf", write_urdf(robots.load(name)).text)).robot
    assert urdf is not None
    found = again(urdf)
    for q in np.random.default_rng(1).uniform(-0.5, 0.5, (5, urdf.n)):
        assert forward(found, q) == forward(urdf, q)


def test_the_classes_of_files() -> None:
    robot = robots.load("two_link")
    bare = replace(robot, links=tuple(replace(one, shapes=()) for one in robot.links))
    weightless = replace(bare, links=tuple(replace(one, mass=0.0, com=np.zeros(3)) for one in bare.links))
    rows = [
        (robot, "CC5"),
        (bare, "CC4"),
        (replace(bare, drives=()), "CC2"),
        (replace(weightless, drives=()), "CC1"),
    ]
    for one, name in rows:
        found = read(write_nirox(one).text).conformance
        assert found is not None
        assert found.name == name


def test_a_file_written_by_hand_reads_as_it_says_and_keeps_its_names() -> None:
    found = read(TEXT)
    assert found.findings == ()
    robot = found.robot
    assert robot is not None
    assert (robot.name, robot.title, robot.n) == ("two_links", "Example Two links", 2)
    assert robot.home.tolist() == [0.3, -0.6]
    assert forward(robot, np.zeros(2)).position.tolist() == [0.8, 0.0, 0.0]
    assert [joint.max_speed for joint in robot.joints] == [3.0, 4.0]
    motor = DcMotor(0.1, 0.1, 1.0, 0.001, 0.0001)
    assert robot.drives[0] == Drive(
        VoltageAmplifier(48.0, 10.0), motor, Gear(100.0), Friction(1e-4, 0.02, -0.02)
    )
    text = write_nirox(robot, found.further).text
    for word in (
        "'Example','Two links'",
        "KINEMATIC_LINK('hand')",
        ".CAD.",
        "DRIVE_TRAIN('d1'",
        "('two links',(",
    ):
        assert word in text
    second = read(text)
    assert second.robot == robot
    assert write_nirox(robot, second.further).text == text


def test_joint_types_have_their_pairs() -> None:
    text = "".join(write_nirox(random_tree(seed, 7).robot).text for seed in range(3))
    for type_, word in PAIRS.items():
        assert f"={word}_PAIR" in text, type_
