"""A hydraulic drive against the closed forms of Merritt, Hydraulic Control Systems, 1967, chapters 5 and 6.

The numbers are those of a cylinder of 12.6 cm² and 0.5 m stroke that moves 500 kg, at a valve of 40 l/min at
70 bar and a supply of 210 bar: ωh = √(4·β·A²/(Vt·M)), v = Q_r·√((ps - F/A)/Δp_r)/A, stall at A·ps.
"""

from dataclasses import replace
from math import sqrt

import numpy as np
import pytest

from ropsim.dynamics import chain_of, drive_fault, steady_drive
from ropsim.dynamics.drives import largest_effort
from ropsim.model import Drive, Gear, HydraulicMotor, InputKind, ValveAmplifier, VoltageAmplifier
from ropsim.spatial import Array
from support.drives import rates_of

AREA, VOLUME, MASS, BULK, SUPPLY = 1.26e-3, 6.3e-4, 500.0, 1.4e9, 2.1e7
"""[m²], both chambers together [m³], [kg], [Pa], [Pa]"""
MOTOR = HydraulicMotor(
    AREA,
    VOLUME / 2,
    0.0,
    0.0,
    supply_pressure=SUPPLY,
    return_pressure=0.0,
    bulk_modulus=BULK,
    rated_flow=40e-3 / 60.0,
    rated_pressure_drop=7e6,
    rated_input=0.05,
    natural_frequency=630.0,
    damping_ratio=0.8,
)
DRIVE = Drive(ValveAmplifier(0.05), MOTOR, Gear())
LAMINAR = 1e-4
"""Share by which flow at falls of pressure far above the laminar ones differs from the root."""


def test_speed_without_load_and_against_a_force_and_stall_are_those_of_the_closed_form() -> None:
    free = steady_drive(DRIVE, 0.0, 0.9164289987136915, 0.0)
    loaded = steady_drive(DRIVE, 0.0, 0.8253131445784427, 5000.0)
    assert free.command == pytest.approx(MOTOR.rated_input, rel=LAMINAR)
    assert loaded.command == pytest.approx(MOTOR.rated_input, rel=LAMINAR)
    assert loaded.states[0] - loaded.states[1] == pytest.approx(3968253.9682539683)
    assert largest_effort(DRIVE, 0.0) == pytest.approx(26460.0)
    assert largest_effort(replace(DRIVE, transmission=Gear(-3.0)), 0.0) == pytest.approx(3.0 * 26460.0)


def test_a_mass_on_oil_swings_at_its_hydraulic_frequency() -> None:
    rates, rest = rates_of(DRIVE), np.array([SUPPLY / 2, SUPPLY / 2, 0.0, 0.0])

    def slope(x: Array) -> Array:
        out = rates(np.append(x[:2], rest[2:]), 0.0, float(x[2]), 0.0)
        return np.array([out[1], out[2], out[0] / MASS])

    at = np.append(rest[:2], 0.0)
    steps = np.diag([1e3, 1e3, 1e-3])
    J = np.column_stack([(slope(at + step) - slope(at - step)) / (2.0 * step.sum()) for step in steps])
    assert np.abs(np.linalg.eigvals(J).imag).max() == pytest.approx(168.0, rel=1e-6)


@pytest.mark.parametrize("seed", range(5))
def test_a_steady_state_stays(seed: int) -> None:
    rng = np.random.default_rng(seed)
    drive = replace(
        DRIVE,
        motor=replace(MOTOR, leakage=2e-12, return_pressure=4e5),
        transmission=Gear(rng.choice([-2.0, 0.5])),
    )
    speed, effort = rng.uniform(-0.2, 0.2), rng.uniform(-0.3, 0.3) * largest_effort(drive, 0.0)
    held = steady_drive(drive, 0.0, speed, effort)
    out = rates_of(drive)(np.array(held.states), 0.0, speed, held.output)
    assert out[0] == pytest.approx(effort)
    # what a thousandth of the rated flow would do to a chamber
    np.testing.assert_allclose(out[1:3], 0.0, atol=1e-9 * BULK * MOTOR.rated_flow / MOTOR.chamber_volume)
    np.testing.assert_allclose(out[3:], 0.0, atol=1e-6)


def test_a_mass_comes_to_the_speed_that_valve_and_load_allow() -> None:
    """By the classical Runge-Kutta method with the steps of the servo loop."""
    rates, step, load = rates_of(replace(DRIVE, motor=replace(MOTOR, leakage=2e-11))), 0.25e-3, 5000.0

    def slope(x: Array) -> Array:
        out = rates(x[:4], 0.0, float(x[4]), MOTOR.rated_input)
        return np.append(out[1:], (out[0] - load) / MASS)

    x = np.array([SUPPLY / 2, SUPPLY / 2, 0.0, 0.0, 0.0])
    seen = []
    for _ in range(2400):
        a = slope(x)
        b = slope(x + 0.5 * step * a)
        c = slope(x + 0.5 * step * b)
        x = x + step / 6.0 * (a + 2.0 * b + 2.0 * c + slope(x + step * c))
        seen.append(x)
    flow = MOTOR.rated_flow * sqrt((SUPPLY - load / AREA) / 7e6) - 2e-11 * load / AREA
    assert x[4] == pytest.approx(flow / AREA, rel=1e-3)
    assert x[2] == pytest.approx(1.0, abs=1e-9)
    assert np.min(seen, axis=0)[:2].min() > -1e6
    assert x[0] - x[1] == pytest.approx(load / AREA, rel=1e-3)


def test_the_valve_is_a_filter_of_second_order() -> None:
    rates = rates_of(DRIVE)
    base = np.array([SUPPLY / 2, SUPPLY / 2, 0.0, 0.0])
    columns = [rates(base + row, 0.0, 0.0, 0.0)[3:] for row in (np.eye(4)[2], np.eye(4)[3])]
    poles = np.linalg.eigvals(np.column_stack(columns))
    assert np.abs(poles) == pytest.approx([630.0, 630.0])
    assert poles.real == pytest.approx([-0.8 * 630.0] * 2)
    assert rates(base, 0.0, 0.0, 0.05)[4] == pytest.approx(630.0**2)


def test_it_takes_the_current_of_a_valve_and_needs_pressure() -> None:
    assert chain_of(DRIVE).amplifier.kind is InputKind.CURRENT
    assert drive_fault(DRIVE) is None
    assert drive_fault(replace(DRIVE, amplifier=VoltageAmplifier(40.0, 10.0))) is not None
    for wrong in (
        dict(return_pressure=SUPPLY),
        dict(bulk_modulus=0.0),
        dict(rated_flow=-1.0),
        dict(leakage=-1e-12),
        dict(rotor_inertia=-1.0),
    ):
        found = drive_fault(replace(DRIVE, motor=replace(MOTOR, **wrong)))
        assert found is not None
        assert found[0] == f"`{next(iter(wrong))}`"
