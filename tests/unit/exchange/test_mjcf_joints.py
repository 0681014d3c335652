"""Joints and actuators of MJCF: places, efforts, home and freedom are those of MuJoCo."""

from dataclasses import replace
from math import inf
from typing import Any

import mujoco
import numpy as np
import pytest

from ropsim.core import SourceText
from ropsim.dynamics import mass_matrix
from ropsim.exchange import ReadOptions, read_mjcf
from ropsim.kinematics import forward
from ropsim.model import ReadRobot
from support.mjcf_texts import ARM, framed_chain
from support.mujoco_files import MujocoFile

SAME = 1e-12
"""Some ten products of rotations, each rounded [m, kg·m²]."""


def read(text: str, tip: str | None = None) -> ReadRobot:
    found = read_mjcf(SourceText("arm.xml", text), ReadOptions(tip))
    assert found.robot is not None, found.findings
    return found


@pytest.mark.parametrize("seed", range(40))
def test_joints_and_weights_in_frames_are_those_of_mujoco(seed: int) -> None:
    text = framed_chain(seed)
    robot, file = read(text, "tip").robot, MujocoFile(text)
    assert robot is not None
    q = np.random.default_rng(seed).uniform(-1.0, 1.0, robot.n)
    np.testing.assert_allclose(forward(robot, q).matrix(), file.frame(q, "tip"), atol=SAME)
    np.testing.assert_allclose(mass_matrix(replace(robot, drives=()), q), file.mass_matrix(q), atol=SAME)


ONE_AXIS = """<mujoco><compiler autolimits="{autolimits}"/>{more}<worldbody><body>
<joint name="j" limited="false" axis="0 0 1" {joint}/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
</body></worldbody><actuator>{actuator}</actuator></mujoco>"""


def effort_of(**parts: str) -> float:
    text = ONE_AXIS.format(**({"autolimits": "true", "more": "", "joint": "", "actuator": ""} | parts))
    robot = read(text).robot
    assert robot is not None
    model: Any = MujocoFile(text).model
    efforts = [float(model.jnt_actfrcrange[0][1])] if model.jnt_actfrclimited[0] else []
    if model.nu and model.actuator_forcelimited[0]:
        efforts.append(float(model.actuator_forcerange[0][1] * model.actuator_gear[0][0]))
    assert robot.max_efforts.tolist() == [min(efforts, default=inf)]
    return min(efforts, default=inf)


@pytest.mark.parametrize(
    ("said", "autolimits", "effort"),
    [
        ("auto", "true", 30.0),
        ("auto", "false", inf),
        ("true", "true", 30.0),
        ("true", "false", 30.0),
        ("false", "true", inf),
        ("false", "false", inf),
    ],
)
def test_an_effort_counts_where_mujoco_has_it_in_force(said: str, autolimits: str, effort: float) -> None:
    if (said, autolimits) != ("auto", "false"):  # which MuJoCo refuses to guess
        joint = f'actuatorfrcrange="-30 30" actuatorfrclimited="{said}"'
        assert effort_of(joint=joint, autolimits=autolimits) == effort
        actuator = f'<position joint="j" kp="1" forcerange="-10 10" gear="3" forcelimited="{said}"/>'
        assert effort_of(actuator=actuator, autolimits=autolimits) == effort
    motor = f'<motor joint="j" ctrlrange="-10 10" gear="3" ctrllimited="{said}"/>'
    robot = read(ONE_AXIS.format(joint="", more="", actuator=motor, autolimits=autolimits)).robot
    assert robot is not None
    assert robot.max_efforts.tolist() == [effort]


def test_the_smaller_effort_of_joint_and_actuator_counts() -> None:
    actuator = '<motor joint="j" forcerange="-10 10"/>'
    assert effort_of(joint='actuatorfrcrange="-30 30"', actuator=actuator) == 10.0
    assert effort_of(joint='actuatorfrcrange="-5 5"', actuator=actuator) == 5.0


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ('forcerange="-1 3" gear="2"', 'ctrlrange="-2 1" gear="-1"'),
        ('forcerange="-1 3" ctrlrange="-2 2"', 'forcerange="-3 1" ctrlrange="-9 9"'),
        ('forcerange="0 3"', 'forcerange="-8 1"'),
    ],
)
def test_efforts_of_actuators_of_one_joint_are_added(first: str, second: str) -> None:
    text = ONE_AXIS.format(
        joint="",
        more="",
        actuator=f'<motor joint="j" {first}/><motor jointinparent="j" {second}/>',
        autolimits="true",
    )
    model: Any = MujocoFile(text).model
    data: Any = mujoco.MjData(model)
    efforts = []
    for control in (-1e4, 1e4):
        data.ctrl[:] = control * np.sign(model.actuator_gear[:, 0])
        mujoco.mj_forward(model, data)
        efforts.append(abs(float(data.qfrc_actuator[0])))
    robot = read(text).robot
    assert robot is not None
    assert robot.max_efforts.tolist() == [max(efforts)]


def test_an_actuator_without_limits_beside_one_with_them_is_named() -> None:
    actuators = '<motor joint="j" forcerange="-1 3"/><damper joint="j" kv="1" ctrlrange="0 1"/>'
    found = read(ONE_AXIS.format(joint="", more="", actuator=actuators, autolimits="true"))
    assert found.robot is not None
    assert found.robot.max_efforts.tolist() == [inf]
    data = {key: names for finding in found.findings for key, names in finding.data.items()}
    assert data["efforts without bounds"] == ("j",)


def test_actuators_of_joints_that_are_left_out_are_named() -> None:
    found = read(ONE_AXIS.format(joint="", more="", actuator='<motor joint="none"/>', autolimits="true"))
    data = {key: names for finding in found.findings for key, names in finding.data.items()}
    assert data["actuators of other joints"] == ("none",)


@pytest.mark.parametrize("default", ["general", "motor", "position", "velocity", "cylinder", "pid"])
@pytest.mark.parametrize("kind", ["general", "motor", "position", "velocity", "intvelocity", "cylinder"])
def test_all_actuators_have_one_default(default: str, kind: str) -> None:
    more = f'<default><{default} forcerange="-6 6"/><default class="c"><motor gear="2"/></default></default>'
    ends = 'actrange="-1 1"' if kind == "intvelocity" else ""
    assert effort_of(more=more, actuator=f'<{kind} joint="j" class="c" {ends}/>') == 12.0


def test_the_axes_come_in_the_order_of_their_actuators_in_the_parent_too() -> None:
    actuators = '<actuator><motor jointinparent="j2"/><motor joint="j1"/></actuator></mujoco>'
    robot = read(ARM.replace("</mujoco>", actuators)).robot
    assert robot is not None
    assert [joint.name for joint in robot.axis_joints] == ["j2", "j1"]


CUBE = """<body name="cube" childclass="float"><joint name="root"/><geom size="0.1"/>
<body pos="1 0 0"><joint type="ball"/><joint type="slide"/><geom size="0.1"/></body></body>"""
FLOAT = '<default><default class="float"><joint type="free"/></default></default><worldbody>'


@pytest.mark.parametrize("cubes", [(0, 1), (1, 0), (2, 3)])
def test_the_home_is_read_beside_bodies_that_move_about_freely(cubes: tuple[int, int]) -> None:
    before, behind = (
        [
            "".join(
                CUBE.replace('"cube"', f'"{side}_{k}"')
                .replace('"root"', f'"{side}_{k}_root"')
                .replace('type="ball"', 'type="ball" class="main"')
                for k in range(count)
            )
        ]
        for side, count in zip("ab", cubes, strict=True)
    )
    text = ARM.replace("<worldbody>", FLOAT + before[0]).replace("</worldbody>", behind[0] + "</worldbody>")
    model: Any = MujocoFile(text).model
    qpos = np.round(np.random.default_rng(sum(cubes)).uniform(-1.0, 1.0, model.nq), 3)
    key = f'<keyframe><key name="empty"/><key name="home" qpos="{" ".join(map(str, qpos))}"/></keyframe>'
    found = read(text.replace("</mujoco>", key + "</mujoco>"))
    assert found.robot is not None
    assert found.robot.home.tolist() == [qpos[model.joint(name).qposadr[0]] for name in ("j1", "j2")]


@pytest.mark.parametrize(
    ("qpos", "why"),
    [
        ("0.1", "it has 1 values, the joints have 2 coordinates"),
        ("0.1 nan", "it has what is no finite number"),
    ],
)
def test_a_home_that_is_not_read_is_said(qpos: str, why: str) -> None:
    key = f'<keyframe><key name="rest" qpos="{qpos}"/></keyframe></mujoco>'
    found = read(ARM.replace("</mujoco>", key))
    assert found.robot is not None
    assert found.robot.home.tolist() == [0.0, 0.0]
    (said,) = [one for one in found.findings if "key frames" in one.data]
    assert said.code == "X995"
    assert "`rest`" in said.message
    assert any(why in words for words in (said.message, *said.notes))


def test_a_body_is_free_by_the_default_of_its_class_and_in_a_frame() -> None:
    for cube in (
        '<body name="cube" childclass="float"><joint/><geom size="0.1"/></body>',
        '<body name="cube"><joint class="float"/><geom size="0.1"/></body>',
        '<body name="cube"><frame><freejoint/></frame><geom size="0.1"/></body>',
        '<frame childclass="float"><body name="cube"><joint/><geom size="0.1"/></body></frame>',
    ):
        text = ARM.replace("<worldbody>", FLOAT).replace("</worldbody>", cube + "</worldbody>")
        assert MujocoFile(text).model.nq == 9
        found = read(text)
        assert found.robot == read(ARM).robot
        assert [one.data["free bodies"] for one in found.findings if "free bodies" in one.data] == [("cube",)]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            'range="-1 1"/>',
            'range="-1 1" limited="yes"/>',
            'limited="yes", allowed are `true`, `false`, `auto`',
        ),
        ('angle="radian"', 'autolimits="auto"', 'autolimits="auto", allowed are `true`, `false`'),
        ('angle="radian"', 'angle="rad"', 'angle="rad", allowed are degree and radian'),
    ],
)
def test_a_word_that_mujoco_does_not_know_is_refused(old: str, new: str, words: str) -> None:
    found = read_mjcf(SourceText("arm.xml", ARM.replace(old, new)))
    assert found.robot is None
    (said,) = [one for one in found.findings if one.is_error]
    assert said.code == "X983"
    assert said.message.endswith(words)


def test_unknown_attributes_of_actuators_are_named() -> None:
    more = '<default><general forcrange="-1 1"/></default><worldbody>'
    text = ARM.replace("<worldbody>", more).replace(
        "</mujoco>", '<actuator><motor joint="j1" kp="1" armature="2"/></actuator></mujoco>'
    )
    findings = {one.code: one for one in read(text).findings}
    assert findings["X995"].data["attributes"] == ("general/forcrange", "motor/kp")
    assert findings["X993"].data == {"attributes": ("motor/armature",)}
