"""Lengths, angles and constant frames of an arm with a swivel angle; symbols as in `swivel.py`."""

from math import atan2, cos, hypot, sin

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.solvers.axes import ANGLE_SLACK, ZeroFrames, across
from ropsim.spatial import Array, frozen, record

ALIGNED = 1e-9
"""A line from S to W this near to the direction of axis 1 [rad] has no plane with it."""


@record
class SwivelArm:
    """Geometry of an arm whose shoulder and wrist are spherical; all of it in J, at coordinate zero.

    Attributes:
        zeros: of the seven joint coordinates in q_i = θ_i - zero_i, shape (7,).
        height: of S on axis 1 [m].
        u, r: from S to axis 4 and from there to W [m], shape (3,).
        axis: direction of axis 4, shape (3,).
        lengths: (L∥, Lu, Lr) [m]: of u + r along axis 4, of u and r across it.
        phi: angle from u to r about axis 4 [rad].
        shoulder, wrist: K and K·Ry(μ) of both, shape (2, 3, 3).
        X_J: frame J in the base frame as (R_BJ, p_BJ), shape (3, 4).
        X_M: in M, orientation of frame J at coordinate zero, and W [m], shape (3, 4).
    """

    zeros: Array
    height: float
    u: Array
    r: Array
    axis: Array
    lengths: Array
    phi: float
    shoulder: Array
    wrist: Array
    X_J: Array
    X_M: Array

    def flat(self, slacks: tuple[float, float, float, float]) -> Array:
        """Return all fields in one array for the kernel, with its slacks at the end, shape (85,)."""
        parts = (self.zeros, self.height, self.u, self.r, self.axis, self.lengths, self.phi)
        frames = (self.shoulder, self.wrist, self.X_J, self.X_M, slacks)
        return frozen(np.concatenate([np.ravel(part) for part in (*parts, *frames)]))

    def turned(self, q: Array) -> tuple[float, float, float]:
        """Return the angles of shoulder, elbow and wrist [rad] at q (7,), each 0 or π where singular."""
        theta = q + self.zeros
        return float(theta[1]), float(theta[3]), float(theta[5])

    def swivel(self, q: Array) -> float:
        """Return the swivel angle at q (7,) [rad], in (-π, π]."""
        theta = (q + self.zeros).tolist()
        Z = (_about_z(theta[0]), _about_y(theta[1]), _about_z(theta[2]))
        R = self.shoulder[0] @ Z[0] @ Z[1] @ Z[2] @ self.shoulder[1].T
        c, s = cos(theta[3] - self.phi), sin(theta[3] - self.phi)
        along = self.axis * (self.axis @ self.r)
        turned = along + (self.r - along) * c + np.cross(self.axis, self.r) * s
        w = R @ (self.u + turned)
        w /= np.linalg.norm(w)
        n = R @ self.axis * (1.0 if sin(theta[3]) >= 0.0 else -1.0)
        level = (
            np.array([-w[1], w[0], 0.0])
            if hypot(w[0], w[1]) > ALIGNED * abs(w[2])
            else np.array([0.0, 1.0, 0.0])
        )
        return atan2(float(n @ np.cross(w, level)), float(n @ level))

    def swivels(self, Q: Array) -> Array:
        """Return the swivel angles at rows of joint coordinates (k, 7) [rad], in (-π, π], shape (k,)."""
        theta = Q + self.zeros
        K, L = self.shoulder
        R = K @ euler_turns(theta[:, :3]) @ L.T
        c, s = (part(theta[:, 3:4] - self.phi) for part in (np.cos, np.sin))
        along = self.axis * (self.axis @ self.r)
        turned = along + (self.r - along) * c + np.cross(self.axis, self.r) * s
        w = (R @ (self.u + turned)[:, :, np.newaxis])[:, :, 0]
        w /= np.linalg.norm(w, axis=1, keepdims=True)
        n = R @ self.axis * np.where(np.sin(theta[:, 3:4]) >= 0.0, 1.0, -1.0)
        steep = np.hypot(w[:, 0], w[:, 1]) <= ALIGNED * np.abs(w[:, 2])
        level = np.column_stack((-w[:, 1], w[:, 0], np.zeros(len(w))))
        level[steep] = [0.0, 1.0, 0.0]
        sine, cosine = (n * np.cross(w, level)).sum(axis=1), (n * level).sum(axis=1)
        return np.asarray(np.arctan2(sine, cosine))


def euler_turns(angles: Array) -> Array:
    """Return Rz(A)·Ry(B)·Rz(C) of rows of three angles (..., 3) [rad], shape (..., 3, 3)."""
    (a, b, c), (s, t, u) = np.moveaxis(np.cos(angles), -1, 0), np.moveaxis(np.sin(angles), -1, 0)
    rows = (
        (a * b * c - s * u, -a * b * u - s * c, a * t),
        (s * b * c + a * u, -s * b * u + a * c, s * t),
        (-t * c, t * u, b),
    )
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def swivel_arm(chain: ChainArrays, frames: ZeroFrames, S: Array, W: Array) -> SwivelArm:
    """Return the geometry of an arm of the class.

    Args:
        chain: of the arm.
        frames: with all joints at zero, axes exactly as the class has them.
        S: where axes 1, 2 and 3 meet, in J [m], shape (3,).
        W: where axes 5, 6 and 7 meet, in J [m], shape (3,).
    """
    axes, axis = frames.axes, frames.axes[3]
    u, r = frames.p[3] - S, W - frames.p[3]
    flat_u, flat_r = (vector - (vector @ axis) * axis for vector in (u, r))
    phi = atan2(float(axis @ np.cross(flat_u, flat_r)), float(flat_u @ flat_r))
    shoulder, mu = _euler(axes[:3])
    wrist, nu = _euler(axes[4:])
    zeros = chain.offset + np.array([0.0, mu, 0.0, phi, 0.0, nu, 0.0])
    back = frames.R[6].T
    return SwivelArm(
        zeros=frozen(zeros),
        height=float(S[2]),
        u=frozen(u),
        r=frozen(r),
        axis=frozen(axis),
        lengths=frozen([(u + r) @ axis, np.linalg.norm(flat_u), np.linalg.norm(flat_r)]),
        phi=phi,
        shoulder=shoulder,
        wrist=wrist,
        X_J=frozen(np.column_stack((chain.R[0], chain.p[0]))),
        X_M=frozen(
            chain.X_nM[:, :3].T @ np.column_stack((back, back @ (W - frames.p[6]) - chain.X_nM[:, 3]))
        ),
    )


def directions_missed(axes: Array) -> str:
    """Return the condition of the class that axes with these directions (7, 3) miss; empty for none."""
    for one in (0, 1, 4, 5):
        if abs(float(axes[one] @ axes[one + 1])) > ANGLE_SLACK:
            return f"axis {one + 2} is not perpendicular to axis {one + 1}"
    return ""


def snapped_axes(axes: Array) -> Array:
    """Return axes that are exactly perpendicular where the class requires it, shape (7, 3)."""
    z2, z6 = across(axes[1], axes[0]), across(axes[5], axes[4])
    return np.array([axes[0], z2, across(axes[2], z2), axes[3], axes[4], z6, across(axes[6], z6)])


def _euler(axes: Array) -> tuple[Array, float]:
    """Return (K, K·Ry(μ)) and μ: turns about axes (3, 3) are K·Rz·Ry·Rz·(K·Ry(μ))ᵀ, the second one plus μ."""
    K = np.column_stack((np.cross(axes[1], axes[0]), axes[1], axes[0]))
    last = K.T @ axes[2]
    mu = atan2(last[0], last[2])
    return frozen(np.array([K, K @ _about_y(mu)])), mu


def _about_y(angle: float) -> Array:
    c, s = cos(angle), sin(angle)
    return np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])


def _about_z(angle: float) -> Array:
    c, s = cos(angle), sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
