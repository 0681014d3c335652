"""Volumes that have a closed form, each within the error that is stated."""

from dataclasses import replace
from math import cos, pi

import numpy as np
import pytest

from ropsim import robots
from ropsim.model import Joint, JointType, RobotModel
from ropsim.spatial import Array, Pose
from ropsim.workspace import (
    PointKind,
    Reachable,
    Resolution,
    SweepKind,
    WorkspaceError,
    moved_point,
    reachable,
)

RELATIVE = 0.01
"""Largest error that may be stated, as a share of the volume."""
ABOUT_X, ABOUT_Y = (0.5, 0.5, 0.5, 0.5), (0.7071067811865476, -0.7071067811865476, 0.0, 0.0)
"""Turns that take z to x, and z to y."""


def arm(
    *joints: tuple[str, tuple[float, ...], tuple[float, ...], float, float], tip: float = 0.0
) -> RobotModel:
    """Return an arm of joints: type, origin [m] and turn against the one before, limits; tip along x [m]."""
    kinds = {"R": JointType.REVOLUTE, "P": JointType.PRISMATIC}
    made = tuple(
        Joint(str(k + 1), kinds[kind], Pose(np.array(p), np.array(turn)), 0.0, lower, upper, 1.0, 1.0, 1.0)
        for k, (kind, p, turn, lower, upper) in enumerate(joints)
    )
    middles = (0.5 * (one.lower + one.upper) for one in made)
    home = np.array([middle if np.isfinite(middle) else 0.0 for middle in middles])
    return RobotModel("made", "an arm", made, (), (), X_nM=Pose(np.array([tip, 0.0, 0.0])), home=home)


STRAIGHT = (1.0, 0.0, 0.0, 0.0)
BASE = (0.0, 0.0, 0.0)


COARSE = Resolution(150, 20_000)


def flange(robot: RobotModel, resolution: Resolution = COARSE) -> Reachable:
    return reachable(robot, moved_point(robot, PointKind.FLANGE), resolution)


def assert_is(found: Reachable, exact: float) -> None:
    assert abs(found.volume - exact) <= found.error
    assert found.error <= RELATIVE * exact


@pytest.mark.parametrize("across", [100, 200])
def test_a_planar_arm_reaches_a_sector_of_a_ring(across: int) -> None:
    """∫∫ l1·l2·sin q2 dq1 dq2, the Jacobian determinant of the arm, over the ranges."""
    first, last = 0.3, 2.4
    robot = arm(("R", BASE, STRAIGHT, -1.0, 1.5), ("R", (0.7, 0.0, 0.0), STRAIGHT, first, last), tip=0.4)
    found = flange(robot, Resolution(across, 20_000))
    assert found.sweep.kind is SweepKind.FLAT
    assert_is(found, 2.5 * 0.7 * 0.4 * (cos(first) - cos(last)))


def test_a_scara_with_one_elbow_reaches_a_sector_of_a_cylinder() -> None:
    robot = robots.load("scara")
    joints = list(robot.joints)
    joints[1] = replace(joints[1], lower=0.2, upper=2.5)
    found = flange(replace(robot, joints=tuple(joints)))
    reach = robot.upper_limits[0] - robot.lower_limits[0]
    assert_is(found, 0.21 * reach * 0.325 * 0.275 * (cos(0.2) - cos(2.5)))


def test_both_elbows_of_a_scara_reach_what_either_does() -> None:
    """At radius r the two elbows stand ψ(r) to both sides, so that the arcs that they reach overlap."""
    robot = robots.load("scara")
    a, b, reach = 0.325, 0.275, robot.upper_limits[0] - robot.lower_limits[0]
    bend = np.linspace(0.0, robot.upper_limits[1], 20_001)
    radius = np.sqrt(a * a + b * b + 2.0 * a * b * np.cos(bend))
    beside = np.arctan2(b * np.sin(bend), a + b * np.cos(bend))
    arc = np.minimum(reach + 2.0 * beside, 2.0 * pi)
    area = float((0.5 * (arc[1:] + arc[:-1]) * 0.5 * (radius[:-1] ** 2 - radius[1:] ** 2)).sum())
    assert_is(flange(robot), 0.21 * area)


def test_a_gantry_reaches_a_box() -> None:
    robot = arm(
        ("P", BASE, ABOUT_X, -0.2, 0.9), ("P", BASE, STRAIGHT, 0.0, 1e-12), ("P", BASE, ABOUT_Y, 0.1, 0.8),
        ("P", (0.0, 0.0, 0.0), ABOUT_X, -0.5, 0.0),
    )  # fmt: skip
    found = flange(robot)
    assert found.sweep.kind is SweepKind.SLIDE
    sides = abs(np.linalg.det(_directions(robot)))
    assert_is(found, sides * 1.1 * 0.7 * 0.5)


def test_a_disc_that_is_turned_makes_a_torus() -> None:
    """Pappus: 2π·a·πb² for the disc of radius b around a circle of radius a."""
    robot = arm(
        ("R", BASE, STRAIGHT, -pi, pi), ("R", (0.6, 0.0, 0.0), ABOUT_Y, -pi, pi),
        ("P", BASE, ABOUT_X, 0.0, 0.25),
    )  # fmt: skip
    assert_is(flange(robot), 2.0 * pi * pi * 0.6 * 0.25**2)


def test_a_narrow_first_axis_gives_separate_sectors() -> None:
    """A first axis of 0.5 rad: the two elbows of a SCARA sweep sectors that lie apart."""
    robot = arm(
        ("R", BASE, STRAIGHT, -0.25, 0.25), ("R", (0.5, 0.0, 0.0), STRAIGHT, -2.6, 2.6),
        ("P", (0.5, 0.0, 0.0), STRAIGHT, 0.0, 0.3),
    )  # fmt: skip
    bend = np.linspace(0.0, 2.6, 20_001)
    radius, beside = 2.0 * 0.5 * np.cos(0.5 * bend), 0.5 * bend  # an isosceles arm
    arc = 0.5 + np.minimum(2.0 * beside, 0.5)
    area = float((0.5 * (arc[1:] + arc[:-1]) * 0.5 * (radius[:-1] ** 2 - radius[1:] ** 2)).sum())
    assert_is(flange(robot), 0.3 * area)


def test_an_axis_without_limits_counts_as_one_turn_and_a_slide_is_refused() -> None:
    ring = ("R", (0.5, 0.0, 0.0), STRAIGHT, 0.0, 2.0)
    found = flange(arm(("R", BASE, STRAIGHT, -np.inf, np.inf), ring, tip=0.3))
    assert_is(found, 2.0 * pi * 0.5 * 0.3 * (1.0 - cos(2.0)))
    assert [one.code for one in found.findings] == ["W104"]
    with pytest.raises(WorkspaceError) as refused:
        flange(arm(("P", BASE, STRAIGHT, 0.0, np.inf), ring))
    assert refused.value.diagnostic.code == "W102"


def _directions(robot: RobotModel) -> Array:
    """Return the directions of the three axes that slide, shape (3, 3)."""
    from ropsim.kinematics import frames_batch

    return np.asarray(frames_batch(robot, np.zeros((1, 4)))[0, [0, 2, 3], :3, 2])
