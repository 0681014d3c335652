"""`replicate` of MJCF: replicas stand where MuJoCo has them, with its names."""

from math import pi

import numpy as np
import pytest

from ropsim.core import SourceText
from ropsim.exchange import ReadOptions, read_mjcf
from ropsim.kinematics import forward
from support.mujoco_files import MujocoFile

TEXT = """<mujoco><compiler eulerseq="zyx"/><worldbody><body name="b" pos="0 0 0.3">
  <inertial pos="0 0 0.1" mass="1" diaginertia="0.01 0.01 0.01"/><joint name="j"/>
  <replicate count="{outer}" offset="0 0.5 0" euler="10 0 0">
    <replicate count="11" offset="0.1 0 0.02" euler="0 20 30" sep="_">
      <body name="h"><geom size="0.01"/><site name="s" pos="0.01 0 0"/></body>
    </replicate></replicate></body></worldbody></mujoco>"""


def test_replicas_stand_where_mujoco_has_them() -> None:
    text = TEXT.format(outer=2)
    file = MujocoFile(text)
    for name in ("s_000", "s_010", "s_101", "s_071"):
        found = read_mjcf(SourceText("r.xml", text), ReadOptions(tip=name))
        assert found.robot is not None
        X = forward(found.robot, np.array([0.7])).matrix()
        np.testing.assert_allclose(X, file.frame(np.array([0.7]), name), atol=1e-12)


def test_replicas_are_of_the_class_that_the_row_says() -> None:
    text = (
        '<mujoco><default><default class="c"><geom mass="3"/></default></default><worldbody><body>'
        '<joint axis="0 1 0"/><replicate count="3" offset="1 0 0" childclass="c"><geom size="0.1"/>'
        "</replicate></body></worldbody></mujoco>"
    )
    robot = read_mjcf(SourceText("r.xml", text)).robot
    assert robot is not None
    assert robot.links[0].mass == pytest.approx(MujocoFile(text).model.body_mass[1])
    assert float(np.linalg.norm(robot.links[0].com)) == pytest.approx(1.0)


EMPTY = '<mujoco><worldbody><replicate count="1000000000"/></worldbody></mujoco>'


@pytest.mark.parametrize("text", [TEXT.format(outer=10**9), EMPTY])
def test_rows_without_end_are_refused(text: str) -> None:
    found = read_mjcf(SourceText("r.xml", text))
    assert [one.code for one in found.findings if one.is_error] == ["X981"]


def test_a_row_without_its_count_is_refused() -> None:
    found = read_mjcf(SourceText("r.xml", TEXT.format(outer=2).replace('count="11"', "")))
    assert {one.code for one in found.findings if one.is_error} == {"X982"}


def test_rows_in_rows_are_read_as_deep_as_a_file_goes() -> None:
    rows = '<replicate count="1">' * 190 + '<geom size="0.1"/>' + "</replicate>" * 190
    text = f'<mujoco><worldbody><body><joint axis="0 1 0"/>{rows}</body></worldbody></mujoco>'
    robot = read_mjcf(SourceText("r.xml", text)).robot
    assert robot is not None
    assert robot.links[0].mass == pytest.approx(4.0 / 3.0 * pi)
