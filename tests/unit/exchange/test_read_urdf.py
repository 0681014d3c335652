"""URDF in: frames, axes, weights, limits, friction, looks, branches and what is lost."""

import re
from itertools import pairwise
from math import cos, inf, sin

import numpy as np
import pytest

from ropsim.core import SourceText
from ropsim.exchange import ReadOptions, RobotFolder, read_urdf
from ropsim.kinematics import forward
from ropsim.model import WITHOUT_END, Box, Cylinder, Mesh, RobotModel, Sphere
from support.urdf_texts import ARM

EXACT = 1e-15


def read(text: str, tip: str | None = None) -> RobotModel:
    found = read_urdf(SourceText("arm.urdf", text), ReadOptions(tip))
    assert found.robot is not None, found.findings
    return found.robot


def turned(roll: float, pitch: float, yaw: float) -> np.ndarray:
    """Return Rz(yaw)·Ry(pitch)·Rx(roll), written out."""
    (sr, sp, sy), (cr, cp, cy) = np.sin([roll, pitch, yaw]), np.cos([roll, pitch, yaw])
    x = np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    y = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    z = np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
    return np.asarray(z @ y @ x)


def test_the_chain_to_the_tip_is_the_arm() -> None:
    robot = read(ARM)
    assert [joint.name for joint in robot.joints] == ["shoulder", "slide"]
    assert robot.n == 2


def test_axes_in_any_direction_turn_and_slide_along_themselves() -> None:
    robot = read(ARM)
    q1, q2 = 0.7, 0.25
    about_y = np.array([[cos(q1), 0, sin(q1)], [0, 1, 0], [-sin(q1), 0, cos(q1)]])
    R = turned(0.1, 0.2, 0.3) @ about_y
    along = np.array([1.0, 2.0, 2.0]) / 3.0
    p = np.array([0, 0, 0.3]) + R @ (np.array([0, 0, 0.5]) + q2 * along + np.array([0.3, 0, 0]))
    X = forward(robot, [q1, q2])
    np.testing.assert_allclose(X.position, p, atol=EXACT)
    np.testing.assert_allclose(X.rotation(), R, atol=4 * EXACT)


def test_a_fixed_link_weighs_with_the_one_that_carries_it() -> None:
    robot = read(ARM)
    upper = robot.links[0]
    com = (4.0 * np.array([0.1, 0.2, 0.3]) + 0.5 * np.array([0.1, 0.0, 0.1])) / 4.5
    Q = turned(0.3, -0.2, 0.5)
    own = Q @ np.array([[0.05, 0.01, 0], [0.01, 0.06, 0], [0, 0, 0.04]]) @ Q.T
    expected = np.zeros((3, 3))
    for mass, at, inertia in ((4.0, [0.1, 0.2, 0.3], own), (0.5, [0.1, 0.0, 0.1], np.eye(3) * 1e-3)):
        r = np.array(at) - com
        expected += inertia + mass * (r @ r * np.eye(3) - np.outer(r, r))
    assert upper.mass == 4.5
    moments = np.linalg.eigvalsh(upper.inertia)
    np.testing.assert_allclose(moments, np.linalg.eigvalsh(expected), rtol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(upper.com), np.linalg.norm(com), rtol=1e-12)
    assert upper.com[2] == pytest.approx(com[1], abs=EXACT)  # along the axis
    assert upper.inertia[2, 2] == pytest.approx(expected[1, 1])


def test_limits_are_those_of_the_file_and_the_rest_is_estimated_and_told() -> None:
    found = read_urdf(SourceText("arm.urdf", ARM))
    assert found.robot is not None
    shoulder, slide = found.robot.joints
    assert (shoulder.lower, shoulder.upper, shoulder.max_effort) == (-2.0, 1.5, 100.0)
    assert (shoulder.max_speed, shoulder.max_acceleration, shoulder.max_jerk) == (2.0, 8.0, 80.0)
    assert (slide.max_speed, slide.max_effort) == (0.5, inf)
    assert slide.max_acceleration > 0.0
    (told,) = [one for one in found.findings if one.code == "X990"]
    assert told.data == {"greatest acceleration and jerk": ("slide",), "greatest effort": ("slide",)}
    assert told.notes[1].endswith("greatest effort, or 0, of joints `slide`: they have no such limit")
    assert any(one.kind == "estimated" for one in found.robot.origins)


def test_friction_of_joints_is_that_of_the_drives() -> None:
    drive = read(ARM).drives[0]
    assert (drive.friction.viscous, drive.friction.coulomb_positive, drive.friction.coulomb_negative) == (
        0.7,
        0.3,
        -0.3,
    )
    assert drive.ratio_at(0.0) == 1.0


def test_a_robot_without_masses_has_no_drives() -> None:
    without = "".join(line for line in ARM.splitlines() if "<mass" not in line and "inertia" not in line)
    text = without.replace("<inertial>", "").replace("</inertial>", "")
    text = text.replace('<origin xyz="0.1 0.2 0.3" rpy="0.3 -0.2 0.5"/>', "")
    assert read(text).drives == ()


def test_looks_are_in_their_places_and_colours() -> None:
    robot = read(ARM)
    (base,) = robot.base_shapes
    assert (base.solid, base.colour, base.opacity) == (Cylinder(0.1, 0.2), "#ff8000", 0.5)
    solids = [one.solid for one in robot.links[0].shapes]
    assert solids == [Box((0.1, 0.1, 0.4)), Sphere(0.05)]
    center = robot.joints[0].placement @ robot.links[0].shapes[1].pose
    expected = np.array([0, 0, 0.3]) + turned(0.1, 0.2, 0.3) @ np.array([0.1, 0, 0.1])
    np.testing.assert_allclose(center.position, expected, atol=EXACT)


def test_a_link_whose_visual_mesh_is_not_drawn_is_drawn_by_its_collision_geometry() -> None:
    mesh = '<mesh filename="package://a/b.fbx"/>'
    text = ARM.replace('<box size="0.1 0.1 0.4"/>', mesh)
    found = read_urdf(
        SourceText("arm.urdf", text), ReadOptions(folder=RobotFolder(packages={"a": "robots/a"}))
    )
    assert found.robot is not None
    assert Sphere(0.3) in [one.solid for one in found.robot.links[0].shapes]
    assert any("b.fbx" in one.message for one in found.findings if one.code == "X995")
    stl = read_urdf(
        SourceText("arm.urdf", text.replace(".fbx", ".stl")),
        ReadOptions(folder=RobotFolder(packages={"a": "x"})),
    )
    assert stl.robot is not None
    assert Mesh("x/b.stl") in [one.solid for one in stl.robot.links[0].shapes]
    unknown = read_urdf(SourceText("arm.urdf", text))
    assert [one.code for one in unknown.findings].count("X991") == 1


def test_missing_meshes_are_said_once_for_each_package_with_their_number_and_errors_come_first() -> None:
    link = '<link name="{0}"><visual><geometry><mesh filename="package://{1}/{0}.stl"/></geometry></visual></link>'
    places = [(f"m{k}", "a" if k % 3 else "b") for k in range(9)] + [("m1", "a")]
    more = "".join(
        link.format(*place).replace('name="m1"', f'name="n{k}"', 1) for k, place in enumerate(places)
    )
    fixed = "".join(
        f'<joint name="f{k}" type="fixed"><parent link="base"/><child link="{child}"/></joint>'
        for k, child in enumerate(re.findall('link name="([mn][0-9])"', more))
    )
    base = re.search(r'<link name="([^"]+)"', ARM)
    assert base is not None
    text = ARM.replace("</robot>", more + fixed.replace("base", base[1]) + "</robot>")
    found = read_urdf(SourceText("arm.urdf", text))
    said = [one.message for one in found.findings if one.code == "X991"]
    assert said == [
        "3 meshes of `package://b` are not near to the robot file, such as `package://b/m0.stl`",
        "6 meshes of `package://a` are not near to the robot file, such as `package://a/m1.stl`",
    ]
    wrong = read_urdf(SourceText("arm.urdf", text.replace('mass value="2"', 'mass value="nan"', 1)))
    errors = [one.is_error for one in wrong.findings]
    assert errors == sorted(errors, reverse=True)


def test_a_box_without_extent_is_left_out() -> None:
    found = read_urdf(SourceText("arm.urdf", ARM.replace('size="0.1 0.1 0.4"', 'size="0 0 0"')))
    assert found.robot is not None
    assert any("extent" in one.message for one in found.findings if one.code == "X995")


def test_a_joint_beside_the_way_to_the_tip_rests_and_its_link_weighs_on() -> None:
    found = read_urdf(SourceText("arm.urdf", ARM))
    assert found.robot is not None
    assert found.robot.links[1].mass == pytest.approx(2.1)
    (lost,) = [one for one in found.findings if one.code == "X993"]
    assert lost.data["joints off the way to the tip"] == ("grip",)
    assert read(ARM, tip="finger").n == 3


def test_a_joint_without_limits_matters_only_where_it_is_an_axis() -> None:
    """Published files end in passive cylinders that have none."""
    text = ARM.replace('<limit lower="0.01" upper="0.05" effort="10" velocity="0.1"/>', "")
    assert read(text) == read(ARM.replace('lower="0.01"', 'lower="-0.01"'))
    found = read_urdf(SourceText("arm.urdf", text), ReadOptions("finger"))
    assert [(one.code, one.message) for one in found.findings if one.is_error] == [
        ("X982", "joint `grip` has no lower and no upper limit")
    ]


LIMIT = '<limit lower="-2" upper="1.5" effort="100" velocity="2" acceleration="8" jerk="80"/>'


@pytest.mark.parametrize(
    ("limit", "lack", "words"),
    [
        ("", "no limits", "no lower and no upper limit of joints `shoulder`: they turn without end"),
        ('<limit effort="1" velocity="1"/>', "equal limits", "both are 0 rad of `shoulder`"),
        ('<limit lower="1" upper="1" effort="1" velocity="1"/>', "equal limits", "both are 1 rad"),
    ],
)
def test_a_joint_without_a_range_turns_without_end_and_is_named(limit: str, lack: str, words: str) -> None:
    found = read_urdf(SourceText("arm.urdf", ARM.replace(LIMIT, limit)))
    assert found.robot is not None
    assert (found.robot.joints[0].lower, found.robot.joints[0].upper) == (-WITHOUT_END, WITHOUT_END)
    (told,) = [one for one in found.findings if one.code == "X999"]
    assert told.data == {lack: ("shoulder",)}
    assert words in told.message
    assert told.span is not None


def test_each_missing_limit_names_its_joints_and_what_is_used_instead() -> None:
    limit = '<limit lower="-2" upper="1.5" effort="0" velocity="0"/>'
    found = read_urdf(SourceText("arm.urdf", ARM.replace(LIMIT, limit)))
    (told,) = [one for one in found.findings if one.code == "X990"]
    assert told.data == {
        "greatest speed": ("shoulder",),
        "greatest acceleration and jerk": ("shoulder", "slide"),
        "greatest effort": ("shoulder", "slide"),
    }
    assert "half a turn in a second" in told.notes[0]
    assert found.robot is not None
    assert found.robot.joints[0].max_speed == pytest.approx(np.pi)


def test_a_file_has_one_finding_of_each_kind() -> None:
    findings = read_urdf(SourceText("arm.urdf", ARM)).findings
    assert len({one.code for one in findings}) == len(findings)


def test_losses_name_the_entities() -> None:
    codes = {one.code: one for one in read_urdf(SourceText("arm.urdf", ARM)).findings}
    assert "`camera`" in " ".join(
        one.message for one in read_urdf(SourceText("a", ARM)).findings if one.code == "X995"
    )
    assert codes["X993"].span is not None
    assert codes["X993"].span.source == "arm.urdf"
    assert not any(one.is_error for one in codes.values())


def test_a_continuous_joint_turns_without_end_and_a_mimic_joint_is_coupled() -> None:
    text = ARM.replace('type="revolute"', 'type="continuous"').replace(
        '<axis xyz="1 2 2"/>', '<axis xyz="1 2 2"/><mimic joint="shoulder" multiplier="0.1" offset="0.2"/>'
    )
    robot = read(text)
    assert robot.n == 1
    assert robot.joints[0].upper == WITHOUT_END
    (coupling,) = robot.couplings
    assert (coupling.dependent, coupling.terms, coupling.constant) == (1, ((0, 0.1),), 0.2)


def test_the_order_of_elements_does_not_matter() -> None:
    head, *joints = ARM.replace("</robot>", "").split("<joint ")
    turned_round = head + "".join(f"<joint {one}" for one in reversed(joints)) + "</robot>"
    a, b = read(ARM), read(turned_round)
    assert (a.joints, a.links, a.X_nM) == (b.joints, b.links, b.X_nM)


BAD = {
    "X980": [ARM[:600], "", "no xml", "<robot></arm>"],
    "X981": ['<!DOCTYPE robot [<!ENTITY a "aa">]><robot name="a"/>', "<robot>" * 300],
    "X982": [
        "<sdf/>",
        '<robot name="a"/>',
        ARM.replace('<parent link="base_link"/>', ""),
        ARM.replace('<mass value="2"/>', ""),
        ARM.replace('limit lower="0.1"', 'limits lower="0.1"'),
        ARM.replace('radius="0.05"', ""),
        ARM.replace('name="slide" ', ""),
        ARM.replace('<box size="0.1 0.1 0.4"/>', ""),
    ],
    "X983": [
        ARM.replace('"1 2 2"', '"0 0 0"'),
        ARM.replace('"1 2 2"', '"nan 0 1"'),
        ARM.replace('"1 2 2"', '"1 2"'),
        ARM.replace('"0 0 0.5"', '"0 0 inf"'),
        ARM.replace('"0 0 0.5"', '"0 0 1e999"'),
        ARM.replace('value="2"', 'value="-2"'),
        ARM.replace('"-2"', '"2"'),
        ARM.replace('lower="0.1" upper="0.4"', 'lower="0.1" upper="0.1"'),
        ARM.replace('size="0.1 0.1 0.4"', 'size="0.1 -0.1 0.4"'),
        ARM.replace('damping="0.7"', 'damping="-0.7"'),
        ARM.replace('velocity="2"', 'velocity="-2"'),
    ],
    "X984": [ARM.replace('"finger"', '"lower"', 1), ARM.replace('name="grip"', 'name="slide"')],
    "X985": [
        ARM.replace('parent link="upper"', 'parent link="uper"'),
        ARM.replace('<axis xyz="1 2 2"/>', '<mimic joint="sholder"/>'),
    ],
    "X986": [
        ARM.replace('<link name="tool0"/>', '<link name="tool0"/><link name="alone"/>'),
        ARM.replace('child link="finger"', 'child link="tool0"'),
        ARM.replace('<parent link="base_link"/>', '<parent link="lower"/>'),
        ARM.replace('<axis xyz="1 2 2"/>', '<mimic joint="slide"/>'),
    ],
    "X987": [
        ARM.replace('type="prismatic"', 'type="floating"'),
        ARM.replace('type="prismatic"', 'type="planar"'),
        ARM.replace('type="prismatic"', 'type="wobbly"'),
        ARM.replace('type="prismatic"', 'type="fixed"').replace('type="revolute"', 'type="fixed"'),
    ],
    "X988": [
        '<robot name="a"><link name="b"/><link name="l"/><link name="r"/>'
        '<joint name="jl" type="continuous"><parent link="b"/><child link="l"/></joint>'
        '<joint name="jr" type="continuous"><parent link="b"/><child link="r"/></joint></robot>'
    ],
}


@pytest.mark.parametrize(("code", "text"), [(code, text) for code, texts in BAD.items() for text in texts])
def test_bad_files_are_answered_with_their_place(code: str, text: str) -> None:
    found = read_urdf(SourceText("bad.urdf", text))
    assert found.robot is None
    errors = [one for one in found.findings if one.is_error]
    assert code in {one.code for one in errors}
    assert all(one.message and one.hint for one in errors)
    assert all(one.span and one.span.line <= text.count("\n") + 1 for one in errors)


def test_a_near_name_is_suggested() -> None:
    found = read_urdf(SourceText("bad.urdf", ARM.replace('parent link="upper"', 'parent link="uper"')))
    assert any("did you mean `upper`" in one.hint for one in found.findings)
    missing = read_urdf(SourceText("a", ARM), ReadOptions(tip="tol0"))
    assert [(one.code, one.hint) for one in missing.findings if one.is_error] == [
        ("X985", "did you mean `tool0`?")
    ]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (ARM.replace('mass value="4"', 'mass value="4000"'), "links are heavy"),
        (ARM.replace('ixx="0.02"', 'ixx="9"'), "moments of inertia"),
        (
            ARM.replace('mass value="2"', 'mass value="0"').replace('mass value="0.1"', 'mass value="0"'),
            "no mass",
        ),
    ],
)
def test_doubtful_bodies_are_told_and_kept(text: str, words: str) -> None:
    found = read_urdf(SourceText("arm.urdf", text))
    assert found.robot is not None
    assert any(one.code == "X989" and words in one.message for one in found.findings)


def test_placeholders_are_told() -> None:
    """Published files give every link 2 kg where nobody knew better."""
    links = "".join(
        f'<link name="l{k}"><inertial><mass value="2"/>'
        '<inertia ixx="1e-2" ixy="0" ixz="0" iyy="1e-2" iyz="0" izz="1e-2"/></inertial></link>'
        for k in range(6)
    )
    joints = "".join(
        f'<joint name="j{k}" type="continuous"><parent link="l{k}"/><child link="l{k + 1}"/>'
        '<origin xyz="0 0 0.4"/><axis xyz="0 1 0"/></joint>'
        for k in range(5)
    )
    found = read_urdf(SourceText("a", f'<robot name="a">{links}{joints}</robot>'))
    assert any("placeholders" in one.hint for one in found.findings if one.code == "X989")


def branch(prefix: str, end: str, joints: int) -> str:
    """Return a chain on the link `base` with a fixed link behind its last joint."""
    names = ["base", *(f"{prefix}l{k}" for k in range(joints)), f"{prefix}{end}"]
    text = "".join(f'<link name="{one}"/>' for one in names[1:])
    for parent, child in pairwise(names):
        kind = "fixed" if child.endswith(end) else "continuous"
        text += (
            f'<joint name="to_{child}" type="{kind}"><parent link="{parent}"/><child link="{child}"/></joint>'
        )
    return text


@pytest.mark.parametrize(
    ("branches", "joints"),
    [
        ([("a_", "tool0", 2), ("b_", "tip", 3)], 2),  # by its name, with a prefix
        ([("a_", "end", 2), ("b_", "tip", 3)], 3),  # by its depth
        ([("a_", "tool0", 2), ("b_", "tool0", 3)], 3),  # by its name, then its depth
        ([("a_", "tool0", 2), ("b_", "tool0", 2)], 0),  # both are alike
    ],
)
def test_the_tip_is_recognised(branches: list[tuple[str, str, int]], joints: int) -> None:
    text = '<robot name="a"><link name="base"/>' + "".join(branch(*one) for one in branches) + "</robot>"
    found = read_urdf(SourceText("a.urdf", text))
    assert (found.robot.n if found.robot else 0) == joints
    if not joints:
        assert [one.code for one in found.findings if one.is_error] == ["X988"]


def test_a_semantic_file_is_recognised() -> None:
    found = read_urdf(SourceText("a.srdf.xacro", '<robot name="a"><group name="arm"/></robot>'))
    assert found.robot is None
    assert "SRDF" in found.findings[0].message


def test_the_ground_needs_no_link() -> None:
    text = (
        '<robot name="a"><link name="base"/><link name="arm"/>'
        '<joint name="stand" type="fixed"><parent link="world"/><child link="base"/>'
        '<origin xyz="0 0 1"/></joint>'
        '<joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint></robot>'
    )
    robot = read(text)
    assert robot.n == 1
    np.testing.assert_allclose(forward(robot, [0.0]).position, [0.0, 0.0, 1.0], atol=EXACT)


def test_followers_that_add_up_may_stand_in_any_order() -> None:
    """Two that follow about one line are one coupling; where the outer one stands first, they stay two."""
    body = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    joint = '<joint name="{0}" type="continuous"><parent link="{1}"/><child link="{2}"/>{3}</joint>'
    follows = '<mimic joint="j"/>'
    inner, outer = joint.format("f", "arm", "mid", follows), joint.format("g", "mid", "tool0", follows)
    head = f'<robot name="a"><link name="base"/><link name="arm">{body}</link><link name="mid"/>'
    head += f'<link name="tool0">{body}</link>' + joint.format("j", "base", "arm", "")
    for text in (inner + outer, outer + inner):
        X = forward(read(f"{head}{text}</robot>"), np.array([0.3])).matrix()
        np.testing.assert_allclose(X[:3, :3] @ X[:3, :3].T, np.eye(3), atol=EXACT)
        assert np.arctan2(X[2, 1], X[1, 1]) == pytest.approx(0.9)
