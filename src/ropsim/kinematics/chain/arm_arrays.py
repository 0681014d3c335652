"""The arrays of any arm: of a chain whose steps are linear in the axes, or of closed chains."""

from functools import lru_cache

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.chain.closed_arrays import ClosedArrays, closed_arrays
from ropsim.kinematics.chain.closed_motion import jacobians_of_loops
from ropsim.kinematics.chain.forward import frames_of
from ropsim.kinematics.chain.linear_loops import without_linear_loops
from ropsim.model import Mechanism
from ropsim.spatial import Array

ArmArrays = ChainArrays | ClosedArrays


@lru_cache(maxsize=64)
def arm_arrays(robot: Mechanism) -> ArmArrays:
    """Return the arrays of an arm for searches of joint coordinates.

    Raises:
        MechanismError: the mechanism cannot be.
    """
    linear = without_linear_loops(robot)
    return closed_arrays(linear) if linear.cuts else chain_arrays(linear)


def turning_axes(robot: Mechanism) -> Array:
    """Return 1.0 for axes whose whole turns change no pose of the interface, else 0.0, shape (n,)."""
    return arm_arrays(robot).turning


def interface_poses(arm: ArmArrays, rows: Array) -> Array:
    """Return X_BM for axes at rows (k, n), shape (k, 4, 4)."""
    if isinstance(arm, ClosedArrays):
        return jacobians_of_loops(arm, rows, np.eye(4))[0]
    return np.asarray(frames_of(arm, rows)[:, -1])
