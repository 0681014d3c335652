"""The geometric Jacobian: from joint speeds to the velocity of a point of the last link."""

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays, joint_rows, joint_vector
from ropsim.kinematics.chain.closed_arrays import closed_arrays
from ropsim.kinematics.chain.closed_motion import jacobians_of_loops
from ropsim.kinematics.chain.linear_loops import without_linear_loops
from ropsim.kinematics.chain.steps_kernel import frames_and_jacobians
from ropsim.model import Mechanism
from ropsim.spatial import Array, Pose

_AT_INTERFACE = Pose().matrix()


def jacobian(robot: Mechanism, q: npt.ArrayLike) -> Array:
    """Return the Jacobian of the mechanical interface in the base frame.

    V = J(q)·q̇ with V = (velocity of the origin of M [m/s], angular velocity [rad/s]), both in base
    coordinates. Column i is (z_i × (p_M - p_i), z_i) for a revolute joint and (z_i, 0) for a prismatic one
    (Whitney 1972). An axis that moves several joints by couplings has the sum of their columns, each times
    its factor; one that moves a closed chain that of all steps of the chain on the way to the interface, each
    times its derivative by the axis.

    Args:
        robot: mechanism with n axes.
        q: coordinates of the axes [rad | m], shape (n,).

    Returns:
        J, shape (6, n): rows 0 to 2 linear, 3 to 5 angular.

    Raises:
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
    """
    return jacobian_at(robot, q, Pose())


def jacobian_at(robot: Mechanism, q: npt.ArrayLike, X_MT: Pose) -> Array:
    """Return the Jacobian of the TCP of a tool in the base frame, shape (6, n); see `jacobian`.

    Args:
        robot: mechanism with n axes.
        q: coordinates of the axes [rad | m], shape (n,).
        X_MT: tool frame in the mechanical interface frame.

    Raises:
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
    """
    return frame_and_jacobian(robot, q, X_MT)[1]


def frame_and_jacobian(robot: Mechanism, q: npt.ArrayLike, X_MT: Pose) -> tuple[Array, Array]:
    """Return X_BT of a tool, homogeneous (4, 4), and the result of `jacobian_at`, in one call.

    Args:
        robot: mechanism with n axes.
        q: coordinates of the axes [rad | m], shape (n,).
        X_MT: tool frame in the mechanical interface frame.

    Raises:
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
    """
    T, J = _of_robot(robot, joint_vector(robot, q)[np.newaxis], X_MT)
    return T[0], J[0]


def jacobians_at(robot: Mechanism, Q: npt.ArrayLike, X_MT: Pose) -> tuple[Array, Array]:
    """Return X_BT of a tool, homogeneous (k, 4, 4), and `jacobian_at` (k, 6, n) at many configurations.

    Args:
        robot: mechanism with n axes.
        Q: coordinates of the axes [rad | m], shape (k, n).
        X_MT: tool frame in the mechanical interface frame.

    Raises:
        ArrayShapeError: M551, Q has another shape.
    """
    return _of_robot(robot, joint_rows(robot, Q), X_MT)


def least_singular_values(chain: ChainArrays, rows: Array) -> Array:
    """Return the least singular value of `jacobian` [m, rad] at configurations (k, n), shape (k,)."""
    _, J = _at_rows(chain, rows, _AT_INTERFACE)
    return np.asarray(np.linalg.svd(J, compute_uv=False)[:, -1])


def _of_robot(robot: Mechanism, rows: Array, X_MT: Pose) -> tuple[Array, Array]:
    linear = without_linear_loops(robot)
    if linear.cuts:
        return jacobians_of_loops(closed_arrays(linear), rows, X_MT.matrix())
    return _at_rows(chain_arrays(linear), rows, X_MT.matrix())


def _at_rows(chain: ChainArrays, rows: Array, X_MT: Array) -> tuple[Array, Array]:
    """Return X_BT (k, 4, 4) and the Jacobians of its origin (k, 6, n) at configurations (k, n)."""
    m, Q = len(chain.slides), np.ascontiguousarray(rows, dtype=np.float64)
    T, J = np.empty((len(Q), 4, 4)), np.zeros((len(Q), 6, chain.n))
    frames, lanes = np.empty((m + 1, 12)), np.empty((7, m))
    frames_and_jacobians(chain.flat, chain.spread, Q, X_MT, frames, lanes, T, J)
    return T, J
