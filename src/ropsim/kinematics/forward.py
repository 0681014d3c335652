"""Forward kinematics: from joint coordinates to poses."""

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.arrays import ChainArrays, chain_arrays, joint_rows, joint_vector
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose


def forward(robot: RobotModel, q: npt.ArrayLike) -> Pose:
    """Return the pose X_BM of the mechanical interface in the base frame.

    The TCP of a tool is `forward(robot, q) @ tool.X_MT`.

    Args:
        robot: arm with n joints.
        q: joint coordinates [rad | m], shape (n,).

    Raises:
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
    """
    return Pose.from_matrix(joint_frames(robot, q)[-1])


def forward_batch(robot: RobotModel, Q: npt.ArrayLike) -> Array:
    """Return X_BM of many configurations as homogeneous matrices, shape (k, 4, 4); compiled.

    Args:
        robot: arm with n joints.
        Q: joint coordinates [rad | m], shape (k, n); a row with NaN gives a matrix with NaN.

    Raises:
        ArrayShapeError: M551, Q has another shape.
    """
    from ropsim.kinematics.forward_kernel import forward_rows

    rows = joint_rows(robot, Q)
    chain = chain_arrays(robot)
    out = np.empty((len(rows), 4, 4))
    forward_rows(chain.R, chain.p, chain.slides, chain.offset, chain.X_nM, rows, out)
    return out


def joint_frames(robot: RobotModel, q: npt.ArrayLike) -> Array:
    """Return the frames of all joints, moved by q, and of the mechanical interface.

    Args:
        robot: arm with n joints.
        q: joint coordinates [rad | m], shape (n,).

    Returns:
        Homogeneous matrices in the base frame, shape (n + 1, 4, 4); row i has the axis of joint i + 1 as z,
        the last row is X_BM.

    Raises:
        ArrayShapeError: M551, q has another shape.
        NotFiniteError: M552, q holds NaN or infinity.
    """
    frames: Array = frames_of(chain_arrays(robot), joint_vector(robot, q)[np.newaxis])[0]
    return frames


def frames_batch(robot: RobotModel, Q: npt.ArrayLike) -> Array:
    """Return `joint_frames` of many configurations Q (k, n), shape (k, n + 1, 4, 4).

    Raises:
        ArrayShapeError: M551, Q has another shape.
    """
    return frames_of(chain_arrays(robot), joint_rows(robot, Q))


def frames_of(chain: ChainArrays, rows: Array) -> Array:
    """Return the frames of all joints and of the interface for rows (k, n), shape (k, n + 1, 4, 4)."""
    count, n = rows.shape
    moved = rows + chain.offset
    angles, shifts = moved * (1.0 - chain.slides), moved * chain.slides
    co, si = np.cos(angles)[..., np.newaxis], np.sin(angles)[..., np.newaxis]  # (k, n, 1)
    x, y, z = chain.R[:, :, 0], chain.R[:, :, 1], chain.R[:, :, 2]  # (n, 3)
    steps = np.zeros((count, n + 1, 4, 4))  # each joint frame in the one before it
    steps[:, :, 3, 3] = 1.0
    steps[:, :n, :3, 0] = x * co + y * si
    steps[:, :n, :3, 1] = y * co - x * si
    steps[:, :n, :3, 2] = z
    steps[:, :n, :3, 3] = chain.p + z * shifts[..., np.newaxis]
    steps[:, n, :3] = chain.X_nM
    for i in range(1, n + 1):
        steps[:, i] = steps[:, i - 1] @ steps[:, i]  # now in the base frame
    return steps
