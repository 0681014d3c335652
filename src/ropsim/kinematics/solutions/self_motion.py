"""Arcs of joint coordinates within the limits along which a redundant arm keeps its pose."""

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.solutions.selection_kernel import LIMIT_SLACK
from ropsim.kinematics.solutions.self_motion_kernel import CLOSED, WALLS, Work, mark_covered, trace_rows
from ropsim.kinematics.solutions.solver import RedundantSolver
from ropsim.spatial import Array

POINTS = 500
"""Largest number of points of an arc to one side of where it is begun."""
JUMP = np.pi / 2.0
"""The free coordinate changes less than this from point to point of one curve [rad]."""
TURN = 2.0 * np.pi


def narrow_limits(limits: Array) -> Array:
    """Return lower and upper limits, infinite for joints that turn and have a whole turn between them.

    Args:
        limits: lower and upper limits [rad | m], and 1.0 for joints that turn, shape (3, n).
    """
    lower, upper, turning = limits
    free = (turning > 0.0) & (upper - lower >= TURN)
    return np.array([np.where(free, -np.inf, lower), np.where(free, np.inf, upper)])


def within(rows: Array, limits: Array, turning: Array) -> Array:
    """Return the rows that have a turn within the limits, in that turn.

    Args:
        rows: joint coordinates [rad | m], shape (m, n).
        limits: of `narrow_limits`, shape (2, n).
        turning: 1.0 for joints that turn, shape (n,).
    """
    lower, upper = limits
    limited = np.isfinite(lower) & (turning > 0.0)
    turns = np.ceil((np.where(limited, lower, rows) - LIMIT_SLACK - rows) / TURN)
    turned = rows + TURN * np.where(limited, turns, 0.0)
    inside = ((turned >= lower - LIMIT_SLACK) & (turned <= upper + LIMIT_SLACK)).all(axis=1)
    return np.asarray(np.clip(turned[inside], lower, upper))


def arcs_of(
    chain: ChainArrays, X_BM: Array, starts: Array, limits: Array, solver: RedundantSolver
) -> tuple[Array, ...]:
    """Return the arcs of answers on which starts lie, each once.

    Where two curves come so near to each other that the one is followed into the other, the free coordinate
    jumps. There the arc ends, and starts with another free coordinate than that of an arc next to them begin
    arcs of their own.

    Args:
        chain: of the arm.
        X_BM: the pose, shape (4, 4).
        starts: joint coordinates that reach it within the limits [rad | m], shape (m, n).
        limits: of `narrow_limits`, shape (2, n).
        solver: of the arm.

    Returns:
        Joint coordinates along each arc [rad | m], one small step from the other and without jumps by whole
        turns, shape (s, n); a closed one ends where it begins; one row for a pose that is reached in a point
        only.
    """
    arcs, known = list[Array](), np.zeros(len(starts))
    marked, wide = _marked(starts, solver), np.hstack((limits, [[-1.0, -1.0], [1.0, 1.0]]))
    for k, q in enumerate(starts):
        if not known[k]:
            for arc in _split(_arc(chain, X_BM, q, limits, solver), solver):
                arcs.append(arc)
                mark_covered(_marked(arc, solver), marked, wide, known)
            known[k] = 1.0
    return tuple(arcs)


def _marked(rows: Array, solver: RedundantSolver) -> Array:
    """Return joint coordinates (m, n) with cosine and sine of the free coordinate, shape (m, n + 2)."""
    values = solver.free_values(rows)
    return np.column_stack((rows, np.cos(values), np.sin(values)))


def _split(arc: Array, solver: RedundantSolver) -> list[Array]:
    """Return the parts of an arc (s, n) between jumps of the free coordinate."""
    steps = np.diff(solver.free_values(arc))
    steps -= TURN * np.round(steps / TURN)
    return np.split(arc, np.flatnonzero(np.abs(steps) > JUMP) + 1)


def _arc(chain: ChainArrays, X_BM: Array, q: Array, limits: Array, solver: RedundantSolver) -> Array:
    """Return the arc through a point q (n,), shape (s, n)."""
    m, n = len(chain.slides), chain.n
    Q, ends = np.empty((2, POINTS, n)), np.array([[1.0, 0.0], [-1.0, 0.0]])
    Q[:, 0] = q
    work = Work(np.empty((m + 1, 12)), np.zeros((n + 12, max(n, 6))), np.empty((7, m)), np.empty((8, n)))
    work.ahead[WALLS:], free = solver.walls(q), solver.free_axis
    for side in (0, 1):
        trace_rows(
            chain.flat, chain.spread, X_BM, limits, free, Q[side : side + 1], ends[side : side + 1], work
        )
        if ends[side, 1] == CLOSED:
            whole = Q[side, : int(ends[side, 0])]
            return np.vstack((whole, whole[-1] - _apart(whole[-1], q, limits)))
    ahead, back = (Q[side, : int(ends[side, 0])] for side in (0, 1))
    return np.ascontiguousarray(np.concatenate((back[:0:-1], ahead)))


def _apart(q: Array, other: Array, limits: Array) -> Array:
    """Return the difference of joint coordinates (n,), without whole turns of joints that have no limits."""
    apart = q - other
    return np.asarray(apart - np.where(np.isinf(limits[1]), TURN * np.round(apart / TURN), 0.0))
