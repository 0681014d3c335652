"""`replicate` of MJCF: replicas stand where MuJoCo has them, with its names."""

from math import pi
from typing import Any

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


ROWS = """<mujoco><option gravity="0 0 0"/>
  <worldbody><body><joint name="base" axis="0 0 1"/><geom size="0.1"/>
    <replicate count="2" offset="0.3 0 0" sep="-">
      <body name="a"><joint name="j" axis="0 1 0"/><geom size="0.1"/>
        <body name="c"><joint name="k" axis="0 1 0"/><geom size="0.1"/></body>
        <replicate count="11" offset="0 0.3 0" sep="_">
          <body name="b"><joint name="l" axis="1 0 0"/><geom size="0.1"/></body>
        </replicate></body></replicate></body></worldbody>
  <actuator><motor name="i" joint="k" forcerange="-1 2"/><motor name="n" joint="l" forcerange="-2 3"/>
  </actuator><actuator>
    <motor name="o" joint="l_07" forcerange="-5 4"/><motor name="q" joint="j-1" forcerange="-6 5"/>
    <motor name="p" jointinparent="j" forcerange="-7 6"/><motor name="r" joint="base" forcerange="-8 7"/>
  </actuator><equality>{more}</equality></mujoco>"""


@pytest.mark.parametrize("tip", ["b_00-0", "b_07-0", "b_07-1", "b_10-1", "c-1"])
def test_actuators_of_joints_in_rows_stand_once_for_each_replica(tip: str) -> None:
    text = ROWS.format(more="")
    robot = read_mjcf(SourceText("r.xml", text), ReadOptions(tip)).robot
    assert robot is not None
    model: Any = MujocoFile(text).model
    efforts: dict[str, Any] = {}
    for place in range(model.nu):
        name = model.joint(model.actuator_trnid[place][0]).name
        efforts[name] = efforts.get(name, np.zeros(2)) + model.actuator_forcerange[place]
    axes = [one.name for one in robot.axis_joints]
    assert len(axes) == 3
    assert axes == [name for name in efforts if name in axes]
    assert robot.max_efforts.tolist() == [float(np.abs(efforts[name]).max()) for name in axes]


@pytest.mark.parametrize(("tip", "follower"), [("c-0", "k-0"), ("c-1", "k-1")])
def test_constraints_of_joints_in_rows_hold_in_each_replica(tip: str, follower: str) -> None:
    text = ROWS.format(more='<joint joint1="k" joint2="j" polycoef="0 2 0 0 0"/>')
    robot = read_mjcf(SourceText("r.xml", text), ReadOptions(tip)).robot
    assert robot is not None
    model: Any = MujocoFile(text).model
    assert follower in [model.joint(number).name for number in model.eq_obj1id]
    axes = {one.name for one in robot.axis_joints}
    assert {one.name for one in robot.joints} - axes == {follower}


def test_actuators_that_rows_make_without_end_are_refused() -> None:
    motors = "<actuator>" + '<motor joint="j"/>' * 10_000 + "</actuator>"
    row = '<replicate count="5000"><body><joint name="j"/><geom size="0.1"/></body></replicate>'
    found = read_mjcf(SourceText("r.xml", f"<mujoco><worldbody>{row}</worldbody>{motors}</mujoco>"))
    assert [one.code for one in found.findings if one.is_error] == ["X981"]


EMPTY = '<mujoco><worldbody><replicate count="1000000000"/></worldbody></mujoco>'


@pytest.mark.parametrize("text", [TEXT.format(outer=10**9), EMPTY])
def test_rows_without_end_are_refused(text: str) -> None:
    found = read_mjcf(SourceText("r.xml", text))
    assert [one.code for one in found.findings if one.is_error] == ["X981"]


def test_names_that_rows_make_without_end_are_refused() -> None:
    rows = f'<replicate count="1" sep="{"s" * 10_000}">' * 190
    text = f'<mujoco><worldbody>{rows}<body name="b"/>{"</replicate>" * 190}</worldbody></mujoco>'
    found = read_mjcf(SourceText("r.xml", text))
    (error,) = [one for one in found.findings if one.is_error]
    assert error.code == "X981"
    assert "names become longer" in error.message


def test_a_row_without_its_count_is_refused() -> None:
    found = read_mjcf(SourceText("r.xml", TEXT.format(outer=2).replace('count="11"', "")))
    assert {one.code for one in found.findings if one.is_error} == {"X982"}


def test_rows_in_rows_are_read_as_deep_as_a_file_goes() -> None:
    rows = '<replicate count="1">' * 190 + '<geom size="0.1"/>' + "</replicate>" * 190
    text = f'<mujoco><worldbody><body><joint axis="0 1 0"/>{rows}</body></worldbody></mujoco>'
    robot = read_mjcf(SourceText("r.xml", text)).robot
    assert robot is not None
    assert robot.links[0].mass == pytest.approx(4.0 / 3.0 * pi)
