"""Whole turns and limits of joint coordinates in plain loops that numba compiles."""

from math import pi

import numpy as np

from ropsim.codegen import Array1, Array2, kernel

TURN = 2.0 * pi


@kernel
def turn_rows(
    branches: Array2,
    q_near: Array1,
    lower: Array1,
    upper: Array1,
    revolute: Array1,
    slack: float,
    turned: Array2,
) -> None:
    """Write branches with each turning joint moved by whole turns, see `nearest_turns`.

    Args:
        branches: NaN where absent [rad | m], shape (m, n).
        q_near: to which coordinates are to be near [rad | m], shape (n,).
        lower: limits of the axes [rad | m], shape (n,).
        upper: upper limits.
        revolute: 1 for axes that turn, else 0, shape (n,).
        slack: by which a coordinate may be beyond its limit [rad | m].
        turned: where the turned ones go, shape (m, n).
    """
    for row in range(branches.shape[0]):
        for j in range(branches.shape[1]):
            q = branches[row, j]
            turns = _turns(q, q_near[j], lower[j], upper[j], slack) if revolute[j] > 0.0 else 0.0
            turned[row, j] = q + TURN * turns


@kernel
def rows_inside(q: Array2, lower: Array1, upper: Array1, slack: float, result: Array1) -> None:
    """Write for each row 1 where no coordinate is beyond its limit, else 0, as for NaN.

    Args:
        q: of the axes [rad | m], shape (k, n).
        lower: limits of the axes [rad | m], shape (n,).
        upper: upper limits.
        slack: by which a coordinate may be beyond its limit [rad | m].
        result: output, shape (k,).
    """
    for row in range(q.shape[0]):
        result[row] = 1.0
        for j in range(q.shape[1]):
            if not (lower[j] - q[row, j] <= slack and q[row, j] - upper[j] <= slack):
                result[row] = 0.0


def _turns(q: float, q_near: float, lower: float, upper: float, slack: float) -> float:
    """Return by how many turns a coordinate is moved: towards another one, or at least to its limits."""
    fewest, most = np.ceil((lower - slack - q) / TURN), np.floor((upper + slack - q) / TURN)
    if fewest <= most:
        return float(min(max(np.rint((q_near - q) / TURN), fewest), most))
    below, above = lower - (q + TURN * most), q + TURN * fewest - upper
    return float(most if below <= above else fewest)
