"""URDF out: the robot that is read back moves and weighs the same, and what is lost is told."""

import re
from dataclasses import replace
from math import radians

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import SourceText
from ropsim.exchange import read_urdf, write_urdf
from ropsim.kinematics import solver_of
from ropsim.model import (
    Coupling,
    ElasticGear,
    FrictionLaw,
    LoadFriction,
    LoopCut,
    Mesh,
    RobotModel,
    Shape,
    StribeckFriction,
    joint_tree,
)
from ropsim.spatial import Pose, frozen, quaternion, roll_pitch_yaw
from support.built_in import WRITTEN
from support.cylinders import lifted
from support.exchange_laws import differences, random_chain

SAME = 1e-12
"""Some ten products of rotations, each rounded [m, N·m over the largest]."""
BUILT_IN = WRITTEN


def again(robot: RobotModel) -> RobotModel:
    found = read_urdf(SourceText("a.urdf", write_urdf(robot).text))
    assert found.robot is not None, found.findings
    return found.robot


@pytest.mark.parametrize("name", BUILT_IN)
def test_a_built_in_robot_comes_back_with_its_motion_its_weight_and_its_solver(name: str) -> None:
    robot = robots.load(name)
    other = again(robot)
    assert max(differences(robot, other)) < SAME
    assert solver_of(other).name == solver_of(robot).name
    assert [one.name for one in other.joints] == [one.name for one in robot.joints]
    for row in (
        "lower_limits",
        "upper_limits",
        "max_speeds",
        "max_accelerations",
        "max_jerks",
        "max_efforts",
    ):
        np.testing.assert_array_equal(getattr(other, row), getattr(robot, row))


@pytest.mark.parametrize("name", ["puma560", "scara", "two_link"])
def test_the_text_of_what_was_read_is_the_text_that_was_written(name: str) -> None:
    text = write_urdf(robots.load(name)).text
    assert write_urdf(again(robots.load(name))).text == text


@pytest.mark.parametrize("seed", range(6))
def test_joints_of_every_type_and_couplings_come_back_as_motion(seed: int) -> None:
    robot = random_chain(seed)
    assert max(differences(robot, again(robot))) < SAME


def test_friction_comes_back_as_it_is_at_the_joints() -> None:
    robot = robots.load("scara")
    for ours, theirs in zip(robot.drives, again(robot).drives, strict=True):
        assert theirs.friction.viscous == pytest.approx(ours.friction.viscous * ours.ratio_at(0.0) ** 2)
        assert theirs.friction.coulomb_positive == pytest.approx(
            ours.friction.coulomb_positive * ours.ratio_at(0.0)
        )


@pytest.mark.parametrize("law", [StribeckFriction(0.01, 0.2, 0.3, 1.0), LoadFriction(0.01, 0.2, 0.1)])
def test_of_other_laws_of_friction_the_viscous_and_the_coulomb_part_goes_over(law: FrictionLaw) -> None:
    robot = robots.load("scara")
    rubbing = replace(robot, drives=tuple(replace(one, friction=law) for one in robot.drives))
    words = [one.message for one in write_urdf(rubbing).losses if one.code == "X994"]
    assert any("friction beyond its viscous and its Coulomb part of axes `1`" in one for one in words)
    for ours, theirs in zip(rubbing.drives, again(rubbing).drives, strict=True):
        ratio = ours.ratio_at(0.0)
        assert theirs.friction.viscous == pytest.approx(0.01 * ratio**2)
        assert theirs.friction.coulomb_positive == pytest.approx(0.2 * abs(ratio))


def test_a_coordinate_that_follows_two_axes_is_two_joints_about_one_line() -> None:
    text = write_urdf(robots.load("palletizer")).text
    mimics = re.findall(r'<joint name="(elbow\w*)"(?:.|\n)*?mimic joint="(\w+)" multiplier="(\S+)"', text)
    assert sorted(mimics) == [("elbow", "2", "-1"), ("elbow_2", "3", "1")]


def test_losses_name_what_is_dropped() -> None:
    words = " ".join(one.message for one in write_urdf(robots.load("puma560")).losses)
    for what in ("rotors of axes `1`", "motor constants", "gear ratios", "cones", "DH table", "numbers come"):
        assert what in words
    assert {one.code for one in write_urdf(robots.load("puma560")).losses} == {"X994", "X995"}


def test_numbers_of_gears_that_twist_and_of_cylinders_are_told_to_be_dropped() -> None:
    puma = robots.load("puma560")
    twisting = replace(puma.drives[0], transmission=ElasticGear(-62.6, 2e4, 1.0))
    words = [one.message for one in write_urdf(replace(puma, drives=(twisting, *puma.drives[1:]))).losses]
    assert any(one.startswith("gear ratios of axes `1`, `2`") for one in words)
    words = [one.message for one in write_urdf(lifted()).losses]
    for what in ("masses of the rods", "valves, oil and supply", "cylinders with their areas"):
        (one,) = (word for word in words if word.startswith(what))
        assert one.endswith(" of axes `lift` do not go over")
    for what in ("gear ratios", "motor constants", "amplifiers", "inertias of the rotors"):
        assert not [one for one in words if one.startswith(what)]


def test_what_urdf_has_no_words_for_is_told() -> None:
    robot = robots.load("two_link")
    sideways = replace(robot, gravity=frozen([9.81, 0.0, 0.0]))
    closed = replace(robot, cuts=(LoopCut(0, Pose(), -1, Pose()),), axes=(0,), home=frozen([0.0]), drives=())
    turned = replace(robot, axes=(1, 0))
    for one, words in ((sideways, "gravity"), (closed, "closed chains"), (turned, "order")):
        assert any(words in loss.message for loss in write_urdf(one).losses if loss.code == "X993"), words
    assert not [loss for loss in write_urdf(robot).losses if loss.code == "X993"]


def test_a_mesh_goes_over_by_its_path_and_scale() -> None:
    robot = robots.load("two_link")
    shape = Shape(Mesh("robots/a.stl", 0.001), Pose(frozen([0.1, 0.0, 0.0])), "#102030", 0.5)
    drawn = replace(robot, links=tuple(replace(link, shapes=(shape,)) for link in robot.links))
    assert again(drawn).links[1].shapes == (shape,)


def test_names_that_xml_has_signs_for_come_back() -> None:
    robot = robots.load("two_link")
    odd = replace(robot, joints=(replace(robot.joints[0], name='a "<&>" ö'), robot.joints[1]))
    assert again(odd).joints[0].name == 'a "<&>" ö'


def test_a_joint_that_never_moves_is_fixed_where_it_stands() -> None:
    robot = robots.load("two_link")
    held = replace(robot, couplings=(Coupling(1, (), 0.4),), axes=(0,), home=frozen([0.0]), drives=())
    assert joint_tree(held).m == 2
    other = again(held)
    assert len(other.joints) == 1
    assert max(differences(held, other)) < SAME


@pytest.mark.parametrize("pitch", [90.0, -90.0, 89.9999999, 0.0, 30.0])
def test_angles_give_the_rotation_in_every_position(pitch: float) -> None:
    rng = np.random.default_rng(3)
    for roll, yaw in rng.uniform(-180.0, 180.0, (20, 2)):
        X = Pose(np.zeros(3), np.array(quaternion.from_zyx(*np.radians([yaw, pitch, roll]))))
        a, b, c = roll_pitch_yaw(X)
        other = Pose(np.zeros(3), np.array(quaternion.from_zyx(c, b, a)))
        np.testing.assert_allclose(other.rotation(), X.rotation(), rtol=0.0, atol=2e-15)
    right = roll_pitch_yaw(Pose(np.zeros(3), np.array(quaternion.from_zyx(0.0, 0.0, radians(90.0)))))
    assert right == (radians(90.0), 0.0, 0.0)
