"""Edges of a servo valve with overlap and null flow, against closed forms and equations written down anew."""

from dataclasses import replace
from math import sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim import robots
from ropsim.controller import CompiledLaw
from ropsim.dynamics import drive_fault, mass_matrix, steady_drive
from ropsim.dynamics.drives import largest_effort
from ropsim.model import (
    Drive,
    Friction,
    Gear,
    HydraulicMotor,
    Linkage,
    Payload,
    Rates,
    RobotModel,
    ValveAmplifier,
)
from ropsim.robots.loops.hydraulic_loops import hydraulic_crossover
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.arms import random_arm
from support.cylinders import CYLINDER, DRIVE, lifted
from support.drives import rates_of
from support.servo_cases import controller, standing

SUPPLY, BACK, RATED, DROP, NULL = 2.1e7, 3e5, 6e-4, 7e6, 2.4e-5
"""[Pa], [Pa], [m³/s], [Pa], [m³/s]"""
MOTOR = HydraulicMotor(
    displacement=1.26e-3,
    chamber_volume=3.15e-4,
    leakage=0.0,
    rotor_inertia=0.0,
    supply_pressure=SUPPLY,
    return_pressure=BACK,
    bulk_modulus=1.4e9,
    rated_flow=RATED,
    rated_pressure_drop=DROP,
    rated_input=0.05,
    natural_frequency=630.0,
    damping_ratio=0.8,
    null_flow=NULL,
)
LAPPED = replace(MOTOR, overlap=0.05)
LAMINAR = 1e-3
"""Share by which flow at falls of pressure above 10 bar differs from the root."""


def driven(motor: HydraulicMotor) -> Drive:
    return Drive(ValveAmplifier(0.05), motor, Gear())


def flows(motor: HydraulicMotor, a: float, b: float, opening: float) -> tuple[float, float]:
    """Return the flow into both chambers [m³/s], from their rates at standstill without other leakage."""
    out = rates_of(driven(motor))(np.array([a, b, opening, 0.0]), 0.0, 0.0, 0.0)
    stiff = motor.bulk_modulus / motor.chamber_volume
    return out[1] / stiff + motor.leakage * (a - b), out[2] / stiff - motor.leakage * (a - b)


@pytest.mark.parametrize("motor", [MOTOR, LAPPED])
def test_the_null_flow_goes_through_a_valve_at_its_centre(motor: HydraulicMotor) -> None:
    """With both ports closed half of it runs through each chamber, at half the fall of pressure an edge."""
    middle = 0.5 * (SUPPLY + BACK)
    assert flows(motor, middle, middle, 0.0) == pytest.approx((0.0, 0.0), abs=1e-15)
    through = [flows(motor, BACK, BACK, 0.0)[0], -flows(motor, SUPPLY, SUPPLY, 0.0)[1]]
    whole = NULL * sqrt((SUPPLY - BACK) / DROP)  # of the valve at this supply
    assert through == pytest.approx([0.5 * whole * sqrt(2.0)] * 2, rel=LAMINAR)


@pytest.mark.parametrize("motor", [MOTOR, LAPPED, replace(LAPPED, null_flow=0.0)])
def test_the_rated_flow_goes_through_at_the_rated_current(motor: HydraulicMotor) -> None:
    a, b = SUPPLY - 0.5 * DROP, BACK + 0.5 * DROP
    into, out = flows(motor, a, b, 1.0)
    assert into == pytest.approx(RATED, rel=5e-3)
    assert out == pytest.approx(-RATED, rel=5e-3)
    assert flows(motor, b, a, -1.0) == pytest.approx((-into, into))


def test_the_flow_gain_at_an_open_centre_is_twice_that_beyond() -> None:
    """H. E. Merritt, Hydraulic Control Systems, 1967, section 5.4, of a valve with underlap."""
    middle, step = 0.5 * (SUPPLY + BACK), 1e-6

    def gain(motor: HydraulicMotor, at: float) -> float:
        ends = (flows(motor, middle, middle, at + way * step)[0] for way in (1.0, -1.0))
        return -float(np.diff(list(ends))[0]) / (2.0 * step)

    closed = replace(MOTOR, null_flow=0.0)
    assert gain(MOTOR, 0.0) / gain(closed, 0.3) == pytest.approx(2.0, rel=0.03)
    assert gain(MOTOR, 0.6) / gain(closed, 0.3) == pytest.approx(1.0, rel=0.03)
    assert gain(replace(LAPPED, null_flow=0.0), 0.02) == 0.0


def test_without_null_flow_nothing_flows_within_the_overlap() -> None:
    dry = replace(LAPPED, null_flow=0.0)
    for opening in (-0.05, -0.01, 0.0, 0.05):
        assert flows(dry, 1e7, 4e6, opening) == pytest.approx((0.0, 0.0), abs=1e-18)
    exact = RATED * (0.10 - 0.05) / 0.95 * sqrt(2.0 * (SUPPLY - 1e7) / DROP)
    assert flows(dry, 1e7, 4e6, 0.10)[0] == pytest.approx(exact, rel=LAMINAR)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("motor", [MOTOR, LAPPED, replace(LAPPED, null_flow=0.0, leakage=2e-12)])
def test_a_steady_state_of_a_motor_stays(motor: HydraulicMotor, seed: int) -> None:
    rng = np.random.default_rng(seed)
    drive = driven(motor)
    speed, effort = rng.uniform(-0.2, 0.2), rng.uniform(-0.3, 0.3) * largest_effort(drive, 0.0)
    held = steady_drive(drive, 0.0, speed, effort)
    out = rates_of(drive)(np.array(held.states), 0.0, speed, held.output)
    assert out[0] == pytest.approx(effort)
    np.testing.assert_allclose(out[1:3], 0.0, atol=1e-5 * motor.bulk_modulus * RATED / motor.chamber_volume)
    np.testing.assert_allclose(out[3:], 0.0, atol=1e-6)


def test_a_motor_that_nothing_loads_rests_with_its_valve_at_the_centre() -> None:
    for motor in (MOTOR, LAPPED, replace(LAPPED, null_flow=0.0)):
        assert steady_drive(driven(motor), 0.0, 0.0, 0.0).command == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize("speed", [-0.25, 0.0, 0.25])
@pytest.mark.parametrize("overlap", [0.0, 0.04])
def test_a_steady_state_of_a_cylinder_stays(overlap: float, speed: float) -> None:
    cylinder = replace(CYLINDER, null_flow=0.02 * CYLINDER.rated_flow, overlap=overlap)
    drive, q, effort = replace(DRIVE, motor=cylinder), 0.5, 9000.0
    held = steady_drive(drive, q, speed, effort)
    out = rates_of(drive)(np.array(held.states), q, speed, held.output)
    assert out[0] == pytest.approx(effort)
    assert isinstance(drive.transmission, Linkage)
    volumes = cylinder.volumes(drive.transmission.out_at(q))
    share = out[1:3] * volumes / cylinder.bulk_modulus / cylinder.rated_flow
    assert share == pytest.approx([0.0, 0.0], abs=1e-9)
    assert out[3:] == pytest.approx([0.0, 0.0], abs=1e-6)


def moving(motor: HydraulicMotor) -> RobotModel:
    """Return one sliding joint without gravity and friction."""
    return replace(random_arm(3, "P", (Drive(ValveAmplifier(0.05), motor, Gear()),)), gravity=np.zeros(3))


def test_null_flow_damps_the_swing_of_a_mass_on_oil_by_the_closed_form() -> None:
    """Merritt, chapter 6: s² + K·β/V·s + ω² with K = Q_0/√(Δp_r·(p_s - p_r)), of a chamber at the centre."""
    robot = moving(MOTOR)
    mass = float(mass_matrix(robot, [0.0])[0, 0])
    rates, middle = rates_of(robot.drives[0]), 0.5 * (SUPPLY + BACK)

    def slope(x: Array) -> Array:
        out = rates(np.array([x[0], x[1], 0.0, 0.0]), 0.0, float(x[2]), 0.0)
        return np.array([out[1], out[2], out[0] / mass])

    at, steps = np.array([middle, middle, 0.0]), np.diag([1e3, 1e3, 1e-4])
    J = np.column_stack([(slope(at + step) - slope(at - step)) / (2.0 * step.sum()) for step in steps])
    pair = max(np.linalg.eigvals(J), key=lambda one: float(one.imag))
    damping = NULL / sqrt(DROP * (SUPPLY - BACK)) * MOTOR.bulk_modulus / MOTOR.chamber_volume
    spring = 2.0 * MOTOR.bulk_modulus * MOTOR.displacement**2 / MOTOR.chamber_volume
    assert abs(pair) ** 2 == pytest.approx(spring / mass, rel=1e-3)
    assert -2.0 * pair.real == pytest.approx(damping, rel=2e-3)


STEP = """\
def law(par, state, ref, meas, load, aux, out):
    out[0] = par[0, 0]
"""


def test_a_mass_behind_leaking_edges_moves_as_an_independent_solver_says() -> None:
    """The equations of Eryilmaz and Wilson 2001 by cases, x0 solved from the null flow by a root finder."""
    robot, current, ticks = moving(LAPPED), 0.02, 300
    mass = float(mass_matrix(robot, [0.0])[0, 0])
    lap = LAPPED.overlap / (1.0 - LAPPED.overlap)
    candidates = np.roots(
        [1.0 - NULL / (2.0 * RATED), -NULL / (2.0 * RATED) * (1.0 + lap), -NULL / (2.0 * RATED) * lap]
    )
    x0 = float(candidates.max())

    def edge(x: float) -> float:
        y = (x - LAPPED.overlap) / (1.0 - LAPPED.overlap)
        return (x0 + y if y >= 0.0 else x0**2 / (x0 - y)) / (1.0 + x0)

    def through(fall: float) -> float:
        return RATED * sqrt(2.0 / DROP) * fall / sqrt(sqrt(fall**2 + 1e10))

    def slope(_: float, x: Array) -> Array:
        a, b, opening, rate, _, speed = x
        into_a = edge(opening) * through(SUPPLY - a) - edge(-opening) * through(a - BACK)
        into_b = edge(-opening) * through(SUPPLY - b) - edge(opening) * through(b - BACK)
        stiff, swept = LAPPED.bulk_modulus / LAPPED.chamber_volume, LAPPED.displacement * speed
        spool = 630.0**2 * (current / 0.05 - opening) - 2.0 * 0.8 * 630.0 * rate
        force = LAPPED.displacement * (a - b)
        return np.array(
            [stiff * (into_a - swept), stiff * (into_b + swept), rate, spool, speed, force / mass]
        )

    servo = Servo.build(robot, controller(1), CompiledLaw("step", STEP, ("i",), np.array([[current]])))
    start = servo.initial_state(np.zeros(1))
    end = servo.run(start, standing(np.zeros(1), ticks), Payload(), servo.recorder(start))
    found = [end.drive(name)[0] for name in ("pressure_a", "pressure_b", "opening")] + [end.q[0], end.qd[0]]
    middle = 0.5 * (SUPPLY + BACK)
    exact = solve_ivp(
        slope, (0.0, ticks / 1000.0), np.array([middle, middle, 0.0, 0.0, 0.0, 0.0]), rtol=1e-10, atol=1e-9
    ).y[:, -1]
    assert exact[4] > 0.05
    np.testing.assert_allclose(found, exact[[0, 1, 2, 4, 5]], rtol=1e-4)


def test_for_the_standard_loops_null_flow_damps_as_half_of_it_from_chamber_to_chamber() -> None:
    """And half of the crossover is taken, for at the centre the loop is twice as fast: a quarter in all."""
    null = 0.6 * CYLINDER.rated_flow
    leaking = replace(CYLINDER, leakage=0.0, null_flow=null)
    fall = CYLINDER.rated_pressure_drop * (CYLINDER.supply_pressure - CYLINDER.return_pressure)
    tight = replace(CYLINDER, leakage=0.25 * null / sqrt(fall))
    found = [
        hydraulic_crossover(lifted(replace(DRIVE, motor=one)), Rates())
        for one in (leaking, tight, replace(CYLINDER, leakage=0.0))
    ]
    assert found[0] == pytest.approx(found[1])
    assert found[0] > 1.3 * found[2]


@pytest.mark.parametrize("share", [0.02, 0.1])
def test_the_standard_loops_hold_a_cylinder_with_leaking_edges(share: float) -> None:
    """A step of its reference by 1°: the arm comes to it and stays."""
    cylinder = replace(CYLINDER, leakage=0.0, null_flow=share * CYLINDER.rated_flow)
    robot = lifted(replace(DRIVE, motor=cylinder, friction=Friction(2e3)))
    servo = Servo.build(robot, robots.default_controller(robot))
    state, goal = servo.initial_state(np.array([0.3])), np.array([0.3 + np.radians(1.0)])
    recorder = servo.recorder(state)
    state = servo.run(state, standing(goal, 8000), Payload(), recorder)
    q = recorder.channels()["q"][:, 0]
    assert np.abs(q[-2000:] - goal).max() < np.radians(0.02)
    assert q.max() < goal[0] + np.radians(0.25)


@pytest.mark.parametrize(
    ("name", "value"), [("null_flow", -1e-6), ("null_flow", RATED), ("overlap", -0.1), ("overlap", 1.0)]
)
def test_edges_that_cannot_be_are_told(name: str, value: float) -> None:
    found = drive_fault(driven(replace(MOTOR, **{name: value})))
    assert found
    assert found[0] == f"`{name}`"
