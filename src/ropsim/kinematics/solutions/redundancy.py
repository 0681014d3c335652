"""Free coordinate of a redundant arm at a pose: where it may be, and the answer nearest to its present value.

The answers to a pose are curves in the space of the joints, of which limits leave arcs. A `RedundantSolver`
gives points on all of them, and the arcs; the values of the free coordinate on an arc are an interval.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.solutions.configurations import spread_between
from ropsim.kinematics.solutions.polish import held_at, polished, polished_within
from ropsim.kinematics.solutions.result import Free, FreeInterval, IkResult, IkStatus
from ropsim.kinematics.solutions.self_motion import narrow_limits, within
from ropsim.kinematics.solutions.solver import RedundantSolver
from ropsim.spatial import Array, record

NEAR = 1e-6
"""An answer this near to a branch [rad] is that one."""
TOGETHER = 1e-9
"""Intervals that are this near to each other [rad] are one."""
ALIKE = 9
"""Decimals of distances and angles [rad]: rounding errors do not decide which is nearer."""
SEARCHED = 64
"""Number of starts of the search within the limits where no anchor is within."""
TURN = 2.0 * np.pi


@record
class Reachable:
    """Where the free coordinate of a pose may be, with the answers there.

    Attributes:
        arcs: of answers within the limits [rad], see `Arc`, shape (s, n) each.
        values: of the free coordinate along each of them [rad], without jumps by whole turns.
        beyond: where there are no arcs, answers beyond the limits [rad], shape (m, n).
    """

    arcs: tuple[Array, ...]
    values: tuple[Array, ...]
    beyond: Array


def reachable(solver: RedundantSolver, chain: ChainArrays, X_BM: Array, limits: Array) -> Reachable:
    """Return all arcs of answers to a pose within the limits.

    Args:
        solver: of the arm.
        chain: of the arm.
        X_BM: the pose, shape (4, 4).
        limits: lower and upper limits [rad], and 1.0 for joints that turn, shape (3, n).
    """
    narrow, turning = narrow_limits(limits), limits[2]
    beyond = solver.anchors(X_BM, narrow)
    starts = within(beyond, narrow, turning)
    if not len(starts):
        starts, beyond = _searched(chain, X_BM, beyond, limits)
    found = solver.arcs(X_BM, starts, limits)
    return Reachable(tuple(rows for rows, _ in found), tuple(values for _, values in found), beyond)


def intervals_of(found: Reachable) -> tuple[FreeInterval, ...]:
    """Return the intervals in which the free coordinate has an answer, in order; lower ends in (-π, π]."""
    ends = [[float(values.min()), float(values.max())] for values in found.values]
    for end in ends:
        end[1] = end[0] + min(end[1] - end[0], TURN)
        shift = TURN * np.ceil((end[0] - np.pi) / TURN)
        end[0], end[1] = end[0] - shift, end[1] - shift
    merged: list[list[float]] = []
    for low, high in sorted(ends):
        if merged and low <= merged[-1][1] + TOGETHER:
            merged[-1][1] = max(merged[-1][1], high)
        else:
            merged.append([low, high])
    while len(merged) > 1 and merged[-1][1] - TURN >= merged[0][0] - TOGETHER:
        first = merged.pop(0)  # the last one goes on behind ±π
        merged[-1][1] = max(merged[-1][1], first[1] + TURN)
    return tuple(FreeInterval(float(low), float(min(high, low + TURN))) for low, high in merged)


def nearest_answer(
    solver: RedundantSolver,
    chain: ChainArrays,
    asked: tuple[Array, Array, Array],
    first: IkResult,
    answer: Callable[[Array], IkResult],
) -> IkResult:
    """Return the answer with the free coordinate as near as possible to its value at `near`.

    Args:
        solver: of the arm.
        chain: of the arm.
        asked: pose X_BM (4, 4), `near` [rad], shape (n,), and limits as in `reachable`.
        first: the answer with it there, which has no solution.
        answer: makes a result of branches (m, n) of which some are present.

    Returns:
        The first answer with a solution, `first` where there is none.
    """
    X_BM, near, limits = asked
    found, here = reachable(solver, chain, X_BM, limits), solver.free(near)
    on_arcs = [
        _nearest_on(solver, chain, X_BM, one, values, here.value)
        for one, values in zip(found.arcs, found.values, strict=True)
    ]
    for value, q in sorted(on_arcs, key=lambda one: _order(one[0], here.value)):
        nearest = _at(solver, asked, value, q, answer)
        if nearest.status is IkStatus.FOUND:
            return nearest
    if first.status is IkStatus.OUT_OF_LIMITS or not len(found.beyond):
        return first
    excess = np.abs(_nearest_turn(found.beyond, limits) - _middle(limits)) - 0.5 * (limits[1] - limits[0])
    q = found.beyond[int(np.argmin(excess.max(axis=1)))]
    return _at(solver, asked, solver.free(q).value, q, answer)


def _at(
    solver: RedundantSolver,
    asked: tuple[Array, Array, Array],
    value: float,
    q: Array,
    answer: Callable[[Array], IkResult],
) -> IkResult:
    """Return the answer with the free coordinate at a value [rad], at which one is q (n,)."""
    X_BM, near, limits = asked
    branches = solver.branches_at(X_BM[np.newaxis], near, np.array([value]))[0]
    made = answer(_with(branches, q, limits[2]))
    return replace(made, free=Free(solver.free(near).name, _principal(value)))


def _nearest_on(
    solver: RedundantSolver, chain: ChainArrays, X_BM: Array, arc: Array, values: Array, here: float
) -> tuple[float, Array]:
    """Return the free coordinate on an arc nearest to a value [rad], in its turn, and the answer there."""
    values = values + TURN * np.round((here - 0.5 * (values.min() + values.max())) / TURN)
    crossed = np.flatnonzero((values[:-1] - here) * (values[1:] - here) < 0.0)
    off = values - here - TURN * np.round((values - here) / TURN)
    at = min(range(len(off)), key=lambda k: _order(here + float(off[k]), here))
    if len(crossed):
        k = int(crossed[0])
        share = (here - values[k]) / (values[k + 1] - values[k])
        start = arc[k] + share * (arc[k + 1] - arc[k])
        if solver.free_axis < 0:
            rows = solver.branches_at(X_BM[np.newaxis], start, np.array([here]))[0]
        else:
            rows = held_at(chain, X_BM, start[np.newaxis], solver.free_axis, here)
        rows = rows[~np.isnan(rows[:, 0])]
        if len(rows):
            apart = rows - start
            apart -= TURN * np.round(apart / TURN)
            aside = np.abs(apart).max(axis=1)
            row = int(np.argmin(aside))
            if aside[row] <= np.abs(arc[k + 1] - arc[k]).max():
                return here, rows[row]
    return here + float(off[at]), arc[at]


def _order(value: float, here: float) -> tuple[float, float]:
    """Return by what values come: by their distance from a value, of two alike the lower one [rad]."""
    return round(abs(value - here), ALIKE), round(_principal(value), ALIKE)


def _with(branches: Array, q: Array, turning: Array) -> Array:
    """Return branches (m, n) among which is an answer q (n,)."""
    apart = branches - q
    apart -= turning * (TURN * np.round(apart / TURN))
    distance = np.nan_to_num(np.abs(apart).max(axis=1), nan=np.inf)
    found = branches.copy()
    row = int(np.argmin(distance))
    if distance[row] > NEAR:
        absent = np.flatnonzero(np.isinf(distance))
        row = int(absent[0]) if len(absent) else len(found) - 1
    found[row] = q
    return found


def _searched(chain: ChainArrays, X_BM: Array, anchors: Array, limits: Array) -> tuple[Array, Array]:
    """Return answers found numerically within the limits, and anchors or others beyond them."""
    spread, T = spread_between(limits[0], limits[1], SEARCHED), X_BM[np.newaxis]
    starts = np.concatenate((_nearest_turn(anchors, limits), spread))
    found = polished_within(chain, T, starts[np.newaxis], limits[:2])[0]
    found = found[~np.isnan(found[:, 0])]
    if len(found) or len(anchors):
        return found, anchors
    beyond = polished(chain, T, starts[np.newaxis])[0]
    return found, beyond[~np.isnan(beyond[:, 0])]


def _middle(limits: Array) -> Array:
    """Return the middle between limits (3, n), 0 where a joint has none."""
    with np.errstate(invalid="ignore"):
        middle = 0.5 * (limits[0] + limits[1])
    return np.where(np.isfinite(middle), middle, 0.0)


def _nearest_turn(rows: Array, limits: Array) -> Array:
    """Return joint coordinates (m, n) in the turns nearest to the middle between limits (3, n)."""
    turns = np.round((_middle(limits) - rows) / TURN)
    return np.asarray(rows + TURN * limits[2] * turns)


def _principal(angle: float) -> float:
    """Return an angle in (-π, π] [rad]."""
    return angle - TURN * float(np.ceil((angle - np.pi) / TURN))
