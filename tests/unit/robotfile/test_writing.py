"""Robots written as robot files: read again they are the same arms."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from ropsim import dynamics, kinematics, robots
from ropsim.core import SourceText
from ropsim.model import (
    Coupling,
    DcMotor,
    EffortAmplifier,
    Joint,
    JointType,
    Link,
    PublishedPathLimits,
    RobotModel,
    coupled_limits,
)
from ropsim.robotfile import read_robot_file, write_robot_file
from ropsim.robotfile.common_normals import common_normals
from ropsim.spatial import Pose
from support.fuzzing.robots import EVERYTHING
from support.published_arms import TABLES, published_arm

ROUNDED = 1e-9
"""Lengths are written to 1e-12 m, angles to 1e-9 degrees, over some metres [m, entries of the rotation]."""


def again(robot: RobotModel) -> RobotModel:
    """Return a robot that was written and read."""
    written = write_robot_file(robot)
    assert written.losses == ()
    read = read_robot_file(SourceText(f"robots/{robot.name}.toml", written.text))
    assert [one.code for one in read.findings] == []
    assert read.robot is not None
    return read.robot


def test_limits_of_tool_paths_come_back() -> None:
    limits = PublishedPathLimits(7.5, 60.0, None, 20.0, None)
    found = again(replace(robots.load("two_link"), path_limits=limits)).path_limits
    assert found is not None
    assert found.given == pytest.approx(limits.given)
    assert again(robots.load("two_link")).path_limits is None


def test_the_rated_payload_comes_back() -> None:
    robot = again(replace(robots.load("two_link"), rated_payload=0.75))
    assert robot.rated_payload == 0.75


def apart(one: RobotModel, other: RobotModel) -> float:
    """Return how far the interfaces of two arms are from each other [m, entries of the rotation]."""
    Q = np.random.default_rng(7).uniform(one.lower_limits, one.upper_limits, (40, one.n))
    return float(np.abs(kinematics.forward_batch(one, Q) - kinematics.forward_batch(other, Q)).max())


@pytest.mark.parametrize("name", ["puma560", "scara", "two_link"])
def test_a_built_in_arm_comes_back_with_masses_drives_and_looks(name: str) -> None:
    robot = robots.load(name)
    copy = again(robot)
    assert apart(robot, copy) < ROUNDED
    assert (copy.drives, copy.origins, copy.title) == (robot.drives, robot.origins, robot.title)
    np.testing.assert_allclose(
        dynamics.mass_matrix(copy, robot.home), dynamics.mass_matrix(robot, robot.home), rtol=1e-9, atol=1e-12
    )
    assert [len(link.shapes) for link in copy.links] == [len(link.shapes) for link in robot.links]
    for one, other in zip(copy.joints, robot.joints, strict=True):
        assert one.max_jerk == pytest.approx(other.max_jerk, rel=1e-9)
        assert (one.name, one.max_effort) == (other.name, other.max_effort)
    assert write_robot_file(copy).text == write_robot_file(robot).text


def test_a_file_of_the_modified_form_comes_back() -> None:
    robot = read_robot_file(SourceText("robots/everything.toml", EVERYTHING)).robot
    assert robot is not None
    copy = again(robot)
    assert apart(robot, copy) < ROUNDED
    assert copy.drives == robot.drives


@pytest.mark.parametrize("name", TABLES)
def test_arms_given_by_frames_get_a_table(name: str) -> None:
    arm = published_arm(name)
    robot = replace(arm, home=np.clip(arm.home, arm.lower_limits, arm.upper_limits))
    assert apart(robot, again(robot)) < ROUNDED


def test_common_normals_of_any_axes_give_the_same_chain() -> None:
    """Skew, meeting, parallel and coinciding axes, turning and sliding, in any order."""
    random = np.random.default_rng(5)
    right = [np.array([1.0, 0.0, 0.0, 0.0]), np.array([1.0, 1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0, 0.0])]
    for _ in range(60):
        joints = []
        for number in range(int(random.integers(1, 8))):
            turn = right[random.integers(3)] if random.random() < 0.6 else random.normal(size=4)
            place = random.normal(size=3) * (random.random() < 0.7)
            type_ = JointType.PRISMATIC if random.random() < 0.3 else JointType.REVOLUTE
            offset = float(random.uniform(-pi, pi)) * (random.random() < 0.5)
            pose = Pose(place, turn / np.linalg.norm(turn))
            joints.append(Joint(str(number), type_, pose, offset, -1.0, 1.0, 1.0, 1.0, 1.0))
        n = len(joints)
        massless = (Link(0.0, np.zeros(3), np.zeros((3, 3))),) * n
        robot = RobotModel(
            "r", "r", tuple(joints), massless, (), np.zeros(n), X_nM=Pose(random.normal(size=3))
        )
        assert apart(robot, again(robot)) < ROUNDED
        first = common_normals(joints).rows[0]
        assert (first.a, first.alpha, first.d, first.theta) == (0.0, 0.0, 0.0, 0.0)


def test_what_a_file_cannot_say_is_told() -> None:
    ball = Joint("ball", JointType.SPHERICAL, Pose(), 0.0, -1.0, 1.0, 1.0, 1.0, 1.0)
    hinge = Joint("hinge", JointType.REVOLUTE, Pose(), 0.0, -1.0, 1.0, 1.0, 1.0, 1.0)
    links = (Link(0.0, np.zeros(3), np.zeros((3, 3))),) * 2
    follow = tuple(Coupling(number, ((3, 1.0),)) for number in range(3))
    written = write_robot_file(
        RobotModel("r", "r", (ball, hinge), links, (), np.zeros(1), axes=(1,), couplings=follow)
    )
    assert written.text == ""
    assert [one.code for one in written.losses] == ["X908"]
    puma = robots.load("puma560")
    odd = replace(puma.drives[0], amplifier=EffortAmplifier())
    assert isinstance(odd.motor, DcMotor)
    written = write_robot_file(replace(puma, drives=(odd, *puma.drives[1:])))
    assert [one.code for one in written.losses] == ["X908"]
    read = read_robot_file(SourceText("robots/a.toml", written.text))
    assert read.robot is not None
    assert read.robot.drives == ()


def test_an_arm_with_a_rod_comes_back_without_the_drawn_bodies_and_says_so() -> None:
    robot = robots.load("irb2400_16")
    written = write_robot_file(robot)
    (told,) = written.losses
    assert (told.code, told.message) == (
        "X908",
        "rods and cranks of `irb2400_16` that only follow its axes are not drawn: `rod`, `3`",
    )
    copy = read_robot_file(SourceText("robots/irb2400.toml", written.text)).robot
    assert copy is not None
    assert apart(robot, copy) < ROUNDED
    assert coupled_limits(copy).lower == pytest.approx(coupled_limits(robot).lower)
    heavy = replace(robot, links=(*robot.links[:-1], replace(robot.links[-1], mass=5.0)))
    assert 'convention = "frames"' in write_robot_file(heavy).text


def test_a_crane_comes_back_with_its_cylinders() -> None:
    crane = robots.load("patu655")
    assert again(crane).drives == crane.drives
