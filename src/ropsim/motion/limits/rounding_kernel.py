"""Rounding of a course in windows, in loops that numba compiles; see `rounded`."""

from ropsim.codegen import Array1, Array2, kernel
from ropsim.spatial import Array

_WIDE, _NARROW = 2.0 / 3.0, 1.0 / 3.0
"""Half widths of the two windows that are averaged over, together 1: the kernel is a trapezoid."""
WORK = 8
"""Rows of room that rounding needs, each two longer than there are places."""


@kernel
def greatest_nearby(sigma: Array1, values: Array1, queue: Array1, out: Array1) -> None:
    """Write the greatest value within ±1 of each place, the places next to that included.

    The window moves on from place to place; places in it whose values are less than one behind them can
    never be the greatest again and leave the queue.

    Args:
        sigma: rising, shape (m,).
        values: shape (m,).
        queue: room for indices of places, shape (m,) or longer.
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
    """Write a smooth course of rates that is nowhere above the given one.

    The lowest rate within ±1 of σ is taken, then the mean over ±2/3, and of that over ±1/3. A mean over ±1
    of what is nowhere above the rates within ±1 is not above the rate, but for what the second mean loses
    between places, of second order in their distance. Where all rates within ±2 are 1, the result is 1 bit
    by bit.

    Args:
        sigma: places in windows that reach from -1 to +1, rising, shape (m,).
        rates: at most 1, shape (m,).
        work: room, shape (WORK, m + 2).
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
    """Write the mean within ±half of each place of what is linear between places, and its slope by σ.

    Args:
        sigma: rising, shape (k,).
        per: inverse of the ways between the places, shape (k - 1,) or longer.
        values: shape (k,).
        half: half width of the window.
        until: room for the areas in front of the places, shape (k,).
        rise: room for the slopes behind the places, shape (k - 1,) or longer.
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
