"""Masses by rule: shares of the whole, and cylinders with the tensors of points spread through them."""

import math

import numpy as np
import pytest

from ropsim import robots
from ropsim.model import ArmClass
from ropsim.robotfile.testing import (
    bodies,
    cylinder,
    extended_length,
    heaviness,
    link_masses,
    link_masses_of_moving,
    total_mass,
)
from ropsim.spatial import Array

MASS = 3.0
SPREAD = 1e-3
"""Share by which sums over the points miss the integral: 40 steps along the axis leave 1/40² of l²/12."""
PRINTED = 2e-4
"""Half a digit of the printed centres [m]."""
SERIAL = [(one, count) for one in ArmClass if one is not ArmClass.PALLETIZER for count in range(1, 10)]


def points(radius: float, length: float) -> Array:
    """Return points that are spread evenly in a cylinder about z, shape (k, 3)."""
    distances = radius * np.sqrt((np.arange(40) + 0.5) / 40)  # rings of one area
    turns = 2.0 * math.pi * np.arange(8) / 8
    heights = length * ((np.arange(40) + 0.5) / 40 - 0.5)
    r, turn, z = (one.ravel() for one in np.meshgrid(distances, turns, heights))
    return np.column_stack([r * np.cos(turn), r * np.sin(turn), z])


@pytest.mark.parametrize("length", [0.05, 0.2, 1.5])
def test_a_link_is_a_cylinder_of_1500_kg_per_cubic_metre_at_least_as_long_as_thick(length: float) -> None:
    whole = max(length, 2.0 * (MASS / (2.0 * math.pi * 1500.0)) ** (1 / 3))
    radius = math.sqrt(MASS / (math.pi * 1500.0 * whole))
    assert whole >= 2.0 * radius * (1.0 - 1e-12)
    places = points(radius, whole)
    squares = MASS * places.T @ places / len(places)
    wanted = np.trace(squares) * np.eye(3) - squares
    found = cylinder(np.zeros(3), np.array([0.0, 0.0, length]), MASS, 0.4)
    np.testing.assert_allclose(found.inertia, wanted, rtol=SPREAD, atol=SPREAD * wanted.max())
    np.testing.assert_allclose(found.com, [0.0, 0.0, 0.4 * length], atol=1e-12)


def test_a_link_is_hardest_to_turn_about_the_axes_across_it() -> None:
    direction = np.array([0.6, 0.0, 0.8])
    tensor = cylinder(np.zeros(3), 1.2 * direction, MASS, 0.5).inertia
    radius = math.sqrt(MASS / (math.pi * 1500.0 * 1.2))
    along, across = MASS * radius**2 / 2.0, MASS * (3.0 * radius**2 + 1.2**2) / 12.0
    np.testing.assert_allclose(tensor @ direction, along * direction, rtol=1e-12)
    np.testing.assert_allclose(np.linalg.eigvalsh(tensor), [along, across, across], rtol=1e-12)


@pytest.mark.parametrize(("arm_class", "count"), SERIAL)
def test_any_number_of_axes_has_the_moving_mass_of_its_class(arm_class: ArmClass, count: int) -> None:
    usual = {ArmClass.SEVEN_AXIS: 7, ArmClass.SCARA: 4}.get(arm_class, 6)
    for total in (20.0, 300.0, 2000.0):
        made = link_masses(arm_class, count, total)
        assert len(made.links) == count
        assert min(made.links) > 0.0
        assert sum(made.links) == pytest.approx(sum(link_masses(arm_class, usual, total).links), rel=1e-12)
        assert sum(made.links) < total


@pytest.mark.parametrize(("arm_class", "count"), SERIAL)
def test_the_moving_mass_leads_back_to_the_total(arm_class: ArmClass, count: int) -> None:
    for total in (5.0, 60.0, 700.0, 3000.0):
        made = link_masses(arm_class, count, total)
        back = link_masses_of_moving(arm_class, count, sum(made.links))
        assert back.total == pytest.approx(total, rel=1e-9)
        assert back.links == pytest.approx(made.links, rel=1e-9)


def test_a_heavy_arm_has_more_of_its_mass_in_motion_and_in_its_column() -> None:
    assert [heaviness(one) for one in (50.0, 1000.0, 4000.0)] == pytest.approx([0.0, 1.0, 1.0])
    light = link_masses(ArmClass.INDUSTRIAL, 6, 50.0)
    heavy = link_masses(ArmClass.INDUSTRIAL, 6, 1000.0)
    assert sum(light.links) == pytest.approx(0.71 * 50.0)
    assert sum(heavy.links) == pytest.approx(0.80 * 1000.0)
    assert light.links[0] / sum(light.links) == pytest.approx(0.244)
    assert heavy.links[0] / sum(heavy.links) == pytest.approx(0.438)


def test_the_irb_140_has_the_centres_of_an_independent_computation() -> None:
    """The rule in another program, with 98 kg: masses to half a percent, centres as printed."""
    robot = robots.load("irb140")
    made = bodies(
        robot.joints, robot.X_nM, ArmClass.INDUSTRIAL, link_masses(ArmClass.INDUSTRIAL, 6, 98.0).links
    )
    assert [one.mass for one in made[:5]] == pytest.approx([20.514, 26.425, 14.262, 7.253, 2.25], rel=6e-3)
    wanted = [
        [0.0399, 0.0, -0.0757],
        [0.1548, 0.0, 0.0],
        [0.0, 0.0513, 0.0],
        [0.0, 0.0, -0.125],
        [0.0, 0.0148, 0.0],
        [0.0, 0.0, 0.0533],
    ]
    np.testing.assert_allclose([one.com for one in made], wanted, atol=PRINTED)


def test_the_total_mass_by_size_is_within_its_accuracy_of_data_sheets() -> None:
    """38·p^0.20·R^1.88 is weak: 80 % within 1.75, old heavy arms weigh twice as much."""
    known = {"irb120": 25.0, "irb1200_5_09": 54.0, "irb4600_60_205": 425.0, "kr6_r900_2": 55.2, "ur5e": 20.6}
    for name, mass in known.items():
        robot = robots.load(name)
        arm_class = ArmClass.COBOT if name == "ur5e" else ArmClass.INDUSTRIAL
        found = total_mass(arm_class, robot.rated_payload, extended_length(robot.joints, robot.X_nM))
        assert mass / 1.75 < found < 1.75 * mass
