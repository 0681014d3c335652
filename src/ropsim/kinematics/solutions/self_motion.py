"""Arcs of joint coordinates within the limits along which a redundant arm keeps its pose."""

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.solutions.selection_kernel import LIMIT_SLACK
from ropsim.kinematics.solutions.self_motion_kernel import CLOSED, Work, mark_covered, trace_rows
from ropsim.spatial import Array

Bools = npt.NDArray[np.bool_]
Arc = tuple[Array, Array]
"""Answers one small step from the other, (s, n), and the free coordinate there without whole turns, (s,)."""

POINTS = 500
"""Largest number of points of an arc to one side of where it is begun."""
TURN = 2.0 * np.pi


def narrow_limits(limits: Array) -> Array:
    """Return lower and upper limits, infinite for joints that turn and have a whole turn between them.

    Args:
        limits: lower and upper limits [rad | m], and 1.0 for joints that turn, shape (3, n).
    """
    lower, upper, turning = limits
    free = (turning > 0.0) & (upper - lower >= TURN)
    return np.array([np.where(free, -np.inf, lower), np.where(free, np.inf, upper)])


def turned_within(rows: Array, limits: Array, turning: Array) -> tuple[Array, Bools]:
    """Return rows in the turn that is within the limits, and for which rows there is one, shape (m,).

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
    return np.clip(turned, lower, upper), inside


def within(rows: Array, limits: Array, turning: Array) -> Array:
    """Return the rows that have a turn within the limits, in that turn; see `turned_within`."""
    turned, inside = turned_within(rows, limits, turning)
    return np.asarray(turned[inside])


def arcs_of(chain: ChainArrays, X_BM: Array, starts: Array, limits: Array, free: int) -> tuple[Array, ...]:
    """Return the arcs of answers on which starts lie, each once.

    Args:
        chain: of the arm.
        X_BM: the pose, shape (4, 4).
        starts: joint coordinates that reach it within the limits [rad | m], shape (m, n).
        limits: of `narrow_limits`, shape (2, n).
        free: axis that is the free coordinate, whose turning points become points of the arcs; -1 for none.

    Returns:
        Joint coordinates along each arc [rad | m], one small step from the other and without jumps by whole
        turns, shape (s, n); a closed one ends where it begins; one row for a pose that is reached in a point
        only.
    """
    arcs, known = [], np.zeros(len(starts))
    for k, q in enumerate(starts):
        if not known[k]:
            arcs.append(_arc(chain, X_BM, q, limits, free))
            mark_covered(arcs[-1], starts, limits, known)
    return tuple(arcs)


def _arc(chain: ChainArrays, X_BM: Array, q: Array, limits: Array, free: int) -> Array:
    """Return the arc through a point q (n,), shape (s, n)."""
    m, n = len(chain.slides), chain.n
    Q, ends = np.empty((2, POINTS, n)), np.array([[1.0, 0.0], [-1.0, 0.0]])
    Q[:, 0] = q
    work = Work(np.empty((m + 1, 12)), np.zeros((n + 12, max(n, 6))), np.empty((7, m)), np.empty((6, n)))
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
