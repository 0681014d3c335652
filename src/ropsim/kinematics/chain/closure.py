"""Closed chains: the coordinates that they determine, followed from the rest position of the axes.

A chain that can be assembled in several ways stays in the assembly that it has at home, the one that Newton's
method finds from passive coordinates of zero, along the straight way of the axes from there; where it locks
on that, along one axis after the other.
"""

import numpy as np

from ropsim.kinematics.chain.closed_arrays import ClosedArrays
from ropsim.kinematics.chain.closure_kernel import close_along, close_rows, write_rows
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
