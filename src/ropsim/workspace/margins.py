"""Quality of a configuration: margins to the limits of its joints, and manipulability."""

import numpy as np

from ropsim.kinematics import jacobian_at
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose, record


@record
class Margin:
    """The joint that is nearest to a limit.

    Attributes:
        share: margin to it, as a share of half of the range: 0 at a limit, 1 in the middle.
        joint: number of the axis from 0; -1 where no axis has limits.
        left: the same [rad | m].
    """

    share: float
    joint: int
    left: float


def margin(robot: RobotModel, q: Array) -> Margin:
    """Return the least margin of the axes at q [rad | m], shape (n,)."""
    found = shares(robot, q)
    k = int(np.argmin(found))
    if not np.isfinite(found[k]):
        return Margin(1.0, -1, np.inf)
    left = min(q[k] - robot.lower_limits[k], robot.upper_limits[k] - q[k])
    return Margin(float(found[k]), k, float(left))


def shares(robot: RobotModel, Q: Array) -> Array:
    """Return the margins to the limits as shares of half ranges, (..., n); inf for axes without any."""
    left = np.minimum(Q - robot.lower_limits, robot.upper_limits - Q)
    half = 0.5 * (robot.upper_limits - robot.lower_limits)
    limited = np.isfinite(half) & (half > 0.0)
    return np.where(limited, left / np.where(limited, half, 1.0), np.inf)


def manipulability(robot: RobotModel, q: Array, X_MT: Pose, reach: float) -> float:
    """Return √det(J·Jᵀ) of Yoshikawa (1985) with lengths in units of the reach of the arm.

    So it has no unit and arms of different size can be compared; it is 0 where the arm is singular. Of an arm
    with fewer than six axes it is √det(Jᵀ·J), the volume of the velocities of its axes.

    Args:
        robot: the arm.
        q: axes [rad | m], shape (n,).
        X_MT: tool frame in the frame of the mechanical interface.
        reach: unit of lengths [m].
    """
    J = jacobian_at(robot, q, X_MT)
    J = np.concatenate((J[:3] / reach, J[3:]))
    return float(np.prod(np.linalg.svd(J, compute_uv=False)))
