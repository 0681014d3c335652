"""Closed chains: the coordinates that they determine, followed from the rest position of the axes.

A chain that can be assembled in several ways stays in the assembly that it has at home, the one that Newton's
method finds from passive coordinates of zero, along the straight way of the axes from there; where it locks
on that, along one axis after the other.
"""

import numpy as np

from ropsim.kinematics.chain.closed_arrays import NUDGE, ClosedArrays, closed_arrays
from ropsim.kinematics.chain.closure_kernel import DEPENDENT, close_along, close_rows, write_rows
from ropsim.model import Mechanism
from ropsim.spatial import Array

APART = 1e-9
"""Frames that are left farther apart than this are not together [m, rad]."""


def closed_states(loops: ClosedArrays, rows: Array) -> tuple[Array, Array]:
    """Return coordinates of axes and loops for axes at rows (k, n), and how well they close.

    Returns:
        The coordinates [rad | m], shape (k, n + p); and the share of the way from home on which the chains
        follow, 1.0 for all of it, with what is left between their frames [m, rad], shape (k, 2).
    """
    states, results = np.empty((len(rows), len(loops.home))), np.empty((len(rows), 2))
    close_rows(loops.arm(), np.ascontiguousarray(rows, dtype=np.float64), states, results, loops.work())
    return states, results


def states_along(loops: ClosedArrays, rows: Array, start: Array) -> tuple[Array, Array]:
    """Return `closed_states` of rows (k, n) that follow each other, from a closed start (n + p,)."""
    states, results = np.empty((len(rows), len(loops.home))), np.empty((len(rows), 2))
    states[:1] = start
    close_along(loops.arm(), np.ascontiguousarray(rows, dtype=np.float64), states, results, loops.work())
    return states, results


def closure(loops: ClosedArrays, q: Array) -> tuple[Array, Array]:
    """Return the residuals of closed chains at axes q (n,), and their slopes by the dependent coordinates.

    Returns:
        Residuals between the frames of all cuts in the directions that they hold [m, rad], shape (r,); and
        its slopes by the p coordinates that the chains determine, shape (r, p).
    """
    state, work = closed_states(loops, q[np.newaxis])[0][0], loops.work()
    write_rows(loops.arm(), state, work)
    return work.left[0], work.slopes @ loops.spread[:, loops.n : -1]


def cut_gaps(loops: ClosedArrays, states: Array) -> Array:
    """Return what is left between the frames of each cut at coordinates of axes and loops (k, n + p).

    Returns:
        The largest distance or angle in a direction that the cut holds [m, rad], shape (k, c).
    """
    work, gaps = loops.work(), np.zeros((len(states), len(loops.ends)))
    for k, state in enumerate(states):
        write_rows(loops.arm(), np.ascontiguousarray(state), work)
        np.maximum.at(gaps[k], loops.rows[:, 0].astype(int), np.abs(work.left[0]))
    return gaps


def independent_rows(mechanism: Mechanism) -> tuple[int, ...]:
    """Return which rows of the cuts determine the coordinates of closed chains, as many as these are.

    The determinant of their slopes by these coordinates changes its sign where chains pass a dead centre.
    The rows are chosen at home, or beside it where that is one: the longest first, less what depends on those
    before it.

    Returns:
        Numbers of the rows; none where the rows leave a coordinate free.
    """
    loops = closed_arrays(mechanism)
    nudges = NUDGE * np.vstack((np.zeros(loops.n), np.eye(loops.n), -np.eye(loops.n)))
    beside = [closure(loops, mechanism.home + nudge)[1] for nudge in nudges]
    left = max(beside, key=lambda slopes: float(np.linalg.svd(slopes, compute_uv=False).min(initial=np.inf)))
    left, chosen, first = left.copy(), [], 0.0
    for _ in range(min(loops.p, len(left))):
        lengths = np.linalg.norm(left, axis=1)
        row = int(lengths.argmax())
        first = max(first, float(lengths[row]))
        if not lengths[row] > DEPENDENT * first:
            break
        chosen.append(row)
        unit = left[row] / lengths[row]
        left -= np.outer(left @ unit, unit)
    return tuple(sorted(chosen)) if len(chosen) == loops.p else ()


def row_volumes(loops: ClosedArrays, rows: tuple[int, ...], states: Array) -> Array:
    """Return the determinants of the slopes of rows by the coordinates of closed chains; 0 in dead centres.

    Args:
        loops: the mechanism.
        rows: of `independent_rows`.
        states: coordinates of axes and loops [rad | m], closed, shape (k, n + p).

    Returns:
        Shape (k,).
    """
    work, found = loops.work(), np.empty(len(states))
    for k, state in enumerate(states):
        write_rows(loops.arm(), np.ascontiguousarray(state), work)
        found[k] = np.linalg.det((work.slopes @ loops.spread[:, loops.n : -1])[list(rows)])
    return found


def usual_volume(mechanism: Mechanism, rows: tuple[int, ...], Q: Array) -> float:
    """Return the greatest volume of rows of `independent_rows` for axes at Q (k, n) where chains close."""
    loops = closed_arrays(mechanism)
    states, results = closed_states(loops, Q)
    return float(np.abs(row_volumes(loops, rows, states[results[:, 1] <= APART])).max(initial=0.0))
