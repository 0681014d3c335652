"""A DC motor that grows warm against closed forms and an independent solver."""

from dataclasses import replace
from math import inf

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from ropsim.controller import CompiledLaw
from ropsim.dynamics import chain_of, drive_fault, mass_matrix, steady_drive
from ropsim.dynamics.drives import largest_effort
from ropsim.model import (
    Drive,
    Gear,
    GuardedAmplifier,
    Payload,
    RobotModel,
    ThermalDcMotor,
    VoltageAmplifier,
)
from ropsim.simulation import Servo
from ropsim.spatial import Array
from support.arms import MOTOR as COLD
from support.arms import random_arm
from support.drives import slopes_of
from support.servo_cases import controller, standing

MOTOR = ThermalDcMotor(
    torque_constant=0.2,
    back_emf_constant=0.21,
    resistance=1.5,
    inductance=6e-3,
    rotor_inertia=2e-4,
    winding_thermal_resistance=0.6,
    housing_thermal_resistance=2.4,
    winding_time_constant=0.05,
    housing_time_constant=0.4,
    resistance_drift=3.9e-3,
    torque_drift=-2e-3,
)
"""Time constants are hundreds of times those of a real motor of that size: a second is long."""
RATIO = -30.0
DRIVE = Drive(GuardedAmplifier(40.0, 20.0, 100.0), MOTOR, Gear(RATIO))
HOLD = """\
def law(par, state, ref, meas, load, aux, out):
    out[0] = par[0, 0]
"""


def free_axis(motor: ThermalDcMotor = MOTOR) -> RobotModel:
    """Return one axis without gravity."""
    return replace(random_arm(5, "R", (replace(DRIVE, motor=motor),)), gravity=np.zeros(3))


def test_a_motor_under_voltage_moves_and_warms_as_an_independent_solver_says() -> None:
    robot, ticks, voltage = free_axis(), 400, 39.0
    inertia = float(mass_matrix(robot, [0.0])[0, 0])

    def slope(_: float, x: Array) -> Array:
        _, qd, current, winding, housing = x
        resistance, flux = 1.5 * (1.0 + 3.9e-3 * winding), 1.0 - 2e-3 * housing
        loss, passed, given_off = resistance * current**2, (winding - housing) / 0.6, housing / 2.4
        return np.array(
            [
                qd,
                RATIO * 0.2 * flux * current / inertia,
                (-voltage - resistance * current - 0.21 * flux * RATIO * qd) / 6e-3,
                (loss - passed) / (0.05 / 0.6),
                (passed - given_off) / (0.4 / 2.4),
            ]
        )

    exact = solve_ivp(slope, (0.0, ticks / 1000.0), np.zeros(5), rtol=1e-10, atol=1e-10).y[:, -1]
    law = CompiledLaw("hold", HOLD, ("voltage",), np.array([[voltage]]))
    servo = Servo.build(robot, controller(1), law)
    start = servo.initial_state(np.zeros(1))
    end = servo.run(start, standing(np.zeros(1), ticks), Payload(), servo.recorder(start))
    states = [end.drive(name)[0] for name in ("current", "winding_rise", "housing_rise")]
    found = [end.q[0], end.qd[0], *states]
    assert exact[3] > 10.0
    np.testing.assert_allclose(found, exact, rtol=1e-5)


@pytest.mark.parametrize("current", [2.0, 5.0, -5.0])
def test_a_constant_current_warms_the_winding_to_where_the_losses_are_given_off(current: float) -> None:
    """ϑ = (R_w + R_h)·R·i²·(1 + α·ϑ), and the housing to the share of its resistance."""
    loss, both = 1.5 * current**2, 0.6 + 2.4
    winding = both * loss / (1.0 - both * loss * 3.9e-3)
    housing = winding * 2.4 / both
    rates = slopes_of(free_axis())(np.array([0.0, 0.0, current, winding, housing]), 0.0)
    assert rates[3:] == pytest.approx([0.0, 0.0], abs=1e-9)


def test_warm_bodies_cool_with_the_two_time_constants_of_the_closed_form() -> None:
    """Without loss: eigenvalues of the two bodies, and none of them rises."""
    rates = slopes_of(free_axis())
    columns = [rates(np.array([0.0, 0.0, 0.0, *row]), 0.0)[3:] for row in np.eye(2)]
    found = np.sort(np.linalg.eigvals(np.column_stack(columns)))
    half = 0.5 * (1.0 / 0.05 + (1.0 + 4.0) / 0.4)
    root = np.sqrt(half**2 - 1.0 / (0.05 * 0.4))
    assert found == pytest.approx([-half - root, -half + root])


@pytest.mark.parametrize("rise", [0.0, 80.0])
def test_a_warm_motor_needs_more_current_and_more_voltage(rise: float) -> None:
    warm = replace(MOTOR, start_rise=rise)
    held = steady_drive(replace(DRIVE, motor=warm), 0.0, 0.5, 30.0)
    current = 30.0 / (RATIO * 0.2 * (1.0 - 2e-3 * rise))
    volts = 1.5 * (1.0 + 3.9e-3 * rise) * current + 0.21 * (1.0 - 2e-3 * rise) * RATIO * 0.5
    assert held.states == pytest.approx((current, rise, rise))
    assert held.output == pytest.approx(volts)
    out = slopes_of(free_axis(warm))(np.array([0.0, 0.5, *held.states]), held.output)
    assert out[2] == pytest.approx(0.0, abs=1e-6)
    most = min(20.0, 40.0 / (1.5 * (1.0 + 3.9e-3 * rise)))
    assert largest_effort(replace(DRIVE, motor=warm), 0.0) == pytest.approx(
        30.0 * 0.2 * (1.0 - 2e-3 * rise) * most
    )


def test_without_drifts_it_is_the_motor_that_stays_as_it_is() -> None:
    constants = (COLD.torque_constant, COLD.back_emf_constant, COLD.resistance, COLD.inductance)
    warm = ThermalDcMotor(*constants, COLD.rotor_inertia, 0.6, 2.4, 0.05, 0.4, resistance_drift=0.0)
    one = slopes_of(free_axis(warm))(np.array([0.1, 0.3, 2.0, 50.0, 20.0]), 7.0)
    plain = replace(DRIVE, amplifier=VoltageAmplifier(40.0, 20.0), motor=COLD)
    other = slopes_of(replace(free_axis(), drives=(plain,)))(np.array([0.1, 0.3, 2.0]), 7.0)
    np.testing.assert_allclose(one[:3], other, rtol=1e-12)


def test_the_amplifier_is_the_one_that_watches_the_winding() -> None:
    assert drive_fault(DRIVE) is None
    assert drive_fault(replace(DRIVE, amplifier=GuardedAmplifier(40.0, 20.0, inf))) is None
    for wrong in (replace(DRIVE, amplifier=VoltageAmplifier(40.0, 20.0)), replace(DRIVE, motor=COLD)):
        found = drive_fault(wrong)
        assert found
        assert "the amplifier" in found[0]
    limits = {limit.column: limit.number for limit in chain_of(DRIVE).amplifier.limits}
    assert limits["winding_rise"] == "max_rise"


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("winding_thermal_resistance", 0.0),
        ("housing_time_constant", -1.0),
        ("resistance_drift", -1e-3),
        ("torque_drift", 1e-3),
        ("torque_drift", -0.02),
        ("start_rise", -1.0),
        ("start_rise", 500.0),
    ],
)
def test_numbers_of_heat_that_cannot_be_are_told(name: str, value: float) -> None:
    found = drive_fault(replace(DRIVE, motor=replace(MOTOR, **{name: value})))
    assert found
    assert found[0] == f"`{name}`"
