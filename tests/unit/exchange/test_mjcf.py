"""MJCF in and out: what comes back, what is included, what is refused and what is lost."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import SourceText
from ropsim.dynamics import inverse_dynamics
from ropsim.exchange import ReadOptions, RobotFolder, read_mjcf, write_mjcf
from ropsim.kinematics import solver_of
from ropsim.model import (
    ALL_DIRECTIONS,
    Box,
    Cylinder,
    Direction,
    LoopCut,
    Mesh,
    RobotModel,
    Sphere,
)
from ropsim.spatial import Pose, frozen
from support.exchange_laws import differences, random_chain
from support.mjcf_texts import ARM
from support.mujoco_files import MujocoFile

SAME = 1e-12
"""Some ten products of rotations, each rounded [m, N·m over the largest]."""


def again(robot: RobotModel) -> RobotModel:
    found = read_mjcf(SourceText("a.xml", write_mjcf(robot).text))
    assert found.robot is not None, found.findings
    return found.robot


@pytest.mark.parametrize("name", ["palletizer", "scara", "two_link"])
def test_a_built_in_robot_comes_back_whole(name: str) -> None:
    robot = robots.load(name)
    other = again(robot)
    assert max(differences(robot, other)) < SAME
    assert solver_of(other).name == solver_of(robot).name
    for row in ("home", "lower_limits", "upper_limits", "max_speeds", "max_accelerations", "max_jerks"):
        np.testing.assert_array_equal(getattr(other, row), getattr(robot, row))
    q, qd, qdd = np.random.default_rng(2).uniform(0.5, 1.0, (3, robot.n))  # where dry friction is all there
    tau = inverse_dynamics(robot, q, qd, qdd)
    np.testing.assert_allclose(inverse_dynamics(other, q, qd, qdd), tau, rtol=SAME)  # rotors and friction


@pytest.mark.parametrize("seed", range(4))
def test_joints_of_every_type_come_back_as_motion(seed: int) -> None:
    robot = replace(random_chain(seed), gravity=frozen([1.0, 2.0, 3.0]))
    assert max(differences(robot, again(robot))) < SAME


def test_what_is_drawn_is_what_a_body_shows_not_what_it_collides_with() -> None:
    robot = read_mjcf(SourceText("a.xml", ARM)).robot
    assert robot is not None
    (shape,) = robot.links[0].shapes
    assert (shape.solid, shape.colour, shape.opacity) == (Box((0.2, 0.4, 0.6)), "#0000ff", 0.5)
    hidden = ARM.replace('<geom type="box" size="0.1 0.2 0.3" rgba="0 0 1 0.5"/>', "")
    bare = read_mjcf(SourceText("a.xml", hidden)).robot
    assert bare is not None
    assert [type(one.solid) for one in bare.links[0].shapes] == [Cylinder, Sphere, Sphere]


def test_included_files_and_meshes_are_found_inside_of_the_folder(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    (folder / "robots").mkdir(parents=True)
    head, tail = ARM.split('      <body name="b"')
    fore = tail.split("    </body>\n  </worldbody>")[0]
    (folder / "robots" / "fore.xml").write_text(f'<mujoco><body name="b"{fore}</mujoco>')
    (folder / "robots" / "a.stl").write_text("solid")
    (tmp_path / "outside.xml").write_text("<mujoco/>")
    mesh = '<asset><mesh name="m" file="a.stl" scale="2 2 2"/></asset>'
    main = head.replace("<worldbody>", f"{mesh}<worldbody>").replace(
        '<geom type="box" size="0.1 0.2 0.3" rgba="0 0 1 0.5"/>', '<geom type="mesh" mesh="m"/>'
    )
    main += '<include file="fore.xml"/></body></worldbody></mujoco>'
    options = ReadOptions(folder=RobotFolder(folder, beside="robots"))
    found = read_mjcf(SourceText("robots/main.xml", main), options)
    assert found.robot is not None, found.findings
    assert max(differences(found.robot, _arm())) < SAME
    assert [one.solid for one in found.robot.links[0].shapes] == [Mesh("robots/a.stl", 2.0)]
    for name in ("../../outside.xml", "absent.xml", "/etc/hostname", "package://a/b.xml"):
        refused = read_mjcf(SourceText("a.xml", main.replace("fore.xml", name)), options)
        assert refused.robot is None
        assert [one.code for one in refused.findings if one.is_error] == ["X982"]


def _arm() -> RobotModel:
    robot = read_mjcf(SourceText("a.xml", ARM)).robot
    assert robot is not None
    return robot


def test_a_file_that_includes_itself_is_refused(tmp_path: Path) -> None:
    text = '<mujoco><worldbody/><include file="a.xml"/></mujoco>'
    (tmp_path / "a.xml").write_text(text)
    found = read_mjcf(SourceText("a.xml", text), ReadOptions(folder=RobotFolder(tmp_path)))
    assert found.robot is None
    assert any(one.code == "X981" for one in found.findings)


def test_parts_that_lie_about_are_left_out() -> None:
    part = '<body name="part"><freejoint/><geom size="0.1"/></body></worldbody>'
    found = read_mjcf(SourceText("a.xml", ARM.replace("</worldbody>", part)))
    assert found.robot is not None
    assert found.robot == _arm()
    assert any("`part`" in one.message for one in found.findings if one.code == "X993")


def test_losses_of_reading_are_told() -> None:
    text = ARM.replace("</mujoco>", "<sensor/><tendon><fixed/></tendon></mujoco>")
    text = text.replace("</worldbody>", '</worldbody><equality><weld body1="a" body2="b"/></equality>')
    text = text.replace('name="j2"', 'name="j2" stiffness="3"')
    words = " ".join(f"{one.code} {one.message}" for one in read_mjcf(SourceText("a", text)).findings)
    for what in ("`sensor`", "tendons", "`weld`", "springs (`j2`)"):
        assert what in words


def test_closed_chains_are_held_in_mujoco() -> None:
    """A hinge between the two ends of a bent arm and the base: MuJoCo counts what holds it."""
    robot = robots.load("two_link")
    base = dict(axes=(0, 1), drives=(), home=frozen([0.0, 0.0]))
    for held, constraints in (
        (ALL_DIRECTIONS, 6),
        ((Direction.X, Direction.Y, Direction.Z), 3),
        (tuple(set(ALL_DIRECTIONS) - {Direction.ABOUT_Z}), 6),
    ):
        cut = LoopCut(1, Pose(frozen([1.0, 0.0, 0.0])), -1, Pose(frozen([2.0, 0.0, 0.0])), held)
        written = write_mjcf(replace(robot, cuts=(cut,), **base))  # type: ignore[arg-type]
        assert not [one for one in written.losses if one.code == "X993"]
        model = MujocoFile(written.text).model
        assert sum({0: 3, 1: 6}[int(kind)] for kind in model.eq_type) == constraints
    cut = LoopCut(1, Pose(), -1, Pose(), (Direction.X,))
    assert [one.code for one in write_mjcf(replace(robot, cuts=(cut,))).losses if one.code == "X993"]


BAD = {
    "X982": [
        "<robot/>",
        "<mujoco/>",
        ARM.replace('mass="2" ', ""),
        ARM.replace('axis="0 1 0" range="-1 1"', 'type="slide"'),
    ],
    "X983": [
        ARM.replace("0 1 0", "0 0 0"),
        ARM.replace("-1 1", "1 -1"),
        ARM.replace('mass="2"', 'mass="-2"'),
        ARM.replace("0 0 1", "0 0 1e400"),
        ARM.replace('pos="0 0 0.5"', 'quat="0 0 0 0"'),
        ARM.replace('pos="0 0 0.5"', 'xyaxes="1 0 0 2 0 0"'),
        ARM.replace('size="0.1 0.2 0.3"', 'size="0.1 0 0.3"'),
    ],
    "X984": [ARM.replace('"j2"', '"j1"'), ARM.replace('name="b"', 'name="a"')],
    "X985": [
        ARM.replace('name="j2"', 'name="j2" class="x"'),
        ARM.replace('type="box" size="0.1 0.2 0.3"', 'type="mesh" mesh="m"'),
        ARM.replace("</mujoco>", '<equality><joint joint1="j3"/></equality></mujoco>'),
        ARM.replace("</mujoco>", '<equality><joint joint1="j1" joint2="j"/></equality></mujoco>'),
    ],
    "X986": [ARM.replace("</mujoco>", '<equality><joint joint1="j1" joint2="j1"/></equality></mujoco>')],
    "X987": [ARM.replace('axis="1 0 0"', 'type="ball"'), "<mujoco><worldbody/></mujoco>"],
}


@pytest.mark.parametrize(("code", "text"), [(code, text) for code, texts in BAD.items() for text in texts])
def test_bad_files_are_answered_with_their_place(code: str, text: str) -> None:
    found = read_mjcf(SourceText("bad.xml", text))
    assert found.robot is None
    errors = [one for one in found.findings if one.is_error]
    assert code in {one.code for one in errors}
    assert all(one.message and one.hint for one in errors)


@pytest.mark.parametrize("name", ["tcp", "b"])
def test_the_tip_is_a_body_or_a_site(name: str) -> None:
    robot = read_mjcf(SourceText("a.xml", ARM), ReadOptions(name)).robot
    assert robot is not None
    assert (
        robot.X_nM.position[2 if name == "tcp" else 0] == 0.0
    )  # j2 turns about x: its z is the x of the body
    assert float(np.linalg.norm(robot.X_nM.position)) == pytest.approx(0.3 if name == "tcp" else 0.0)


def test_names_that_are_blank_are_given() -> None:
    robot = read_mjcf(SourceText("a.xml", ARM.replace('name="j2"', 'name=" "'))).robot
    assert robot is not None
    assert [joint.name for joint in robot.joints] == ["j1", "b_joint"]
