"""Splines of compression agree with scipy: basis, energy, normal equations and polynomials of spans."""

import numpy as np
import pytest
from scipy.interpolate import BSpline

from ropsim.motion.testing import normal_equations_kernel, spline_kernel
from ropsim.spatial import Array

ROUNDING = 1e-11
RULE = np.stack(
    [0.5 * (np.polynomial.legendre.leggauss(3)[0] + 1.0), 0.5 * np.polynomial.legendre.leggauss(3)[1]]
)


def breaks_of(spans: int) -> Array:
    """Return uneven breakpoints, lengths of spans from 0.2 to 3."""
    lengths = np.random.default_rng(spans).uniform(0.2, 3.0, spans)
    return np.concatenate(([0.0], np.cumsum(lengths)))


def knots_of(breaks: Array) -> Array:
    return np.concatenate((np.repeat(breaks[0], 5), breaks, np.repeat(breaks[-1], 5)))


SPANS = pytest.mark.parametrize("spans", [1, 2, 3, 7, 20])


@SPANS
def test_basis_functions_are_those_of_scipy(spans: int) -> None:
    breaks = breaks_of(spans)
    u = np.sort(np.concatenate((breaks[:-1], np.random.default_rng(1).uniform(0.0, breaks[-1], 50))))
    values, firsts = np.empty((len(u), 6)), np.empty(len(u))
    spline_kernel.basis_rows(breaks, spans, u, values, firsts)
    dense = np.zeros((len(u), spans + 5))
    for row, first in enumerate(firsts.astype(int)):
        dense[row, first : first + 6] = values[row]
    assert np.abs(dense - BSpline.design_matrix(u, knots_of(breaks), 5).toarray()).max() < ROUNDING


def energy_matrix(breaks: Array, spans: int) -> Array:
    """Return the integrals of products of third derivatives as a full matrix."""
    thirds, packed = np.empty((spans, 18)), np.zeros((spans + 5, 6))
    spline_kernel.third_derivative_rows(breaks, spans, RULE, np.empty((8, 7)), thirds)
    spline_kernel.add_energy(thirds, spans, packed)
    coefficients = np.random.default_rng(2).normal(size=(spans + 5, 2))
    full = unpacked(packed)
    wanted = coefficients[:, 1] @ full @ coefficients[:, 1]
    assert spline_kernel.energy(thirds, spans, coefficients, 1, 1) == pytest.approx(wanted, rel=1e-9)
    return full


def unpacked(packed: Array) -> Array:
    """Return a symmetric matrix of rows with element (i, i - k) in column k."""
    full = np.zeros((len(packed), len(packed)))
    for i, row in enumerate(packed):
        for k in range(min(i, 5) + 1):
            full[i, i - k] = full[i - k, i] = row[k]
    return full


@SPANS
def test_the_energy_is_the_integral_of_squared_third_derivatives(spans: int) -> None:
    breaks = breaks_of(spans)
    nodes, weights = np.polynomial.legendre.leggauss(8)
    u = (breaks[:-1, None] + 0.5 * np.diff(breaks)[:, None] * (nodes + 1.0)).ravel()
    w = (0.5 * np.diff(breaks)[:, None] * weights).ravel()
    thirds = BSpline(knots_of(breaks), np.eye(spans + 5), 5)(u, 3)
    wanted = thirds.T @ (w[:, None] * thirds)
    assert np.abs(energy_matrix(breaks, spans) - wanted).max() < ROUNDING * np.abs(wanted).max()


@SPANS
def test_polynomials_of_spans_are_those_of_scipy(spans: int) -> None:
    breaks, coefficients = breaks_of(spans), np.random.default_rng(3).normal(size=(spans + 5, 7))
    polynomials = np.empty((spans, 6, 7))
    spline_kernel.span_polynomials(breaks, spans, coefficients, np.empty((7, 7)), polynomials)
    curve = BSpline(knots_of(breaks), coefficients, 5)
    for share in (0.0, 0.3, 0.99):
        found = np.einsum("k,skj->sj", share ** np.arange(6.0), polynomials)
        assert np.abs(found - curve(breaks[:-1] + share * np.diff(breaks))).max() < ROUNDING


@pytest.mark.parametrize(("begin", "end"), [(0, 14), (1, 13), (3, 11), (3, 13)])
def test_normal_equations_with_given_unknowns_have_the_solution_of_a_full_matrix(
    begin: int, end: int
) -> None:
    rng, size, samples = np.random.default_rng(4), 14, 60
    basis, firsts = rng.uniform(0.1, 1.0, (samples, 6)), np.sort(rng.integers(0, size - 5, samples))
    weights, values, given = (
        rng.uniform(0.5, 2.0, samples),
        rng.normal(size=(samples, 3)),
        rng.normal(size=(size, 3)),
    )
    dense = np.zeros((samples, size))
    for row, first in enumerate(firsts):
        dense[row, first : first + 6] = basis[row]
    free = slice(begin, end)
    fixed = given.copy()
    fixed[free] = 0.0
    roots = np.sqrt(weights)[:, None]
    wanted = np.linalg.lstsq(roots * dense[:, free], roots * (values - dense @ fixed), rcond=None)[0]
    matrix, right = np.zeros((size, 6)), np.zeros((size, 3))
    normal_equations_kernel.add_samples(basis, firsts.astype(float), weights, matrix)
    normal_equations_kernel.add_values(basis, firsts.astype(float), weights, values, right, 0, 3)
    normal_equations_kernel.move_given(matrix, begin, end, size, right, given)
    normal_equations_kernel.factorize(matrix, begin, end)
    normal_equations_kernel.substitute(matrix, begin, end, right, 0, 3)
    assert np.abs(right[free] - wanted).max() < 1e-8
