"""The computed-torque law: errors die out as its gains say, whatever couples the axes."""

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.codegen import Engine
from ropsim.controller import GainError, LawError, law_of
from ropsim.dynamics import inverse_dynamics
from ropsim.model import (
    ComputedTorqueGains,
    ControllerKind,
    ControllerModel,
    EffortAmplifier,
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
from support.servo_cases import quintic, standing

FAST = Rates(control_hz=10_000, interpolation_ticks=4, plant_steps=1)
OMEGA = 20.0  # [rad/s]
LOAD = Payload(1.5, np.array([0.05, -0.1, 0.2]), np.diag([0.02, 0.03, 0.01]))


def torque_controller(robot: RobotModel, rates: Rates = FAST) -> ControllerModel:
    rate = np.full(robot.n, OMEGA)
    standard = robots.default_controller("two_link")
    gains = ComputedTorqueGains(rate**2, 2.0 * rate)
    return replace(standard, rates=rates, gains=gains, in_position=np.full(robot.n, 1e-3))


def output(robot: RobotModel, ref: Array, meas: Array, load: Payload) -> Array:
    """Return what the law puts out, evaluated in plain Python."""
    from ropsim.dynamics import barycentric

    law = law_of(torque_controller(robot), robot)
    scope: dict[str, Any] = {"math": math}
    exec(law.source, scope)
    out = np.zeros(robot.n)
    numbers = barycentric(load.mass, load.com, load.inertia)
    scope["law"](law.parameters, np.zeros((0, robot.n)), ref, meas, numbers, np.zeros(0), out)
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
    robot, puma = robots.load("two_link"), robots.default_controller("puma560")
    wrong = replace(puma, kind=ControllerKind.COMPUTED_TORQUE)
    with pytest.raises(GainError, match="C604"):
        law_of(wrong, robot)
    short = replace(torque_controller(robot), gains=ComputedTorqueGains(np.ones(3), np.ones(3)))
    with pytest.raises(GainError, match="C600"):
        law_of(short, robot)


def test_motors_that_take_voltages_are_refused() -> None:
    robot = robots.load("puma560")
    with pytest.raises(LawError, match="C602"):
        Servo.build(robot, torque_controller(robot), None, Engine.PYTHON)
    assert isinstance(robots.load("scara").drives[0].amplifier, EffortAmplifier)
