"""Derivatives by differences: exact for polynomials, of the stated order for others, for poses, too."""

import math

import numpy as np
import pytest

from ropsim.motion import Line, OrientationMode, numeric_points, pose_derivatives
from ropsim.motion.testing import row_derivatives
from ropsim.spatial import Array
from support.paths import random_pose


@pytest.mark.parametrize("count", range(2, 13))
def test_rows_of_a_polynomial_have_exact_derivatives(count: int) -> None:
    coefficients = np.random.default_rng(count).normal(size=min(count, 7))
    polynomial = np.polynomial.Polynomial(coefficients)
    places = np.linspace(0.0, 1.0, count)
    d1, d2 = row_derivatives(polynomial(places)[:, None], 1.0 / (count - 1))
    assert d1[:, 0] == pytest.approx(polynomial.deriv()(places), abs=1e-11)
    assert d2[:, 0] == pytest.approx(polynomial.deriv(2)(places), abs=1e-9)


def test_differences_of_rows_are_of_order_six_everywhere() -> None:
    errors = []
    for count in (41, 81):
        places = np.linspace(0.0, 3.0, count)
        d1, d2 = row_derivatives(np.sin(places)[:, None], 3.0 / (count - 1))
        errors.append((np.abs(d1[:, 0] - np.cos(places)).max(), np.abs(d2[:, 0] + np.sin(places)).max()))
    coarse, fine = np.array(errors)
    assert (np.log2(coarse / fine) > 5.5).all()


@pytest.mark.parametrize("length", [1e-3, 1.0, 50.0])
@pytest.mark.parametrize("mode", OrientationMode)
def test_poses_alone_have_derivatives_up_to_both_ends(mode: OrientationMode, length: float) -> None:
    rng = np.random.default_rng(8)
    line = Line(random_pose(rng, length), random_pose(rng, length), mode)
    s = np.linspace(0.0, line.length, 31)
    asked = []

    def matrices(places: Array) -> Array:
        asked.append(places)
        return line.tool(places).matrices

    found, exact = numeric_points(matrices, s, line.length), line.tool(s)
    everything = np.concatenate(asked)
    assert (everything.min(), everything.max()) == (0.0, line.length)
    assert (found.matrices == exact.matrices).all()
    units = np.repeat([line.length / length, line.length], 3)  # way per length, angle per length
    assert np.abs((found.d1 - exact.d1) * units).max() < 1e-10
    assert np.abs((found.d2 - exact.d2) * units * line.length).max() < 1e-7


def test_a_bend_of_poses_alone_is_found() -> None:
    def circle(s: Array) -> Array:
        matrices = np.tile(np.eye(4), (len(s), 1, 1))
        matrices[:, 0, 3], matrices[:, 1, 3] = np.cos(s), np.sin(s)
        return matrices

    points = numeric_points(circle, np.array([0.0, 1.0, math.pi]), math.pi)
    assert points.d1[:, :2] == pytest.approx(
        np.array([[0.0, 1.0], [-math.sin(1.0), math.cos(1.0)], [0.0, -1.0]]), abs=1e-10
    )
    assert points.d2[:, :2] == pytest.approx(
        np.array([[-1.0, 0.0], [-math.cos(1.0), -math.sin(1.0)], [1.0, 0.0]]), abs=1e-7
    )


def test_poses_by_offsets_have_the_derivatives_of_their_path() -> None:
    rng = np.random.default_rng(9)
    line = Line(random_pose(rng, 1.0), random_pose(rng, 1.0), OrientationMode.DRIVE_TRANSFORM)
    s = np.linspace(0.1, 0.9, 17) * line.length

    def around(offsets: Array) -> Array:
        return line.tool((s[:, None] + offsets).ravel()).matrices.reshape(*offsets.shape, 4, 4)

    exact = line.tool(s)
    for step in (0.01, 0.003):
        found = pose_derivatives(around, np.full(len(s), step * line.length))
        assert (found.matrices == exact.matrices).all()
        assert np.abs(found.d1 - exact.d1).max() < 1e-10
        assert np.abs(found.d2 - exact.d2).max() < 1e-8
