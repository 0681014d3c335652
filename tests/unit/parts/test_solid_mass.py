"""Mass, centre of mass and inertia of filled shapes, checked against sums over tetrahedra."""

from math import pi

import numpy as np
import pytest

from ropsim.model import Box, Cylinder, Polyline, Prism, Revolve, Shape, Solid, Sphere
from ropsim.parts.solid_mass import filled
from ropsim.spatial import Array, Pose
from ropsim.views.testing import facets

TURNED = Pose(np.array([0.3, -0.2, 0.7]), np.array([0.8, 0.1, -0.5, 0.3]))
SOLIDS: list[tuple[Solid, float]] = [
    (Box((0.2, 0.3, 0.5)), 1e-9),
    (Prism(((0.0, 0.0), (0.4, 0.0), (0.3, 0.2), (0.1, 0.25)), 0.6), 1e-9),
    (Prism(((0.0, 0.0), (0.4, 0.0), (0.4, 0.1), (0.1, 0.1), (0.1, 0.3), (0.0, 0.3)), 0.2), 1e-9),
    (Cylinder(0.2, 0.5), 1e-2),
    (Cylinder(0.2, 0.5, 0.05), 1e-2),
    (Revolve(((0.0, 0.0), (0.1, 0.0), (0.3, 0.2), (0.05, 0.4), (0.0, 0.4))), 1e-2),
    (Sphere(0.25), 2e-2),
]
"""Solids, and the share by which facets differ from round ones."""


def of_tetrahedra(triangles: Array) -> tuple[float, Array, Array]:
    """Return volume, centre and inertia at density 1 from the triangles of a closed surface."""
    volumes = np.einsum("ki,ki->k", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])) / 6.0
    volume = float(volumes.sum())
    centre = (volumes[:, None] * triangles.sum(axis=1) / 4.0).sum(axis=0) / volume
    relative = triangles - centre
    volumes = np.einsum("ki,ki->k", relative[:, 0], np.cross(relative[:, 1], relative[:, 2])) / 6.0
    sums = relative.sum(axis=1)
    second = np.einsum("k,kci,kcj->ij", volumes, relative, relative)
    second = (second + np.einsum("k,ki,kj->ij", volumes, sums, sums)) / 20.0
    return volume, centre, np.trace(second) * np.eye(3) - second


@pytest.mark.parametrize(("solid", "near"), SOLIDS)
def test_a_solid_weighs_as_its_tetrahedra_do(solid: Solid, near: float) -> None:
    shape = Shape(solid, TURNED)
    load = filled((shape,), None, density=1.0)
    volume, centre, inertia = of_tetrahedra(facets(shape))
    assert load.mass == pytest.approx(volume, rel=near)
    assert load.com == pytest.approx(centre, rel=near)
    assert load.inertia == pytest.approx(inertia, abs=2.0 * near * float(np.trace(inertia)))


def test_two_solids_weigh_as_both_and_lines_as_nothing() -> None:
    shapes = (Shape(Box((1.0, 1.0, 1.0))), Shape(Sphere(1.0), Pose(np.array([4.0, 0.0, 0.0]))))
    line = Shape(Polyline(((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))))
    load = filled((*shapes, line), None, density=3.0)
    assert load.mass == pytest.approx(3.0 * (1.0 + 4.0 / 3.0 * pi))
    assert load.com[0] == pytest.approx(4.0 * 4.0 / 3.0 * pi / (1.0 + 4.0 / 3.0 * pi))


def test_a_given_mass_keeps_the_centre_and_scales_the_inertia() -> None:
    shapes = (Shape(Box((0.2, 0.3, 0.5)), TURNED), Shape(Cylinder(0.1, 0.4)))
    light, heavy = filled(shapes, 2.0), filled(shapes, 6.0)
    assert heavy.mass == 6.0
    assert heavy.com == pytest.approx(light.com)
    assert heavy.inertia == pytest.approx(3.0 * light.inertia)
