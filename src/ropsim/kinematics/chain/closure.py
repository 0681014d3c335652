"""Closed chains: the coordinates that they determine, found by Newton's method from the home position.

A cut holds two frames together in some directions. The residual between them is made zero by Gauss and
Newton, in small steps of the axes from the home position, so that a chain that can be assembled in several
ways stays in the one nearest to passive coordinates of zero at home.
"""

import numpy as np

from ropsim.kinematics.chain.tree_arrays import Loops, TreeArrays, placed_steps
from ropsim.model import BASE_LINK
from ropsim.spatial import Array

STRIDE = 0.1
"""Longest step of an axis from one closed position to the next [rad | m]."""
ROUNDS = 20
"""Most steps of Newton's method in one position; more do not help where the chain does not reach."""
CLOSED = 1e-13
"""Below this nothing is left between the frames [m, rad]."""
LONGEST = 0.5
"""Longest step of a coordinate in Newton's method [rad | m]."""
DIFFERENCE = 1e-6
"""Step of the difference quotients of the slopes [rad | m]."""


def step_frames(tree: TreeArrays, rows: Array) -> Array:
    """Return the frames of all steps in the base frame for axes at rows (k, n), shape (k, m, 4, 4).

    Where a closed chain cannot reach, it is left open.
    """
    moved = tree.steps(rows)
    if tree.loops is not None:
        moved = moved + np.array([_closed(tree, tree.loops, row) for row in rows]) @ tree.loops.P.T
    return placed_steps(tree, moved)


def closure(tree: TreeArrays, loops: Loops, q: Array) -> tuple[Array, Array]:
    """Return the residuals of closed chains at axes q (n,), and their slopes by the dependent coordinates.

    Returns:
        Residuals between the frames of all cuts [m, rad], shape (6·cuts,), 0 in directions not held; and its
        slopes by the p coordinates that the chains determine, shape (6·cuts, p).
    """
    moved = tree.steps(q[np.newaxis])[0]
    return _left_and_slopes(tree, loops, moved, _closed(tree, loops, q))


def _closed(tree: TreeArrays, loops: Loops, q: Array) -> Array:
    """Return the coordinates that the loops determine at axes q (n,), shape (p,)."""
    z = np.zeros(loops.P.shape[1])
    count = max(1, int(np.ceil(np.abs(q - loops.home).max(initial=0.0) / STRIDE)))
    for share in np.linspace(0.0, 1.0, count + 1):
        z = _assembled(tree, loops, tree.steps((loops.home + share * (q - loops.home))[np.newaxis])[0], z)
    return z


def _assembled(tree: TreeArrays, loops: Loops, moved: Array, z: Array) -> Array:
    """Return z (p,), improved until the loops are closed; `moved` are the steps without it, shape (m,)."""
    for _ in range(ROUNDS):
        left, slopes = _left_and_slopes(tree, loops, moved, z)
        if np.abs(left).max(initial=0.0) < CLOSED:
            break
        step = np.linalg.lstsq(slopes, -left, rcond=None)[0]
        z = z + step * min(1.0, LONGEST / max(float(np.abs(step).max(initial=0.0)), 1e-300))
    return z


def _left_and_slopes(tree: TreeArrays, loops: Loops, moved: Array, z: Array) -> tuple[Array, Array]:
    """Return the residuals at z (p,), shape (6·cuts,), and its slopes by z, shape (6·cuts, p)."""
    apart = DIFFERENCE * np.eye(len(z))
    beside = np.concatenate((z[np.newaxis], z + apart, z - apart))
    left = _left(loops, placed_steps(tree, moved + beside @ loops.P.T))
    return left[0], (left[1 : len(z) + 1] - left[len(z) + 1 :]).T / (2.0 * DIFFERENCE)


def _left(loops: Loops, frames: Array) -> Array:
    """Return the residuals between the frames of all cuts [m, rad], shape (k, 6·cuts); 0 where not held."""
    found = []
    for (one, other), (X_1, X_2), held in zip(loops.carriers, loops.frames, loops.held, strict=True):
        first = X_1 if one == BASE_LINK else frames[:, one] @ X_1
        second = X_2 if other == BASE_LINK else frames[:, other] @ X_2
        R = np.broadcast_to(first, (len(frames), 4, 4))[:, :3, :3].transpose(0, 2, 1)
        along = np.einsum("kij,kj->ki", R, (second - first)[:, :3, 3])
        E = R @ np.broadcast_to(second, (len(frames), 4, 4))[:, :3, :3]
        about = np.stack((E[:, 2, 1] - E[:, 1, 2], E[:, 0, 2] - E[:, 2, 0], E[:, 1, 0] - E[:, 0, 1]), axis=1)
        found.append(np.concatenate((along, about / 2.0), axis=1) * held)
    return np.concatenate(found, axis=1)
