"""Motion time below given rates, in loops that numba compiles; see `course`."""

import math

from ropsim.codegen import Array1, Array2, kernel
from ropsim.motion.limits.motion_time_kernel import timed
from ropsim.motion.limits.rounding_kernel import rounded
from ropsim.spatial import Array

LEAST_RATE = 1e-4
"""A path that must be gone slower than by this share of its plan cannot be gone."""
SLACK = 5e-10
"""Share by which bounds are planned wider, so that a plan that is on them is left as it is."""
_FEWEST_CELLS = 5.0
"""Half width of the least window over the way between places."""
_SLOPE = 0.6
"""Greatest change of the width along the motion, so that a window far off a dip does not reach it."""
_SWING = 0.5
"""Half width of a window over the time in which the jerk limit lets acceleration go from 0 to its limit."""
_ENDLESS = 1e100
_LEAST_WAY = 2.0**-52


@kernel
def smooth_course(
    places: Array1,
    x: Array1,
    lasting: Array1,
    width: Array1,
    work: Array2,
    sigma: Array1,
    times: Array1,
    smooth: Array1,
    changes: Array1,
) -> None:
    """Write a course of rates without kinks that is nowhere above the given one, and its times.

    Args:
        places: motion times [s], rising, shape (m,).
        x: squares of rates; these are nowhere exceeded, but for the least rate that counts, shape (m,).
        lasting: real times that windows last at least [s], shape (m,).
        width: factor of the windows, shape (m,).
        work: room, shape (2 + WORK, m + 2).
        sigma: becomes the places in windows, in which these reach from -1 to +1: dσ/dφ = 1/width, shape (m,).
        times: becomes the real times [s], shape (m,).
        smooth: becomes the rates dφ/dt, shape (m,).
        changes: becomes the changes of these [1/s], shape (m,).
    """
    last = places.shape[0] - 1
    widths, counted = work[0], work[1, : last + 1]
    lowest = math.inf
    for i in range(last + 1):
        counted[i] = max(math.sqrt(x[i]), LEAST_RATE) if x[i] < 1.0 - SLACK else 1.0
        wide = max(lasting[i] * counted[i], _FEWEST_CELLS * _cell(places, i)) * width[i]
        lowest = min(lowest, wide - places[i] * _SLOPE)
        widths[i] = lowest + places[i] * _SLOPE
    lowest = math.inf
    for i in range(last, -1, -1):
        lowest = min(lowest, widths[i] + places[i] * _SLOPE)
        widths[i] = max(lowest - places[i] * _SLOPE, _cell(places, i))
    for i in range(last + 1):
        widths[i] = 1.0 / widths[i]
    sigma[0] = 0.0
    for i in range(last):
        windows = (places[i + 1] - places[i]) * (widths[i + 1] + widths[i]) / 2.0
        sigma[i + 1] = sigma[i] + windows
    rounded(sigma, counted, work[2:], smooth, changes)
    for i in range(last + 1):
        changes[i] = smooth[i] * changes[i] * widths[i]
    timed(places, smooth, changes, times)


def _cell(places: Array, i: int) -> float:
    """Return the longer one of the ways beside a place."""
    last = places.shape[0] - 1
    before = places[i] - places[i - 1] if i > 0 else 0.0
    return max(places[i + 1] - places[i], before) if i < last else before


@kernel
def windows_last(
    first: Array2, most: Array2, jerk: Array2, by_speed: float, longest: float, lasting: Array1
) -> None:
    """Write how long windows last, so that jerk limits let accelerations swing in them.

    Args:
        first: first derivatives of joints and places on paths by motion time, shape (m, n + r).
        most: bounds of their accelerations, shape (m, n + r), or (1, n + r) for the same at all places.
        jerk: bounds of their jerks likewise.
        by_speed: longest time for the sake of the limits of speed [s].
        longest: bound of the result [s].
        lasting: becomes the times [s], shape (m,).
    """
    same = most.shape[0] == 1
    for i in range(first.shape[0]):
        here = 0 if same else i
        along, swing = _ENDLESS, 0.0
        for j in range(first.shape[1]):
            way = abs(first[i, j]) + _LEAST_WAY
            along = min(along, most[here, j] / way)
            swing = max(swing, way / jerk[here, j])
        lasting[i] = _SWING * min(along * swing, by_speed, longest)
