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


@pytest.mark.parametrize(("total", "told"), [(1077.0, False), (4879.0, True)])
def test_masses_that_no_arm_of_this_length_has_are_told(total: float, told: bool) -> None:
    """A file of a KUKA KR 210 adds up to 4,879 kg; the robot weighs 1,077 kg (kroshu, kr210_r2700_2)."""
    text = published_urdf("kr210_r2700_2")
    for k, share in enumerate((0.35, 0.3, 0.2, 0.08, 0.05, 0.02), start=1):
        mass = f'<inertial><mass value="{share * total}"/></inertial>'
        text = text.replace(f'<link name="l{k}"/>', f'<link name="l{k}">{mass}</link>')
    found = read_urdf(SourceText("kr210.urdf", text)).findings
    words = [text for one in found if one.code == "X989" for text in (one.message, *one.notes)]
    assert any("heavy" in text for text in words) is told
