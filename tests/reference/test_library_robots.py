"""The robots that come as files: poses of other programs, limits and solvers."""

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import IkOptions, Method, RedundantSolver, forward, inverse, solver_of
from ropsim.model import coupled_limits
from ropsim.spatial import Pose
from support.built_in import WRITTEN

DATA = Path(__file__).parent / "data" / "library_robots.toml"
TABLES: dict[str, Any] = tomllib.loads(DATA.read_text("utf-8"))
STORED = [name for name in robots.names() if name not in WRITTEN]
TOLERANCE = 1e-6
"""Some of the files give right angles with six digits [m, entries of the rotation matrix]."""

JOINT_3 = {"irb2400_16": -1.0, "lr_mate_200id": 1.0, "m10ia_12": 1.0}
"""Published files count the joint itself: axis 3 of the maker and so many times axis 2."""

AMONG = 1e-9
"""Of the posture that made a pose among those that are found [rad | m]."""


def test_poses_are_known_of_every_robot() -> None:
    assert sorted(TABLES) == STORED


@pytest.mark.parametrize("name", STORED)
def test_the_interface_is_where_the_published_file_has_it(name: str) -> None:
    robot = robots.load(name)
    assert len(TABLES[name]["poses"]) == 2
    for row in TABLES[name]["poses"]:
        q, p, (x, y, z, w) = np.array(row[: robot.n]), row[-7:-4], row[-4:]
        if name in JOINT_3:
            q[2] -= JOINT_3[name] * q[1]
        expected = Pose(np.array(p), np.array([w, x, y, z])).matrix()
        np.testing.assert_allclose(forward(robot, q).matrix(), expected, rtol=0.0, atol=TOLERANCE)


@pytest.mark.parametrize("name", STORED)
def test_at_home_the_tool_points_down_and_the_joints_are_within_their_limits(name: str) -> None:
    robot = robots.load(name)
    assert (robot.lower_limits < robot.home).all()
    assert (robot.home < robot.upper_limits).all()
    np.testing.assert_allclose(forward(robot, robot.home).rotation()[:, 2], [0.0, 0.0, -1.0], atol=1e-12)


SOLVERS = {
    "cobra600": ("SCARA", Method.CLOSED_FORM),
    "irb460_110_240": ("level wrist", Method.CLOSED_FORM),
    "irb660_180_315": ("level wrist", Method.CLOSED_FORM),
    "m410ib_700": ("level wrist", Method.CLOSED_FORM),
    "iiwa14": ("S-R-S", Method.CLOSED_FORM),
    "patu655": ("planar two-link", Method.CLOSED_FORM),
    "panda": ("general seven-axis", Method.ALGEBRAIC),
    "stanford": ("sliding joint, spherical wrist", Method.CLOSED_FORM),
    "ur10e": ("three parallel axes", Method.CLOSED_FORM),
    "ur3e": ("three parallel axes", Method.CLOSED_FORM),
    "ur5e": ("three parallel axes", Method.CLOSED_FORM),
}
"""Classes of the robots whose class is not that of arms with a spherical wrist."""


@pytest.mark.parametrize("name", STORED)
def test_the_class_is_recognised(name: str) -> None:
    solver = solver_of(robots.load(name))
    assert (solver.name, solver.method) == SOLVERS.get(name, ("spherical wrist", Method.CLOSED_FORM))


NEW_CLASSES = ("cobra600", "iiwa14", "irb460_110_240", "irb660_180_315", "m410ib_700")


@pytest.mark.parametrize("name", [*NEW_CLASSES, "irb140", "irb6640_180_255"])
def test_the_posture_that_made_a_pose_is_among_its_branches(name: str) -> None:
    robot = robots.load(name)
    lower, upper = np.maximum(robot.lower_limits, -np.pi), np.minimum(robot.upper_limits, np.pi)
    Q = np.random.default_rng(12).uniform(lower, upper, (120, robot.n))
    for q in Q[~coupled_limits(robot).excess(Q).any(axis=1)][:40]:
        solver = solver_of(robot)
        free = solver.free(q).value if isinstance(solver, RedundantSolver) else None
        held = IkOptions(near=q, free=free)
        found = np.array(inverse(robot, forward(robot, q), held).solutions)
        assert np.abs(found - q).max(axis=1).min() < AMONG


def test_the_iiwa_is_where_the_file_of_ros_industrial_has_it_but_for_its_shift() -> None:
    """That file shifts axes 2 and 4 by 0.436 mm against the drawing of the maker and back."""
    robot = robots.load("iiwa14")
    q = [1.291312713, -1.704214557, 1.604492105, -1.806591905, 0.297060959, -1.215827979, 2.559793749]
    position = forward(robot, q).position
    np.testing.assert_allclose(position, [-0.558764921, -0.282167461, 0.322261647], rtol=0.0, atol=8.8e-4)
