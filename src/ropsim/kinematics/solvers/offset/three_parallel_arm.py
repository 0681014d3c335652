"""Lengths, angles and frames of an arm with three parallel axes; symbols as in `three_parallel.py`."""

from math import atan2, cos, sin

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.solvers.axes import ANGLE_SLACK, ZeroFrames, across, along, angle_between
from ropsim.spatial import Array, frozen, record


@record
class ThreeParallelArm:
    """Lengths, angles and constant frames of an arm with three parallel axes.

    Attributes:
        lengths: (a, h, D, L2, L3, L4) [m]: axis 2 ahead of axis 1 and above frame J, lateral offset of the
            point P along axis 2, upper arm, forearm, axis 4 to P in the plane of the arm.
        eta: direction of the last of these over the first angle of the wrist [rad].
        signs: of the six joint coordinates in q_i = sign_i·(θ_i - zero_i), shape (6,).
        zeros: [rad], shape (6,).
        X_J: frame J in the base frame as (R_BJ, p_BJ), shape (3, 4).
        X_M: in M, the frame of joint 6 turned into the basis of the wrist, and the point P [m], shape (3, 4).
    """

    lengths: Array
    eta: float
    signs: Array
    zeros: Array
    X_J: Array
    X_M: Array

    def flat(self, slacks: tuple[float, float, float, float, float]) -> Array:
        """Return all fields in one array for the kernel, with its slacks at the end, shape (48,)."""
        parts = (self.lengths, self.eta, self.signs, self.zeros, self.X_J, self.X_M, slacks)
        return frozen(np.concatenate([np.ravel(part) for part in parts]))

    def turned(self, q: Array) -> tuple[float, float, float]:
        """Return how an arm at `q` [rad], shape (6,), stands.

        Returns:
            Distance of P ahead of axis 1 along e_x [m], and the angles of elbow and wrist, γ and β [rad].
        """
        _, shoulder, elbow, last, wrist, _ = (q * self.signs + self.zeros).tolist()
        a, _, _, upper, fore, end = self.lengths.tolist()
        first = -last - shoulder - elbow
        reach = upper * cos(shoulder) + fore * cos(shoulder + elbow) + end * cos(self.eta - first)
        return a + reach, elbow, wrist


def three_parallel_arm(chain: ChainArrays, frames: ZeroFrames, point: Array) -> ThreeParallelArm:
    """Return the geometry of an arm of the class.

    Args:
        chain: of the arm.
        frames: with all joints at zero, axes exactly as the class has them.
        point: P, where axes 5 and 6 meet, in J [m], shape (3,).
    """
    axes, origins = frames.axes, frames.p
    e_z, u = np.array([0.0, 0.0, 1.0]), axes[1]
    e_x = np.cross(e_z, u)
    basis = np.column_stack((e_x, -u, e_z))
    start, upper, fore, end = (
        complex(vector @ e_x, vector[2])
        for vector in (origins[1], origins[2] - origins[1], origins[3] - origins[2], point - origins[3])
    )
    beta_2, beta_3 = atan2(upper.imag, upper.real), atan2(fore.imag, fore.real)
    third, fourth = (1.0 if float(axis @ u) > 0.0 else -1.0 for axis in axes[2:4])
    a5 = basis.T @ axes[4]
    kappa = atan2(a5[0], a5[2])
    level = _about_y(kappa)
    a6 = level.T @ basis.T @ axes[5]
    lam = atan2(-a6[0], a6[1])
    signs = np.array([1.0, 1.0, third, fourth, 1.0, 1.0])
    # Θ1 = q1 + ., φ = q2 + β2, γ = ±q3 + β3 - β2, -α - φ - γ = ±q4 - κ - β3, β = q5 + λ, C = q6
    zeros = np.array([atan2(e_x[1], e_x[0]), beta_2, beta_3 - beta_2, -kappa - beta_3, lam, 0.0])
    wrist = frames.R[5].T @ basis @ level @ _about_z(lam)
    point_6 = frames.R[5].T @ (point - origins[5])
    return ThreeParallelArm(
        lengths=frozen([start.real, start.imag, point @ u, abs(upper), abs(fore), abs(end)]),
        eta=atan2(end.imag, end.real) + kappa,
        signs=frozen(signs),
        zeros=frozen(zeros + signs * chain.offset),
        X_J=frozen(np.column_stack((chain.R[0], chain.p[0]))),
        X_M=frozen(chain.X_nM[:, :3].T @ np.column_stack((wrist, point_6 - chain.X_nM[:, 3]))),
    )


def directions_missed(axes: Array) -> str:
    """Return the condition of the class that axes with these directions (6, 3) miss; empty for none."""

    def crooked(one: int, other: int) -> bool:
        return abs(float(axes[one] @ axes[other])) > ANGLE_SLACK

    if crooked(0, 1):
        return "axis 2 is not perpendicular to axis 1"
    if max(angle_between(axes[1], along(axes[1], axes[k])) for k in (2, 3)) > ANGLE_SLACK:
        return "axes 2, 3 and 4 are not parallel"
    if crooked(3, 4):
        return "axis 5 is not perpendicular to axis 4"
    if crooked(4, 5):
        return "axis 6 is not perpendicular to axis 5"
    return ""


def snapped_axes(axes: Array) -> Array:
    """Return axes that are exactly perpendicular and parallel where the class requires it, shape (6, 3)."""
    z2 = across(axes[1], axes[0])
    z5 = across(axes[4], z2)
    return np.array([axes[0], z2, along(axes[2], z2), along(axes[3], z2), z5, across(axes[5], z5)])


def _about_y(angle: float) -> Array:
    c, s = cos(angle), sin(angle)
    return np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])


def _about_z(angle: float) -> Array:
    c, s = cos(angle), sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
