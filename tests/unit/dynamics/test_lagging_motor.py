"""A motor that follows its command with a lag, against the closed form."""

from dataclasses import replace
from math import exp

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import CompiledLaw
from ropsim.dynamics import chain_of, drive_fault, mass_matrix, steady_drive
from ropsim.dynamics.drives import largest_effort
from ropsim.model import Drive, EffortAmplifier, Gear, LaggingMotor, Payload
from ropsim.simulation import Servo
from support.arms import random_arm
from support.servo_cases import controller, quintic, standing

RATE, RATIO = 300.0, -20.0
DRIVE = Drive(EffortAmplifier(3.0), LaggingMotor(RATE, 1e-3), Gear(RATIO))
HOLD = """\
def law(par, state, ref, meas, load, aux, out):
    out[0] = par[0, 0]
"""


@pytest.mark.parametrize(("told", "given"), [(1.2, 1.2), (-9.0, -3.0)])
def test_torque_speed_and_way_are_those_of_a_lag_of_first_order(told: float, given: float) -> None:
    """τ = u·(1 - e), q̇ = u/J·(t - (1 - e)/ω) with e = exp(-ω·t), u clipped."""
    robot = replace(random_arm(5, "R", (DRIVE,)), gravity=np.zeros(3))
    inertia = float(mass_matrix(robot, [0.0])[0, 0])
    servo = Servo.build(robot, controller(1), CompiledLaw("hold", HOLD, ("u",), np.array([[told]])))
    start = servo.initial_state(np.zeros(1))
    end = servo.run(start, standing(np.zeros(1), 15), Payload(), servo.recorder(start))
    t, left = 0.015, exp(-RATE * 0.015)
    effort = abs(RATIO) * given
    assert end.drive("motor_torque")[0] == pytest.approx(-given * (1.0 - left), rel=1e-5)
    assert end.qd[0] == pytest.approx(effort / inertia * (t - (1.0 - left) / RATE), rel=1e-5)
    way = 0.5 * t**2 - t / RATE + (1.0 - left) / RATE**2
    assert end.q[0] == pytest.approx(effort / inertia * way, rel=1e-5)


def test_its_steady_state_is_the_torque_and_its_pole_the_bandwidth() -> None:
    held = steady_drive(DRIVE, 0.0, 1.0, 30.0)
    assert held.states == pytest.approx((30.0 / RATIO,))
    assert held.command == pytest.approx(1.5)
    assert chain_of(DRIVE).motor.pole(DRIVE.motor) == RATE
    assert largest_effort(DRIVE, 0.0) == pytest.approx(60.0)
    assert drive_fault(DRIVE) is None
    found = drive_fault(replace(DRIVE, motor=LaggingMotor(0.0)))
    assert found
    assert found[0] == "`bandwidth`"


def test_the_standard_controller_knows_the_lag() -> None:
    robot = robots.load("two_link")
    drives = tuple(replace(one, motor=LaggingMotor(RATE, one.motor.rotor_inertia)) for one in robot.drives)
    slow = replace(robot, drives=drives)
    servo = Servo.build(slow, robots.default_controller(slow))
    start, goal = np.array([0.2, 0.3]), np.array([0.9, -0.4])
    state = servo.initial_state(start)
    recorder = servo.recorder(state)
    state = servo.run(state, quintic(start, goal, 1000), Payload(), recorder)
    state = servo.run(state, standing(goal, 800), Payload(), recorder)
    assert np.abs(state.q - goal).max() < 1e-4
    assert recorder.channels()["q"][:, 0].max() < goal[0] + 2e-3
