"""The geometry of two links in a plane that turn about parallel axes, alone or with a rotation and a slide.

Frame J: the first revolute joint at coordinate zero, z along its axis 1. In its x-y plane Θ1 is the
direction of link 1 (axis 1 to axis 2) and γ = Θ2 - Θ1 the bend to link 2 (axis 2 to axis 3, or to the
interface of a two-link arm). ψ is the turn of the interface about z against coordinate zero, z its height.
With the lengths L1, L2 the end of link 2 is at
    L1·(cos Θ1, sin Θ1) + L2·(cos(Θ1 + γ), sin(Θ1 + γ)),
and the coordinates are q_i = sign_i·(v_i - zero_i) of v = (Θ1, γ, ψ - Θ1 - γ, z).
"""

from collections.abc import Sequence
from math import atan2, hypot

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.solutions.solver import Snap
from ropsim.kinematics.solvers.axes import ZeroFrames, along, angle_between
from ropsim.spatial import Array, frozen, record

REACH_SLACK = 1e-10
"""A cosine this far beyond ±1 is rounding at the edge of reach."""
WIDER = 3.0
"""The slacks of a snapped arm are this multiple of the error that its snap can make."""


@record
class PlanarArm:
    """Two links in a plane.

    Attributes:
        lengths: (L1, L2) [m].
        bend: sign and zero of the second joint, to determine the sense of the bend.
        second: its index.
        X_J: frame J in the base frame, shape (4, 4).
        R_M: rotation of M in J at coordinate zero, shape (3, 3).
        height: of the origin of M in J at coordinate zero [m].
        offset: of M from the end of link 2 there, in the plane [m], shape (2,).
        axis: number of the first revolute joint, from 1.
        flat: all of it for the kernel, shape (39,).
    """

    lengths: tuple[float, float]
    bend: tuple[float, float]
    second: int
    X_J: Array
    R_M: Array
    height: float
    offset: Array
    axis: str
    flat: Array

    def bend_at(self, q: Array) -> float:
        """Return γ [rad] of joint coordinates, shape (n,)."""
        sign, zero = self.bend
        return sign * float(q[self.second]) + zero

    def in_plane(self, X_BM: Array) -> tuple[Array, Array]:
        """Return rotation (3, 3), against coordinate zero, and position (3,) [m] of a pose in J."""
        R = self.X_J[:3, :3].T @ X_BM[:3, :3] @ self.R_M.T
        return R, self.X_J[:3, :3].T @ (X_BM[:3, 3] - self.X_J[:3, 3])


def planar_arm(chain: ChainArrays, frames: ZeroFrames, turning: Sequence[int], snapped_by: Snap) -> PlanarArm:
    """Return the geometry of an arm whose axes are all parallel.

    Args:
        chain: of the arm.
        frames: with all joints at zero, axes exactly parallel.
        turning: indices of the two or three revolute joints; the joint left over, if there is one, slides.
        snapped_by: the change that made the axes parallel.
    """
    first, second = turning[:2]
    X_J = np.eye(4)
    X_J[:3, :3] = chain.R[0] @ frames.R[first]
    X_J[:3, 3] = chain.p[0] + chain.R[0] @ frames.p[first]
    R = frames.R[first].T @ frames.R
    p = (frames.p - frames.p[first]) @ frames.R[first]
    R_M, p_M = R[-1] @ chain.X_nM[:, :3], R[-1] @ chain.X_nM[:, 3] + p[-1]
    end = p[turning[2]] if len(turning) > 2 else p_M
    link_1, link_2 = p[second], end - p[second]
    beta_1, beta_2 = atan2(link_1[1], link_1[0]), atan2(link_2[1], link_2[0])
    lengths = hypot(link_1[0], link_1[1]), hypot(link_2[0], link_2[1])
    slide = [i for i in range(len(p)) if i not in turning]
    joints = [*turning, -1][:3] + (slide or [-1])
    signs = [float(np.sign(R[i, 2, 2])) if i >= 0 else 0.0 for i in joints]
    values = (beta_1, beta_2 - beta_1, -beta_2, float(p_M[2]))  # v at coordinate zero, as ψ = 0 there
    zeros = [
        value + sign * (chain.offset[i] if i >= 0 else 0.0)
        for i, sign, value in zip(joints, signs, values, strict=True)
    ]
    beyond = WIDER * snapped_by.size * sum(lengths) / (min(lengths) or 1.0)
    offset = frozen((p_M - end)[:2])
    slacks = (REACH_SLACK + beyond, beyond)
    parts = (lengths, joints, signs, zeros, X_J[:3], R_M, offset, slacks)
    return PlanarArm(
        lengths,
        (signs[1], zeros[1]),
        second,
        frozen(X_J),
        frozen(R_M),
        float(p_M[2]),
        offset,
        str(first + 1),
        frozen(np.concatenate([np.ravel(part) for part in parts])),
    )


def rows(arm: PlanarArm, T: Array, near: Array) -> Array:
    """Return both branches of the plane for poses T (k, 4, 4), unchecked, shape (k, 2, n)."""
    from ropsim.kinematics.solvers.planar.planar_kernel import planar_rows

    out = np.empty((len(T), 2, len(near)))
    planar_rows(arm.flat, np.array(near), T, out)
    return out


def parallel(axes: Array) -> tuple[Array, float]:
    """Return axes that are all parallel to the first one, and the largest angle to before [rad]."""
    snapped = np.array([along(axis, axes[0]) for axis in axes])
    return snapped, max(map(angle_between, axes, snapped))
