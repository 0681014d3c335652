"""A rotary vane motor against closed forms and an independent solver."""

from dataclasses import replace
from math import inf, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim import robots
from ropsim.controller import CompiledLaw
from ropsim.dynamics import drive_fault, mass_matrix, range_fault, steady_drive
from ropsim.dynamics.drives import largest_effort
from ropsim.model import (
    Drive,
    Friction,
    Gear,
    HydraulicMotor,
    HydraulicVane,
    JointType,
    Payload,
    RobotModel,
    ValveAmplifier,
)
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.arms import random_arm
from support.drives import rates_of
from support.servo_cases import controller, quintic, standing

RATIO, SUPPLY, BACK, FLOW, DROP, BULK = -1.5, 1.4e7, 2e5, 2e-4, 7e6, 1.2e9
VANE = HydraulicVane(
    displacement=2.5e-5,
    swing=4.6,
    first_angle=-2.3,
    dead_volume=1.5e-5,
    leakage=2e-12,
    rotor_inertia=1e-2,
    supply_pressure=SUPPLY,
    return_pressure=BACK,
    bulk_modulus=BULK,
    rated_flow=FLOW,
    rated_pressure_drop=DROP,
    rated_input=0.05,
    natural_frequency=500.0,
    damping_ratio=0.8,
)
DRIVE = Drive(ValveAmplifier(0.05), VANE, Gear(RATIO), Friction(4.0))
HOLD = """\
def law(par, state, ref, meas, load, aux, out):
    out[0] = par[0, 0]
"""


def free_axis() -> RobotModel:
    """Return one axis without gravity, from -1.5 to 1.5 rad."""
    robot = replace(random_arm(5, "R", (DRIVE,)), gravity=np.zeros(3))
    return replace(robot, joints=(replace(robot.joints[0], lower=-1.5, upper=1.5),))


def test_half_way_it_is_a_motor_with_the_volume_that_its_chambers_have_there() -> None:
    middle = 1.5e-5 + 2.5e-5 * 2.3
    motor = HydraulicMotor(
        2.5e-5,
        middle,
        2e-12,
        1e-2,
        supply_pressure=SUPPLY,
        return_pressure=BACK,
        bulk_modulus=BULK,
        rated_flow=FLOW,
        rated_pressure_drop=DROP,
        rated_input=0.05,
        natural_frequency=500.0,
        damping_ratio=0.8,
    )
    states = np.array([9e6, 4e6, 0.3, 2.0])
    one, other = (rates_of(replace(DRIVE, motor=kind))(states, 0.0, 0.7, 0.01) for kind in (VANE, motor))
    np.testing.assert_allclose(one, other, rtol=1e-12)


@pytest.mark.parametrize("q", [-1.4, 0.2, 1.0])
def test_the_oil_is_a_spring_by_the_volumes_at_the_angle_of_the_shaft(q: float) -> None:
    """ω² = β·D²·(1/V_a + 1/V_b)·G²/M of a mass on both chambers with the valve closed."""
    drive = replace(DRIVE, motor=replace(VANE, leakage=0.0), friction=Friction())
    inertia = float(mass_matrix(replace(free_axis(), drives=(drive,)), [q])[0, 0])
    rates = rates_of(drive)

    def slope(x: Array) -> Array:
        out = rates(np.array([x[0], x[1], 0.0, 0.0]), q, float(x[2]), 0.0)
        return np.array([out[1], out[2], out[0] / inertia])

    J = np.column_stack([(slope(row) - slope(-row)) / 2.0 for row in np.eye(3)])
    turned = RATIO * q + 2.3
    volumes = 1.5e-5 + 2.5e-5 * turned, 1.5e-5 + 2.5e-5 * (4.6 - turned)
    expected = sqrt(BULK * 2.5e-5**2 * (1.0 / volumes[0] + 1.0 / volumes[1]) * RATIO**2 / inertia)
    assert np.abs(np.linalg.eigvals(J).imag).max() == pytest.approx(expected, rel=1e-9)
    assert VANE.volumes(RATIO * q) == pytest.approx(volumes)


def test_beyond_a_stop_the_chambers_keep_their_volumes() -> None:
    assert VANE.volumes(-9.0) == VANE.volumes(-2.3) == pytest.approx((1.5e-5, 1.5e-5 + 2.5e-5 * 4.6))
    states = np.array([9e6, 4e6, 0.3, 2.0])
    ends = [rates_of(DRIVE)(states, q, 0.7, 0.01) for q in (2.3 / 1.5, 2.0)]
    np.testing.assert_allclose(ends[0], ends[1], rtol=1e-12)


@pytest.mark.parametrize("seed", range(4))
def test_a_steady_state_stays(seed: int) -> None:
    rng = np.random.default_rng(seed)
    speed, effort = rng.uniform(-1.0, 1.0), rng.uniform(-0.4, 0.4) * largest_effort(DRIVE, 0.0)
    held = steady_drive(DRIVE, 0.6, speed, effort)
    out = rates_of(DRIVE)(np.array(held.states), 0.6, speed, held.output)
    assert out[0] == pytest.approx(effort)
    np.testing.assert_allclose(out[1:3], 0.0, atol=1e-5 * BULK * FLOW / 1.5e-5)
    np.testing.assert_allclose(out[3:], 0.0, atol=1e-6)


def test_an_axis_swings_from_stop_to_stop_as_an_independent_solver_says() -> None:
    robot, current, ticks = free_axis(), 0.01, 500
    inertia = float(mass_matrix(robot, [0.0])[0, 0])

    def through(fall: float) -> float:
        return FLOW * sqrt(2.0 / DROP) * fall / sqrt(sqrt(fall**2 + 1e10))

    def slope(_: float, x: Array) -> Array:
        q, qd, a, b, opening, rate = x
        into_a = max(opening, 0.0) * through(SUPPLY - a) - max(-opening, 0.0) * through(a - BACK)
        into_b = max(-opening, 0.0) * through(SUPPLY - b) - max(opening, 0.0) * through(b - BACK)
        turned = min(max(RATIO * q + 2.3, 0.0), 4.6)
        swept = 2.5e-5 * RATIO * qd + 2e-12 * (a - b)
        torque = RATIO * 2.5e-5 * (a - b) - 4.0 * RATIO**2 * qd
        return np.array(
            [
                qd,
                torque / inertia,
                BULK / (1.5e-5 + 2.5e-5 * turned) * (into_a - swept),
                BULK / (1.5e-5 + 2.5e-5 * (4.6 - turned)) * (into_b + swept),
                rate,
                500.0**2 * (-current / 0.05 - opening) - 2.0 * 0.8 * 500.0 * rate,
            ]
        )

    law = CompiledLaw("hold", HOLD, ("current",), np.array([[current]]))
    servo = Servo.build(robot, controller(1), law)
    start = servo.initial_state(np.zeros(1))
    end = servo.run(start, standing(np.zeros(1), ticks), Payload(), servo.recorder(start))
    middle = 0.5 * (SUPPLY + BACK)
    begin = np.array([0.0, 0.0, middle, middle, 0.0, 0.0])
    exact = solve_ivp(slope, (0.0, ticks / 1000.0), begin, rtol=1e-10, atol=1e-8, max_step=1e-3).y[:, -1]
    found = [end.q[0], end.qd[0], *(end.drive(name)[0] for name in ("pressure_a", "pressure_b"))]
    assert 0.3 < exact[0] < 1.5
    np.testing.assert_allclose(found, exact[:4], rtol=1e-4)


def test_the_standard_controller_moves_an_arm_with_vanes() -> None:
    robot = robots.load("two_link")
    ends = [(-1.5 * one.upper, -1.5 * one.lower) for one in robot.joints]
    vanes = [
        replace(VANE, displacement=1e-4, leakage=2e-11, swing=last - first, first_angle=first)
        for first, last in ends
    ]
    arm = replace(robot, drives=tuple(replace(DRIVE, motor=one) for one in vanes))
    servo = Servo.build(arm, robots.default_controller(arm))
    start, goal = np.array([0.2, 0.3]), np.array([0.7, -0.2])
    state = servo.initial_state(start)
    recorder = servo.recorder(state)
    state = servo.run(state, quintic(start, goal, 2000), Payload(), recorder)
    state = servo.run(state, standing(goal, 3000), Payload(), recorder)
    assert (np.abs(state.q - goal) < np.radians(0.5)).all()


def test_a_vane_needs_stops_beyond_the_range_of_its_joint() -> None:
    (joint,) = free_axis().joints
    assert drive_fault(DRIVE) is None
    assert range_fault(DRIVE, joint) is None
    for wrong, words in (
        (replace(joint, upper=1.6), "its stops are at -2.3 and 2.3 rad"),
        (replace(joint, upper=inf, lower=-inf, type=JointType.REVOLUTE), "no limits"),
    ):
        found = range_fault(DRIVE, wrong)
        assert found
        assert words in found[1]


@pytest.mark.parametrize("name", ["displacement", "swing", "dead_volume", "rated_flow"])
def test_its_numbers_are_positive(name: str) -> None:
    found = drive_fault(replace(DRIVE, motor=replace(VANE, **{name: 0.0})))
    assert found
    assert found[0] == f"`{name}`"
