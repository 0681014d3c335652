"""Joints of MJCF: zeros, couplings, classes and limits have the meaning that they have in MuJoCo."""

import mujoco
import numpy as np
import pytest

from ropsim.core import SourceText
from ropsim.exchange import read_mjcf
from ropsim.kinematics import frames_batch
from ropsim.model import WITHOUT_END, RobotModel, coordinates
from support.mujoco_files import MujocoFile

SAME = 1e-12
"""Both engines multiply the same numbers some ten times [m, entries of the rotation]."""
ARM = """<mujoco><compiler angle="radian" {compiler}/>{default}<worldbody>
<body name="a" pos="0.1 0 1"><joint name="j1" {first}/><geom type="box" size="0.1 0.2 0.3" density="500"/>
{beside}
<body name="b" pos="0 0.3 0.5"><joint name="j2" {second}/><geom type="box" size="0.1 0.1 0.2" pos="0 0 0.1"/>
<body name="tool0" pos="0 0 0.3"/></body></body></worldbody>
{equality}<actuator><motor joint="j1"/>{motor}</actuator></mujoco>"""


def text(
    first: str = 'axis="0 1 0" range="-1 1"',
    second: str = 'axis="1 0 0" range="-1 1"',
    *,
    compiler: str = "",
    default: str = "",
    equality: str = "",
    beside: str = "",
) -> str:
    """Return an arm of two joints; the second one has a motor where nothing holds it to the first."""
    motor = "" if equality else '<motor joint="j2"/>'
    return ARM.format(**locals())


def read(content: str) -> RobotModel:
    found = read_mjcf(SourceText("arm.xml", content))
    assert found.robot is not None, found.findings
    return found.robot


def joint_coordinates(robot: RobotModel, q: list[float]) -> np.ndarray:
    """Return the coordinates of all joints where the axes are at q."""
    found = coordinates(robot)
    return np.asarray(found.T @ np.array(q) + found.c)


def assert_stands_as_in_mujoco(robot: RobotModel, content: str, q: list[float]) -> None:
    """Make sure that the second joint carries its body to the place that MuJoCo has for the coordinates."""
    file = MujocoFile(content)
    frames = frames_batch(robot, [q])[0]
    place = file.frame(joint_coordinates(robot, q), "tool0", "body")
    tip = frames[-1]
    np.testing.assert_allclose(tip, place, atol=SAME)


@pytest.mark.parametrize("kind", ["hinge", "slide"])
def test_coordinates_count_from_the_reference_of_a_joint(kind: str) -> None:
    content = text(
        'axis="0 1 0" range="-1 1" ref="0.4"', f'type="{kind}" axis="1 0 0" range="-1 1" ref="-0.25"'
    )
    assert_stands_as_in_mujoco(read(content), content, [0.7, -0.6])


def test_a_coupling_of_joints_with_references_is_kept_in_mujoco() -> None:
    """Where the follower stands by the model the equality of MuJoCo holds."""
    content = text(
        'axis="0 1 0" range="-1 1" ref="0.4"',
        'axis="1 0 0" range="-9 9" ref="-0.25"',
        equality='<equality><joint joint1="j2" joint2="j1" polycoef="0.1 0.5 0 0 0"/></equality>',
    )
    robot = read(content)
    model = mujoco.MjModel.from_xml_string(content)
    data = mujoco.MjData(model)
    for x in (-0.8, 0.0, 0.9):
        data.qpos[:] = joint_coordinates(robot, [x])
        mujoco.mj_forward(model, data)
        equalities = data.efc_pos[data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY]
        assert len(equalities) == 1
        assert abs(float(equalities[0])) < SAME
        assert_stands_as_in_mujoco(robot, content, [x])


def test_a_class_has_what_the_classes_around_it_say() -> None:
    default = (
        '<default><joint axis="1 0 0" range="-0.5 0.5"/>'
        '<default class="outer"><joint pos="0 0 0.1" range="-0.3 0.7"/>'
        '<default class="inner"><joint damping="2"/></default></default></default>'
    )
    content = text('class="outer"', 'class="inner"', default=default)
    robot = read(content)
    assert_stands_as_in_mujoco(robot, content, [0.2, 0.6])
    model = MujocoFile(content).model
    for number, joint in enumerate(robot.joints):
        assert (joint.lower, joint.upper) == pytest.approx(model.jnt_range[number], abs=SAME)
    assert [drive.friction.viscous for drive in robot.drives] == [0.0, 2.0]


@pytest.mark.parametrize(
    ("compiler", "joint"),
    [
        ('autolimits="false"', 'axis="0 1 0" range="-1 1" limited="true"'),
        ('autolimits="false"', 'axis="0 1 0" range="-1 1" limited="false"'),
        ("", 'axis="0 1 0" range="-1 1" limited="false"'),
        ("", 'axis="0 1 0" range="-1 1"'),
        ("", 'axis="0 1 0"'),
    ],
)
def test_a_range_limits_a_joint_where_mujoco_says_so(compiler: str, joint: str) -> None:
    content = text(joint, 'axis="1 0 0" range="-1 1" limited="true"', compiler=compiler)
    limited = bool(MujocoFile(content).model.jnt_limited[0])
    first = read(content).joints[0]
    assert (first.lower, first.upper) == ((-1.0, 1.0) if limited else (-WITHOUT_END, WITHOUT_END))


def test_a_range_alone_limits_no_joint_without_autolimits() -> None:
    """MuJoCo refuses a file that leaves that open; a reader has to take the joint as free."""
    content = text('axis="0 1 0" range="-1 1"', 'axis="1 0 0" range="-1 1"', compiler='autolimits="false"')
    with pytest.raises(ValueError, match="limited"):
        MujocoFile(content)
    assert [joint.upper for joint in read(content).joints] == [WITHOUT_END, WITHOUT_END]


@pytest.mark.parametrize("kind", ["hinge", "slide"])
def test_a_branch_that_rests_weighs_where_mujoco_has_it(kind: str) -> None:
    """A joint off the way to the tip with a reference: it rests at zero, not where the file draws it."""
    beside = (
        f'<body name="c" pos="0.2 0 0"><joint name="off" type="{kind}" axis="0 1 0" range="-1 1" ref="0.5"/>'
        '<geom type="box" size="0.3 0.1 0.1" pos="0.4 0 0"/></body>'
    )
    content = text(beside=beside)
    robot = read(content)
    assert [joint.name for joint in robot.joints] == ["j1", "j2"]
    file = MujocoFile(content)
    qpos = np.zeros(3)
    frames = frames_batch(robot, [[0.0, 0.0]])[0]
    masses = [float(file.model.body(name).mass[0]) for name in ("a", "c")]
    centres = []
    for name in ("a", "c"):
        X = file.frame(qpos, name, "body")
        centres.append(X[:3, 3] + X[:3, :3] @ file.model.body(name).ipos)
    link = robot.links[0]
    assert link.mass == pytest.approx(sum(masses), rel=SAME)
    com = frames[0][:3, :3] @ link.com + frames[0][:3, 3]
    np.testing.assert_allclose(com, np.average(centres, axis=0, weights=masses), atol=SAME)
