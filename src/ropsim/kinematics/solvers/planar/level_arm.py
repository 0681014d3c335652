"""Lengths, angles and constant frames of an arm with a level wrist; symbols as in `level_wrist.py`."""

from math import atan2, cos, sin

import numpy as np

from ropsim.kinematics.chain.arrays import ChainArrays
from ropsim.kinematics.solvers.axes import ZeroFrames
from ropsim.spatial import Array, frozen, record


@record
class LevelArm:
    """Lengths and constant frames of an arm of the class.

    Attributes:
        lengths: (L2, L3) [m].
        shoulder: (a, h) including the contribution of the level wrist [m].
        lateral: D [m].
        directions: angle of e_x in J, and of the two links over e_x at coordinate zero [rad].
        sign: of axis 3 against axis 2.
        X_J: frame J in the base frame, shape (4, 4).
        R_5: orientation of axis 5 with the column at zero, in J, shape (3, 3).
        from_steps: coordinates of the axes from coordinates of the steps 1, 2, 3, 5, as (T⁻¹, c), shape (4,
            5).
    """

    lengths: tuple[float, float]
    shoulder: tuple[float, float]
    lateral: float
    directions: tuple[float, float, float]
    sign: float
    X_J: Array
    R_5: Array
    from_steps: Array


def level_arm(chain: ChainArrays, frames: ZeroFrames, level: float, sign: float) -> LevelArm:
    """Return the geometry of an arm of the class, whose wrist is turned by `level` about axis 2 [rad]."""
    e_z = np.array([0.0, 0.0, 1.0])
    u = frames.axes[1] - (frames.axes[1] @ e_z) * e_z
    u = u / np.linalg.norm(u)
    e_x = np.cross(e_z, u)
    links = [frames.p[k + 1] - frames.p[k] for k in (1, 2, 3)]
    flat = [complex(link @ e_x, link[2]) for link in links]
    wrist = flat[2] * complex(cos(level), sin(level))
    start = complex(frames.p[1] @ e_x, frames.p[1][2])
    X_J = np.eye(4)
    X_J[:3, :3], X_J[:3, 3] = chain.R[0], chain.p[0]
    four = [0, 1, 2, 4]
    inverse = np.round(np.linalg.inv(chain.spread[four, :-1]), 12)
    return LevelArm(
        lengths=(abs(flat[0]), abs(flat[1])),
        shoulder=((start + wrist).real, (start + wrist).imag),
        lateral=float(u @ frames.p[4]),
        directions=(
            atan2(e_x[1], e_x[0]),
            atan2(flat[0].imag, flat[0].real),
            atan2(flat[1].imag, flat[1].real),
        ),
        sign=sign,
        X_J=frozen(X_J),
        R_5=frozen(_about(u, level) @ frames.R[4]),
        from_steps=frozen(np.column_stack((inverse, chain.spread[four, -1]))),
    )


def _about(axis: Array, angle: float) -> Array:
    x, y, z = axis.tolist()
    W = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + sin(angle) * W + (1.0 - cos(angle)) * W @ W)
