"""Nominal time below given rates, rounded in windows, in loops that numba compiles."""

import math

from ropsim.codegen import Array1, Array2, kernel
from ropsim.motion.retiming.nominal_time_kernel import timed
from ropsim.spatial import Array

_WIDE, _NARROW = 2.0 / 3.0, 1.0 / 3.0
"""Half widths of the two windows that are averaged over, together 1: the kernel is a trapezoid."""
WORK = 8
"""Rows of work for smoothing, each two longer than there are grid points."""


@kernel
def greatest_nearby(sigma: Array1, values: Array1, queue: Array1, out: Array1) -> None:
    """Write the greatest value within ±1 of each grid point, the grid points next to that included.

    The window moves on from grid point to grid point; grid points in it whose values are less than one behind
    them can never be the greatest again and leave the queue.

    Args:
        sigma: rising, shape (m,).
        values: shape (m,).
        queue: work for indices of grid points, shape (m,) or longer.
        out: where the answers go, shape (m,).
    """
    last = sigma.shape[0] - 1
    head, tail, taken, first = 0, 0, 0, 0
    for k in range(last + 1):
        below, above = sigma[k] - 1.0, sigma[k] + 1.0
        while first < last and sigma[first + 1] <= below:
            first += 1
        while taken <= last and (taken == 0 or sigma[taken - 1] < above):
            while tail > head and values[int(queue[tail - 1])] <= values[taken]:
                tail -= 1
            queue[tail] = taken
            tail += 1
            taken += 1
        while head < tail - 1 and queue[head] < first:
            head += 1
        out[k] = values[int(queue[head])]


@kernel
def rounded(sigma: Array1, rates: Array1, work: Array2, smooth: Array1, slopes: Array1) -> None:
    """Write a smooth timing of rates that is nowhere above the given one.

    The lowest rate within ±1 of σ is taken, then the mean over ±2/3, and of that over ±1/3. A mean over ±1 of
    values nowhere above the rates within ±1 is not above the rate, except for the error of the second mean
    between grid points, of second order in their distance. Where all rates within ±2 are 1, the result is 1
    bit by bit.

    Args:
        sigma: positions in windows that reach from -1 to +1, rising, shape (m,).
        rates: at most 1, shape (m,).
        work: of shape (WORK, m + 2).
        smooth: becomes the rates, shape (m,).
        slopes: becomes their derivatives by σ, which have no jumps, shape (m,).
    """
    m = sigma.shape[0]
    padded, lack, queue, greatest, mean, slope = work[0], work[1], work[2], work[3], work[4], work[5]
    per, rise = work[6], work[7]
    for k in range(m):
        padded[k + 1] = sigma[k]
        lack[k + 1] = 1.0 - rates[k]
    padded[0], padded[m + 1] = -3.0, sigma[m - 1] + 3.0  # beyond the ends the rate stays
    lack[0], lack[m + 1] = lack[1], lack[m]
    for k in range(m + 1):
        per[k] = 1.0 / (padded[k + 1] - padded[k])
    greatest_nearby(padded, lack, queue, greatest)
    _average(padded, per, greatest, _WIDE, queue, rise, mean, slope)
    _average(padded, per, mean, _NARROW, queue, rise, lack, slope)
    for k in range(m):
        smooth[k] = 1.0 - lack[k + 1]
        slopes[k] = -slope[k + 1]


def _average(
    sigma: Array, per: Array, values: Array, half: float, until: Array, rise: Array, mean: Array, slope: Array
) -> None:
    """Write the mean within ±half of each grid point of a piecewise linear function, and its slope by σ.

    Args:
        sigma: rising, shape (k,).
        per: inverse of the intervals between the grid points, shape (k - 1,) or longer.
        values: shape (k,).
        half: half width of the window.
        until: work for the areas in front of the grid points, shape (k,).
        rise: work for the slopes behind the grid points, shape (k - 1,) or longer.
        mean: where the means go, shape (k,).
        slope: where the slopes go, shape (k,).
    """
    last = sigma.shape[0] - 1
    until[0] = 0.0
    for k in range(last):
        rise[k] = (values[k + 1] - values[k]) * per[k]
        until[k + 1] = until[k] + (sigma[k + 1] - sigma[k]) * (values[k + 1] + values[k]) / 2.0
    i, j, share = 0, 0, 1.0 / (2.0 * half)
    for k in range(last + 1):
        left, right = sigma[k] - half, sigma[k] + half
        while i < last - 1 and sigma[i + 1] <= left:
            i += 1
        while j < last - 1 and sigma[j + 1] <= right:
            j += 1
        past = left - sigma[i]
        begin = values[i] + past * rise[i]
        before = until[i] + past * (values[i] + begin) / 2.0
        past = right - sigma[j]
        end = values[j] + past * rise[j]
        behind = until[j] + past * (values[j] + end) / 2.0
        mean[k] = (behind - before) * share
        slope[k] = (end - begin) * share


LEAST_RATE = 1e-4
"""Least share of the planned speed; a path that requires less is infeasible."""
SLACK = 5e-10
"""Share by which bounds are planned wider, so that a plan that is on them is left unchanged."""
_FEWEST_CELLS = 5.0
"""Half width of the least window over the interval between grid points."""
_SLOPE = 0.6
"""Greatest change of the width along the motion, so that a window far off a dip does not reach it."""
_SWING = 0.5
"""Half width of a window over the time in which the jerk limit lets acceleration go from 0 to its limit."""
_ENDLESS = 1e100
_LEAST_SLOPE = 2.0**-52


@kernel
def smooth_timing(
    grid_phi: Array1,
    x: Array1,
    lasting: Array1,
    width: Array1,
    work: Array2,
    sigma: Array1,
    times: Array1,
    smooth: Array1,
    changes: Array1,
) -> None:
    """Write a timing of rates without kinks that is nowhere above the given one, and its times.

    Args:
        grid_phi: nominal times [s], rising, shape (m,).
        x: squares of rates; these are nowhere exceeded, except for the least rate that counts, shape (m,).
        lasting: real times that windows last at least [s], shape (m,).
        width: factor of the windows, shape (m,).
        work: of shape (2 + WORK, m + 2).
        sigma: becomes the positions in windows, in which these reach from -1 to +1: dσ/dφ = 1/width, shape
            (m,).
        times: becomes the real times [s], shape (m,).
        smooth: becomes the rates dφ/dt, shape (m,).
        changes: becomes the changes of these [1/s], shape (m,).
    """
    last = grid_phi.shape[0] - 1
    widths, counted = work[0], work[1, : last + 1]
    lowest = math.inf
    for i in range(last + 1):
        counted[i] = max(math.sqrt(x[i]), LEAST_RATE) if x[i] < 1.0 - SLACK else 1.0
        wide = max(lasting[i] * counted[i], _FEWEST_CELLS * _cell(grid_phi, i)) * width[i]
        lowest = min(lowest, wide - grid_phi[i] * _SLOPE)
        widths[i] = lowest + grid_phi[i] * _SLOPE
    lowest = math.inf
    for i in range(last, -1, -1):
        lowest = min(lowest, widths[i] + grid_phi[i] * _SLOPE)
        widths[i] = max(lowest - grid_phi[i] * _SLOPE, _cell(grid_phi, i))
    for i in range(last + 1):
        widths[i] = 1.0 / widths[i]
    sigma[0] = 0.0
    for i in range(last):
        windows = (grid_phi[i + 1] - grid_phi[i]) * (widths[i + 1] + widths[i]) / 2.0
        sigma[i + 1] = sigma[i] + windows
    rounded(sigma, counted, work[2:], smooth, changes)
    for i in range(last + 1):
        changes[i] = smooth[i] * changes[i] * widths[i]
    timed(grid_phi, smooth, changes, times)


def _cell(grid_phi: Array, i: int) -> float:
    """Return the longer one of the intervals next to a grid point."""
    last = grid_phi.shape[0] - 1
    before = grid_phi[i] - grid_phi[i - 1] if i > 0 else 0.0
    return max(grid_phi[i + 1] - grid_phi[i], before) if i < last else before


@kernel
def windows_last(
    first: Array2, most: Array2, jerk: Array2, by_speed: float, longest: float, lasting: Array1
) -> None:
    """Write how long windows last, so that jerk limits let accelerations swing in them.

    Args:
        first: first derivatives of joints and path parameters by nominal time, shape (m, n + r).
        most: bounds of their accelerations, shape (m, n + r), or (1, n + r) for the same at all grid points.
        jerk: bounds of their jerks.
        by_speed: longest time for the sake of the limits of speed [s].
        longest: bound of the result [s].
        lasting: becomes the times [s], shape (m,).
    """
    same = most.shape[0] == 1
    for i in range(first.shape[0]):
        here = 0 if same else i
        along, swing = _ENDLESS, 0.0
        for j in range(first.shape[1]):
            slope = abs(first[i, j]) + _LEAST_SLOPE
            along = min(along, most[here, j] / slope)
            swing = max(swing, slope / jerk[here, j])
        lasting[i] = _SWING * min(along * swing, by_speed, longest)
