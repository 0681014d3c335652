"""The robots that come as files: poses of other programs, limits and solvers."""

import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import Method, forward, solver_of
from ropsim.spatial import Pose
from support.built_in import WRITTEN

DATA = Path(__file__).parent / "data" / "library_robots.toml"
TABLES: dict[str, Any] = tomllib.loads(DATA.read_text("utf-8"))
STORED = [name for name in robots.names() if name not in WRITTEN]
TOLERANCE = 1e-6
"""Some of the files give right angles with six digits [m, entries of the rotation matrix]."""


def test_poses_are_known_of_every_robot() -> None:
    assert sorted(TABLES) == STORED


@pytest.mark.parametrize("name", STORED)
def test_the_interface_is_where_the_published_file_has_it(name: str) -> None:
    robot = robots.load(name)
    assert len(TABLES[name]["poses"]) == 2
    for row in TABLES[name]["poses"]:
        q, p, (x, y, z, w) = row[: robot.n], row[-7:-4], row[-4:]
        expected = Pose(np.array(p), np.array([w, x, y, z])).matrix()
        np.testing.assert_allclose(forward(robot, q).matrix(), expected, rtol=0.0, atol=TOLERANCE)


@pytest.mark.parametrize("name", STORED)
def test_at_home_the_tool_points_down_and_the_joints_are_within_their_limits(name: str) -> None:
    robot = robots.load(name)
    assert (robot.lower_limits < robot.home).all()
    assert (robot.home < robot.upper_limits).all()
    np.testing.assert_allclose(forward(robot, robot.home).rotation()[:, 2], [0.0, 0.0, -1.0], atol=1e-12)


@pytest.mark.parametrize("name", STORED)
def test_all_branches_are_found(name: str) -> None:
    solver = solver_of(robots.load(name))
    six_axes = "three parallel axes" if name.startswith("ur") else "spherical wrist"
    assert solver.name == ("general seven-axis" if name == "panda" else six_axes)
    assert solver.method is (Method.ALGEBRAIC if name == "panda" else Method.CLOSED_FORM)
