"""The fastest motion along a path under limits linear in squared speed, in loops that numba compiles."""

from typing import NamedTuple

from ropsim.codegen import Array1, Array2, kernel
from ropsim.spatial import Array


class LinearRows(NamedTuple):
    """Limits of acceleration u and squared speed x at m points: lower <= A·u + B·x <= upper.

    Attributes:
        A: shape (m, r).
        B: shape (m, r).
        lower: at most 0, shape (m, r).
        upper: at least 0, shape (m, r).
    """

    A: Array2
    B: Array2
    lower: Array2
    upper: Array2


@kernel
def bound(
    most: Array2,
    share: Array1,
    imposed: Array1,
    wider: float,
    before: Array2,
    lower: Array2,
    upper: Array2,
    same: Array1,
) -> None:
    """Write the bounds of the first rows of `fastest`, and where they are those of the call before.

    Args:
        most: greatest sizes of rows, shape (m, n), or (1, n) for the same at all grid points.
        share: what is used of them, shape (m,).
        imposed: bounds of x, shape (m,).
        wider: factor of the bounds.
        before: share and caps of the call before; become those of this one, shape (2, m).
        lower: its first n columns become minus the bounds, shape (m, r).
        upper: its first n columns become the bounds, shape (m, r).
        same: becomes 1 where all is as in the call before, 0 elsewhere, shape (m,).
    """
    constant = most.shape[0] == 1
    for i in range(share.shape[0]):
        here, is_same = 0 if constant else i, share[i] == before[0, i]
        same[i] = 1.0 if is_same and imposed[i] == before[1, i] else 0.0
        before[0, i], before[1, i] = share[i], imposed[i]
        for r in range(0 if is_same else most.shape[1]):
            upper[i, r] = most[here, r] * share[i] * wider
            lower[i, r] = -upper[i, r]


NOTHING = 1e-12
"""Where the acceleration changes a row by less than this share of its range, it is no part of the row."""
MOST_FALL = 0.75
"""Share of x by which it may fall from one grid point to the next, unless it must be 0 there.

Where a torque row changes its side at once, such as where a joint turns back against dry friction, the
fastest path up to there would come to rest behind it.
"""
MOST_STEPS = 60
"""Newton steps at one grid point; each passes a blend of a convex polygon, so that a handful is the rule."""


@kernel
def fastest(
    rows: LinearRows,
    imposed: Array1,
    steps: Array1,
    same: Array1,
    free: Array1,
    back: Array1,
    x: Array1,
) -> None:
    """Compute the greatest squared speeds x = (ds/dt)² along a path.

    Between grid points i and i+1 the acceleration u = d²s/dt² is constant, x[i+1] = x[i] + 2·steps[i]·u, and
    each row r holds at both ends of the interval with that u:

        lower[i, r] <= A[i, r]·u + B[i, r]·x[i] <= upper[i, r]
        lower[i+1, r] <= A[i+1, r]·u + B[i+1, r]·x[i+1] <= upper[i+1, r]

    Backwards, the greatest x from which the rest can be gone; then forwards, the greatest acceleration that
    stays below it. Standing still satisfies all rows, so a grid point never has a least speed. The greatest x
    of a grid point is the root of a convex function, linear in path segments, so Newton's method from above
    finds it exactly.

    Args:
        rows: the limits.
        imposed: bounds of x, at least 0, shape (m,).
        steps: intervals from grid point to grid point, above 0, shape (m - 1,).
        same: above 0 where rows and cap of a grid point are those of the call before, whose answers in
            `free`, `back` and `x` then hold where no neighbour changed; becomes 0 where `back` changed,
            (m,).
        free: the x from which no row keeps the next one from being reached, then the greatest cap, (m,).
        back: the greatest x from which the rest can be gone, shape (m,).
        x: the squared speeds afterwards, shape (m,).

    References:
        Bobrow, Dubowsky and Gibson 1985, Time-optimal control of robotic manipulators along specified paths.
        Pham and Pham 2018, A new approach to time-optimal path parameterization based on reachability
        analysis; rows at both ends of the interval are its interpolation scheme.
    """
    last = imposed.shape[0] - 1
    greatest = 0.0
    for i in range(last + 1):
        greatest = max(greatest, imposed[i])
    if greatest != free[last]:
        same[:] = 0.0
    free[last] = greatest
    unchanged = same[last] > 0.0
    if not unchanged:
        back[last] = imposed[last]
    for i in range(last - 1, -1, -1):
        unchanged_there, unchanged = unchanged, same[i] > 0.0
        if unchanged_there and unchanged:
            continue
        before = back[i]
        back[i] = _backwards(rows, i, steps[i], imposed[i], back[i + 1], greatest, free)
        if back[i] != before:
            same[i] = 0.0
            unchanged = False
    unchanged = same[0] > 0.0
    x[0] = back[0]
    for i in range(last):
        if unchanged and same[i] > 0.0 and same[i + 1] > 0.0:
            continue
        most, fall = back[i + 1] / (2.0 * steps[i]), -1.0 / (2.0 * steps[i])
        if x[i] != free[i]:
            reach = greatest / (2.0 * steps[i])
            most, fall, _ = _binding(rows, i, steps[i], x[i], 1.0, most, fall, reach)
        before = x[i + 1]
        x[i + 1] = min(back[i + 1], max(x[i] + 2.0 * steps[i] * (most + fall * x[i]), 0.0))
        unchanged = x[i + 1] == before


def _backwards(
    rows: LinearRows, i: int, step: float, cap: float, goal: float, greatest: float, free: Array
) -> float:
    """Return the greatest x of a grid point with `goal` at the next one, and note if that is free."""
    free[i] = -1.0
    share = MOST_FALL if goal > 0.0 else 1.0
    twice, value = 2.0 * step, cap
    reach = greatest / twice  # no acceleration is greater
    if _is_free(rows, i, step, value, goal / twice - value / twice, -share * value / twice):
        free[i] = value
        return value
    for _ in range(MOST_STEPS):
        least, rise, _ = _binding(rows, i, step, value, -1.0, 0.0, share / twice, reach)
        most, fall, cap = _binding(rows, i, step, value, 1.0, goal / twice, -1.0 / twice, reach)
        least, rise = -least, -rise
        new = min(value, cap)
        if least + rise * value > most + fall * value and rise > fall:
            new = min(new, (most - least) / (rise - fall))
        new = max(new, 0.0)
        if not new < value * (1.0 - 1e-15):
            if most == goal / twice and fall == -1.0 / twice:
                free[i] = value
            break
        value = new
    return value


def _is_free(rows: LinearRows, i: int, step: float, x: float, u: float, least: float) -> bool:
    """Return whether an acceleration from x holds all rows, and falls by no more than it may."""
    if not u >= least:
        return False
    A, B, lower, upper = rows
    for end in range(2):
        for r in range(A.shape[1]):
            b = B[i + end, r]
            value = (A[i + end, r] + 2.0 * step * end * b) * u + b * x
            if not lower[i + end, r] <= value <= upper[i + end, r]:
                return False
    return True


def _binding(
    rows: LinearRows, i: int, step: float, x: float, sign: float, line: float, slope: float, reach: float
) -> tuple[float, float, float]:
    """Return the line by x that binds acceleration times sign from above at x, and a bound of x.

    Only a row that the acceleration so far does not keep becomes a line of its own: few of them do, and the
    others cost no division.

    Args:
        rows: the limits.
        i: number of the point.
        step: interval to the next one.
        x: squared speed.
        sign: 1 for the greatest acceleration, -1 for minus the least.
        line: what binds it without rows, at x = 0.
        slope: of that by x.
        reach: no acceleration is greater.

    Returns:
        the line at x = 0, its slope, the bound.
    """
    A, B, lower, upper = rows
    cap, most = x, line + slope * x
    for end in range(2):
        for r in range(A.shape[1]):
            b, low, high = B[i + end, r], lower[i + end, r], upper[i + end, r]
            a, offset = (A[i + end, r] + 2.0 * step * end * b) * sign, b * x
            if low <= a * most + offset <= high:
                continue
            if abs(a) * reach <= NOTHING * (high - low):
                if b > 0.0:
                    cap = min(cap, high / b)
                elif b < 0.0:
                    cap = min(cap, low / b)
                continue
            if a < 0.0:
                a, b, high, offset = -a, -b, -low, -offset
            if a * most > high - offset:
                inverse = 1.0 / a
                line, slope = high * inverse, -b * inverse
                most = line + slope * x
    return line, slope, cap
