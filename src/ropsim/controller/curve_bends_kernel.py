"""Bounds of the bends of a curve of polynomials, looked at closely where it counts; numba compiles it."""

from ropsim.codegen import kernel
from ropsim.controller.bends_kernel import bounds_of
from ropsim.motion import curve_points
from ropsim.spatial import Array

ROUNDS = 6
"""How often cells are halved at most."""


@kernel(
    "void(f8[:,::1], f8[::1], f8[:,::1], i8, f8[:,:,::1], f8[:,:,::1], f8[:,::1], f8[::1], f8[::1],"
    " f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[:,:,::1], f8[::1])"
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
    matrices: Array,
    rows: Array,
    more: Array,
    parts: Array,
    table: Array,
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
        matrices: room to work in, shape (m, 4, 4).
        rows: room for both derivatives, shape (2, m, 6).
        more: room for those at new places, shape (2, m, 6).
        parts: the memory of `rows`, shape (2·m, 2, 3).
        table: where the bounds go, in its first cells, shape (10, m, 2).
        told: number of the places; becomes that of all, 0 where there is no room for them; then the greatest
            sizes of first and second derivatives of a part, shape (3,).
    """
    m, n = s.shape[0], int(told[0])
    curve_points(series, ends, inverse, steps, coefficients, middles, s[:n], matrices, rows[0], rows[1])
    for attempt in range(ROUNDS + 1):
        k = n - 1
        bounds_of(s[:n], parts[:n], parts[m : m + n], limits, table[:, :k], between)
        count = 0
        for i in range(k):
            if between[i] != 0.0:
                between[count] = 0.5 * (s[i] + s[i + 1])
                count += 1
        if count == 0 or attempt == ROUNDS:
            break
        if n + count > m:
            told[0] = 0.0
            return
        curve_points(
            series, ends, inverse, steps, coefficients, middles, between[:count], matrices, more[0], more[1]
        )
        n = _merged(s, between, rows, more, n, count)
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


def _merged(s: Array, between: Array, rows: Array, more: Array, n: int, count: int) -> int:
    """Write new places and their derivatives between those that are there; return the number of all."""
    to, new = n + count - 1, count - 1
    for i in range(n - 1, -1, -1):
        while new >= 0 and between[new] > s[i]:
            s[to] = between[new]
            for order in range(2):
                for c in range(6):
                    rows[order, to, c] = more[order, new, c]
            to, new = to - 1, new - 1
        s[to] = s[i]
        for order in range(2):
            for c in range(6):
                rows[order, to, c] = rows[order, i, c]
        to -= 1
    return n + count
