"""Published arms read from URDF: the poses of another program, and the class of inverse kinematics."""

import numpy as np
import pytest

from ropsim.core import SourceText
from ropsim.exchange import read_urdf
from ropsim.kinematics import forward, solver_of
from ropsim.model import RobotModel
from ropsim.spatial import Pose
from support.published_arms import TABLES, published_arm
from support.urdf_texts import published_urdf

PRINTED = 1e-8
"""Angles and poses are printed to 1e-9; six angles act on at most 3 m [m, entries of the matrix]."""


def read(name: str) -> RobotModel:
    found = read_urdf(SourceText(f"{name}.urdf", published_urdf(name)))
    assert found.robot is not None
    return found.robot


@pytest.mark.parametrize("name", [name for name in TABLES if "poses" in TABLES[name]])
def test_the_tip_is_where_another_program_has_it(name: str) -> None:
    robot = read(name)
    for row in TABLES[name]["poses"]:
        q, p, (x, y, z, w) = row[: robot.n], row[-7:-4], row[-4:]
        expected = Pose(np.array(p), np.array([w, x, y, z])).matrix()
        np.testing.assert_allclose(forward(robot, q).matrix(), expected, rtol=0.0, atol=PRINTED)


@pytest.mark.parametrize("name", TABLES)
def test_the_solver_is_that_of_the_chain(name: str) -> None:
    assert solver_of(read(name)).name == solver_of(published_arm(name)).name
