"""How far and how high a point comes: its greatest and least coordinates over the ranges of the axes."""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from ropsim.model import RobotModel, coupled_limits
from ropsim.spatial import Array, record
from ropsim.workspace.even import even_rows
from ropsim.workspace.point import MovedPoint
from ropsim.workspace.ranges import AxisRanges
from ropsim.workspace.sheets import section_coordinates
from ropsim.workspace.sweep import Sweep

STARTS = 2048
"""Configurations of which the best ones begin a search."""
KEPT = 12
LEAST_STEP = 1e-8
"""The search ends with steps of this share of a range: a smooth extreme is then off by its square."""


@record
class Extreme:
    """A coordinate of the section at its greatest or least.

    Attributes:
        value: [m].
        q: an axis vector that takes the point there [rad | m], shape (n,).
    """

    value: float
    q: Array


def extremes(robot: RobotModel, point: MovedPoint, sweep: Sweep, ranges: AxisRanges) -> tuple[Extreme, ...]:
    """Return least and greatest of the first coordinate of the section, then of the second one.

    Found by a compass search (Hooke & Jeeves 1961) from the best of many configurations; the answers are
    places that the arm takes, so that a greatest value is never too great.
    """
    Q = _allowed(robot, even_rows(ranges, STARTS))
    if not len(Q):
        Q = robot.home[np.newaxis]
    found = []
    for column in (0, 1):
        for sign in (1.0, -1.0):  # the least, then the greatest

            def worth(rows: Array, column: int = column, sign: float = sign) -> Array:
                return sign * section_coordinates(sweep, point.positions(robot, rows))[:, column]

            q, value = _least(robot, ranges, Q, worth)
            found.append(Extreme(sign * value, q))
    return tuple(found)


def _least(
    robot: RobotModel, ranges: AxisRanges, Q: Array, worth: Callable[[Array], Array]
) -> tuple[Array, float]:
    """Return the axes at which a function is least, and its value there."""
    order = np.argsort(worth(Q), kind="stable")[:KEPT]
    q = Q[order]
    best = worth(q)
    n = q.shape[1]
    steps = np.full(len(q), 0.125)
    compass = np.concatenate((np.eye(n), -np.eye(n)))
    while steps.max() > LEAST_STEP:
        tried = q[:, np.newaxis] + steps[:, np.newaxis, np.newaxis] * compass * ranges.extent
        tried = np.clip(tried, ranges.lower, ranges.upper)
        values = worth(tried.reshape(-1, n)).reshape(len(q), 2 * n)
        values[_beyond(robot, tried)] = np.inf
        pick = values.argmin(axis=1)
        rows = np.arange(len(q))
        better = values[rows, pick] < best
        q = np.where(better[:, np.newaxis], tried[rows, pick], q)
        best = np.where(better, values[rows, pick], best)
        steps = np.where(better, steps, 0.5 * steps)
    k = int(best.argmin())
    return q[k], float(best[k])


def _beyond(robot: RobotModel, Q: Array) -> npt.NDArray[np.bool_]:
    """Return which rows of axes (..., n) break a limit of a joint that follows them."""
    return np.asarray((coupled_limits(robot).excess(Q) > 0.0).any(axis=-1))


def _allowed(robot: RobotModel, Q: Array) -> Array:
    return np.asarray(Q[~_beyond(robot, Q)])
