"""Motions of mechanisms with closed chains: Jacobians, speeds and accelerations of all coordinates."""

import numpy as np
import numpy.typing as npt

from ropsim.core import frozen_dataclass
from ropsim.kinematics.chain.arrays import joint_rows, tree_of
from ropsim.kinematics.chain.closed_arrays import ClosedArrays, closed_arrays
from ropsim.kinematics.chain.closed_jacobian_kernel import (
    closed_coordinates,
    closed_frames_and_jacobians,
)
from ropsim.kinematics.chain.closure import closed_states
from ropsim.model import Mechanism, coordinates
from ropsim.spatial import Array


@frozen_dataclass
class JointMotion:
    """How all coordinates of a mechanism move, joint by joint, N of them (`model.coordinates`).

    Attributes:
        position: [rad | m], shape (k, N).
        speed: [rad/s | m/s], shape (k, N).
        acceleration: [rad/s² | m/s²], shape (k, N).
    """

    position: Array
    speed: Array
    acceleration: Array


def joint_motion(
    mechanism: Mechanism,
    Q: npt.ArrayLike,
    speeds: npt.ArrayLike | None = None,
    accelerations: npt.ArrayLike | None = None,
) -> JointMotion:
    """Return positions, speeds and accelerations of all coordinates of the joints from those of the axes.

    Coordinates that follow by couplings are linear functions of the axes. Those of closed chains follow from
    the rows of the cuts, C·s = 0 and its derivatives along the steps s; where a chain cannot reach, they are
    those that bring it nearest.

    Args:
        mechanism: with n axes.
        Q: coordinates of the axes [rad | m], shape (k, n).
        speeds: their derivatives by time, or by another parameter, shape (k, n); None for zero.
        accelerations: their second derivatives, shape (k, n); None for zero.

    Raises:
        ArrayShapeError: M551, an array has another shape.
        MechanismError: the mechanism cannot be.
    """
    tree_of(mechanism)
    rows = joint_rows(mechanism, Q)
    still = np.zeros_like(rows)
    rates = [still if one is None else joint_rows(mechanism, one) for one in (speeds, accelerations)]
    made = coordinates(mechanism)
    found = [rows @ made.T.T + made.c, rates[0] @ made.T.T, rates[1] @ made.T.T]
    if mechanism.cuts:
        loops = closed_arrays(mechanism)
        states = closed_states(loops, rows)[0]
        out = np.empty((2, len(rows), loops.p))
        closed_coordinates(loops.arm(), states, np.array(rates), out, loops.work())
        passive = (states[:, loops.n :], *out)
        found = [one + other @ made.P.T for one, other in zip(found, passive, strict=True)]
    return JointMotion(*found)


def loop_gaps(mechanism: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return the most that is left between frames of closed chains for axes at Q (k, n) [m, rad], shape (k,).

    Raises:
        ArrayShapeError: M551, Q has another shape.
        MechanismError: the mechanism cannot be.
    """
    rows = joint_rows(mechanism, Q)
    return closed_states(closed_arrays(mechanism), rows)[1][:, 1] if mechanism.cuts else np.zeros(len(rows))


def jacobians_of_loops(loops: ClosedArrays, rows: Array, X_MT: Array) -> tuple[Array, Array]:
    """Return X_BT (k, 4, 4) and the Jacobians of its origin (k, 6, n) for axes at rows (k, n)."""
    states = closed_states(loops, rows)[0]
    frames, J = np.empty((len(rows), 12)), np.empty((len(rows), 6, loops.n))
    place = np.ascontiguousarray(X_MT[:3, 3])
    closed_frames_and_jacobians(loops.arm(), states, place, frames, J, loops.work())
    return np.asarray(poses_of(frames) @ X_MT), J


def poses_of(frames: Array) -> Array:
    """Return frames given as R by rows and p (k, 12) as homogeneous matrices, shape (k, 4, 4)."""
    T = np.zeros((len(frames), 4, 4))
    T[:, :3, :3], T[:, :3, 3], T[:, 3, 3] = frames[:, :9].reshape(-1, 3, 3), frames[:, 9:], 1.0
    return T
