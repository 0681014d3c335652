"""The spline of least jerk for a run: fitted within its tolerances, checked and fitted closer."""

import math
from functools import cache

import numpy as np

from ropsim.motion.compression.deviation_kernel import SAMPLE, STEPS, Checked, deviations
from ropsim.motion.compression.fit_kernel import Fit, FitWork, Samples, fit_closer, fit_smoother, fit_spline
from ropsim.motion.compression.quaternion_rows import between, rate_between
from ropsim.motion.compression.run import Polyline
from ropsim.motion.compression.spline_kernel import NODES, span_polynomials
from ropsim.spatial import Array, cross, frozen, record

_SAFE = 0.97
"""Of a tolerance: the bound that is fitted to."""
_EVERY = 8
"""Moves for each span at first."""
_TIMES = 6
"""How often bounds are lowered where the spline exceeds a tolerance between samples."""
_MARGIN, _LOWEST = 1.02, 1e-3
"""Factor by which they are lowered in addition, and the least share of a bound that is left at once."""


@record
class SplineFit:
    """A spline for a polyline, in the unit of length of the polyline from its first point on.

    Attributes:
        line: polyline.
        breaks: breakpoints, shape (spans + 1,).
        polynomials: of the spans over their shares: position, quaternion; shape (spans, 6, 7).
        deviation: greatest distance from the polyline [m].
        ratios: greatest deviations in position and orientation by their tolerances for each move, (n, 2).
    """

    line: Polyline
    breaks: Array
    polynomials: Array
    deviation: float
    ratios: Array


def spline_fit(line: Polyline) -> SplineFit:
    """Return the spline of least jerk within the tolerances of a polyline, or one that exceeds them."""
    points = np.hstack(((line.points - line.points[0]) / line.unit, line.quaternions))
    directions = np.diff(points[:, :3], axis=0) / np.diff(line.ends)[:, None]
    tolerances = line.position / line.unit
    samples = _samples(line, points, directions, tolerances)
    fit, work = _first_spline(line.ends), _work(samples)
    angles = _angles(directions)
    first = int(fit.state[0]) + 1
    fit_spline(samples, work, fit)
    found = _checked_fit(line, points, angles, tolerances, fit)
    for _ in range(_TIMES):
        if found.ratios.max() <= 1.0:
            break
        _lower(samples.bounds, found.ratios)
        fit_closer(samples, work, fit)
        found = _checked_fit(line, points, angles, tolerances, fit)
    if found.ratios.max() <= 1.0 and len(found.breaks) > first:
        fit_smoother(samples, work, fit)
        smoother = _checked_fit(line, points, angles, tolerances, fit)
        if smoother.ratios.max() <= 1.0:
            return smoother
    return found


def _samples(line: Polyline, points: Array, directions: Array, tolerances: Array) -> Samples:
    """Return the points and the middles between them, with bounds a little below the tolerances."""
    ends, moves = line.ends, len(line.ends) - 1
    parameters = np.empty(2 * moves + 1)
    parameters[::2], parameters[1::2] = ends, 0.5 * (ends[:-1] + ends[1:])
    values = np.empty((2 * moves + 1, 7))
    values[::2], values[1::2, :3] = points, 0.5 * (points[:-1, :3] + points[1:, :3])
    values[1::2, 3:] = between(points[:-1, 3:], points[1:, 3:], np.full(moves, 0.5))
    tangents = np.empty((2 * moves + 1, 3))
    sums = np.concatenate((directions[:1], directions[:-1] + directions[1:], directions[-1:]))
    tangents[::2] = sums / np.sqrt(np.einsum("ij,ij->i", sums, sums))[:, None]
    tangents[1::2] = directions
    bounds = np.empty((2 * moves + 1, 2))
    bounds[::2, 0], bounds[1::2, 0] = tolerances, np.minimum(tolerances[:-1], tolerances[1:])
    angles = np.concatenate((line.orientation[:1], line.orientation, line.orientation[-1:]))
    bounds[::2, 1], bounds[1::2, 1] = np.minimum(angles[:-1], angles[1:]), line.orientation
    gaps = np.diff(parameters)
    spacing = np.concatenate((gaps[:1], 0.5 * (gaps[:-1] + gaps[1:]), gaps[-1:]))
    given = np.array([float(line.run.before > 0.0), float(line.run.behind > 0.0)])
    fixed = _fixed(ends, points, directions)
    turns = int(line.turns)
    return Samples(
        ends, parameters, values, tangents, _SAFE * bounds, spacing, fixed, given, turns, _quadrature()
    )


def _fixed(ends: Array, points: Array, directions: Array) -> Array:
    """Return first and second derivatives of both ends that go on along a line, shape (4, 7)."""
    fixed = np.zeros((4, 7))
    fixed[0, :3], fixed[2, :3] = directions[0], directions[-1]
    for row, one, other, length in ((0, 0, 1, ends[1]), (2, -1, -2, ends[-2] - ends[-1])):
        rate = rate_between(points[one, 3:], points[other, 3:]) / length
        fixed[row, 3:], fixed[row + 1, 3:] = rate, -points[one, 3:] * (rate @ rate)
    return fixed


def _first_spline(ends: Array) -> Fit:
    """Return a spline without coefficients, with the first breakpoints, evenly by the number of moves."""
    moves = len(ends) - 1
    most, spans = _most_spans(moves), max(2, math.ceil(moves / _EVERY))
    breaks, state = np.zeros(most + 1), np.zeros(5)
    breaks[: spans + 1] = np.interp(np.arange(spans + 1) * (moves / spans), np.arange(moves + 1), ends)
    state[0] = spans
    return Fit(breaks, np.zeros((most + 5, 7)), state)


def _most_spans(moves: int) -> int:
    """Return a bound of the number of spans: at most two breakpoints lie within a move."""
    return 3 * moves + 4


def _work(samples: Samples) -> FitWork:
    """Return work buffers for a fit."""
    most, count = _most_spans(len(samples.ends) - 1), len(samples.parameters)
    return FitWork(
        np.zeros(most + 1),
        np.zeros((count, 6)),
        np.zeros(count),
        np.zeros((most, 6 * NODES)),
        np.zeros((most + 5, 6)),
        np.zeros((most + 5, 7)),
        np.zeros((most + 5, 7)),
        np.zeros((3, count)),
        np.zeros((3, count)),
        np.zeros((8, 7)),
    )


@cache
def _quadrature() -> Array:
    """Return points in [0, 1] and weights of the quadrature of Gauss and Legendre, shape (2, NODES)."""
    points, weights = np.polynomial.legendre.leggauss(NODES)
    return frozen(np.stack((0.5 * (points + 1.0), 0.5 * weights)))


def _angles(directions: Array) -> Array:
    """Return the angles between moves, 0 at both ends of the run, shape (n + 1,)."""
    product = cross(directions[:-1], directions[1:])
    sines = np.sqrt(np.einsum("ij,ij->i", product, product))
    turns = np.arctan2(sines, np.einsum("ij,ij->i", directions[:-1], directions[1:]))
    return np.concatenate(([0.0], turns, [0.0]))


def _checked_fit(line: Polyline, points: Array, angles: Array, tolerances: Array, fit: Fit) -> SplineFit:
    """Return a spline with its deviations from the polyline."""
    spans, turns = int(fit.state[0]), int(line.turns)
    polynomials, breaks = np.empty((spans, 6, 7)), fit.breaks[: spans + 1].copy()
    span_polynomials(breaks, spans, fit.coefficients, np.empty((7, 7)), polynomials)
    checked = Checked(breaks, polynomials, line.ends, points, angles, tolerances, turns)
    found = np.empty((len(line.ends), 3))
    deviations(checked, spans, np.empty((STEPS + 2, SAMPLE)), found)
    ratios = _ratios(found, tolerances, line.orientation)
    return SplineFit(line, breaks, polynomials, float(found[:-1, 0].max() * line.unit), ratios)


def _ratios(found: Array, tolerances: Array, angles: Array) -> Array:
    """Return the deviations in position and orientation by the tolerances for each move, shape (n, 2)."""
    at_points = found[:, 2] / tolerances
    moves = found[:-1, 0] / np.minimum(tolerances[:-1], tolerances[1:])
    position = np.maximum(moves, np.maximum(at_points[:-1], at_points[1:]))
    return np.stack((position, found[:-1, 1] / angles), axis=1)


def _lower(bounds: Array, ratios: Array) -> None:
    """Lower the bounds at the samples of moves that exceed their tolerances, and of those next to them."""
    factors = np.where(ratios > 1.0, np.minimum(_MARGIN * ratios, 1.0 / _LOWEST), 1.0)
    wider = factors.copy()
    wider[1:] = np.maximum(wider[1:], factors[:-1])
    wider[:-1] = np.maximum(wider[:-1], factors[1:])
    bounds[:-1] /= np.repeat(wider, 2, axis=0)
    bounds[-1] /= wider[-1]
