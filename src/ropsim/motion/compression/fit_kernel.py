"""A smooth spline within bounds at samples: weights of samples, breakpoints where bounds require them.

The spline minimises the integral of the squared third derivative plus the weighted squares of its distances
from the samples. A bound that is exceeded pulls harder in the next fit (Lawson 1961, iteratively reweighted
least squares); where no weights keep a bound the span is halved.
"""

from math import asin, inf, sqrt
from typing import NamedTuple

from ropsim.codegen import Array1, Array2, kernel
from ropsim.motion.compression.normal_equations_kernel import (
    add_samples,
    add_values,
    factorize,
    move_given,
    substitute,
)
from ropsim.motion.compression.spline_kernel import (
    add_energy,
    basis_rows,
    energy,
    knot,
    span_at,
    third_derivative_rows,
)
from ropsim.spatial import Array

ROUNDS, FITS, MOST_FITS, SMOOTHER_FITS = 7, 6, 30, 14
"""Rounds in which breakpoints are added, fits in each of them and at last, and fits to become smoother."""
LEAST_CHANGE, MOST_CHANGE = 0.4, 3.0
"""Bounds of a deviation by its bound, where it changes a weight."""
LEAST_WEIGHT, MOST_WEIGHT = 1e-4, 1e7
"""Bounds of a weight by the first one."""
FIRST_WAVE = 2.0943951023931953
"""2π / 3: the first weights let waves of three spans pass."""
FARTHEST_SAMPLE = 12.0
"""Distances between samples that a span counts as in the first weights, at most."""
SPLIT = 0.6
"""Least length of a span within a move, by that of the move, that is halved."""
AT_BREAK = 1e-9
"""Share of a span; samples nearer to a breakpoint lie at it."""
POSITION, TURN = 0, 3
"""First columns of the values of position and orientation."""


class Samples(NamedTuple):
    """Points of a polyline for the fit; lengths in any unit.

    Attributes:
        ends: path parameters of the points between moves, rising from 0, shape (n + 1,).
        parameters: of the samples, rising, shape (m,).
        values: positions and unit quaternions, shape (m, 7).
        tangents: unit vectors; only the distance across them counts, shape (m, 3).
        bounds: of the distances and of the angles [rad], shape (m, 2).
        spacing: half the distance of the samples before and behind, shape (m,).
        fixed: at the begin, then at the end: first and second derivative, shape (4, 7).
        given: whether derivatives are given at the begin, whether at the end, shape (2,).
        turns: 1 where the orientation changes, 0 where it is the same everywhere.
        rule: quadrature of `third_derivative_rows`.
    """

    ends: Array1
    parameters: Array1
    values: Array2
    tangents: Array2
    bounds: Array2
    spacing: Array1
    fixed: Array2
    given: Array1
    turns: int
    rule: Array2


class FitWork(NamedTuple):
    """Work buffers for a spline of at most `most` spans.

    Attributes:
        others: breakpoints, shape (most + 1,).
        basis: shape (m, 6).
        spans: shape (m,).
        thirds: shape (most, 18).
        matrix: shape (most + 5, 6).
        trial: coefficients, shape (most + 5, 7).
        right: right sides, shape (most + 5, 7).
        weights: of position and orientation, and the first ones, shape (3, m).
        ratios: deviations by their bounds: of a trial, of the best in position and in orientation, (3, m).
        small: shape (8, 7).
    """

    others: Array1
    basis: Array2
    spans: Array1
    thirds: Array2
    matrix: Array2
    trial: Array2
    right: Array2
    weights: Array2
    ratios: Array2
    small: Array2


class Fit(NamedTuple):
    """A spline.

    Attributes:
        breaks: breakpoints, shape (most + 1,).
        coefficients: shape (most + 5, 7).
        state: number of spans; then whether position and orientation exceed a bound at a sample, 1 or 0, and
            by which ratio, or with which energy: shape (5,).
    """

    breaks: Array1
    coefficients: Array2
    state: Array1


@kernel
def fit_spline(samples: Samples, work: FitWork, fit: Fit) -> None:
    """Write a spline that keeps the bounds at the samples, or the one that exceeds them least.

    It is the first one that keeps them, so that wide bounds do not change the shape of a smooth polyline.

    Args:
        samples: of the polyline, and the bounds.
        work: buffers.
        fit: has the first breakpoints and their number, becomes the spline.
    """
    _prepare(samples, work, fit)
    _fit_until_it_holds(samples, work, fit, FITS)
    _add_breaks(samples, work, fit)


@kernel
def fit_closer(samples: Samples, work: FitWork, fit: Fit) -> None:
    """Fit the spline to bounds that have been lowered, from the weights and breakpoints that it has on."""
    _forget(fit)
    _fit_until_it_holds(samples, work, fit, FITS)
    _add_breaks(samples, work, fit)


@kernel
def fit_smoother(samples: Samples, work: FitWork, fit: Fit) -> None:
    """Write the smoothest one of several splines that keep the bounds, or keep the one that there is."""
    for _ in range(SMOOTHER_FITS):
        _fit_once(samples, work, fit, 0)
        if samples.turns:
            _fit_once(samples, work, fit, 1)


def _add_breaks(samples: Samples, work: FitWork, fit: Fit) -> None:
    """Halve spans in which bounds are exceeded until a fit keeps them all."""
    for _ in range(ROUNDS):
        if _holds(samples, fit) or not _halve_spans(samples, work, fit):
            break
        _prepare(samples, work, fit)
        _fit_until_it_holds(samples, work, fit, FITS)
    _fit_until_it_holds(samples, work, fit, MOST_FITS)


def _holds(samples: Samples, fit: Fit) -> bool:
    return fit.state[1] == 0.0 and (samples.turns == 0 or fit.state[3] == 0.0)


def _forget(fit: Fit) -> None:
    fit.state[1] = fit.state[3] = 1.0
    fit.state[2] = fit.state[4] = inf


def _prepare(samples: Samples, work: FitWork, fit: Fit) -> None:
    """Write basis functions, energy and first weights for the present breakpoints."""
    breaks, spans, parameters, spacing = fit.breaks, int(fit.state[0]), samples.parameters, samples.spacing
    basis_rows(breaks, spans, parameters, work.basis, work.spans)
    third_derivative_rows(breaks, spans, samples.rule, work.small, work.thirds)
    for i in range(parameters.shape[0]):
        span, before = int(work.spans[i]), _span_before(samples, work, fit, i)
        length = min(breaks[span + 1] - breaks[span], breaks[before + 1] - breaks[before])
        wave = min(length, FARTHEST_SAMPLE * spacing[i])
        square = FIRST_WAVE * FIRST_WAVE / (wave * wave)
        weight = square * square * square * spacing[i]
        work.weights[0, i] = work.weights[1, i] = work.weights[2, i] = weight
    _forget(fit)


def _span_before(samples: Samples, work: FitWork, fit: Fit, i: int) -> int:
    """Return the span in front of a sample: for one at a breakpoint that before, else its own."""
    span = int(work.spans[i])
    small = AT_BREAK * (fit.breaks[span + 1] - fit.breaks[span])
    return span - 1 if span > 0 and samples.parameters[i] <= fit.breaks[span] + small else span


def _fit_until_it_holds(samples: Samples, work: FitWork, fit: Fit, fits: int) -> None:
    """Fit position and orientation each until it keeps its bounds, at most this number of times."""
    for _ in range(fits):
        if fit.state[1] > 0.0:
            _fit_once(samples, work, fit, 0)
        if samples.turns and fit.state[3] > 0.0:
            _fit_once(samples, work, fit, 1)


def _fit_once(samples: Samples, work: FitWork, fit: Fit, channel: int) -> None:
    """Fit position (channel 0) or orientation (1), keep it if it is the best one, and adapt its weights."""
    spans, trial, weights = int(fit.state[0]), work.trial, work.weights[channel]
    column, count = (POSITION, 3) if channel == 0 else (TURN, 4)
    _solve(samples, work, fit, channel, column, count)
    if channel == 0:
        _distance_ratios(samples, work)
    else:
        _angle_ratios(samples, work)
    ratios, first = work.ratios[0], work.weights[2]
    worst = 0.0
    for i in range(ratios.shape[0]):
        worst = max(worst, ratios[i])
        change = min(max(ratios[i], LEAST_CHANGE), MOST_CHANGE)
        weight = weights[i] * (change * sqrt(change))
        weights[i] = min(max(weight, LEAST_WEIGHT * first[i]), MOST_WEIGHT * first[i])
    exceeds = 1.0 if worst > 1.0 else 0.0
    mark = worst if worst > 1.0 else energy(work.thirds, spans, trial, column, count)
    best, mark_of_best = fit.state[1 + 2 * channel], fit.state[2 + 2 * channel]
    if exceeds < best or (exceeds == best and mark < mark_of_best):
        fit.state[1 + 2 * channel], fit.state[2 + 2 * channel] = exceeds, mark
        for i in range(spans + 5):
            for j in range(column, column + count):
                fit.coefficients[i, j] = trial[i, j]
        for i in range(ratios.shape[0]):
            work.ratios[1 + channel, i] = ratios[i]


def _solve(samples: Samples, work: FitWork, fit: Fit, channel: int, column: int, count: int) -> None:
    """Write the coefficients of the spline of least energy and weighted squares."""
    spans = int(fit.state[0])
    size, matrix, right, trial = spans + 5, work.matrix, work.right, work.trial
    for i in range(size):
        for k in range(6):
            matrix[i, k] = 0.0
        for j in range(column, column + count):
            right[i, j] = 0.0
    add_energy(work.thirds, spans, matrix)
    add_samples(work.basis, work.spans, work.weights[channel], matrix)
    add_values(work.basis, work.spans, work.weights[channel], samples.values, right, column, count)
    begin, end = _write_ends(samples, fit, trial, column, count)
    move_given(matrix, begin, end, size, right, trial)
    factorize(matrix, begin, end)
    substitute(matrix, begin, end, right, column, count)
    for i in range(begin, end):
        for j in range(column, column + count):
            trial[i, j] = right[i, j]


def _write_ends(samples: Samples, fit: Fit, trial: Array, column: int, count: int) -> tuple[int, int]:
    """Write the coefficients that the values and derivatives at both ends decide; return the free ones."""
    breaks, spans, last = fit.breaks, int(fit.state[0]), samples.values.shape[0] - 1
    end = spans + 4
    one, two = breaks[1] - breaks[0], knot(breaks, spans, 7) - breaks[0]
    before, near = breaks[spans] - breaks[spans - 1], breaks[spans] - knot(breaks, spans, spans + 3)
    for j in range(column, column + count):
        trial[0, j], trial[end, j] = samples.values[0, j], samples.values[last, j]
        if samples.given[0] > 0.0:
            v, a = samples.fixed[0, j], samples.fixed[1, j]
            trial[1, j] = trial[0, j] + v * one / 5.0
            trial[2, j] = trial[1, j] + (v + a * one / 4.0) * two / 5.0
        if samples.given[1] > 0.0:
            v, a = samples.fixed[2, j], samples.fixed[3, j]
            trial[end - 1, j] = trial[end, j] - v * before / 5.0
            trial[end - 2, j] = trial[end - 1, j] - (v - a * before / 4.0) * near / 5.0
    return (3 if samples.given[0] > 0.0 else 1), (spans + 2 if samples.given[1] > 0.0 else spans + 4)


def _distance_ratios(samples: Samples, work: FitWork) -> None:
    """Write the distances of the trial from the samples across the polyline, by their bounds."""
    basis, values, tangents = work.basis, samples.values, samples.tangents
    for i in range(basis.shape[0]):
        first, square, along = int(work.spans[i]), 0.0, 0.0
        for j in range(3):
            value = -values[i, j]
            for p in range(6):
                value += basis[i, p] * work.trial[first + p, j]
            square += value * value
            along += value * tangents[i, j]
        work.ratios[0, i] = sqrt(max(square - along * along, 0.0)) / samples.bounds[i, 0]


def _angle_ratios(samples: Samples, work: FitWork) -> None:
    """Write the angles between the trial and the samples, by their bounds."""
    basis, values, q = work.basis, samples.values, work.small[0]
    for i in range(basis.shape[0]):
        first, square, difference = int(work.spans[i]), 0.0, 0.0
        for j in range(4):
            q[j] = 0.0
            for p in range(6):
                q[j] += basis[i, p] * work.trial[first + p, TURN + j]
            square += q[j] * q[j]
        for j in range(4):
            apart = q[j] / sqrt(square) - values[i, TURN + j]
            difference += apart * apart
        work.ratios[0, i] = 4.0 * asin(min(0.5 * sqrt(difference), 1.0)) / samples.bounds[i, 1]


def _halve_spans(samples: Samples, work: FitWork, fit: Fit) -> bool:
    """Add a breakpoint to each span with a sample beyond a bound, where it has room for one."""
    breaks, others, spans, ends = fit.breaks, work.others, int(fit.state[0]), samples.ends
    worst = work.right  # free between two fits
    for span in range(spans):
        worst[span, 0] = 0.0
    for i in range(samples.parameters.shape[0]):
        span, before = int(work.spans[i]), _span_before(samples, work, fit, i)
        ratio = max(work.ratios[1, i], work.ratios[2, i]) if samples.turns else work.ratios[1, i]
        worst[span, 0] = max(worst[span, 0], ratio)
        worst[before, 0] = max(worst[before, 0], ratio)
    count, low = 0, 0
    for span in range(spans):
        others[count] = breaks[span]
        count += 1
        if worst[span, 0] <= 1.0:
            continue
        small = AT_BREAK * (breaks[span + 1] - breaks[span])
        low = span_at(ends, ends.shape[0] - 1, breaks[span] + small, low)
        high = span_at(ends, ends.shape[0] - 1, breaks[span + 1] - small, low)
        if high > low:  # points low + 1 to high lie within
            middle = (low + 1 + high) // 2
            even = (low + 1 + high) % 2 == 0
            others[count] = ends[middle] if even else 0.5 * (ends[middle] + ends[middle + 1])
            count += 1
        elif breaks[span + 1] - breaks[span] > SPLIT * (ends[low + 1] - ends[low]):
            others[count] = 0.5 * (breaks[span] + breaks[span + 1])
            count += 1
    others[count] = breaks[spans]
    for i in range(count + 1):
        breaks[i] = others[i]
    fit.state[0] = count
    return count > spans
