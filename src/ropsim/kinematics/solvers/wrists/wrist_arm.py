"""Lengths, angles and constant frames of an arm with spherical wrist; symbols as in `spherical_wrist.py`."""

from math import atan2, cos, hypot

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.solvers.axes import (
    ANGLE_SLACK,
    LENGTH_SLACK,
    ZeroFrames,
    across,
    along,
    angle_between,
)
from ropsim.spatial import Array, frozen, record


@record
class WristArm:
    """Lengths, angles and constant frames of an arm with spherical wrist.

    Attributes:
        lengths: (a1, h, D, L2, L3) [m]: axis 2 ahead of axis 1 and above frame J, lateral offset of the wrist
            centre along axis 2, upper arm, forearm.
        signs: of the six joint coordinates in q_i = sign_i·(θ_i - zero_i), shape (6,).
        zeros: [rad], shape (6,).
        front: +1 where e_x points to the front of the arm, else -1.
        X_J: frame J in the base frame as (R_BJ, p_BJ), shape (3, 4).
        X_M: in M, the frame of joint 6 turned by Rx(π) and the wrist centre [m], shape (3, 4).
        R_F: frame of axis 4 in the forearm frame at zero, transposed, shape (3, 3).
    """

    lengths: Array
    signs: Array
    zeros: Array
    front: float
    X_J: Array
    X_M: Array
    R_F: Array

    def flat(self, slacks: tuple[float, float, float, float, float]) -> Array:
        """Return all fields in one array for the kernel, with its slacks at the end, shape (56,)."""
        parts = (self.lengths, self.signs, self.zeros, self.front, self.X_J, self.X_M, self.R_F, slacks)
        return frozen(np.concatenate([np.ravel(part) for part in parts]))

    def turned(self, q: Array) -> tuple[float, float, float]:
        """Return how an arm at `q` [rad], shape (6,), stands.

        Returns:
            Distance of the wrist centre ahead of axis 1 along e_x [m], and the angles θ3 and θ5 [rad].
        """
        _, shoulder, elbow, _, wrist, _ = (q * self.signs + self.zeros).tolist()
        a1, _, _, upper, fore = self.lengths.tolist()
        return a1 + upper * cos(shoulder) + fore * cos(shoulder + elbow), elbow, wrist


def wrist_arm(chain: ChainArrays, frames: ZeroFrames, wrist: Array) -> WristArm:
    """Return the geometry of an arm of the class.

    Args:
        chain: of the arm.
        frames: with all joints at zero, axes exactly as the class has them.
        wrist: wrist centre in J [m], shape (3,).
    """
    rotations, origins = frames.R, frames.p
    e_z, u = np.array([0.0, 0.0, 1.0]), rotations[1][:, 2]
    e_x = np.cross(e_z, u)
    upper, fore = origins[2] - origins[1], wrist - origins[2]
    a1, beta2, beta3 = float(origins[1] @ e_x), _direction(upper, e_x), _direction(fore, e_x)
    L2, L3 = hypot(upper @ e_x, upper[2]), hypot(fore @ e_x, fore[2])
    elbow_sign = 1.0 if float(rotations[2][:, 2] @ u) > 0.0 else -1.0
    before5, after5 = split(frames.steps[4])
    before6, after6 = split(frames.steps[5])
    # θ1 = q1 + ., θ2 = q2 + β2, γ = θ23 - θ2 = ±q3 + β3 - β2, wrist A = q4 + ., β = -q5 - ., C = -q6 - .
    zeros = (
        np.array([atan2(e_x[1], e_x[0]), beta2, beta3 - beta2, before5, -(after5 + before6), -after6])
        + np.array([1.0, 1.0, elbow_sign, 1.0, -1.0, -1.0]) * chain.offset
    )
    basis = np.column_stack((e_x, -u, e_z))
    turned = np.diag([1.0, -1.0, -1.0])  # Rx(π)
    w_6 = rotations[5].T @ (wrist - origins[5])
    return WristArm(
        lengths=frozen([a1, origins[1][2], wrist @ u, L2, L3]),
        signs=frozen([1.0, 1.0, elbow_sign, 1.0, -1.0, -1.0]),
        zeros=frozen(zeros),
        front=-1.0 if a1 < -LENGTH_SLACK else 1.0,
        X_J=frozen(np.column_stack((chain.R[0], chain.p[0]))),
        X_M=frozen(chain.X_nM[:, :3].T @ np.column_stack((turned, w_6 - chain.X_nM[:, 3]))),
        R_F=frozen(_forearm(basis, frames, beta3)),
    )


def _forearm(basis: Array, frames: ZeroFrames, beta3: float) -> Array:
    """Return (Ry(β3)·basisᵀ·R_J3·R_34)ᵀ: the forearm frame has x from axis 3 to the wrist centre."""
    c, s = np.cos(beta3), np.sin(beta3)
    level = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    return np.asarray((level @ basis.T @ frames.R[2] @ frames.steps[3]).T, dtype=np.float64)


def _direction(vector: Array, e_x: Array) -> float:
    return atan2(float(vector[2]), float(vector @ e_x))


def split(R: Array) -> tuple[float, float]:
    """Return (a, b) with R = Rz(a)·Rx(π/2)·Rz(b), for a rotation whose z is perpendicular to the old z."""
    return atan2(R[0, 2], -R[1, 2]), atan2(R[2, 0], R[2, 1])


def directions_missed(axes: Array) -> str:
    """Return the condition of the class that axes with these directions (6, 3) miss; empty for none."""

    def crooked(one: int, other: int) -> bool:
        return abs(float(axes[one] @ axes[other])) > ANGLE_SLACK

    if crooked(0, 1):
        return "axis 2 is not perpendicular to axis 1"
    if angle_between(axes[1], along(axes[1], axes[2])) > ANGLE_SLACK:
        return "axes 2 and 3 are not parallel"
    if crooked(3, 4):
        return "axis 5 is not perpendicular to axis 4"
    if crooked(4, 5):
        return "axis 6 is not perpendicular to axis 5"
    return ""


def snapped_axes(axes: Array) -> Array:
    """Return axes that are exactly perpendicular and parallel where the class requires it, shape (6, 3)."""
    z2 = across(axes[1], axes[0])
    z5 = across(axes[4], axes[3])
    return np.array([axes[0], z2, along(axes[2], z2), axes[3], z5, across(axes[5], z5)])
