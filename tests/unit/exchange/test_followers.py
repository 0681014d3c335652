"""Joints that follow others, which follow others again: where they stand, and what they leave alone."""

from math import cos, sin

import numpy as np
import pytest

from ropsim.core import SourceText
from ropsim.exchange import read_urdf
from ropsim.kinematics import forward
from ropsim.model import WITHOUT_END, RobotModel

EXACT = 1e-14
WEIGHT = '<inertial><mass value="1"/><inertia ixx=".1" iyy=".1" izz=".1" ixy="0" ixz="0" iyz="0"/></inertial>'


def read(text: str) -> RobotModel:
    found = read_urdf(SourceText("arm.urdf", text))
    assert found.robot is not None, found.findings
    return found.robot


def joint(name: str, parent: str, child: str, x: float, mimic: str = "", limits: str = "-9 9") -> str:
    """Return a joint about z at a distance x from its parent, with its empty child."""
    lower, upper = limits.split()
    return (
        f'<joint name="{name}" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{x} 0 0"/><axis xyz="0 0 1"/>{mimic}'
        f'<limit lower="{lower}" upper="{upper}" velocity="9" effort="100"/></joint>'
    )


@pytest.mark.parametrize(("followed", "c"), [("B", 1.0), ("A", 2.0)])
def test_a_follower_at_the_place_of_another_stays_where_a_third_one_follows_it(
    followed: str, c: float
) -> None:
    """B = A/2, C = 2·A or 2·B = c·A at the same place behind an empty link, D = C."""
    robot = read(
        f'<robot name="r"><link name="base"/><link name="l1">{WEIGHT}</link><link name="l2"/>'
        f'<link name="l3">{WEIGHT}</link><link name="l4"/>'
        + joint("A", "base", "l1", 0.0, limits="-1 1")
        + joint("B", "l1", "l2", 1.0, '<mimic joint="A" multiplier="0.5"/>')
        + joint("C", "l2", "l3", 0.0, f'<mimic joint="{followed}" multiplier="2"/>')
        + joint("D", "l3", "l4", 1.0, '<mimic joint="C"/>')
        + "</robot>"
    )
    assert robot.n == 1
    q = 0.3
    before, last = q * (1.0 + 0.5 + c), q * (1.0 + 0.5 + 2.0 * c)
    X = forward(robot, [q])
    np.testing.assert_allclose(X.position, [cos(q) + cos(before), sin(q) + sin(before), 0.0], atol=EXACT)
    np.testing.assert_allclose(X.rotation()[:2, 0], [cos(last), sin(last)], atol=EXACT)


def test_a_follower_of_a_resting_joint_rests_with_its_offset() -> None:
    """Of two fingers beside the way to the tip the second one stands at 0.2·0.1 + 0.03."""
    slide = (
        '<joint name="{}" type="prismatic"><parent link="arm"/><child link="{}"/><axis xyz="0 0 1"/>{}'
        '<limit lower="{}" upper="0.5" velocity="1" effort="9"/></joint>'
    )
    robot = read(
        f'<robot name="r"><link name="base"/><link name="arm">{WEIGHT}</link><link name="tool0"/>'
        f'<link name="left"/><link name="right">{WEIGHT}</link>'
        + joint("A", "base", "arm", 0.0, limits="-1 1")
        + '<joint name="f" type="fixed"><parent link="arm"/><child link="tool0"/></joint>'
        + slide.format("L", "left", "", 0.1)
        + slide.format("R", "right", '<mimic joint="L" multiplier="0.2" offset="0.03"/>', 0)
        + "</robot>"
    )
    assert robot.n == 1
    assert robot.links[0].com == pytest.approx([0.0, 0.0, 0.5 * (0.2 * 0.1 + 0.03)], abs=EXACT)


def test_a_follower_that_slides_needs_no_range_of_its_own() -> None:
    """Files give followers the limits 0 and 0: where they stand follows from their leaders."""
    robot = read(
        f'<robot name="r"><link name="base"/><link name="arm">{WEIGHT}</link>'
        f'<link name="tool0">{WEIGHT}</link>'
        + joint("A", "base", "arm", 0.0, limits="-1 1")
        + '<joint name="B" type="prismatic"><parent link="arm"/><child link="tool0"/><axis xyz="0 0 1"/>'
        '<mimic joint="A" multiplier="0.1"/><limit lower="0" upper="0" velocity="1" effort="9"/></joint>'
        "</robot>"
    )
    assert (robot.joints[1].lower, robot.joints[1].upper) == (-WITHOUT_END, WITHOUT_END)
    assert forward(robot, [0.5]).position[2] == pytest.approx(0.05, abs=EXACT)


ROOM = np.radians(2.0)
"""To a limit, in a rest position that no file says."""


@pytest.mark.parametrize(
    ("limits", "home"),
    [("-1 1", 0.0), ("0.2 1", 0.2 + ROOM), ("-1 -0.4", -0.4 - ROOM), ("0.3 0.5", 0.3 + ROOM)],
)
def test_the_rest_position_is_as_near_to_zero_as_the_limits_allow(limits: str, home: float) -> None:
    robot = read(
        '<robot name="r"><link name="base"/><link name="tool0"/>'
        + joint("A", "base", "tool0", 0.0, limits=limits)
        + "</robot>"
    )
    assert robot.home.tolist() == pytest.approx([home], abs=EXACT)
