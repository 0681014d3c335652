"""Recognise arms whose inverse kinematics has a closed form, and take their lengths from the geometry.

The class: six revolute joints, axes 2 and 3 parallel and perpendicular to axis 1, axes 4, 5, 6 meeting in
one point with 4 ⟂ 5 ⟂ 6 (Pieper 1968). It covers the PUMA with its lateral offset and the usual industrial
arms (the ortho-parallel basis with spherical wrist of Brandstötter, Angerer & Hofbaur 2014). Nothing is
read from a DH table: the axes are taken in their places at coordinate zero.

Frame J: placement of joint 1. Shoulder basis in J: e_z = axis 1, u = axis 2, e_x = e_z × u, so that
positive turns about u raise e_x towards e_z. With θ1 = direction of e_x about axis 1, θ2 and θ23 =
directions of the upper arm and of the forearm (axis 3 to wrist centre) in the plane (e_x, e_z), the wrist
centre is in J at
    Rz(θ1)·(x, -D, z),  x = a1 + L2·cos θ2 + L3·cos θ23,  z = h + L2·sin θ2 + L3·sin θ23.
"""

from functools import lru_cache
from math import atan2, cos, hypot

import numpy as np

from ropsim.kinematics.arrays import ChainArrays, chain_arrays
from ropsim.kinematics.diagnostics import NoClosedFormError
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array, frozen, record

ANGLE_SLACK = 1e-9
"""Directions count as parallel or perpendicular within this [rad]; finer than any drawing, above rounding."""
LENGTH_SLACK = 1e-9
"""Axes count as meeting within this [m]; poses are promised to 1e-9 m."""
SHORTEST_LINK = 1e-6
"""An upper arm or forearm shorter than this [m] cannot place the wrist."""


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

    def turned(self, q: Array) -> tuple[float, float, float]:
        """Return how an arm at `q` [rad], shape (6,), stands.

        Returns:
            Distance of the wrist centre ahead of axis 1 along e_x [m], and the angles θ3 and θ5 [rad].
        """
        _, shoulder, elbow, _, wrist, _ = (q * self.signs + self.zeros).tolist()
        a1, _, _, upper, fore = self.lengths.tolist()
        return a1 + upper * cos(shoulder) + fore * cos(shoulder + elbow), elbow, wrist


def has_closed_form(robot: RobotModel) -> bool:
    """Return whether `inverse` can solve this arm."""
    try:
        wrist_arm(robot)
    except NoClosedFormError:
        return False
    return True


@lru_cache(maxsize=64)
def wrist_arm(robot: RobotModel) -> WristArm:
    """Return the geometry of an arm of the class; computed once per model.

    Raises:
        NoClosedFormError: M550, with the condition that the arm misses.
    """
    if robot.n != 6:
        raise NoClosedFormError(robot.name, f"it has {robot.n} joints, the class has 6")
    for joint in robot.joints:
        if joint.type is not JointType.REVOLUTE:
            raise NoClosedFormError(robot.name, f"joint `{joint.name}` is prismatic")
    chain = chain_arrays(robot)
    rotations, origins = _zero_frames(chain)
    axes = rotations[:, :, 2]
    reason = _directions_missed(axes)
    wrist = origins[3] + ((origins[4] - origins[3]) @ axes[3]) * axes[3]  # on axis 4, nearest to axis 5
    if not reason and _distance(wrist, origins[3:], axes[3:]) > LENGTH_SLACK:
        reason = "axes 4, 5 and 6 do not meet in one point"
    if reason:
        raise NoClosedFormError(robot.name, reason)
    arm = _geometry(chain, rotations, origins, wrist)
    if min(arm.lengths[3], arm.lengths[4]) < SHORTEST_LINK:
        raise NoClosedFormError(robot.name, "the upper arm or the forearm has no length")
    return arm


def _zero_frames(chain: ChainArrays) -> tuple[Array, Array]:
    """Return rotations (6, 3, 3) and origins (6, 3) of the joint frames in J, all angles zero."""
    R, p = np.eye(3), np.zeros(3)
    rotations, origins = [R], [p]
    for i in range(1, 6):
        p = p + R @ chain.p[i]
        R = R @ chain.R[i]
        rotations.append(R)
        origins.append(p)
    return np.array(rotations), np.array(origins)


def _directions_missed(axes: Array) -> str:
    if abs(axes[0] @ axes[1]) > ANGLE_SLACK:
        return "axis 2 is not perpendicular to axis 1"
    if np.linalg.norm(np.cross(axes[1], axes[2])) > ANGLE_SLACK:
        return "axes 2 and 3 are not parallel"
    if abs(axes[3] @ axes[4]) > ANGLE_SLACK:
        return "axis 5 is not perpendicular to axis 4"
    if abs(axes[4] @ axes[5]) > ANGLE_SLACK:
        return "axis 6 is not perpendicular to axis 5"
    return ""


def _distance(point: Array, origins: Array, axes: Array) -> float:
    return float(np.linalg.norm(np.cross(axes, point - origins), axis=1).max())


def _geometry(chain: ChainArrays, rotations: Array, origins: Array, wrist: Array) -> WristArm:
    e_z, u = np.array([0.0, 0.0, 1.0]), rotations[1][:, 2]
    e_x = np.cross(e_z, u)
    upper, fore = origins[2] - origins[1], wrist - origins[2]
    a1, beta2, beta3 = float(origins[1] @ e_x), _direction(upper, e_x), _direction(fore, e_x)
    L2, L3 = hypot(upper @ e_x, upper[2]), hypot(fore @ e_x, fore[2])
    elbow_sign = 1.0 if float(rotations[2][:, 2] @ u) > 0.0 else -1.0
    before5, after5 = _split(chain.R[4])
    before6, after6 = _split(chain.R[5])
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
        R_F=frozen(_forearm(basis, rotations, chain, beta3)),
    )


def _forearm(basis: Array, rotations: Array, chain: ChainArrays, beta3: float) -> Array:
    """Return (Ry(β3)·basisᵀ·R_J3·R_34)ᵀ: the forearm frame has x from axis 3 to the wrist centre."""
    c, s = np.cos(beta3), np.sin(beta3)
    level = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
    return np.asarray((level @ basis.T @ rotations[2] @ chain.R[3]).T, dtype=np.float64)


def _direction(vector: Array, e_x: Array) -> float:
    return atan2(float(vector[2]), float(vector @ e_x))


def _split(R: Array) -> tuple[float, float]:
    """Return (a, b) with R = Rz(a)·Rx(π/2)·Rz(b), for a rotation whose z is perpendicular to the old z."""
    return atan2(R[0, 2], -R[1, 2]), atan2(R[2, 0], R[2, 1])
