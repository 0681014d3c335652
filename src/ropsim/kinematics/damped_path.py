"""Damped least squares: joint coordinates along a path, bounded where the arm passes a singular pose."""

import math

import numpy as np

from ropsim.kinematics.chain.jacobian import frame_and_jacobian
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose, record

NEAR = 0.05
"""Least singular value of the Jacobian [m, rad] below which its direction is damped."""
MOST_DAMPING = 0.02
"""Damping at a singular pose [m, rad]; a step of the pose moves no joint by more than 30 times as much."""
CATCH_UP = 0.02
"""Way [m, rad] on which what damping has left behind is made good, by a factor of e."""


@record
class DampedPath:
    """Joint coordinates along a path, and how far they leave the tool beside it.

    Attributes:
        q: joint coordinates [rad | m], shape (k, n).
        distance: greatest distance of the TCP from its poses [m].
        turn: greatest turn of the tool away from them [rad].
    """

    q: Array
    distance: float
    turn: float


def damped_path(robot: RobotModel, X_BT: Array, q_start: Array, X_MT: Pose) -> DampedPath:
    """Return joint coordinates along a path, each from the one before it by damped least squares.

    dq = Σ v·(u·dx)·σ/(σ² + λ²) over the singular values σ of the Jacobian, with λ² = λ0²·(1 - (σ/ε)²)² for
    those below ε and 0 for all others. Away from singular poses that is Newton's step, and the poses are met;
    near one what the arm lacks in a direction that it loses is left behind, and made good gradually.

    Args:
        robot: arm without external axes, of six axes or more.
        X_BT: poses of the tool, each a small step from the other, shape (k, 4, 4).
        q_start: joint coordinates at the first of them [rad | m], shape (n,).
        X_MT: tool frame in the mechanical interface frame.

    References:
        Maciejewski and Klein 1988, J. Robotic Systems 5(6), for damping the lost direction alone.
        Nakamura and Hanafusa 1986, ASME J. Dyn. Syst. Meas. Control 108(3), for damping by the distance.
        Chiaverini, Siciliano and Egeland 1994, IEEE Trans. Control Systems Technology 2(2), for the feedback.
    """
    q, found = np.array(q_start, dtype=np.float64), np.empty((len(X_BT), len(q_start)))
    distance = turn = 0.0
    for k, X in enumerate(X_BT):
        if k:
            step = _difference(X_BT[k - 1], X)
            share = 1.0 - math.exp(-float(np.linalg.norm(step)) / CATCH_UP)
            middle = q + 0.5 * damped_step(frame_and_jacobian(robot, q, X_MT)[1], step, 1.0)
            q = q + damped_step(frame_and_jacobian(robot, middle, X_MT)[1], step, 1.0)
            for _ in range(2):
                X_now, J = frame_and_jacobian(robot, q, X_MT)
                q = q + damped_step(J, _difference(X_now, X), share)
        found[k] = q
        left = _difference(frame_and_jacobian(robot, q, X_MT)[0], X)
        distance = max(distance, float(np.linalg.norm(left[:3])))
        turn = max(turn, float(np.linalg.norm(left[3:])))
    return DampedPath(found, distance, turn)


def damped_step(J: Array, dx: Array, share: float) -> Array:
    """Return the step of the joints for one of the pose, shape (n,); see `damped_path`.

    Args:
        J: Jacobian, shape (6, n).
        dx: step of the pose, linear and angular, shape (6,).
        share: of the step in directions at a singular pose; the nearer to it, the more it counts.
    """
    u, sigma, v = np.linalg.svd(J, full_matrices=False)
    weights = (1.0 - np.minimum(sigma / NEAR, 1.0) ** 2) ** 2
    gains = sigma / (sigma**2 + MOST_DAMPING**2 * weights) * (1.0 - weights * (1.0 - share))
    return np.asarray(v.T @ (gains * (u.T @ dx)))


def _difference(X_from: Array, X_to: Array) -> Array:
    """Return the step from a pose to another one in base coordinates, linear and angular, shape (6,)."""
    R = X_to[:3, :3] @ X_from[:3, :3].T
    turn = 0.5 * np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    sine = float(np.linalg.norm(turn))
    if sine > 0.0:
        turn *= math.atan2(sine, 0.5 * (float(np.trace(R)) - 1.0)) / sine
    return np.concatenate((X_to[:3, 3] - X_from[:3, 3], turn))
