"""What a correction adds to the joints, kept within what a move leaves of their speeds and accelerations."""

import numpy as np

from ropsim.controller.correction_room import PLANNED_ACCELERATION, PLANNED_SPEED, ShiftedJoints
from ropsim.model import RobotModel


def is_within_limits(before: ShiftedJoints, after: ShiftedJoints, time: float, robot: RobotModel) -> bool:
    """Return whether joints may go from what was added to what is to be added, on the cubic between both.

    Args:
        before: at the beginning of a slice.
        after: at its end.
        time: of the slice [s].
        robot: the arm.
    """
    v0, v1, mean = before.qd, after.qd, (after.q - before.q) / time
    speeds = np.abs((v0, v1, 1.5 * mean - 0.25 * (v0 + v1))).max(axis=0)
    ends = np.abs((6.0 * mean - 4.0 * v0 - 2.0 * v1, 2.0 * v0 + 4.0 * v1 - 6.0 * mean)).max(axis=0) / time
    allowed = (1.0 - PLANNED_SPEED) * robot.max_speeds, (1.0 - PLANNED_ACCELERATION) * robot.max_accelerations
    return bool((speeds <= allowed[0]).all() and (ends <= allowed[1]).all())


def braked(before: ShiftedJoints, time: float, robot: RobotModel) -> ShiftedJoints:
    """Return what is added where joints come to rest as quickly as they may.

    Args:
        before: at the beginning of a slice.
        time: of the slice [s].
        robot: the arm.
    """
    most = (1.0 - PLANNED_ACCELERATION) * robot.max_accelerations * time
    qd = before.qd - np.clip(before.qd, -most, most)
    return ShiftedJoints(before.q + 0.5 * (before.qd + qd) * time, qd)
