"""Sections of paths: the same way, counted from where the section begins."""

import numpy as np
import pytest

from ropsim.motion import JointLine, JointSection, Line, ToolSection
from ropsim.spatial import Pose
from support.paths import random_pose

ROUNDING = 1e-12


def test_a_section_of_the_joints_is_what_lies_between_its_places() -> None:
    line = JointLine(np.zeros(2), np.array([1.0, -2.0]))
    section = JointSection(line, 0.25, 0.75)
    assert section.length == 0.5
    points = section.joints(np.array([0.0, 0.5]))
    assert points.q.tolist() == [[0.25, -0.5], [0.75, -1.5]]
    assert points.d1.tolist() == [[1.0, -2.0]] * 2


def test_a_section_of_the_tool_is_what_lies_between_its_places() -> None:
    rng = np.random.default_rng(9)
    line = Line(random_pose(rng), random_pose(rng))
    section = ToolSection(line, 0.2 * line.length, 0.7 * line.length)
    assert section.length == pytest.approx(0.5 * line.length, rel=ROUNDING)
    s = np.linspace(0.0, section.length, 7)
    assert section.tool(s) == line.tool(s + 0.2 * line.length)
    assert (section.positions(s) == line.positions(s + 0.2 * line.length)).all()


def test_the_distance_from_a_section_ends_where_the_section_ends() -> None:
    section = ToolSection(Line(Pose(), Pose(np.array([10.0, 0.0, 0.0]))), 2.0, 6.0)
    points = np.array([[3.3, 3.0, 4.0], [-1.0, 0.0, 4.0], [9.0, 4.0, 0.0], [2.5, 0.0, 0.0]])
    assert section.distance(points).tolist() == pytest.approx([5.0, 5.0, 5.0, 0.0], abs=ROUNDING)
