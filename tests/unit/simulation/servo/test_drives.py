"""Arms with other drives than rigidly geared DC motors in the servo simulation."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import expm

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw, LawInput, LawTraits
from ropsim.dynamics import forward_dynamics, gravity
from ropsim.model import (
    Drive,
    ElasticGear,
    Payload,
    RobotModel,
    VoltageAmplifier,
    ideal_drive,
)
from ropsim.simulation import Servo
from ropsim.simulation.testing import joint_channels
from ropsim.spatial import Array
from support.arms import MOTOR, drive, random_arm
from support.servo_cases import controller, quintic, standing

NOTHING = Payload()
STIFFNESS, DAMPING, RATIO = 2e3, 3.0, 40.0
ELASTIC = Drive(VoltageAmplifier(40.0, 100.0), MOTOR, ElasticGear(RATIO, STIFFNESS, DAMPING))
HOLD = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        out[j] = par[0, j]
"""


def _constant(*commands: float) -> CompiledLaw:
    return CompiledLaw("constant", HOLD, ("command",), np.array([commands]))


def _ideal_two_link() -> RobotModel:
    return replace(robots.load("two_link"), drives=(ideal_drive(60.0), ideal_drive(20.0)))


def test_an_ideal_drive_moves_the_arm_as_forward_dynamics_say() -> None:
    robot = _ideal_two_link()
    servo = Servo.build(robot, controller(2), _constant(15.0, 4.0), Engine.PYTHON)
    q, ticks = np.array([0.3, 0.4]), 20
    start = servo.initial_state(q)
    after = servo.run(start, standing(q, ticks), NOTHING, servo.recorder(start))
    x, h = np.concatenate([q, np.zeros(2)]), 1e-4

    def rate(x: Array) -> Array:
        return np.concatenate([x[2:], forward_dynamics(robot, x[:2], x[2:], np.array([15.0, 4.0]))])

    for _ in range(10 * ticks):
        k1 = rate(x)
        k2 = rate(x + 0.5 * h * k1)
        k3 = rate(x + 0.5 * h * k2)
        x = x + h / 6.0 * (k1 + 2.0 * (k2 + k3) + rate(x + h * k3))
    np.testing.assert_allclose(np.concatenate([after.q, after.qd]), x, rtol=1e-9)


def test_an_ideal_drive_needs_no_motor_data_for_a_controller_that_settles() -> None:
    robot = _ideal_two_link()
    model = robots.default_controller(robot)
    servo = Servo.build(robot, model)
    start, goal = np.array([0.2, 0.3]), np.array([0.9, -0.4])
    state = servo.initial_state(start)
    recorder = servo.recorder(state)
    state = servo.run(state, quintic(start, goal, 1000), NOTHING, recorder)
    state = servo.run(state, standing(goal, 600), NOTHING, recorder)
    assert (np.abs(state.q - goal) < model.in_position).all()
    np.testing.assert_allclose(recorder.channels()["tau"], recorder.channels()["command"], rtol=0, atol=0)
    assert "current" not in recorder.channels()


def test_an_ideal_drive_gives_no_more_than_it_may() -> None:
    servo = Servo.build(_ideal_two_link(), controller(2), _constant(1e3, -1e3), Engine.PYTHON)
    state = servo.initial_state(np.zeros(2))
    recorder = servo.recorder(state)
    servo.run(state, standing(np.zeros(2), 3), NOTHING, recorder)
    assert recorder.channels()["tau"][1:].tolist() == [[60.0, -20.0]] * 3


def _free_axis() -> tuple[RobotModel, float]:
    """Return one elastic axis without gravity and its inertia [kg·m²]."""
    robot = replace(random_arm(6, "R", (ELASTIC,)), gravity=np.zeros(3))
    link = robot.links[0]
    x, y, _ = link.com
    return robot, float(link.inertia[2, 2] + link.mass * (x * x + y * y))


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_an_elastic_axis_moves_as_the_matrix_exponential_says(sign: float) -> None:
    """Two inertias and a spring, driven by a DC motor: linear in (q, q̇, i, θ/G, ω/G)."""
    robot, inertia = _free_axis()
    turned = replace(ELASTIC, transmission=ElasticGear(sign * RATIO, STIFFNESS, DAMPING))
    robot = replace(robot, drives=(turned,))
    servo = Servo.build(robot, controller(1), _constant(5.0), Engine.PYTHON)
    rotor = MOTOR.rotor_inertia * RATIO**2
    spring = np.array([-STIFFNESS, -DAMPING, 0.0, STIFFNESS, DAMPING, 0.0])
    A = np.zeros((6, 6))
    A[0, 1] = A[3, 4] = 1.0
    A[1] = spring / inertia
    A[4] = -spring / rotor
    A[4, 2] = sign * RATIO * MOTOR.torque_constant / rotor
    A[2, [2, 4, 5]] = (
        np.array([-MOTOR.resistance, -sign * RATIO * MOTOR.back_emf_constant, sign * 5.0]) / MOTOR.inductance
    )
    expected = expm(A * 0.04) @ np.array([0.0, 0.0, 0.0, 0.0, 0.0, 1.0])
    start = servo.initial_state(np.zeros(1))
    after = servo.run(start, standing(np.zeros(1), 40), NOTHING, servo.recorder(start))
    attained = [after.q[0], after.qd[0], *(after.drive(name)[0] for name in ("current", "motor_coordinate"))]
    assert abs(after.q[0] - after.drive("motor_coordinate")[0]) > 1e-5
    np.testing.assert_allclose(attained, expected[[0, 1, 2, 3]], rtol=1e-4)


def test_a_free_elastic_axis_swings_at_its_natural_frequency() -> None:
    """ω² = k·(1/I + 1/(J·G²)) for two inertias on a spring without damping."""
    robot, inertia = _free_axis()
    motor = replace(MOTOR, torque_constant=1e-9, back_emf_constant=1e-9)
    soft = Drive(VoltageAmplifier(40.0, 100.0), motor, ElasticGear(RATIO, STIFFNESS))
    servo = Servo.build(replace(robot, drives=(soft,)), controller(1), _constant(0.0), Engine.PYTHON)
    values = servo.initial_state(np.zeros(1)).values.copy()
    values[list(servo.layout.drive(0))[1]] = 0.01
    state = replace(servo.initial_state(np.zeros(1)), values=values)
    recorder = servo.recorder(state)
    servo.run(state, standing(np.zeros(1), 400), NOTHING, recorder)
    rows = recorder.channels()
    twist = (rows["motor_coordinate"] - rows["q"])[:, 0]
    expected = np.sqrt(STIFFNESS * (1.0 / inertia + 1.0 / (MOTOR.rotor_inertia * RATIO**2)))
    np.testing.assert_allclose(twist, 0.01 * np.cos(expected * np.arange(401) * 1e-3), rtol=0, atol=2e-6)


def test_an_elastic_arm_stands_still_against_gravity() -> None:
    robot = random_arm(3, "RR", (ELASTIC,) * 2)
    servo = Servo.build(robot, controller(2), None, Engine.PYTHON)
    q = np.array([0.4, -0.2])
    start = servo.initial_state(q)
    recorder = servo.recorder(start)
    after = servo.run(start, standing(q, 10), NOTHING, recorder)
    np.testing.assert_allclose(after.q, q, rtol=0, atol=1e-9)
    np.testing.assert_allclose(recorder.channels()["tau"][0], gravity(robot, q), rtol=1e-9)
    np.testing.assert_allclose(recorder.channels()["tau"][-1], gravity(robot, q), rtol=1e-6)


def test_every_joint_has_the_channels_of_its_own_drive() -> None:
    robot = random_arm(5, "RPR", (drive(), ideal_drive(50.0), ELASTIC))
    servo = Servo.build(robot, controller(3), _constant(1.0, 2.0, 3.0), Engine.PYTHON)
    start = servo.initial_state(np.zeros(3))
    recorder = servo.recorder(start)
    servo.run(start, standing(np.zeros(3), 4), NOTHING, recorder)
    channels = joint_channels("robot", robot, recorder.channels())
    columns = {name: channel.columns for name, channel in channels.items()}
    assert columns == {
        **dict.fromkeys(("q", "qd", "tau", "q_ref", "qd_ref"), ("1", "2", "3")),
        **dict.fromkeys(("current", "voltage"), ("1", "3")),
        "command": ("2",),
        **dict.fromkeys(("motor_coordinate", "motor_speed"), ("3",)),
    }
    assert channels["command"].unit == "N"
    assert channels["motor_speed"].unit == "rad/s"
    assert channels["command"].values[1:, 0].tolist() == [2.0] * 4
    assert channels["voltage"].values[1:].tolist() == [[1.0, 3.0]] * 4
    spring = STIFFNESS * (channels["motor_coordinate"].values[:, 0] - channels["q"].values[:, 2])
    damper = DAMPING * (channels["motor_speed"].values[:, 0] - channels["qd"].values[:, 2])
    np.testing.assert_allclose(channels["tau"].values[:, 2], spring + damper, rtol=1e-12, atol=1e-12)


def test_states_of_the_same_name_stand_together() -> None:
    robot = random_arm(5, "RPR", (drive(), ideal_drive(), ELASTIC))
    layout = Servo.build(robot, controller(3), _constant(0.0, 0.0, 0.0), Engine.PYTHON).layout
    assert [(field.name, field.axes, field.first) for field in layout.drives] == [
        ("current", (0, 2), 6),
        ("motor_coordinate", (2,), 8),
        ("motor_speed", (2,), 9),
    ]
    assert (layout.integrated, layout.output) == (10, slice(10, 13))
    assert (layout.reference, layout.size) == (slice(13, 22), 22)
    assert layout.drive(2) == (7, 8, 9)


ECHO = """\
def law(par, state, ref, meas, load, aux, out):
    for j in range(out.shape[0]):
        out[j] = meas[1, j] + par[0, j]
"""


class EchoLaw:
    """What `ECHO` does, in Python."""

    traits = LawTraits()

    def step(self, now: LawInput, state: Array) -> Array:
        """Return the measured speeds, more by 5."""
        del state
        return np.asarray(now.meas[1] + 5.0)


@pytest.mark.parametrize("law", [CompiledLaw("echo", ECHO, ("more",), np.array([[5.0, 5.0]])), EchoLaw()])
def test_laws_are_given_the_speeds_of_the_motors(law: CompiledLaw | EchoLaw) -> None:
    rigid = drive()
    robot = replace(random_arm(6, "RR", (ELASTIC, rigid)), gravity=np.zeros(3))
    servo = Servo.build(robot, controller(2), law, Engine.PYTHON)
    state = servo.initial_state(np.zeros(2))
    for _ in range(15):
        speeds = [state.drive("motor_speed")[0], state.qd[1]]
        state = servo.run(state, standing(np.zeros(2), 1), NOTHING, servo.recorder(state))
        np.testing.assert_allclose(state.output, np.sign(RATIO) * (np.array(speeds) + 5.0), rtol=1e-12)
    assert abs(state.drive("motor_speed")[0] - state.qd[0]) > 1e-3
