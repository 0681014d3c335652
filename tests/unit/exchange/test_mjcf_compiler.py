"""Settings of MJCF: those that change weights have the effect that they have in MuJoCo; the rest is named."""

import numpy as np
import pytest

from ropsim.core import SourceText
from ropsim.exchange import read_mjcf
from ropsim.model import Mesh, ReadRobot
from support.mujoco_files import MujocoFile

SAME = 1e-12
"""Relative: both engines scale the same numbers."""
TEXT = """<mujoco model="arm">
  <compiler angle="radian" {compiler}/>
  <worldbody>
    <body name="a" pos="0 0 1">
      <joint name="j1" axis="0 1 0" range="-1 1"/>
      <geom type="box" size="0.1 0.2 0.3" density="500"/>
      <geom type="sphere" size="0.1" pos="0.3 0 0" group="4"/>
      <body name="b" pos="0 0 0.5">
        <joint name="j2" axis="1 0 0" range="-1 1"/>
        <inertial pos="0 0.1 0.1" euler="0.3 0.2 0.1" mass="0.5" diaginertia="0.01 0.02 0.028"/>
        <geom type="box" size="0.1 0.1 0.1"/>
      </body>
    </body>
  </worldbody>
</mujoco>
"""


def read(text: str) -> ReadRobot:
    found = read_mjcf(SourceText("arm.xml", text))
    assert found.robot is not None, found.findings
    return found


@pytest.mark.parametrize(
    "compiler",
    [
        "",
        'settotalmass="7"',
        'boundmass="2"',
        'boundinertia="0.025"',
        'boundmass="0.6" boundinertia="0.02" settotalmass="9"',
        'balanceinertia="true" boundinertia="0.015"',
        'inertiagrouprange="0 3"',
        'inertiafromgeom="true" inertiagrouprange="4 4" boundmass="0.1" boundinertia="0.001"',
        'inertiafromgeom="true" settotalmass="3"',
    ],
)
def test_weights_are_those_of_mujoco(compiler: str) -> None:
    robot = read(TEXT.format(compiler=compiler)).robot
    assert robot is not None
    model = MujocoFile(TEXT.format(compiler=compiler)).model
    for number, link in enumerate(robot.links, start=1):
        assert link.mass == pytest.approx(model.body_mass[number], rel=SAME)
        moments = np.linalg.eigvalsh(link.inertia)
        np.testing.assert_allclose(moments, np.sort(model.body_inertia[number]), rtol=1e-9)


def test_moments_that_break_the_triangle_are_balanced() -> None:
    text = TEXT.format(compiler='balanceinertia="true"').replace("0.01 0.02 0.028", "0.01 0.02 0.06")
    robot = read(text).robot
    assert robot is not None
    np.testing.assert_allclose(robot.links[1].inertia, np.eye(3) * 0.03, atol=1e-12)
    np.testing.assert_allclose(MujocoFile(text).model.body_inertia[2], 0.03)


def test_files_of_meshes_count_without_their_folders_where_the_file_says_so() -> None:
    text = TEXT.format(compiler='strippath="true" meshdir="m"').replace(
        "<worldbody>", '<asset><mesh name="x" file="C:/old\\dir/x.stl"/></asset><worldbody>'
    )
    text = text.replace("<inertial", '<geom type="mesh" mesh="x"/><inertial')
    robot = read(text).robot
    assert robot is not None
    assert Mesh("m/x.stl") in [one.solid for one in robot.links[1].shapes]


@pytest.mark.parametrize("compiler", ['eulerseq="xya"', 'eulerseq="xy"', 'coordinate="global"'])
def test_a_setting_that_would_place_bodies_elsewhere_is_refused(compiler: str) -> None:
    found = read_mjcf(SourceText("arm.xml", TEXT.format(compiler=compiler)))
    assert found.robot is None
    assert [one.code for one in found.findings if one.is_error] == ["X983"]


def test_attributes_that_are_not_read_are_one_finding_of_each_kind() -> None:
    text = TEXT.format(compiler='polish="1"').replace("<joint ", '<joint springdamper="1 1" ')
    text = text.replace("<geom ", '<geom shine="3" ').replace('name="a"', 'name="a" gravcomp="1"')
    findings = {one.code: one for one in read(text).findings}
    assert findings["X995"].data["attributes"] == ("compiler/polish", "geom/shine")
    assert findings["X993"].data == {"attributes": ("joint/springdamper",)}
    assert findings["X994"].data == {"weight compensation": ("a",)}
    assert "here the drives carry it" in findings["X994"].message


def test_what_mujoco_makes_of_joints_elsewhere_is_no_attribute_of_a_joint() -> None:
    text = TEXT.format(compiler="").replace(
        "</mujoco>", '<tendon><fixed name="t"><joint joint="j1" coef="1"/></fixed></tendon></mujoco>'
    )
    findings = {one.code: one for one in read(text).findings}
    assert "attributes" not in findings["X995"].data
    assert findings["X993"].data == {"tendons": ("t",)}


@pytest.mark.parametrize("free", ["<freejoint/>", '<joint type="free" name="root"/>'])
def test_a_base_that_moves_about_freely_is_taken_as_fixed_and_said(free: str) -> None:
    fixed = read(TEXT.format(compiler="").replace('<joint name="j1" axis="0 1 0" range="-1 1"/>', ""))
    found = read(TEXT.format(compiler="").replace('<joint name="j1" axis="0 1 0" range="-1 1"/>', free))
    assert fixed.robot is not None
    assert found.robot is not None
    assert (found.robot.joints, found.robot.links) == (fixed.robot.joints, fixed.robot.links)
    (said,) = [one for one in found.findings if one.code == "X993"]
    assert said.data == {"free base": ("a",)}
    assert "it is taken as fixed" in said.message


def test_bodies_that_other_elements_make_are_named() -> None:
    made = '<attach model="hand" prefix="h_"/><inertial'
    findings = {one.code: one for one in read(TEXT.format(compiler="").replace("<inertial", made)).findings}
    assert findings["X993"].data == {"bodies that are made": ("attach",)}
