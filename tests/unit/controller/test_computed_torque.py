"""The computed-torque law: errors die out as its gains say, whatever couples the axes."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.controller import CompiledLaw, GainError, law_of
from ropsim.dynamics import inverse_dynamics, with_rigid_gears
from ropsim.model import (
    ComputedTorqueGains,
    ControllerKind,
    ControllerModel,
    Friction,
    Gear,
    IdealMotor,
    Payload,
    Rates,
    RobotModel,
    ideal_drive,
)
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.arms import random_arm
from support.dc_drives import dc_motor
from support.servo_cases import quintic, standing

FAST = Rates(control_hz=10_000, interpolation_ticks=4, plant_steps=1)
OMEGA = 20.0  # [rad/s]
LOAD = Payload(1.5, np.array([0.05, -0.1, 0.2]), np.diag([0.02, 0.03, 0.01]))


def torque_controller(robot: RobotModel, rates: Rates = FAST) -> ControllerModel:
    rate = np.full(robot.n, OMEGA)
    standard = robots.default_controller("two_link")
    gains = ComputedTorqueGains(rate**2, 2.0 * rate, np.zeros(robot.n))
    return replace(standard, rates=rates, gains=gains, in_position=np.full(robot.n, 1e-3))


def output(robot: RobotModel, ref: Array, meas: Array, load: Payload) -> Array:
    """Return what the law puts out, evaluated in plain Python."""
    from ropsim.dynamics import barycentric

    law = law_of(torque_controller(robot), robot)
    assert isinstance(law, CompiledLaw)
    scope: dict[str, Any] = {"math": math}
    for one in (*(function.text for function in law.functions), law.source):
        exec(one, scope)
    out = np.zeros(robot.n)
    numbers = barycentric(load.mass, load.com, load.inertia)
    scope["law"](law.parameters, np.zeros((1, robot.n)), ref, meas, numbers, np.zeros(0), out)
    return out


@pytest.mark.parametrize("types", ["RR", "RPR", "RRRRRR"])
def test_the_output_is_the_inverse_dynamics_of_the_wanted_acceleration(types: str) -> None:
    drives = (ideal_drive(),) * len(types)
    robot = random_arm(2, types, drives)
    ref, meas = np.random.default_rng(5).uniform(-1.0, 1.0, (2, 3, robot.n))
    wanted = ref[2] + 2.0 * OMEGA * (ref[1] - meas[1]) + OMEGA**2 * (ref[0] - meas[0])
    expected = inverse_dynamics(robot, meas[0], meas[1], wanted, payload=LOAD)
    np.testing.assert_allclose(output(robot, ref, meas, LOAD), expected, rtol=1e-12, atol=1e-9)


def test_gears_and_motors_are_a_part_of_the_model() -> None:
    one = ideal_drive()
    geared = replace(one, motor=IdealMotor(1e-3), transmission=Gear(-30.0), friction=Friction(1e-3))
    robot = random_arm(2, "RR", (geared, geared))
    ref, meas = np.random.default_rng(5).uniform(-1.0, 1.0, (2, 3, 2))
    meas[1] = ref[1]  # friction is taken at the speed of the reference
    wanted = ref[2] + OMEGA**2 * (ref[0] - meas[0])
    expected = inverse_dynamics(robot, meas[0], meas[1], wanted) / 30.0
    np.testing.assert_allclose(output(robot, ref, meas, Payload()), expected, rtol=1e-12, atol=1e-9)


def test_the_output_stays_within_the_amplifier() -> None:
    robot = random_arm(2, "RR", (ideal_drive(3.0), ideal_drive(2.0)))
    ref, meas = np.zeros((3, 2)), np.zeros((3, 2))
    ref[0] = [5.0, -5.0]
    assert np.abs(output(robot, ref, meas, Payload())).tolist() == [3.0, 2.0]


def test_an_error_dies_out_as_the_gains_say() -> None:
    """e(t) = e0·(1 + ω·t)·exp(-ω·t), for both axes alike, with a load that the law knows."""
    robot = robots.load("two_link")
    robot = replace(robot, drives=(ideal_drive(), ideal_drive()))
    servo = Servo.build(robot, torque_controller(robot), None, Engine.PYTHON)
    goal, off = np.array([0.4, 0.8]), np.array([0.02, -0.03])
    start = servo.initial_state(goal + off, LOAD)
    ticks = 800
    after = servo.run(start, standing(goal, ticks), LOAD, servo.recorder(start))
    t = ticks / FAST.control_hz
    expected = off * (1.0 + OMEGA * t) * np.exp(-OMEGA * t)
    np.testing.assert_allclose(after.q - goal, expected, rtol=0, atol=3e-5)  # the output is held for 0.1 ms


def test_the_two_link_arm_of_the_library_ends_its_moves_at_once() -> None:
    robot, controller = robots.load("two_link"), robots.default_controller("two_link")
    assert controller.kind is ControllerKind.COMPUTED_TORQUE
    servo = Servo.build(robot, controller, None, Engine.PYTHON)
    begin, end = np.array([0.5, 1.0]), np.array([1.3, -0.5])
    reference = quintic(begin, end, 900)
    start = servo.initial_state(begin)
    after = servo.run(start, reference, Payload(), servo.recorder(start))
    assert np.abs(after.q - end).max() < 0.2e-3


def test_an_arm_that_is_its_model_stays_with_its_reference() -> None:
    """What remains is the output that is held: a few hundredths of the way of a control period."""
    robot, controller = robots.load("two_link"), robots.default_controller("two_link")
    servo = Servo.build(robot, controller, None, Engine.PYTHON)
    reference = quintic(np.array([0.5, 1.0]), np.array([1.3, -0.5]), 900)
    start = servo.initial_state([0.5, 1.0])
    recorder = servo.recorder(start)
    servo.run(start, reference, Payload(), recorder)
    error = np.abs(recorder.channels()["q_ref"] - recorder.channels()["q"]).max(axis=0)
    assert (error < 0.05 * np.abs(reference.qd).max(axis=0) * servo.period).all()


def test_gains_of_another_law_are_refused() -> None:
    robot = robots.load("two_link")
    wrong = replace(robots.cascaded_controller(robot, Rates()), kind=ControllerKind.COMPUTED_TORQUE)
    with pytest.raises(GainError, match="C604"):
        law_of(wrong, robot)
    short = replace(torque_controller(robot), gains=ComputedTorqueGains(*(np.ones(3),) * 3))
    with pytest.raises(GainError, match="C600"):
        law_of(short, robot)


def test_motors_that_take_voltages_get_those_of_torque_and_speed() -> None:
    """U = R·τ/(Kt·|G|) + Ke·|G|·q̇_ref for DC motors."""
    robot = robots.load("puma560")
    ref, meas = np.random.default_rng(5).uniform(-0.1, 0.1, (2, 3, 6))
    meas[1] = ref[1]
    tau = inverse_dynamics(robot, meas[0], meas[1], ref[2] + OMEGA**2 * (ref[0] - meas[0]), payload=LOAD)
    motors, ratios = [dc_motor(one) for one in robot.drives], [one.ratio_at(0.0) for one in robot.drives]
    expected = [
        motor.resistance * effort / (motor.torque_constant * abs(ratio))
        + motor.back_emf_constant * abs(ratio) * speed
        for motor, ratio, effort, speed in zip(motors, ratios, tau, ref[1], strict=True)
    ]
    np.testing.assert_allclose(output(robot, ref, meas, LOAD), expected, rtol=1e-9)


def test_the_integral_takes_away_what_the_model_does_not_know() -> None:
    """A load that the law is not told of: a moment later the arm stands where it should all the same."""
    robot, controller = robots.load("two_link"), robots.default_controller("two_link")
    servo = Servo.build(robot, controller, None, Engine.PYTHON)
    lighter = replace(robot, links=tuple(replace(link, mass=0.8 * link.mass) for link in robot.links))
    misled = Servo.build(robot, controller, law_of(controller, lighter), Engine.PYTHON)
    q = np.array([0.3, 0.4])
    errors = []
    for one in (servo, misled):
        start = one.initial_state(q)
        recorder = one.recorder(start)
        after = one.run(start, standing(q, 600), Payload(), recorder)
        errors.append((np.abs(recorder.channels()["q"] - q).max(), np.abs(after.q - q).max()))
    assert errors[0][0] < 1e-9
    assert errors[1][0] > 1e-4 > 100.0 * errors[1][1]


def test_the_integral_stands_still_while_the_amplifier_is_at_its_limit() -> None:
    robot = random_arm(2, "RR", (ideal_drive(3.0), ideal_drive(1e4)))
    model = torque_controller(robot)
    rate = np.full(2, OMEGA)
    law = law_of(replace(model, gains=ComputedTorqueGains(rate**2, 2.0 * rate, np.ones(2))), robot)
    assert isinstance(law, CompiledLaw)
    scope: dict[str, Any] = {"math": math}
    for one in (*(function.text for function in law.functions), law.source):
        exec(one, scope)
    ref, state, out = np.zeros((3, 2)), np.zeros((1, 2)), np.zeros(2)
    ref[0] = 0.5
    scope["law"](law.parameters, state, ref, np.zeros((3, 2)), np.zeros(10), np.zeros(0), out)
    assert out[0] == 3.0
    assert state[0, 0] == 0.0
    assert state[0, 1] == pytest.approx(OMEGA**2 * 0.5 / FAST.control_hz, abs=1e-9)


def test_a_motor_behind_a_spring_runs_ahead_by_the_twist() -> None:
    """M·q⃛/k more speed than its joint, so that an arm on springs stays with a smooth reference."""
    robot = robots.load("manutec_r3")
    controller = robots.default_controller(robot)
    law = law_of(controller, robot)
    assert law.traits.state_names == ("integral", "acceleration", "twist_speed")
    servo = Servo.build(robot, controller, law)
    end = robot.home + np.array([0.5, -0.3, -0.4, 0.3, 0.3, 0.3])
    reference = quintic(robot.home, end, 1000)
    off = {}
    for stiff in (False, True):
        aware = law if not stiff else law_of(controller, with_rigid_gears(robot))
        one = Servo.build(robot, controller, aware) if stiff else servo
        start = one.initial_state(robot.home)
        recorder = one.recorder(start)
        one.run(start, reference, Payload(), recorder)
        errors = recorder.channels()["q_ref"] - recorder.channels()["q"]
        off[stiff] = np.abs(errors[-1]).max()
    assert off[False] < 0.2 * off[True]
