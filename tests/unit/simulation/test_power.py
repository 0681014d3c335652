"""The power that drives draw: balances of energy, and equations written down anew."""

from dataclasses import replace
from math import sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim import robots
from ropsim.controller import CompiledLaw, LawTraits
from ropsim.dynamics import friction, mass_matrix
from ropsim.flow import JointReference, Recording
from ropsim.model import (
    DcMotor,
    Drive,
    EffortAmplifier,
    ElasticGear,
    Friction,
    Gear,
    GuardedAmplifier,
    HydraulicMotor,
    LaggingMotor,
    Rates,
    RobotModel,
    ThermalDcMotor,
    ValveAmplifier,
)
from ropsim.simulation import SimulationOptions, simulate
from ropsim.spatial import Array
from support.arms import drive, potential_energy, random_arm
from support.cylinders import CYLINDER, DRIVE, lifted
from support.dc_drives import dc_motor
from support.servo_cases import GOAL, START, controller, puma, quintic, standing

BALANCE = 1e-3
"""Of an integral over rows 4 ms apart."""
ROWS = SimulationOptions(decimation=4)


def values(recording: Recording, name: str) -> Array:
    return recording.channels[name].values


def integral(recording: Recording, rates: Array) -> float:
    """Return the integral of rates over the rows, joints and all."""
    return float(np.trapezoid(rates, recording.time, axis=0).sum())


def energy(robot: RobotModel, q: Array, qd: Array) -> float:
    """Return what moves, rotors and all, and what is lifted [J]."""
    return 0.5 * float(qd @ mass_matrix(robot, q) @ qd) + potential_energy(robot, q)


def test_what_a_dc_arm_draws_goes_into_copper_friction_and_motion() -> None:
    """A motion that is cut off in its midst: the arm is faster and higher than at its start."""
    robot, model = puma()
    motion = quintic(START, GOAL, 400)
    ran = simulate(robot, model, JointReference(motion.q[:252], motion.qd[:252], motion.qdd[:252]), ROWS)
    q, qd, current, power = (values(ran, name) for name in ("q", "qd", "current", "power"))
    copper = np.array([dc_motor(one).resistance for one in robot.drives]) * current**2
    rubbed = -np.array([friction(robot, *row) * row[1] for row in zip(q, qd, strict=True)])
    gained = energy(robot, q[-1], qd[-1]) - energy(robot, q[0], qd[0])
    drawn = integral(ran, power)
    assert gained > 5.0
    assert integral(ran, copper) > 0.2 * drawn
    assert drawn == pytest.approx(integral(ran, copper) + integral(ran, rubbed) + gained, rel=BALANCE)


def test_beside_what_it_draws_the_voltage_of_a_motor_only_fills_its_winding() -> None:
    robot, model = puma()
    motion = quintic(START, GOAL, 400)
    ran = simulate(robot, model, JointReference(motion.q[:250], motion.qd[:250], motion.qdd[:250]))
    current, voltage = values(ran, "current"), values(ran, "voltage")[1:]
    steps = np.diff(ran.time)[:, np.newaxis]
    brought = (voltage * 0.5 * (current[1:] + current[:-1]) * steps).sum()
    inductance = np.array([dc_motor(one).inductance for one in robot.drives])
    filled = 0.5 * float((inductance * (current[-1] ** 2 - current[0] ** 2)).sum())
    drawn = integral(ran, values(ran, "power"))
    assert abs(filled) > 1e-3
    assert brought == pytest.approx(drawn + filled, rel=2e-3)


def test_an_arm_at_rest_draws_what_warms_its_windings() -> None:
    robot, model = puma()
    ran = simulate(robot, model, standing(START, 100))
    current = values(ran, "current")[-1]
    exact = np.array([dc_motor(one).resistance for one in robot.drives]) * current**2
    np.testing.assert_allclose(values(ran, "power")[-1], exact, rtol=1e-6, atol=1e-9)
    assert exact[1] > 1.0
    assert ran.channels["power"].unit == "W"


def test_a_motor_that_brakes_a_heavy_link_gives_back() -> None:
    """Up to its half the motion draws what the link takes up, from there on the motor is driven by it."""
    robot = replace(random_arm(2, "R", (drive(ratio=50.0),)), gravity=np.zeros(3))
    ran = simulate(robot, controller(1, kv=30.0), quintic(np.zeros(1), np.array([2.0]), 600))
    power, rows = values(ran, "power")[:, 0], len(ran.time)
    assert power[: rows // 3].min() > -1e-9
    assert power.min() < -0.1 * power.max()


def test_behind_an_elastic_gear_the_speed_that_counts_is_that_of_the_motor() -> None:
    """The balance of a single axis with a spring and a damper between its rotor and its link."""
    gear, rotor, constant = ElasticGear(50.0, 400.0, 2.0), 2e-4, 0.2
    motor = DcMotor(constant, constant, 1.0, 1e-3, rotor)
    axis = replace(drive(ratio=50.0), motor=motor, transmission=gear, friction=Friction(1e-3))
    robot = replace(random_arm(4, "R", (axis,)), gravity=np.zeros(3))
    rigid = replace(robot, drives=(replace(axis, transmission=Gear(50.0)),))
    links = float(mass_matrix(rigid, [0.0])[0, 0]) - rotor * 50.0**2
    motion = quintic(np.zeros(1), np.array([1.0]), 1500, 2e-4)
    ran = simulate(
        robot,
        controller(1, Rates(5000), kv=1.0),
        JointReference(motion.q[:800], motion.qd[:800], motion.qdd[:800]),
    )
    names = ("q", "qd", "motor_coordinate", "motor_speed", "current", "power")
    q, qd, theta, omega, current, power = (values(ran, name)[:, 0] for name in names)
    twist, slip = theta - q, omega - qd
    kept = 0.5 * (links * qd**2 + rotor * (50.0 * omega) ** 2 + gear.stiffness * twist**2)
    lost = motor.resistance * current**2 + gear.damping * slip**2 + 1e-3 * (50.0 * omega) ** 2
    exact = np.trapezoid(lost, ran.time) + kept[-1] - kept[0]
    assert np.abs(slip).max() > 0.05
    assert np.trapezoid(power, ran.time) == pytest.approx(float(exact), rel=BALANCE)


def test_a_motor_that_drags_its_torque_behind_brings_what_its_shaft_does() -> None:
    axis = Drive(EffortAmplifier(1e3), LaggingMotor(0.1, 200.0), Gear(2.0), Friction(0.5))
    robot = replace(random_arm(4, "R", (axis,)), gravity=np.zeros(3))
    mass = float(mass_matrix(robot, [0.0])[0, 0])
    motion = quintic(np.zeros(1), np.array([1.0]), 300)
    ran = simulate(robot, controller(1), JointReference(motion.q[:160], motion.qd[:160], motion.qdd[:160]))
    qd = values(ran, "qd")[:, 0]
    exact = 0.5 * mass * qd[-1] ** 2 + np.trapezoid(4.0 * 0.5 * qd**2, ran.time)
    assert integral(ran, values(ran, "power")) == pytest.approx(float(exact), rel=BALANCE)


def test_a_warm_winding_draws_more_for_the_same_current() -> None:
    """At rest R·(1 + α·ϑ)·i²."""
    warm = ThermalDcMotor(0.2, 0.2, 1.5, 1e-3, 2e-4, 0.6, 1.4, 18.0, 900.0, start_rise=60.0)
    axis = replace(drive(ratio=60.0), amplifier=GuardedAmplifier(40.0, 20.0, 100.0), motor=warm)
    robot = random_arm(2, "R", (axis,))
    ran = simulate(robot, controller(1), standing(np.zeros(1), 20))
    current, rise = values(ran, "current")[-1, 0], values(ran, "winding_rise")[-1, 0]
    exact = 1.5 * (1.0 + warm.resistance_drift * rise) * current**2
    assert rise > 50.0
    assert current**2 > 1e-6
    assert values(ran, "power")[-1, 0] == pytest.approx(exact, rel=1e-6)


SUPPLY, BACK, RATED, DROP = 2.1e7, 3e5, 6e-4, 7e6
"""[Pa], [Pa], [m³/s], [Pa]"""
STEP = """\
def law(par, state, ref, meas, load, aux, out):
    out[0] = par[0, 0] if state[0, 0] < 150.0 else -par[0, 0]
    state[0, 0] += 1.0
"""


def test_a_valve_draws_what_flows_out_of_its_supply_as_an_independent_solver_says() -> None:
    """Edges with null flow and overlap by cases, the supplied volume as one more state."""
    motor = HydraulicMotor(
        *(1.26e-3, 3.15e-4, 1e-12, 0.0),
        supply_pressure=SUPPLY,
        return_pressure=BACK,
        bulk_modulus=1.4e9,
        rated_flow=RATED,
        rated_pressure_drop=DROP,
        rated_input=0.05,
        natural_frequency=630.0,
        damping_ratio=0.8,
        null_flow=2.4e-5,
        overlap=0.05,
    )
    robot = replace(random_arm(3, "P", (Drive(ValveAmplifier(0.05), motor, Gear()),)), gravity=np.zeros(3))
    mass, lap = float(mass_matrix(robot, [0.0])[0, 0]), 0.05 / 0.95
    leak = motor.null_flow / (2.0 * RATED)
    x0 = float(np.roots([1.0 - leak, -leak * (1.0 + lap), -leak * lap]).max())

    def edge(x: float) -> float:
        y = (x - 0.05) / 0.95
        return (x0 + y if y >= 0.0 else x0**2 / (x0 - y)) / (1.0 + x0)

    def through(fall: float) -> float:
        return RATED * sqrt(2.0 / DROP) * fall / sqrt(sqrt(fall**2 + 1e10))

    def slope(time: float, x: Array) -> Array:
        a, b, opening, rate, speed, _ = x
        current = 0.02 if time < 0.15 else -0.02
        out_a, out_b = edge(opening) * through(SUPPLY - a), edge(-opening) * through(SUPPLY - b)
        into_a = out_a - edge(-opening) * through(a - BACK)
        into_b = out_b - edge(opening) * through(b - BACK)
        stiff, swept = 1.4e9 / 3.15e-4, 1.26e-3 * speed + 1e-12 * (a - b)
        spool = 630.0**2 * (current / 0.05 - opening) - 2.0 * 0.8 * 630.0 * rate
        moved = 1.26e-3 * (a - b) / mass
        return np.array(
            [stiff * (into_a - swept), stiff * (into_b + swept), rate, spool, moved, out_a + out_b]
        )

    law = CompiledLaw("step", STEP, ("i",), np.array([[0.02]]), LawTraits(state_names=("ticks",)))
    ran = simulate(robot, controller(1), standing(np.zeros(1), 300), SimulationOptions(law=law))
    middle, volume = 0.5 * (SUPPLY + BACK), 0.0
    state = np.array([middle, middle, 0.0, 0.0, 0.0, 0.0])
    for span in ((0.0, 0.15), (0.15, 0.3)):
        inner = (span[0], span[1] - 1e-12)
        state = solve_ivp(slope, inner, state, rtol=1e-10, atol=1e-12).y[:, -1]
    volume = float(state[5])
    power = values(ran, "power")[:, 0]
    assert volume > 1e-5
    assert integral(ran, power[:, np.newaxis]) == pytest.approx(SUPPLY * volume, rel=BALANCE)


@pytest.mark.parametrize("null_flow", [0.0, 0.05])
def test_a_cylinder_at_rest_takes_oil_for_its_leaks(null_flow: float) -> None:
    """Between its chambers, and through the closed edges of both chambers."""
    motor = replace(CYLINDER, null_flow=null_flow * CYLINDER.rated_flow)
    robot = lifted(replace(DRIVE, motor=motor))
    ran = simulate(robot, robots.default_controller(robot), standing(np.array([0.4]), 100))
    held, a, b = (values(ran, name)[-1, 0] for name in ("power", "pressure_a", "pressure_b"))
    leak = motor.leakage * (a - b)
    supplied = held / motor.supply_pressure
    if not null_flow:
        assert supplied == pytest.approx(abs(leak), rel=1e-3)
    else:
        centre = motor.null_flow * sqrt(motor.supply_pressure / motor.rated_pressure_drop)
        assert supplied == pytest.approx(centre, rel=0.05)  # the spool is a little off its centre
