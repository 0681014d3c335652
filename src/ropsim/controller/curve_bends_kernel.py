"""Bounds of the bends of a curve of polynomials, looked at closely where it counts; numba compiles it."""

from ropsim.codegen import kernel
from ropsim.controller.bends_kernel import SEEN, bounds_between, keep_units
from ropsim.motion import curve_points
from ropsim.spatial import Array

ROUNDS = 6
"""How often cells are halved at most."""
REACH = 2
"""So many cells on both sides have a say in the bounds of a cell."""


@kernel(
    "void(f8[:,::1], f8[::1], f8[:,::1], i8, f8[:,:,::1], f8[:,:,::1], f8[:,::1], f8[::1], f8[::1], f8[::1],"
    " f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,::1], f8[:,:,::1], f8[::1], f8[::1])"
)
def bends_along(
    series: Array,
    ends: Array,
    inverse: Array,
    steps: int,
    coefficients: Array,
    middles: Array,
    limits: Array,
    s: Array,
    between: Array,
    fresh: Array,
    matrices: Array,
    rows: Array,
    more: Array,
    parts: Array,
    room: Array,
    table: Array,
    speeds: Array,
    told: Array,
) -> None:
    """Write the bounds of `bends_of` in the cells of a curve.

    Args:
        series: as for `curve_points`, and so are ends, inverse, steps, coefficients and middles.
        ends: see there.
        inverse: see there.
        steps: see there.
        coefficients: see there.
        middles: see there.
        limits: of speed, acceleration and jerk of position and orientation, shape (3, 2).
        s: places from start to end, as many as `told` says at first, afterwards with those between, (m,).
        between: room to work in, shape (m,).
        fresh: room to work in, shape (m,).
        matrices: room to work in, shape (m, 4, 4).
        rows: room for both derivatives, shape (2, m, 6).
        more: room for those at new places, shape (2, m, 6).
        parts: the memory of `rows`, shape (2·m, 2, 3).
        room: to work in, shape (m, 7).
        table: where the bounds go, in its first cells, shape (10, m, 2).
        speeds: where the highest speeds go at which bends take no more than their share, shape (m,).
        told: number of the places; becomes that of all, 0 where there is no room for them; then the greatest
            sizes of first and second derivatives of a part, shape (3,); then room for two numbers.
    """
    m, n, units = s.shape[0], int(told[0]), told[3:5]
    curve_points(series, ends, inverse, steps, coefficients, middles, s[:n], matrices, rows[0], rows[1])
    units[0] = units[1] = 1.0
    keep_units(parts, 0, n, units)
    for i in range(n - 1):
        fresh[i] = 1.0
    for attempt in range(ROUNDS + 1):
        count = _loose(n - 1, s[:n], parts, limits, units, room, table, speeds, fresh, between)
        if count == 0 or attempt == ROUNDS:
            break
        if n + count > m:
            told[0] = 0.0
            return
        curve_points(
            series, ends, inverse, steps, coefficients, middles, between[:count], matrices, more[0], more[1]
        )
        n = _merged(s, between, rows, more, table, speeds, fresh, n, count)
        even = units[0] + units[1]
        keep_units(parts, 0, n, units)
        if units[0] + units[1] != even:
            for i in range(n - 1):
                fresh[i] = 1.0
    told[0] = n
    for order in range(2):
        told[1 + order] = 0.0
        for i in range(n):
            for part in range(2):
                square = 0.0
                for c in range(3 * part, 3 * part + 3):
                    square += rows[order, i, c] * rows[order, i, c]
                told[1 + order] = max(told[1 + order], square)
        told[1 + order] **= 0.5


def _loose(
    k: int,
    s: Array,
    parts: Array,
    limits: Array,
    units: Array,
    room: Array,
    table: Array,
    speeds: Array,
    fresh: Array,
    between: Array,
) -> int:
    """Write the bounds of k cells that are new or near to new ones, and the middles of those that are loose.

    Returns:
        the number of these.
    """
    m, count, begin = parts.shape[0] // 2, 0, 0
    d1, d2 = parts[: k + 1], parts[m : m + k + 1]
    while begin < k:
        end = begin
        while end < k and _is_near(fresh, end, k):
            end += 1
        if end > begin:
            bounds_between(begin, end - 1, s, d1, d2, limits, units, room, table, speeds, between)
        for i in range(begin, end):
            if between[i] != 0.0:
                between[count] = 0.5 * (s[i] + s[i + 1])
                count += 1
        begin = end + 1
    return count


def _is_near(fresh: Array, i: int, k: int) -> bool:
    """Return whether one of the k cells that have a say in the bounds of a cell is new."""
    number = 0.0
    for j in range(max(i - REACH, 0), min(i + REACH + 1, k)):
        number += fresh[j]
    return number > 0.0


def _merged(
    s: Array,
    between: Array,
    rows: Array,
    more: Array,
    table: Array,
    speeds: Array,
    fresh: Array,
    n: int,
    count: int,
) -> int:
    """Write new places and their derivatives between those that are there; return the number of all.

    Cells that are not halved go with their bounds to where they are now.
    """
    to, new, i = n + count - 1, count - 1, n - 1
    while new >= 0:
        is_halved = between[new] > s[i]
        if is_halved:
            s[to], fresh[to] = between[new], 1.0
            for order in range(2):
                for c in range(6):
                    rows[order, to, c] = more[order, new, c]
            to, new = to - 1, new - 1
        s[to], fresh[to], speeds[to] = s[i], 1.0 if is_halved else 0.0, speeds[i]
        for order in range(2):
            for c in range(6):
                rows[order, to, c] = rows[order, i, c]
        for row in range(SEEN):
            table[row, to, 0], table[row, to, 1] = table[row, i, 0], table[row, i, 1]
        to, i = to - 1, i - 1
    for cell in range(i + 1):  # those before the first halved one stay where they are
        fresh[cell] = 0.0
    return n + count
