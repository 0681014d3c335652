"""What stands in for missing shapes: rods from joint to joint, brackets from the interface to the TCP."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.model import Box, Cylinder, Gripper, Part, Shape, Tool, grip_width, tool_shapes
from ropsim.spatial import Array, Pose, frozen
from ropsim.views.testing import base_shapes, link_shapes, reach
from support.arms import random_arm
from support.cells import one_station

TOUCH = 1e-9  # [m]
ASIDE = Pose(frozen([-0.16, 0.0, 0.06]), frozen([np.sqrt(0.5), 0.0, -np.sqrt(0.5), 0.0]))


def ends(shape: Shape) -> Array:
    """Return the middles of both faces of a rod [m], shape (2, 3)."""
    assert isinstance(shape.solid, Cylinder)
    half = shape.solid.length / 2.0
    return np.array([(shape.pose.matrix() @ [0.0, 0.0, side * half, 1.0])[:3] for side in (-1.0, 1.0)])


@pytest.mark.parametrize("seed", range(5))
def test_a_link_without_shapes_reaches_from_its_joint_to_the_next(seed: int) -> None:
    robot = random_arm(seed, "RPRRPR")
    for number in range(1, robot.n + 1):
        shapes = link_shapes(robot, number)
        after = robot.joints[number].placement if number < robot.n else robot.X_nM
        assert ends(shapes[-1]) == pytest.approx(np.array([np.zeros(3), after.position]), abs=TOUCH)


def test_the_bar_of_a_sliding_joint_reaches_its_guide_over_the_whole_stroke() -> None:
    robot = random_arm(1, "RP")
    joint = replace(robot.joints[1], lower=-0.2, upper=0.7, offset=0.1)
    robot = replace(robot, joints=(robot.joints[0], joint))
    bar = link_shapes(robot, 2)[1]
    assert sorted(ends(bar)[:, 2]) == pytest.approx([-0.8, 0.1], abs=TOUCH)  # guide at -(q + offset)


def test_hubs_lie_along_the_axes_and_shrink_towards_the_tip() -> None:
    robot = random_arm(2, "RRRR")
    radii = []
    for number in range(2, robot.n + 1):
        hub = link_shapes(robot, number)[0]
        assert ends(hub)[:, :2] == pytest.approx(np.zeros((2, 2)), abs=TOUCH)
        assert isinstance(hub.solid, Cylinder)
        radii.append(hub.solid.radius)
    assert radii == sorted(radii, reverse=True)
    assert len(set(radii)) == len(radii)


def test_shapes_of_the_model_come_before_stand_ins() -> None:
    robot = robots.load("puma560")
    assert link_shapes(robot, 2) == robot.links[1].shapes
    assert base_shapes(robot) == robot.base_shapes


def test_a_base_without_shapes_reaches_the_first_joint() -> None:
    robot = random_arm(3, "RR")
    assert ends(base_shapes(robot)[-1])[1] == pytest.approx(robot.joints[0].placement.position, abs=TOUCH)


def test_the_reach_of_the_puma_is_counted_from_its_shoulder() -> None:
    centre, radius = reach(robots.load("puma560"))
    assert centre == pytest.approx([0.0, 0.0, 0.67183], abs=TOUCH)
    assert radius == pytest.approx(0.4318 + np.hypot(0.0203, 0.15005) + 0.4318, abs=TOUCH)


def test_a_tip_runs_through_the_tcp() -> None:
    shapes = tool_shapes(Tool("pen", ASIDE), 0.04)
    assert ends(shapes[0])[0] == pytest.approx(np.zeros(3), abs=TOUCH)
    assert ends(shapes[-1])[1] == pytest.approx(ASIDE.position, abs=TOUCH)
    approach = np.diff(ends(shapes[-1]), axis=0)[0]
    assert approach / np.linalg.norm(approach) == pytest.approx(ASIDE.rotation()[:, 2], abs=1e-9)


def test_fingers_stand_as_far_apart_as_asked_and_hold_the_tcp_between_them() -> None:
    shapes = tool_shapes(Tool("jaws", ASIDE, gripper=Gripper(0.1, 0.1, 0.005)), 0.06)
    left, right = shapes[-2:]
    assert isinstance(left.solid, Box)
    assert isinstance(right.solid, Box)
    apart = ASIDE.rotation().T @ (left.pose.position - right.pose.position)
    assert abs(apart[1]) - left.solid.size[1] == pytest.approx(0.06, abs=TOUCH)
    assert apart[[0, 2]] == pytest.approx([0.0, 0.0], abs=TOUCH)
    for finger, solid in ((left, left.solid), (right, right.solid)):
        in_tool = ASIDE.rotation().T @ (finger.pose.position - ASIDE.position)
        assert in_tool[2] + solid.size[2] / 2 > 0.0 > in_tool[2] - solid.size[2] / 2


def test_a_tool_at_the_interface_needs_no_bracket() -> None:
    assert tool_shapes(Tool("bare"), 0.04) == ()


def test_the_narrowest_part_tells_the_width_of_the_grip() -> None:
    cell = one_station("c", robots.load("puma560"), robots.default_controller("puma560"))
    parts = tuple(
        Part(f"p{k}", frozen(size), 0.1, Pose())
        for k, size in enumerate(([0.3, 0.2, 0.01], [0.08, 0.07, 0.2]))
    )
    assert grip_width(replace(cell, parts=parts)) == pytest.approx(0.07)
    assert grip_width(cell) == pytest.approx(0.04)
