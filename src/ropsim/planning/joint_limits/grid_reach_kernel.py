"""Cells in which caps count, in loops that numba compiles."""

from ropsim.codegen import Array1, Array2, kernel
from ropsim.planning.joint_limits.joint_imposed_kernel import JERK
from ropsim.spatial import Array

KIND, VALUE, TICK, JOINT, QUANTITY = range(5)
"""Rows of caps."""
NEIGHBOURS = 2
"""Number of neighbouring cells that are lowered with a cell: a slower motion arrives later at the following
cells."""
MOST_LONGER = 0.3
"""Share of a time with too much jerk by which it is taken to get longer, at most: without a bound short
motions that turn back last 0.3 % longer in the mean, with less a line often takes a step more."""


@kernel
def reach_of(
    imposed: Array2,
    count: int,
    parameters: Array2,
    borders: Array1,
    before: Array2,
    ticks: Array2,
    reach: Array2,
) -> None:
    """Write the first and the last cell in which each cap counts.

    A joint-imposed limit applies in the cells of its tick and in a few next to them. With less jerk along the
    path, the time in which the acceleration changes gets longer by as much, in front of it or behind it: a
    jerk limit at the first of successive ticks applies from that distance in front of it, and one at the last
    of them up to that distance behind it; and one tick further, since it may begin and end anywhere between
    two ticks.

    Args:
        imposed: in columns kind, value, number of the tick, joint, quantity; of shape (5, h or more).
        count: of them, h.
        parameters: from which and up to which caps of a tick count, of b ticks, rising, shape (2, b).
        borders: path parameters between which the cells lie, shape (c + 1,).
        before: present bounds of speed, acceleration and jerk, shape (3, c).
        ticks: work, shape (4, b).
        reach: where the cells go, shape (2, h or more).
    """
    most = borders.shape[0] - 2
    _cells_of_ticks(parameters, borders, ticks)
    _count_successive(parameters, ticks)
    for h in range(count):
        k = int(imposed[TICK, h])
        first, last = int(ticks[0, k]), int(ticks[1, k])
        if imposed[KIND, h] == JERK and imposed[QUANTITY, h] == JERK and max(ticks[2, k], ticks[3, k]) > 0.0:
            longer = min(max(before[JERK, (first + last) // 2] / imposed[VALUE, h] - 1.0, 0.0), MOST_LONGER)
            width = parameters[1, k] - parameters[0, k]
            if ticks[2, k] > 0.0:
                begin = parameters[0, k] - (1.0 + longer * ticks[2, k]) * width
                first = min(first, _cell_of(borders, begin, first))
            if ticks[3, k] > 0.0:
                end = parameters[1, k] + (1.0 + longer * ticks[3, k]) * width
                last = max(last, _cell_of(borders, end, last))
        reach[0, h], reach[1, h] = max(first, 0), min(last, most)


def _cells_of_ticks(parameters: Array, borders: Array, ticks: Array) -> None:
    """Write the cells of each tick and the neighbouring ones, in the first two rows."""
    most, last = borders.shape[0] - 2, 0
    for k in range(parameters.shape[1]):
        for end in range(2):
            last = _cell_of(borders, parameters[end, k], last)
            ticks[end, k] = min(max(last + (NEIGHBOURS if end else -NEIGHBOURS), 0), most)


def _count_successive(parameters: Array, ticks: Array) -> None:
    """Write how many ticks are successive: in the third row at the first of them, in the last at the last."""
    first, count = 0, parameters.shape[1]
    for k in range(count):
        ticks[2, k] = ticks[3, k] = 0.0
        if k == count - 1 or parameters[0, k + 1] != parameters[1, k]:
            ticks[2, first] = ticks[3, k] = k + 1 - first
            first = k + 1


def _cell_of(borders: Array, s: float, near: int) -> int:
    """Return the cell before the first border behind a path parameter, searched first near one.

    It is -1 in front of all cells, and their number behind them.
    """
    low, high = 0, borders.shape[0]
    if near > 0 and near < high and borders[near] <= s:
        low = near + 1
        if low < high and borders[low] > s:
            return near
    while low < high:
        middle = (low + high) // 2
        if borders[middle] <= s:
            low = middle + 1
        else:
            high = middle
    return low - 1
