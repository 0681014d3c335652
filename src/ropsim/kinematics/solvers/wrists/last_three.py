"""Three last joints whose axes meet in one point, each perpendicular to the one before: their angles.

With N = R_34ᵀ·R_B3ᵀ·R_BM·R_6Mᵀ·Rx(π) motions of joints 4 to 6 solve N = Rz(A)·Ry(β)·Rz(C); symbols and both
answers as in `spherical_wrist_kernel.py`, for arrays of rotations.
"""

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.solvers.axes import ANGLE_SLACK, LENGTH_SLACK, ZeroFrames, across, distance
from ropsim.kinematics.solvers.wrists.wrist_arm import split
from ropsim.spatial import Array, frozen, record

ALIGNED = 1e-10
"""With sin β below this axes 4 and 6 count as one line; the error stays below the promised accuracy."""
_TURNED = np.diag([1.0, -1.0, -1.0])  # Rx(π)


@record
class LastThree:
    """Joints 4 to 6 of an arm, of which all motions are zero where its frames are given.

    Attributes:
        centre: where their axes meet, in frame J of the arm [m], shape (3,).
        R_34: joint frame 4 in that of joint 3, shape (3, 3).
        R_6M: interface in joint frame 6, shape (3, 3).
        zeros: (b, a, c) with A = m4 + b, β = -(m5 + a), C = -(m6 + c) for motions m [rad], shape (3,).
    """

    centre: Array
    R_34: Array
    R_6M: Array
    zeros: Array

    def motions(self, R_B3: Array, R_BM: Array, m4: Array) -> Array:
        """Return the two answers of each orientation, shape (..., 2, 3) [rad]: joint 5 turned back, then on.

        Args:
            R_B3: frame 3, moved, shape (..., 3, 3).
            R_BM: interface, shape (..., 3, 3).
            m4: motion of joint 4 where axes 4 and 6 are one line [rad], shape ().
        """
        N = self.R_34.T @ np.swapaxes(R_B3, -1, -2) @ R_BM @ (self.R_6M.T @ _TURNED)
        tilt = np.hypot(N[..., 0, 2], N[..., 1, 2])
        line = tilt < ALIGNED
        A = np.where(line, m4 + self.zeros[0], np.arctan2(N[..., 1, 2], N[..., 0, 2]))
        beta = np.where(line, np.where(N[..., 2, 2] > 0.0, 0.0, np.pi), np.arctan2(tilt, N[..., 2, 2]))
        c, s = np.cos(A), np.sin(A)
        C = np.arctan2(c * N[..., 1, 0] - s * N[..., 0, 0], c * N[..., 1, 1] - s * N[..., 0, 1])
        on = np.stack((A, beta, C), axis=-1)
        turn = np.where(line[..., np.newaxis], 0.0, np.pi)
        back = on * np.array([1.0, -1.0, 1.0]) + turn * np.array([1.0, 0.0, 1.0])
        both = np.stack((back, on), axis=-2)  # β of joint 5 turned on is negative in its own count
        return np.asarray(both * np.array([1.0, -1.0, -1.0]) - self.zeros)

    def flip(self, m5: float) -> float:
        """Return β for a motion of joint 5 [rad]: positive where it is turned on from a straight wrist."""
        return -(m5 + float(self.zeros[1]))


def last_three(chain: ChainArrays, frames: ZeroFrames) -> tuple[LastThree, float] | str:
    """Return the wrist of an arm with six joints and the miss of its axes [m], or why it has no wrist.

    Args:
        chain: of the arm.
        frames: with all motions at zero, axes exactly as `snapped_wrist` has them.
    """
    z4, z5 = frames.axes[3], frames.axes[4]
    centre = frames.p[3] + ((frames.p[4] - frames.p[3]) @ z4) * z4  # on axis 4, nearest to axis 5
    apart = distance(centre, frames.p[3:], np.array([z4, z5, frames.axes[5]]))
    if apart > LENGTH_SLACK:
        return "axes 4, 5 and 6 do not meet in one point"
    before5, after5 = split(frames.steps[4])
    before6, after6 = split(frames.steps[5])
    zeros = np.array([before5, after5 + before6, after6])
    return LastThree(frozen(centre), frozen(frames.steps[3]), frozen(chain.X_nM[:, :3]), frozen(zeros)), apart


def wrist_missed(axes: Array) -> str:
    """Return the condition that the directions of axes (6, 3) miss; empty for none."""
    for one, other in ((3, 4), (4, 5)):
        if abs(float(axes[one] @ axes[other])) > ANGLE_SLACK:
            return f"axis {other + 1} is not perpendicular to axis {one + 1}"
    return ""


def snapped_wrist(axes: Array) -> Array:
    """Return axes (6, 3) of which 5 is exactly perpendicular to 4, and 6 to 5."""
    z5 = across(axes[4], axes[3])
    return np.array([*axes[:4], z5, across(axes[5], z5)])
