"""Robot files of frames: mechanisms of all kinds come back, and mistakes are named with their line."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import SourceText
from ropsim.kinematics import frames_batch, joint_motion
from ropsim.model import (
    ALL_DIRECTIONS,
    BASE_LINK,
    Direction,
    JointSpring,
    JointType,
    LoopCut,
    OriginKind,
    ParameterOrigin,
    RobotModel,
    Spring,
)
from ropsim.robotfile import read_robot_file, write_robot_file
from support.closed_arms import (
    COUPLED_PALLETIZER,
    delta,
    five_bar,
    palletizer,
    six_axis_with_cylinders,
    two_link_with_cylinders,
)
from support.trees import random_tree

ROUNDED = 1e-10  # millimetres and degrees have nine digits behind the point
SOURCE = (ParameterOrigin("all numbers", OriginKind.ESTIMATED, "a test"),)
SPRINGS = (
    Spring("balance", BASE_LINK, np.array([0.1, 0.2, 0.3]), 1, np.array([0.0, -0.1, 0.05]), 2e4, 0.3, 50.0),
)


def again(robot: RobotModel) -> RobotModel:
    """Return a robot that has gone through a file; its text is the same when it is written once more."""
    written = write_robot_file(replace(robot, origins=SOURCE))
    assert written.losses == ()
    found = read_robot_file(SourceText("robots/arm.toml", written.text))
    assert found.robot is not None, found.findings
    assert write_robot_file(found.robot).text == written.text
    return found.robot


def assert_same(robot: RobotModel, copy: RobotModel) -> None:
    """Assert that two robots have the same structure, and their bodies the same places."""
    assert [one.type for one in copy.joints] == [one.type for one in robot.joints]
    assert [one.parent for one in copy.joints] == [one.parent for one in robot.joints]
    assert (copy.axes, copy.tip) == (robot.axes, robot.tip)
    assert [cut.held for cut in copy.cuts] == [cut.held for cut in robot.cuts]
    rows = robot.home + np.random.default_rng(1).uniform(-0.01, 0.01, (5, robot.n))
    np.testing.assert_allclose(frames_batch(copy, rows), frames_batch(robot, rows), atol=100.0 * ROUNDED)
    found, expected = (joint_motion(one, rows, rows) for one in (copy, robot))
    np.testing.assert_allclose(found.speed, expected.speed, atol=1e4 * ROUNDED)
    for one, other in zip(copy.links, robot.links, strict=True):
        assert one.mass == other.mass
        np.testing.assert_allclose(one.com, other.com, atol=ROUNDED)
        np.testing.assert_allclose(one.inertia, other.inertia, atol=ROUNDED)


@pytest.mark.parametrize(
    "make", [palletizer, two_link_with_cylinders, five_bar, delta, six_axis_with_cylinders]
)
def test_arms_with_closed_chains_come_back(make: Callable[[], RobotModel]) -> None:
    robot = make()
    assert_same(robot, again(robot))


def test_couplings_and_branches_come_back() -> None:
    assert_same(COUPLED_PALLETIZER, again(COUPLED_PALLETIZER))
    assert again(COUPLED_PALLETIZER).couplings == COUPLED_PALLETIZER.couplings
    assert again(COUPLED_PALLETIZER).drives == COUPLED_PALLETIZER.drives


def test_random_trees_come_back() -> None:
    kinds: set[JointType] = set()
    for seed in range(30):
        robot = random_tree(seed, 6).robot
        copy = write_robot_file(replace(robot, origins=SOURCE, drives=()))
        if copy.text:
            kinds |= {joint.type for joint in robot.joints}
            assert_same(replace(robot, drives=()), again(replace(robot, drives=())))
    assert len(kinds) >= 3


@pytest.mark.parametrize("robot", [two_link_with_cylinders(), robots.load("puma560")])
def test_springs_come_back(robot: RobotModel) -> None:
    on_joints = (JointSpring("return", 1, 30.0, 0.25, 0.5), JointSpring("damper", 0, 0.0, 0.0, 3.0))
    copy = again(replace(robot, springs=SPRINGS, joint_springs=on_joints))
    (spring,) = copy.springs
    assert (spring.link_1, spring.link_2, spring.stiffness, spring.damping) == (BASE_LINK, 1, 2e4, 50.0)
    np.testing.assert_allclose(spring.point_2, SPRINGS[0].point_2, atol=ROUNDED)
    assert [one.coordinate for one in copy.joint_springs] == [1, 0]
    np.testing.assert_allclose(copy.joint_springs[0].rest, 0.25, atol=ROUNDED)


@pytest.mark.parametrize(
    "held", [ALL_DIRECTIONS[:5], ALL_DIRECTIONS[:3], (Direction.X, Direction.Y, Direction.ABOUT_X)]
)
def test_all_directions_that_a_loop_holds_come_back(held: tuple[Direction, ...]) -> None:
    robot = five_bar()
    (cut,) = robot.cuts
    made = again(replace(robot, cuts=(LoopCut(cut.first, cut.X_first, cut.second, cut.X_second, held),)))
    assert made.cuts[0].held == held


TEXT = """convention = "frames"
axes = ["left"]
home = [30]
joints = [
  { name = "left", position = [-200, 0, 0], limits = [-170, 170] },
  { name = "elbow", position = [350, 0, 0] },
  { name = "right", on = "base", position = [200, 0, 0], limits = [-170, 170] },
]
[[loops]]
first = { on = "elbow", position = [450, 0, 0] }
second = { on = "right", position = [450, 0, 0] }
joint = "revolute"
"""


@pytest.mark.parametrize(
    ("before", "after", "code", "words"),
    [
        ('axes = ["left"]', 'axes = ["lefd"]', "X927", "axis `lefd`"),
        ('axes = ["left"]', 'axes = "left"', "X804", "`axes`"),
        ('on = "base"', 'on = "hand"', "X927", "body `hand`"),
        ('{ name = "left", ', '{ name = "left", on = "elbow", ', "X927", "body `elbow`"),
        ('{ on = "elbow"', '{ on = "elbows"', "X927", "body `elbows`"),
        ('joint = "revolute"', 'joint = "ball"', "X808", "`loops.joint`"),
        ('joint = "revolute"', 'joint = "revolute"\nholds = ["x"]', "X812", "both say"),
        ('joint = "revolute"', 'holds = ["u"]', "X804", "`loops.holds`"),
        ('first = { on = "elbow", position = [450, 0, 0] }', "", "X803", "`first`"),
        (
            '{ name = "elbow", ',
            '{ name = "elbow", follows = { lefd = 1 }, ',
            "X927",
            "joint `lefd` to follow",
        ),
        ('{ name = "elbow", ', '{ name = "elbow", type = "screw", ', "X803", "`lead`"),
        ('{ on = "right", position', '{ on = "elbow", position', "X837", "cut 1"),
    ],
)
def test_mistakes_are_named(before: str, after: str, code: str, words: str) -> None:
    assert not any(one.is_error for one in read_robot_file(SourceText("robots/a.toml", TEXT)).findings)
    assert before in TEXT
    found = read_robot_file(SourceText("robots/a.toml", TEXT.replace(before, after)))
    assert found.robot is None
    mine = [one for one in found.findings if one.code == code]
    assert mine, [(one.code, one.message) for one in found.findings]
    assert words in mine[0].message
    assert (mine[0].span is None) == (code == "X837")
