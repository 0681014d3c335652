"""Course of a rate without kinks below one that has them; windows that are wide where time is long."""

import numpy as np

from ropsim.spatial import Array

_WIDE, _NARROW = 2.0 / 3.0, 1.0 / 3.0
"""Half widths of the two windows that are averaged over, together 1: the kernel is a trapezoid."""


def window_places(places: Array, widths: Array) -> Array:
    """Return the coordinate σ in which all windows reach from -1 to +1: dσ/dφ = 1/width, shape (m,).

    Args:
        places: motion times φ [s], rising, shape (m,).
        widths: half width of the window at each place [s], above 0, shape (m,).
    """
    steps = np.diff(places) * (1.0 / widths[1:] + 1.0 / widths[:-1]) / 2.0
    return np.concatenate(([0.0], np.cumsum(steps)))


def rounded(sigma: Array, rates: Array) -> tuple[Array, Array]:
    """Return a smooth course of rates that is nowhere above the given one.

    The lowest rate within ±1 of σ is taken, then the mean over ±2/3, and of that over ±1/3. A mean over ±1
    of what is nowhere above the rates within ±1 is not above the rate, but for what the second mean loses
    between places, of second order in their distance. Where all rates within ±2 are 1, the
    result is 1 bit by bit.

    Args:
        sigma: places, see `window_places`, shape (m,).
        rates: at most 1, shape (m,).

    Returns:
        rates and their derivatives by σ, which have no jumps, each of shape (m,).
    """
    padded = np.concatenate(([-3.0], sigma, [sigma[-1] + 3.0]))  # beyond the ends the rate stays
    lack = greatest_nearby(padded, np.pad(1.0 - rates, 1, mode="edge"))
    lack, slope = _mean(padded, _mean(padded, lack, _WIDE)[0], _NARROW)
    return 1.0 - lack[1:-1], -slope[1:-1]


def greatest_nearby(sigma: Array, values: Array) -> Array:
    """Return the greatest value within ±1 of each place, the places next to that included, shape (…, m).

    Of each window the two longest runs of 2^k places that cover it are compared; those of all k are made by
    doubling.

    Args:
        sigma: rising, shape (m,).
        values: of one or more quantities, shape (…, m).
    """
    first = np.maximum(np.searchsorted(sigma, sigma - 1.0, "right") - 1, 0)
    last = np.minimum(np.searchsorted(sigma, sigma + 1.0, "left"), len(sigma) - 1)
    level = np.frexp(last - first + 1)[1] - 1
    result, runs = np.empty(values.shape), values
    for k in range(int(level.max()) + 1):
        here = np.flatnonzero(level == k)
        result[..., here] = np.maximum(runs[..., first[here]], runs[..., last[here] - 2**k + 1])
        runs = np.maximum(runs[..., : max(runs.shape[-1] - 2**k, 0)], runs[..., 2**k :])
    return result


def gently(places: Array, widths: Array, slope: float) -> Array:
    """Return the widths brought down to what changes by at most `slope` along the places, shape (m,)."""
    way = places * slope
    rising = np.minimum.accumulate(widths - way) + way
    return np.asarray(np.minimum.accumulate((rising + way)[::-1])[::-1] - way)


def _mean(sigma: Array, values: Array, half: float) -> tuple[Array, Array]:
    """Return the mean within ±half of each place of what is linear between places, and its slope by σ."""
    until = np.concatenate(([0.0], np.cumsum(np.diff(sigma) * (values[1:] + values[:-1]) / 2.0)))
    ends, areas = [], []
    for place in (sigma - half, sigma + half):
        k = np.clip(np.searchsorted(sigma, place, "right") - 1, 0, len(sigma) - 2)
        past = place - sigma[k]
        end = values[k] + past * (values[k + 1] - values[k]) / (sigma[k + 1] - sigma[k])
        ends.append(end)
        areas.append(until[k] + past * (values[k] + end) / 2.0)
    return (areas[1] - areas[0]) / (2.0 * half), (ends[1] - ends[0]) / (2.0 * half)
