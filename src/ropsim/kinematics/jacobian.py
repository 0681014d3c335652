"""The geometric Jacobian: from joint speeds to the velocity of a point of the last link."""

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.arrays import ChainArrays, chain_arrays, joint_vector
from ropsim.kinematics.forward import frames_of
from ropsim.model import Mechanism
from ropsim.spatial import Array, Pose, cross


def jacobian(robot: Mechanism, q: npt.ArrayLike) -> Array:
    """Return the Jacobian of the mechanical interface in the base frame.

    V = J(q)·q̇ with V = (velocity of the origin of M [m/s], angular velocity [rad/s]), both in base
    coordinates. Column i is (z_i × (p_M - p_i), z_i) for a revolute joint and (z_i, 0) for a prismatic one
    (Whitney 1972). An axis that moves several joints by couplings has the sum of their columns, each times
    its factor.

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
    chain = chain_arrays(robot)
    frames = frames_of(chain, joint_vector(robot, q)[np.newaxis])[0]
    X_BM = frames[-1]
    return _of_point(chain, frames, X_BM[:3, :3] @ X_MT.position + X_BM[:3, 3])


def frame_and_jacobian(robot: Mechanism, q: npt.ArrayLike, X_MT: Pose) -> tuple[Array, Array]:
    """Return X_BT of a tool, homogeneous (4, 4), and what `jacobian_at` returns, in the time of one of them.

    Args:
        robot: mechanism with n axes.
        q: coordinates of the axes [rad | m], shape (n,).
        X_MT: tool frame in the mechanical interface frame.

    Raises:
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
    """
    chain = chain_arrays(robot)
    frames = frames_of(chain, joint_vector(robot, q)[np.newaxis])[0]
    X_BT = np.asarray(frames[-1] @ X_MT.matrix())
    return X_BT, _of_point(chain, frames, X_BT[:3, 3])


def least_singular_values(chain: ChainArrays, rows: Array) -> Array:
    """Return the least singular value of `jacobian` [m, rad] at configurations (k, n), shape (k,)."""
    frames = frames_of(chain, rows)
    J = np.array([_of_point(chain, one, one[-1, :3, 3]) for one in frames])
    return np.asarray(np.linalg.svd(J, compute_uv=False)[:, -1])


def _of_point(chain: ChainArrays, frames: Array, p_BT: Array) -> Array:
    """Return the Jacobian of a point of the interface for frames of the steps and its own, (m + 1, 4, 4)."""
    axes = frames[:-1, :3, 2]  # (m, 3)
    levers = p_BT - frames[:-1, :3, 3]  # (m, 3)
    slides = chain.slides[:, np.newaxis] > 0.0  # (m, 1)
    linear = np.where(slides, axes, cross(axes, levers))
    angular = np.where(slides, 0.0, axes)
    J = np.concatenate((linear, angular), axis=1).T  # of the steps
    return J if chain.parallel else np.asarray(J @ chain.spread[:, :-1])
