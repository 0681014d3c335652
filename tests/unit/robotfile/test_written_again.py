"""A robot file that was written is read again as the same arm; what its reader refuses is not written."""

from dataclasses import replace
from math import inf, pi, tau
from typing import Any

import numpy as np
import pytest

from ropsim import kinematics, robots
from ropsim.core import SourceText
from ropsim.model import (
    WITHOUT_END,
    ArmClass,
    EffortAmplifier,
    Friction,
    IdealMotor,
    Joint,
    JointType,
    Link,
    RobotModel,
    coupled_limits,
    ideal_drive,
)
from ropsim.robotfile import read_robot_file, write_robot_file
from ropsim.robotfile.drawn_bodies import without_drawn_bodies
from ropsim.spatial import Array, Pose

NEAR = 1e-8
"""Lengths are written to 1e-12 m, angles to 1e-9 degrees, over some metres; relative and absolute."""

BRANCHED = {"irb460_110_240", "irb660_180_315", "m410ib_700", "palletizer"}
"""Built-in arms that a table does not say."""


def again(robot: RobotModel) -> RobotModel:
    """Return a robot that was written and read."""
    written = write_robot_file(robot)
    assert written.text, written.losses
    read = read_robot_file(SourceText(f"robots/{robot.name}.toml", written.text))
    assert read.robot is not None
    return read.robot


def weights(robot: RobotModel) -> Array:
    """Return masses, centres and inertias of the moving links in the base frame, in three postures."""
    Q = np.random.default_rng(3).uniform(-1.0, 1.0, (3, robot.n))
    rows = []
    for frames in kinematics.frames_batch(robot, Q):
        for X, link in zip(frames, robot.links, strict=False):
            R = X[:3, :3]
            com = X[:3, 3] + R @ link.com if link.mass else np.zeros(3)
            rows.append([link.mass, *com, *(R @ link.inertia @ R.T).ravel()])
    return np.array(rows)


def limits(robot: RobotModel) -> Array:
    kept = ("lower", "upper", "max_speed", "max_acceleration", "max_jerk", "max_effort")
    return np.array([[getattr(joint, name) for name in kept] for joint in robot.axis_joints])


def assert_same(robot: RobotModel, copy: RobotModel) -> None:
    """Make sure that two arms move, weigh and are driven alike."""
    Q = np.random.default_rng(7).uniform(-pi, pi, (6, robot.n))
    near: Any = {"rtol": NEAR, "atol": NEAR}
    np.testing.assert_allclose(
        kinematics.forward_batch(copy, Q), kinematics.forward_batch(robot, Q), atol=NEAR, rtol=0.0
    )
    np.testing.assert_allclose(limits(copy), limits(robot), **near)
    np.testing.assert_allclose(copy.home, robot.home, **near)
    np.testing.assert_allclose(weights(copy), weights(robot), **near)
    np.testing.assert_array_equal(copy.gravity, robot.gravity)
    np.testing.assert_allclose(coupled_limits(copy).lower, coupled_limits(robot).lower, **near)
    names = [[(joint.name, joint.type) for joint in one.joints] for one in (robot, copy)]
    assert names[0] == names[1]
    for what in ("name", "title", "drives", "rated_payload", "arm_class"):
        assert getattr(copy, what) == getattr(robot, what), what


@pytest.mark.parametrize("name", sorted({*robots.names()} - BRANCHED))
def test_a_built_in_arm_comes_back(name: str) -> None:
    robot = without_drawn_bodies(robots.load(name)).robot
    assert_same(robot, again(robot))


def random_limits(random: np.random.Generator, type_: JointType) -> tuple[float, float]:
    """Return limits: without end, of many turns, or of a usual joint."""
    kind = random.integers(4)
    if type_ is JointType.REVOLUTE and kind == 0:
        return -WITHOUT_END, WITHOUT_END
    if type_ is JointType.REVOLUTE and kind == 1:
        return float(random.uniform(-300.0 * tau, 1.0)), float(random.uniform(2.0 * tau, 400.0 * tau))
    return float(random.uniform(-3.0, 0.0)), float(random.uniform(0.1, 3.0))


def random_joint(random: np.random.Generator, number: int) -> Joint:
    type_ = JointType.PRISMATIC if random.random() < 0.2 else JointType.REVOLUTE
    turn = random.normal(size=4)
    pose = Pose(random.normal(size=3) * (random.random() < 0.8), turn / np.linalg.norm(turn))
    offset = float(random.uniform(-pi, pi)) * (random.random() < 0.5)
    speed, acceleration, jerk = 10.0 ** random.uniform([-2, -1, 0], [1, 3, 5])
    effort = float(random.uniform(1.0, 1e4)) if random.random() < 0.7 else inf
    rest = (*random_limits(random, type_), float(speed), float(acceleration), float(jerk), effort)
    return Joint(f"axis {number}", type_, pose, offset, *rest)


def random_link(random: np.random.Generator) -> Link:
    turned = np.linalg.qr(random.normal(size=(3, 3)))[0]
    a, b = random.uniform(0.01, 1.0, 2)
    inertia = turned @ np.diag([a, b, (a + b) * random.uniform(0.6, 1.0)]) @ turned.T
    mass = float(10.0 ** random.uniform(-1.0, 3.0))
    return Link(mass, 0.3 * random.normal(size=3), (inertia + inertia.T) / 2.0)


def random_arm(seed: int) -> RobotModel:
    """Return an arm of one to seven joints in any order, half of them with masses and drives."""
    random = np.random.default_rng(seed)
    joints = tuple(random_joint(random, number) for number in range(int(random.integers(1, 8))))
    n = len(joints)
    driven = random.random() < 0.5
    links = tuple(random_link(random) for _ in joints) if driven else (massless(),) * n
    friction = Friction(*random.uniform([0.0, 0.0, -2.0], [2.0, 2.0, 0.0]).tolist())
    motor = IdealMotor(float(random.uniform(0.0, 1.0)))
    drive = replace(ideal_drive(float(random.uniform(1.0, 100.0))), motor=motor, friction=friction)
    return RobotModel(
        f"arm {seed}",
        "an arm",
        joints,
        links,
        (drive,) * n if driven else (),
        np.array([random.choice([joint.lower, joint.upper, 0.5 * joint.upper]) for joint in joints]),
        gravity=random.normal(size=3) * 9.81 if random.random() < 0.5 else np.array([0.0, 0.0, -9.81]),
        X_nM=Pose(random.normal(size=3)),
        rated_payload=float(random.uniform(1.0, 100.0)) if random.random() < 0.5 else inf,
        arm_class=ArmClass.COBOT if random.random() < 0.3 else None,
    )


def massless() -> Link:
    return Link(0.0, np.zeros(3), np.zeros((3, 3)))


@pytest.mark.parametrize("first", range(0, 200, 20))
def test_random_arms_come_back(first: int) -> None:
    for seed in range(first, first + 20):
        robot = random_arm(seed)
        assert_same(robot, again(robot))


def test_gravity_and_endless_joints_have_their_own_words() -> None:
    two = robots.load("two_link")
    first = replace(two.joints[0], lower=-WITHOUT_END, upper=WITHOUT_END)
    second = replace(two.joints[1], lower=-tau, upper=2.5 * tau)
    text = write_robot_file(replace(two, joints=(first, second), gravity=np.array([9.81, 0.0, 0.0]))).text
    assert 'limits = "endless"' in text
    assert "limits = { turns = [-1, 2.5] }" in text
    assert "gravity = [9.81, 0, 0]" in text
    assert "gravity" not in write_robot_file(two).text


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"max_speed": 1e6}, "at joint `2`: `joints.speed` is 5.72958e+07 deg/s, allowed is"),
        ({"max_speed": 1e-7}, "at joint `2`: `joints.speed` is 5.72958e-06 deg/s, allowed is"),
        ({"placement": Pose(np.array([1000.0, 0.0, 0.0]))}, "`joints.a` is 1e+06 mm, allowed is"),
        (
            {"lower": -1000.0 * tau},
            "at joint `2`: item 1 of `joints.limits.turns` is -1000 turns, allowed is",
        ),
        ({"max_effort": 1e9}, "at joint `2`: `joints.effort` is 1e+09"),
    ],
)
def test_an_arm_that_would_not_be_read_again_is_not_written(change: dict[str, Any], words: str) -> None:
    two = replace(robots.load("two_link"), dh=())
    written = write_robot_file(replace(two, joints=(two.joints[0], replace(two.joints[1], **change))))
    assert written.text == ""
    assert [one.code for one in written.losses] == ["X908"]
    assert words in written.losses[0].message
    assert ".stp" in written.losses[0].hint


def test_a_link_that_is_too_heavy_is_named_by_its_joint() -> None:
    two = robots.load("two_link")
    heavy = replace(two, links=(two.links[0], replace(two.links[1], mass=1e6)))
    (told,) = write_robot_file(heavy).losses
    assert "at joint `2`: `links.mass` is 1e+06 kg, allowed is" in told.message
    wrong = replace(two.drives[1], amplifier=EffortAmplifier(1e12), motor=IdealMotor())
    (told,) = write_robot_file(replace(two, drives=(wrong,) * 2)).losses[:1]
    assert "at joint `1`: `drives.max_torque`" in told.message
