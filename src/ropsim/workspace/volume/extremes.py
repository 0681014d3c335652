"""How far and how high a point comes: its greatest and least coordinates over the ranges of the axes."""

from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from ropsim.model import RobotModel, coupled_limits
from ropsim.spatial import Array, frozen, record
from ropsim.workspace.point import MovedPoint
from ropsim.workspace.ranges import AxisRanges, even_rows
from ropsim.workspace.volume.sheets import section_coordinates
from ropsim.workspace.volume.sweep import Sweep

STARTS = 2048
"""Configurations of which the best ones begin a search."""
KEPT = 12
LEAST_STEP = 1e-8
"""The search ends with steps of this share of a range: a smooth extreme is then off by its square."""
ROUNDING = 1e-12
"""Nothing is won by less than this [m]: where axes hardly move the point, searches would follow last bits."""
GOALS = frozen(np.array([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]]))
"""Of the coordinates of the section, the one to be minimised: the first one, its opposite, and so the
second."""

Worth = Callable[[Array, npt.NDArray[np.intp]], Array]
"""Cost of axes (k, n) for the searches with these numbers (k,), shape (k,)."""


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
    places that the arm takes, so that a greatest value is never too great. The four searches go on together.
    """
    Q = _allowed(robot, even_rows(ranges, STARTS))
    if not len(Q):
        Q = robot.home[np.newaxis]
    order = np.argsort(_places(robot, point, sweep, Q) @ GOALS.T, axis=0, kind="stable")[:KEPT]
    goals = np.repeat(GOALS, len(order), axis=0)

    def worth(rows: Array, of: npt.NDArray[np.intp]) -> Array:
        return np.asarray((_places(robot, point, sweep, rows) * goals[of]).sum(axis=1))

    q, values = _least(robot, ranges, Q[order.T].reshape(-1, robot.n), worth)
    found = values.reshape(len(GOALS), -1).argmin(axis=1) + len(order) * np.arange(len(GOALS))
    return tuple(Extreme(float(GOALS[k].sum() * values[row]), q[row]) for k, row in enumerate(found))


def _least(robot: RobotModel, ranges: AxisRanges, starts: Array, worth: Worth) -> tuple[Array, Array]:
    """Return the axes to which searches from `starts` (k, n) come, (k, n), and their costs, (k,)."""
    q = starts.copy()
    going = np.arange(len(q))
    best = worth(q, going)
    n = q.shape[1]
    steps = np.full(len(q), 0.125)
    compass = np.concatenate((np.eye(n), -np.eye(n))) * ranges.extent
    while len(going):
        tried = q[going, np.newaxis] + steps[going, np.newaxis, np.newaxis] * compass
        tried = np.clip(tried, ranges.lower, ranges.upper)
        values = worth(tried.reshape(-1, n), np.repeat(going, 2 * n)).reshape(-1, 2 * n)
        values[_beyond(robot, tried)] = np.inf
        pick = values.argmin(axis=1)
        rows = np.arange(len(going))
        better = values[rows, pick] < best[going] - ROUNDING
        won = going[better]
        q[won], best[won] = tried[rows, pick][better], values[rows, pick][better]
        steps[going[~better]] *= 0.5
        going = going[steps[going] > LEAST_STEP]
    return q, best


def _places(robot: RobotModel, point: MovedPoint, sweep: Sweep, Q: Array) -> Array:
    return section_coordinates(sweep, point.positions(robot, Q))


def _beyond(robot: RobotModel, Q: Array) -> npt.NDArray[np.bool_]:
    """Return which rows of axes (..., n) break a limit of a joint that follows them."""
    return np.asarray((coupled_limits(robot).excess(Q) > 0.0).any(axis=-1))


def _allowed(robot: RobotModel, Q: Array) -> Array:
    return np.asarray(Q[~_beyond(robot, Q)])
