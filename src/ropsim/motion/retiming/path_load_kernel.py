"""Accelerations of paths with limits of their own at control ticks, and what they may be, for numba."""

import math
from typing import NamedTuple

from ropsim.codegen import Array2
from ropsim.spatial import Array


class PathLoad(NamedTuple):
    """r paths with limits of their own at k control ticks, see `PathMotion`; each of shape (k, r).

    Attributes:
        first: first derivatives by nominal time.
        second: second ones.
        accelerations: greatest accelerations by real time.
        jerks: greatest jerks by real time.
    """

    first: Array2
    second: Array2
    accelerations: Array2
    jerks: Array2


def path_acceleration(paths: PathLoad, timing: Array, k: int, j: int) -> float:
    """Return the acceleration of a path by real time: s''·w² + s'·c at the rate w, which changes by c."""
    w = timing[1, k]
    return float(paths.second[k, j] * (w * w) + paths.first[k, j] * timing[2, k])


def path_jump(paths: PathLoad, timing: Array, k: int, j: int, ticks: int) -> float:
    """Return how much the acceleration of a path changes towards a tick; see `_jump`."""
    now = path_acceleration(paths, timing, k, j)
    jump = abs(now) if k == 0 else abs(now - path_acceleration(paths, timing, k - 1, j))
    return max(jump, abs(now)) if k == ticks - 1 else jump


def most_acceleration(paths: PathLoad, k: int, j: int) -> float:
    """Return the limit of the acceleration of a path at a tick, never less than that of the plan itself."""
    return float(max(paths.accelerations[k, j], abs(paths.second[k, j])))


def most_step(paths: PathLoad, timing: Array, k: int, j: int, period: float) -> float:
    """Return by how much the acceleration of a path may differ from that of the tick before.

    Limits may change from tick to tick; the lesser one counts, but never less than the value of the plan
    itself between the two. Where there is no limit at one of them, there is none.
    """
    jerk = paths.jerks[k, j]
    if k == 0:
        return float(period * jerk)
    before = paths.jerks[k - 1, j]
    if max(jerk, before) == math.inf:
        return math.inf
    gone = timing[0, k] - timing[0, k - 1]
    planned = abs(paths.second[k, j] - paths.second[k - 1, j]) / gone if gone > 0.0 else 0.0
    return float(period * max(min(jerk, before), planned))
