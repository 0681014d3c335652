"""The published controller of the Manutec r3, from its file, against the published equations of its drives.

The oracle integrates arm (MuJoCo), elastic gears, friction, motors with their current loops and the
continuous controllers of the Modelica Standard Library, Mechanics.MultiBody.Examples.Systems.RobotR3, with
scipy. The current loop there, a network of operational amplifiers, is i'' + 2·D·w·i' + w²·(i - i_ref) =
-(2·D·w/250)·k·ω'.
"""

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim import robots
from ropsim.blockdiagram import (
    Axes,
    CascadeGains,
    OutputKind,
    motor_cascade,
    published_controller,
    published_controllers,
    read_diagram,
    write_diagram,
)
from ropsim.controller import diagram_law
from ropsim.dynamics import gravity
from ropsim.flow import JointReference, MoveEvent
from ropsim.model import (
    Gear,
    IdealMotor,
    JointType,
    Payload,
    Rates,
    combine,
    moved,
)
from ropsim.simulation import Fidelity, RunOptions, SimulationOptions, simulate
from ropsim.spatial import Array
from ropsim.workbench import open_project
from support.mujoco_arm import MujocoArm

START = np.radians([-60.0, 20.0, 90.0, 0.0, -110.0, 0.0])
WAY = np.radians([60.0, -70.0, -35.0, 45.0, 110.0, 45.0]) - START
SPEEDS = np.array([3.0, 1.5, 5.0, 3.1, 3.1, 4.1])
ACCELERATIONS = np.array([15.0, 15.0, 15.0, 60.0, 60.0, 60.0])
SYNCHRONOUS = 1.3560450019040893
"""Time of the fastest synchronous motion with these limits [s]."""
SWING = 0.5
"""Time that the published simulation goes on behind it [s]."""
LOAD = Payload(15.0, np.array([0.1, 0.1, 0.25]), 1e-3 * np.eye(3))
HZ = 4000
G = np.array([-105.0, 210.0, 60.0, -99.0, 79.2, -99.0])
K = np.array([1.1616, 1.1616, 1.1616, 0.2365, 0.2608, 0.0842])
KP, KS, TS = 5.0, 0.5, 0.05


def reference(t: Array) -> tuple[Array, Array, Array]:
    """Return the fastest synchronous motion with bounded speed and acceleration, each shape (k, 6)."""
    v, a = (SPEEDS / np.abs(WAY)).min(), (ACCELERATIONS / np.abs(WAY)).min()
    end, rise = 1.0 / v + v / a, v / a
    left = np.maximum(end - t, 0.0)
    parts = [t < rise, t < end - rise, t < end]
    s = np.select(parts, [0.5 * a * t * t, v * (t - 0.5 * rise), 1.0 - 0.5 * a * left * left], 1.0)
    sd, sdd = np.select(parts, [a * t, v + 0.0 * t, a * left], 0.0), np.select(parts, [a, 0.0, -a], 0.0)
    assert end == pytest.approx(SYNCHRONOUS, rel=1e-15)
    return START + s[:, None] * WAY, sd[:, None] * WAY, sdd[:, None] * WAY


def times() -> Array:
    return np.arange(1, int((SYNCHRONOUS + SWING) * HZ) + 1) / HZ


@cache
def published() -> tuple[Array, Array]:
    """Return coordinates [rad] and currents [A] of the published model at the control ticks."""
    robot, J = robots.load("manutec_r3"), np.array([1.3e-3, 1.3e-3, 1.3e-3, 1.6e-4, 1.8e-4, 4.3e-5])
    w, D = np.array([4590.0, 5500, 5500, 6250, 6250, 7400]), np.array([0.6, 0.6, 0.6, 0.55, 0.55, 0.27])
    c, d = np.array([43.0, 8.0, 58.0]), np.array([0.005, 0.01, 0.04])
    dry, viscous = (
        np.array([0.4, 0.5, 0.7, 21.8, 30.1, 10.9]),
        np.array([0.13 / 160, 0.1 / 130, 0.2 / 130, 9.8, 0.03, 3.92]),
    )
    sharp = np.array([one.friction.smoothing_speed for one in robot.drives])
    rotors = [0.0, 0.0, 0.0, *J[3:].tolist()]
    drives = tuple(
        replace(one, motor=IdealMotor(rotor), transmission=Gear(float(g)))
        for one, rotor, g in zip(robot.drives, rotors, G, strict=True)
    )
    last = robot.links[-1]
    held = combine((Payload(last.mass, last.com, last.inertia), moved(LOAD, robot.X_nM)))
    links = (*robot.links[:-1], replace(last, mass=held.mass, com=held.com, inertia=held.inertia))
    arm, E, R = MujocoArm(replace(robot, drives=drives, links=links)), slice(0, 3), slice(3, 6)

    def rates(t: float, y: Array) -> Array:
        q, qd, angle, speed, x, i, di = np.split(y, [6, 12, 15, 18, 24, 30])
        q_ref, qd_ref, _ = (one[0] for one in reference(np.array([t])))
        angles, speeds = np.concatenate((angle, G[R] * q[R])), np.concatenate((speed, G[R] * qd[R]))
        error = KP * (G * q_ref - angles) + G * qd_ref - speeds
        rubbed = dry * np.tanh(speeds / G / sharp * np.where(np.arange(6) < 3, np.sign(G), 1.0))
        spring = c * (angle - G[E] * q[E]) + d * (speed - G[E] * qd[E])
        efforts = G[R] * K[R] * i[R] - rubbed[R] - viscous[R] * qd[R]
        qdd = arm.forward(q, qd, np.concatenate((G[E] * spring, efforts)))
        turned = (K[E] * i[E] - rubbed[E] - viscous[E] * speed - spring) / J[E]
        emf = 2.0 * D * w / 250.0 * K * np.concatenate((turned, G[R] * qdd[R]))
        i_ref = KS * (error + x / TS)
        ddi = w * w * (i_ref - i) - 2.0 * D * w * di - emf
        return np.concatenate((qd, qdd, speed, turned, error, di, ddi))

    tau = gravity(robot, START, LOAD)
    i = tau / G / K
    angle = G[E] * START[E] + tau[E] / G[E] / c
    x = TS * (i / KS - KP * (G * START - np.concatenate((angle, G[R] * START[R]))))
    y = np.concatenate((START, np.zeros(6), angle, np.zeros(3), x, i, np.zeros(6)))
    made = solve_ivp(rates, (0.0, times()[-1]), y, "LSODA", times(), rtol=1e-6, atol=1e-8, max_step=2e-3)
    assert made.success
    return made.y[:6].T, made.y[24:30].T


def data(text: str) -> str:
    """Return a file without its header, which has the version of the writer."""
    return text.partition("DATA;")[2]


def test_the_file_is_canonical_and_cites_its_source() -> None:
    assert published_controllers() == ("manutec_r3",)
    text = published_controller("manutec_r3")
    found = read_diagram(text)
    assert found.findings == ()
    assert found.diagram is not None
    assert data(write_diagram(found.diagram)) == data(text.text)
    assert "DFVLR-Mitteilung 88-13" in found.diagram.description
    assert found.diagram.arm == "manutec_r3"


def test_positions_and_currents_are_those_of_the_published_model() -> None:
    robot, diagram = robots.load("manutec_r3"), read_diagram(published_controller("manutec_r3")).diagram
    assert diagram is not None
    controller = replace(robots.default_controller("manutec_r3"), rates=Rates(HZ, 4, 1))
    options = SimulationOptions(start=START, law=diagram_law(diagram, robot), payload=LOAD)
    made = simulate(robot, controller, JointReference(*reference(times())), options)
    q, i = published()
    assert np.abs(made.channels["q"].values[1:] - q).max() < 1e-4  # demanded are 1e-3 rad; 2.6e-5 are reached
    assert np.abs(q - reference(times())[0]).max() > 0.01  # the arm is that much behind its reference
    currents = made.channels["command"].values[1:] / K
    most = np.abs(i).max(axis=0)
    assert (np.abs(currents - i).max(axis=0) / most).max() < 0.03  # 1.1 % are reached
    assert (most > 7.0).all()
    limits = [one.max_effort for one in robot.joints] / np.abs(G)
    used = np.abs(made.channels["command"].values).max(axis=0) / limits
    assert (used < 1.0).all()
    assert used.max() > 0.95  # the limits are what this motion needs, and hardly more


def test_the_builder_of_cascades_at_the_motors_makes_the_same_controller() -> None:
    robot, diagram = robots.load("manutec_r3"), read_diagram(published_controller("manutec_r3")).diagram
    assert diagram is not None
    axes = Axes((JointType.REVOLUTE,) * 6, 1.0 / HZ, OutputKind.EFFORT)
    gains = CascadeGains(KP, tuple((KS * K).tolist()), tuple((KS / TS * K).tolist()))
    built = motor_cascade(axes, gains, G, (True,) * 3 + (False,) * 3)
    controller = replace(robots.default_controller("manutec_r3"), rates=Rates(HZ, 4, 1))
    ticks = JointReference(*(one[:400] for one in reference(times())))
    first, second = (
        simulate(robot, controller, ticks, SimulationOptions(start=START, law=diagram_law(one, robot)))
        for one in (diagram, built)
    )
    np.testing.assert_allclose(first.channels["q"].values, second.channels["q"].values, rtol=0.0, atol=1e-12)


CELL = """\
[robot]
model = "manutec_r3"
start = [-60, 20, 90, 0, -110, 0]
tool = "load"

[tools.load]
position = [0, 0, 0]
mass = 15
com = [100, 100, 250]
inertia = [0.001, 0.001, 0.001, 0, 0, 0]

[controller]
file = "manutec_r3.p21"
control_hz = 4000
joint_jerk = [5e7, 5e7, 5e7, 5e7, 5e7, 5e7]
"""


def test_a_cell_with_the_file_moves_in_the_synchronous_time(tmp_path: Path) -> None:
    (tmp_path / "programs").mkdir()
    (tmp_path / "manutec_r3.p21").write_text(published_controller("manutec_r3").text, "utf-8")
    (tmp_path / "cell.toml").write_text(CELL, "utf-8")
    text = "program p\nunits mm, deg, s\nmov joints(60, -70, -35, 45, 110, 45)\n"
    (tmp_path / "programs" / "main.task").write_text(text, "utf-8")
    project = open_project(tmp_path)
    assert [one for one in project.compile().diagnostics if one.is_error] == []
    recording = project.simulate(options=RunOptions(Fidelity.DYNAMIC))
    (move,) = (event for event in recording.events if isinstance(event, MoveEvent))
    assert abs(move.travel - SYNCHRONOUS) <= 1.0 / HZ
    error = np.abs(recording.channels["q_error"].values).max(axis=0)
    q, _ = published()
    own = np.abs(q - reference(times())[0]).max(axis=0)
    np.testing.assert_allclose(error, own, rtol=0.02)
