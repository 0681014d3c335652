"""A motor in a current loop against closed forms and an independent solver."""

from dataclasses import replace
from math import exp

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim import robots
from ropsim.controller import CompiledLaw
from ropsim.dynamics import chain_of, drive_fault, mass_matrix, steady_drive
from ropsim.dynamics.drives import largest_effort
from ropsim.model import (
    CurrentLoopMotor,
    Drive,
    EffortAmplifier,
    Friction,
    Gear,
    InputKind,
    Payload,
    RobotModel,
    VoltageAmplifier,
)
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.arms import random_arm
from support.drives import slopes_of
from support.servo_cases import controller, quintic, standing

MOTOR = CurrentLoopMotor(
    torque_constant=0.2,
    back_emf_constant=0.21,
    resistance=1.5,
    inductance=6e-3,
    rotor_inertia=2e-4,
    max_voltage=40.0,
    max_current=12.0,
    bandwidth=800.0,
)
RATIO = -30.0
DRIVE = Drive(EffortAmplifier(), MOTOR, Gear(RATIO), Friction(1e-4))
HOLD = """\
def law(par, state, ref, meas, load, aux, out):
    out[0] = par[0, 0]
"""


def free_axis(motor: CurrentLoopMotor = MOTOR) -> RobotModel:
    """Return one axis without gravity."""
    return replace(random_arm(5, "R", (replace(DRIVE, motor=motor),)), gravity=np.zeros(3))


def after(robot: RobotModel, torque: float, ticks: int) -> dict[str, Array]:
    """Return the channels of an axis whose motor is told a torque in the sense of the joint."""
    servo = Servo.build(robot, controller(1), CompiledLaw("hold", HOLD, ("torque",), np.array([[torque]])))
    start = servo.initial_state(np.zeros(1))
    recorder = servo.recorder(start)
    servo.run(start, standing(np.zeros(1), ticks), Payload(), recorder)
    return recorder.channels()


def test_the_current_follows_with_the_bandwidth_of_the_loop_though_the_motor_turns() -> None:
    found = after(free_axis(), 0.3, 12)["current"][:, 0]
    wanted = -0.3 / MOTOR.torque_constant
    expected = [wanted * (1.0 - exp(-MOTOR.bandwidth * tick / 1000.0)) for tick in range(13)]
    np.testing.assert_allclose(found, expected, rtol=0, atol=2e-4 * abs(wanted))


def test_at_standstill_the_torque_is_that_of_the_largest_current_or_voltage() -> None:
    assert largest_effort(DRIVE, 0.0) == pytest.approx(30.0 * 0.2 * 12.0)
    weak = replace(DRIVE, motor=replace(MOTOR, max_voltage=9.0))
    assert largest_effort(weak, 0.0) == pytest.approx(30.0 * 0.2 * 9.0 / 1.5)
    told = replace(DRIVE, amplifier=EffortAmplifier(1.5))
    assert largest_effort(told, 0.0) == pytest.approx(30.0 * 1.5)


def test_no_motor_turns_faster_than_its_voltage_drives_it_against_the_back_emf() -> None:
    """With all of u_max and without load, Ke·ω = u_max less what friction takes: ω = u/(Ke + R·B/Kt)."""
    rows = after(free_axis(), 2.0, 20000)
    motor = abs(RATIO) * np.abs(rows["qd"][:, 0])
    final = MOTOR.max_voltage / (MOTOR.back_emf_constant + MOTOR.resistance * 1e-4 / MOTOR.torque_constant)
    assert motor[-1] == pytest.approx(final, rel=1e-3)
    assert np.abs(rows["current"]).max() < MOTOR.max_current * 1.001


@pytest.mark.parametrize("seed", range(4))
def test_a_steady_state_stays(seed: int) -> None:
    rng = np.random.default_rng(seed)
    speed, effort = rng.uniform(-2.0, 2.0), rng.uniform(-30.0, 30.0)
    held = steady_drive(DRIVE, 0.0, speed, effort)
    out = slopes_of(free_axis())(np.array([0.0, speed, *held.states]), held.output)
    assert out[2:] == pytest.approx([0.0, 0.0], abs=1e-6)
    assert held.command == pytest.approx(effort / abs(RATIO))
    inertia = float(mass_matrix(free_axis(), [0.0])[0, 0])
    assert out[1] * inertia == pytest.approx(effort - 1e-4 * RATIO**2 * speed)


def test_with_clipped_current_and_voltage_it_moves_as_an_independent_solver_says() -> None:
    """A torque beyond the largest current, until the voltage no longer suffices; then the other way."""
    robot, ticks = free_axis(), 400
    inertia = float(mass_matrix(robot, [0.0])[0, 0])

    def slope(command: float, x: Array) -> Array:
        _, qd, current, integral = x
        speed = RATIO * qd
        wanted = float(np.clip(command / MOTOR.torque_constant, -12.0, 12.0))
        asked = 800.0 * 6e-3 * (wanted - current) + integral + 0.21 * speed
        given = float(np.clip(asked, -40.0, 40.0))
        excess = (given - asked) / (800.0 * 6e-3)
        torque = RATIO * 0.2 * current - 1e-4 * RATIO**2 * qd
        return np.array(
            [
                qd,
                torque / inertia,
                (given - 1.5 * current - 0.21 * speed) / 6e-3,
                800.0 * 1.5 * (wanted - current + excess),
            ]
        )

    exact = solve_ivp(
        lambda _, x: slope(-3.0, x), (0.0, ticks / 1000.0), np.zeros(4), rtol=1e-10, atol=1e-10, max_step=1e-3
    ).y[:, -1]
    rows = after(robot, 3.0, ticks)
    found = [rows[name][-1, 0] for name in ("q", "qd", "current", "loop_voltage")]
    assert abs(0.21 * RATIO * exact[1]) + 1.5 * 12.0 > 40.0  # the voltage is all
    np.testing.assert_allclose(found, exact, rtol=1e-3)


def test_the_integral_does_not_wind_up_while_the_voltage_is_clipped() -> None:
    """A reversal from there: the current comes to the other side with no more than a tenth beyond it."""
    servo = Servo.build(free_axis(), controller(1), CompiledLaw("hold", HOLD, ("torque",), np.array([[2.0]])))
    start = servo.initial_state(np.zeros(1))
    turned = servo.run(start, standing(np.zeros(1), 3000), Payload(), servo.recorder(start))
    back = Servo.build(free_axis(), controller(1), CompiledLaw("hold", HOLD, ("torque",), np.array([[-0.4]])))
    recorder = back.recorder(turned)
    back.run(turned, standing(np.zeros(1), 60), Payload(), recorder)
    current = recorder.channels()["current"][:, 0]
    assert current[-1] == pytest.approx(2.0, rel=1e-3)
    assert current.max() < 2.2


def test_it_is_told_a_torque_and_its_pole_is_that_of_the_loop() -> None:
    chain = chain_of(DRIVE)
    assert chain.amplifier.kind is InputKind.EFFORT
    assert chain.motor.pole(MOTOR) == 800.0
    assert drive_fault(DRIVE) is None
    assert drive_fault(replace(DRIVE, amplifier=VoltageAmplifier(40.0, 10.0))) is not None


@pytest.mark.parametrize("name", chain_of(DRIVE).motor.positive)
def test_its_numbers_are_positive(name: str) -> None:
    found = drive_fault(replace(DRIVE, motor=replace(MOTOR, **{name: 0.0})))
    assert found
    assert found[0] == f"`{name}`"


def test_the_standard_controller_moves_an_arm_with_current_loops() -> None:
    robot = robots.load("puma560")
    drives = []
    for one in robot.drives:
        motor = one.motor
        constant, resistance, inductance = (
            float(getattr(motor, name)) for name in ("torque_constant", "resistance", "inductance")
        )
        looped = CurrentLoopMotor(
            constant, constant, resistance, inductance, motor.rotor_inertia, 60.0, 20.0, 1200.0
        )
        drives.append(replace(one, amplifier=EffortAmplifier(constant * 20.0), motor=looped))
    arm = replace(robot, drives=tuple(drives))
    model = robots.default_controller(arm)
    servo = Servo.build(arm, model)
    start = robot.home
    state, goal = servo.initial_state(start), start + 0.4
    recorder = servo.recorder(state)
    state = servo.run(state, quintic(start, goal, 900), Payload(), recorder)
    state = servo.run(state, standing(goal, 400), Payload(), recorder)
    assert (np.abs(state.q - goal) < model.in_position).all()
    channels = recorder.channels()
    assert np.abs(channels["q"] - channels["q_ref"]).max() < 2e-3
