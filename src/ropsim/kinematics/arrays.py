"""What kernels need of a robot as plain arrays, made once per robot, and checks of arrays at the door."""

from functools import lru_cache

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.diagnostics import ArrayShapeError, NotFiniteError
from ropsim.model import JointType, RobotModel, interface_matrices, placement_matrices
from ropsim.spatial import Array, frozen, real_numbers, record


@record
class ChainArrays:
    """The kinematic chain of a robot with n joints.

    Attributes:
        R: rotation of each joint frame at coordinate 0 in the frame before it, shape (n, 3, 3).
        p: its origin [m], shape (n, 3).
        slides: 1.0 for a prismatic joint, 0.0 for a revolute one, shape (n,).
        offset: added to each coordinate [rad | m], shape (n,).
        X_nM: mechanical interface in the last joint's frame as (R_nM, p_nM), shape (3, 4).
        flat: all of it for kernels that take one array: for each joint R by rows, p, slides, offset, then
            R_nM by rows and p_nM; shape (14·n + 12,).
    """

    R: Array
    p: Array
    slides: Array
    offset: Array
    X_nM: Array
    flat: Array


@lru_cache(maxsize=64)
def chain_arrays(robot: RobotModel) -> ChainArrays:
    """Return the chain of a robot as arrays; computed once per model."""
    rotations, positions = placement_matrices(robot)
    R_nM, p_nM = interface_matrices(robot)
    slides = [float(joint.type is JointType.PRISMATIC) for joint in robot.joints]
    offset = [joint.offset for joint in robot.joints]
    rows = np.column_stack((rotations.reshape(-1, 9), positions, slides, offset))
    return ChainArrays(
        R=frozen(rotations),
        p=frozen(positions),
        slides=frozen(slides),
        offset=frozen(offset),
        X_nM=frozen(np.column_stack((R_nM, p_nM))),
        flat=frozen(np.concatenate((rows.ravel(), R_nM.ravel(), p_nM))),
    )


def joint_vector(robot: RobotModel, q: npt.ArrayLike) -> Array:
    """Return joint coordinates [rad | m] as an array of shape (n,).

    Raises:
        ArrayShapeError: M551, another shape.
        NotFiniteError: M552, NaN, infinity or no numbers.
    """
    array = _numbers("q", q)
    if array.shape != (robot.n,):
        raise ArrayShapeError("q", array.shape, f"({robot.n},)")
    if not np.isfinite(array).all():
        raise NotFiniteError("q")
    return array


def joint_rows(robot: RobotModel, Q: npt.ArrayLike) -> Array:
    """Return k rows of joint coordinates [rad | m] as a contiguous array of shape (k, n); NaN may pass.

    Raises:
        ArrayShapeError: M551, another shape.
        NotFiniteError: M552, no numbers.
    """
    array = np.ascontiguousarray(_numbers("Q", Q))
    if array.ndim != 2 or array.shape[1] != robot.n:
        raise ArrayShapeError("Q", array.shape, f"(k, {robot.n})")
    return array


def pose_rows(T: npt.ArrayLike) -> Array:
    """Return k homogeneous matrices as a contiguous array of shape (k, 4, 4); NaN may pass.

    Raises:
        ArrayShapeError: M551, another shape.
        NotFiniteError: M552, no numbers.
    """
    array = np.ascontiguousarray(_numbers("T", T))
    if array.ndim != 3 or array.shape[1:] != (4, 4):
        raise ArrayShapeError("T", array.shape, "(k, 4, 4)")
    return array


def _numbers(name: str, values: npt.ArrayLike) -> Array:
    """Return any array as float64."""
    array = real_numbers(values)
    if array is None:
        raise NotFiniteError(name, "something that is no real number")
    return array
