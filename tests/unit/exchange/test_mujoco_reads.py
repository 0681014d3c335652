"""MuJoCo reads what we write, and we read what it reads: poses, mass matrix and torques agree."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import SourceText
from ropsim.dynamics import mass_matrix, rigid_inverse_dynamics
from ropsim.exchange import read_mjcf, write_mjcf, write_urdf
from ropsim.exchange.testing import friction_at_joint, rotor_at_joint
from ropsim.kinematics import forward
from ropsim.model import RobotModel
from support.exchange_laws import random_chain
from support.mjcf_texts import HANDS
from support.mujoco_files import MujocoFile

SAME = 1e-9
"""Relative to the largest torque: two engines add up some thousand rounded terms."""
NAMES = ["palletizer", "puma560", "scara", "two_link"]
EXTENDED = (
    '<mujoco><compiler discardvisual="true" fusestatic="false" boundmass="1e-12" boundinertia="1e-12"/>'
)


def possible(robot: RobotModel) -> RobotModel:
    """Return a robot with moments of inertia that MuJoCo takes; the published ones of the PUMA are not."""
    links = (replace(one, inertia=one.inertia + 0.03 * one.mass * np.eye(3)) for one in robot.links)
    return replace(
        robot,
        links=tuple(replace(one, mass=max(one.mass, 1.0), inertia=one.inertia + np.eye(3)) for one in links),
    )


def robot_of(name: str) -> RobotModel:
    return possible(robots.load(name)) if name == "puma560" else robots.load(name)


def agree(robot: RobotModel, file: MujocoFile, kind: str, rotors: np.ndarray, viscous: np.ndarray) -> None:
    T, c = file.rows(robot)
    rng = np.random.default_rng(5)
    for q, qd, qdd in rng.uniform(-1.5, 1.5, (4, 3, robot.n)):
        np.testing.assert_allclose(
            forward(robot, q).matrix(), file.frame(T @ q + c, "flange", kind), atol=SAME
        )
        M = T.T @ file.mass_matrix(T @ q + c) @ T
        ours = mass_matrix(replace(robot, drives=()), q) + np.diag(rotors)
        np.testing.assert_allclose(M, ours, rtol=0.0, atol=SAME * np.abs(ours).max())
        tau = rigid_inverse_dynamics(robot, q, qd, qdd) + rotors * qdd + viscous * qd
        found = T.T @ file.inverse(T @ q + c, T @ qd, T @ qdd)
        np.testing.assert_allclose(found, tau, rtol=0.0, atol=SAME * max(1.0, np.abs(tau).max()))


@pytest.mark.parametrize("name", NAMES)
def test_mujoco_has_the_same_robot_from_our_mjcf(name: str) -> None:
    robot = robot_of(name)
    rotors = np.array([rotor_at_joint(one, 0.0) for one in robot.drives])
    viscous = np.array([friction_at_joint(one, 0.0)[0] for one in robot.drives])
    agree(robot, MujocoFile(write_mjcf(robot).text), "site", rotors, viscous)


@pytest.mark.parametrize("name", NAMES)
def test_mujoco_has_the_same_robot_from_our_urdf(name: str) -> None:
    robot = robot_of(name)
    viscous = np.array([friction_at_joint(one, 0.0)[0] for one in robot.drives])
    text = write_urdf(robot).text.replace("  <link", f"  {EXTENDED}</mujoco>\n  <link", 1)
    agree(robot, MujocoFile(text), "body", np.zeros(robot.n), viscous)


@pytest.mark.parametrize("seed", range(4))
def test_mujoco_has_joints_of_every_type_from_our_mjcf(seed: int) -> None:
    robot = random_chain(seed)
    zero = np.zeros(robot.n)
    agree(robot, MujocoFile(write_mjcf(robot).text), "site", zero, zero)


def test_mujoco_takes_the_puma_with_its_smaller_moments_raised() -> None:
    written = write_mjcf(robots.load("puma560"))
    MujocoFile(written.text)
    (told,) = [one for one in written.losses if one.code == "X989"]
    assert "`link_1`, `link_3`" in told.message


@pytest.mark.parametrize(("angle", "order"), [("degree", "xyz"), ("radian", "ZYX"), ("degree", "zxz")])
def test_we_read_what_mujoco_reads(angle: str, order: str) -> None:
    text = HANDS.format(angle=angle, order=order)
    found = read_mjcf(SourceText("hands.xml", text))
    robot, file = found.robot, MujocoFile(text)
    assert robot is not None, found.findings
    assert [joint.name for joint in robot.axis_joints] == ["elbow", "shoulder", "lift"]
    places = [int(file.model.joint(joint.name).qposadr[0]) for joint in robot.joints]
    names = [joint.name for joint in robot.joints]
    rotors = np.array([0.2, 0.7, 0.7])
    rng = np.random.default_rng(6)
    for q, qd, qdd in rng.uniform(-1.0, 1.0, (4, 3, 3)):
        C, c = np.zeros((4, 3)), np.zeros(4)
        for axis, name in enumerate(("elbow", "shoulder", "lift")):
            C[places[names.index(name)], axis] = 1.0
        (coupling,) = robot.couplings
        at = places[names.index("wrist")]
        C[at, 0], c[at] = 0.5, coupling.constant
        X = file.frame(C @ q + c, "flange")
        np.testing.assert_allclose(forward(robot, q).matrix(), X, atol=SAME)
        tau = rigid_inverse_dynamics(robot, q, qd, qdd) + rotors * qdd + 0.5 * qd
        wrist = 0.5 * (0.7 * 0.5 * qdd[0] + 0.5 * 0.5 * qd[0])  # rotor and friction of the one that follows
        tau[0] += wrist
        expected = C.T @ file.inverse(C @ q + c, C @ qd, C @ qdd)
        np.testing.assert_allclose(tau, expected, rtol=0.0, atol=SAME * np.abs(expected).max())


def test_what_mjcf_says_of_axes_is_taken() -> None:
    robot = read_mjcf(SourceText("hands.xml", HANDS.format(angle="degree", order="xyz"))).robot
    assert robot is not None
    assert robot.max_efforts.tolist() == [60.0, 70.0, np.inf]
    np.testing.assert_allclose(robot.lower_limits, [-np.radians(100.0), -np.radians(90.0), -0.2])
    np.testing.assert_allclose(robot.home, [0.3, 0.1, 0.2])
    assert robot.gravity.tolist() == [1.0, -2.0, -9.0]
    assert robot.drives[0].friction.coulomb_positive == 0.1
