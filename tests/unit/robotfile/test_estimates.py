"""Links taken for cylinders: their tensors are those of points spread evenly through them."""

import math

import numpy as np
import pytest

from ropsim.robotfile.estimates import Cylindrical
from ropsim.spatial import Array

MASS = 3.0
SPREAD = 1e-3
"""Share by which sums over the points miss the integral: 40 steps along the axis leave 1/40² of l²/12."""


def points(radius: float, length: float) -> Array:
    """Return points that are spread evenly in a cylinder about z, shape (k, 3)."""
    distances = radius * np.sqrt((np.arange(40) + 0.5) / 40)  # rings of one area
    turns = 2.0 * math.pi * np.arange(8) / 8
    heights = length * ((np.arange(40) + 0.5) / 40 - 0.5)
    r, turn, z = (one.ravel() for one in np.meshgrid(distances, turns, heights))
    return np.column_stack([r * np.cos(turn), r * np.sin(turn), z])


@pytest.mark.parametrize(("radius", "length"), [(0.1, 0.2), (0.2, 0.1), (0.02, 0.5)])
def test_the_inertia_of_a_link_is_that_of_points_spread_evenly_in_its_cylinder(
    radius: float, length: float
) -> None:
    places = points(radius, length)
    squares = MASS * places.T @ places / len(places)
    wanted = np.trace(squares) * np.eye(3) - squares
    found = Cylindrical((0.0, 0.0, 0.0), (0.0, 0.0, 1.0), radius, length).inertia(MASS)
    np.testing.assert_allclose(found, wanted, rtol=SPREAD, atol=SPREAD * wanted.max())


def test_a_link_is_hardest_to_turn_about_the_axes_across_it() -> None:
    """m·r²/2 along its axis, m·(3 r² + l²)/12 across it, wherever that axis points."""
    radius, length, direction = 0.05, 0.4, np.array([0.6, 0.0, 0.8])
    tensor = Cylindrical((0.0, 0.0, 0.0), (0.6, 0.0, 0.8), radius, length).inertia(MASS)
    along, across = MASS * radius**2 / 2.0, MASS * (3.0 * radius**2 + length**2) / 12.0
    np.testing.assert_allclose(tensor @ direction, along * direction, rtol=1e-12)
    np.testing.assert_allclose(np.linalg.eigvalsh(tensor), [along, across, across], rtol=1e-12)
