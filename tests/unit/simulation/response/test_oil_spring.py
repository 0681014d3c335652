"""Hydraulic axes at a place: levers, masses, oil, and frequencies, against formulas of their own."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import eigh
from scipy.optimize import brentq

from ropsim import robots
from ropsim.dynamics import gravity, mass_matrix
from ropsim.model import Drive, Friction, HydraulicCylinder, Linkage, Payload, RobotModel
from ropsim.simulation import linear_loop, oil_springs, plant_modes
from ropsim.spatial import Array

CRANE = robots.load("patu655")
SPEED = 1e-3
"""Of a rod [m/s]."""
PLACES = np.radians([[0.0, -20.0], [45.0, -60.0], [70.0, 20.0]])


def cylinder(drive: Drive) -> HydraulicCylinder:
    assert isinstance(drive.motor, HydraulicCylinder)
    return drive.motor


def without_losses() -> RobotModel:
    """Return the crane with tight chambers and without friction."""
    drives = (
        replace(one, motor=replace(cylinder(one), leakage=0.0), friction=Friction()) for one in CRANE.drives
    )
    return replace(CRANE, drives=tuple(drives))


def chamber_springs(q: Array) -> Array:
    """Return stiffnesses at the rods from the way of the rod by differences of its length."""
    found = []
    for drive, place in zip(CRANE.drives, q.tolist(), strict=True):
        motor, gear = cylinder(drive), drive.transmission
        assert isinstance(gear, Linkage)
        (a, b, e), (c, d, f) = gear.carrier_pin, gear.link_pin
        turned = (c * math.cos(place) - d * math.sin(place), c * math.sin(place) + d * math.cos(place), f)
        out = math.dist((a, b, e), turned) - gear.retracted_length
        behind = motor.dead_volume_a + motor.area_a * out
        around = motor.dead_volume_b + motor.area_b * (motor.stroke - out)
        found.append(motor.bulk_modulus * (motor.area_a**2 / behind + motor.area_b**2 / around))
    return np.array(found)


@pytest.mark.parametrize("q", PLACES)
def test_lever_mass_and_oil_are_those_of_the_triangle_and_the_chambers(q: Array) -> None:
    found = oil_springs(CRANE, q, Payload())
    levers = np.array([one.lever for one in found])
    for axis, drive in enumerate(CRANE.drives):
        gear = drive.transmission
        assert isinstance(gear, Linkage)
        apart = (gear.length_at(q[axis] + 1e-6) - gear.length_at(q[axis] - 1e-6)) / 2e-6
        assert levers[axis] == pytest.approx(abs(apart), rel=1e-8)
    assert [one.stiffness for one in found] == pytest.approx(chamber_springs(q), rel=1e-12)
    assert [one.mass for one in found] == pytest.approx(np.diag(mass_matrix(CRANE, q)) / levers**2)
    for one in found:
        assert one.hz == pytest.approx(math.sqrt(one.stiffness / one.mass) / (2.0 * math.pi))


@pytest.mark.parametrize("q", PLACES)
def test_without_a_law_the_arm_swings_on_its_oil(q: Array) -> None:
    """K·x = ω²·M·x of all axes together, without leaks and friction; gravity's own stiffness is small."""
    arm = without_losses()
    found = oil_springs(arm, q, Payload())
    stiffness = np.diag([one.stiffness * one.lever**2 for one in found])
    expected = np.sqrt(eigh(stiffness, mass_matrix(arm, q), eigvals_only=True)) / (2.0 * np.pi)
    hz, damping = plant_modes(linear_loop(arm, robots.default_controller(CRANE), q, Payload()))
    for own in expected.tolist():
        nearest = int(np.abs(hz - own).argmin())
        assert hz[nearest] == pytest.approx(own, rel=0.02)
        assert damping[nearest] == pytest.approx(0.0, abs=0.02)
    _, damping = plant_modes(linear_loop(CRANE, robots.default_controller(CRANE), q, Payload()))
    assert (damping > 0.0).all()


@pytest.mark.parametrize("q", PLACES)
def test_a_valve_moves_its_axis_as_fast_as_the_flow_through_both_edges_allows(q: Array) -> None:
    """Of a rod that is pushed out: v·A_a = x·Q·√(2·(p_s - p_a)/Δp), v·A_b = x·Q·√(2·(p_b - p_r)/Δp)."""
    arm = without_losses()
    efforts = gravity(arm, q)
    for one in oil_springs(arm, q, Payload()):
        motor, gear = cylinder(arm.drives[one.axis]), arm.drives[one.axis].transmission
        assert isinstance(gear, Linkage)
        force = efforts[one.axis] / gear.ratio_at(q[one.axis])

        def left_over(opening: float, force: float = force, motor: HydraulicCylinder = motor) -> float:
            edge = opening * motor.rated_flow * math.sqrt(2.0 / motor.rated_pressure_drop)
            a = motor.supply_pressure - (SPEED * motor.area_a / edge) ** 2
            b = motor.return_pressure + (SPEED * motor.area_b / edge) ** 2
            return motor.area_a * a - motor.area_b * b - force

        opening = brentq(left_over, 1e-4, 1.0)
        out = one.forward if gear.sense > 0.0 else one.back
        assert out * one.lever == pytest.approx(SPEED / opening, rel=1e-3)


def test_electric_axes_have_no_oil() -> None:
    puma = robots.load("puma560")
    assert oil_springs(puma, puma.home, Payload()) == ()
