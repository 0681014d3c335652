"""Joint references shifted by a correction, within the limits left by a move."""

import numpy as np

from ropsim.controller.corrections.correction_room import ShiftedJoints
from ropsim.flow import JointReference
from ropsim.model import RobotModel
from ropsim.planning import PLANNED_ACCELERATION, PLANNED_SPEED


def is_within_limits(before: ShiftedJoints, after: ShiftedJoints, time: float, robot: RobotModel) -> bool:
    """Return whether joints may go from one shift to the next, on the cubic between both.

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
    """Return the shift with which joints come to rest as quickly as allowed.

    Args:
        before: at the beginning of a slice.
        time: of the slice [s].
        robot: the arm.
    """
    most = (1.0 - PLANNED_ACCELERATION) * robot.max_accelerations * time
    qd = before.qd - np.clip(before.qd, -most, most)
    return ShiftedJoints(before.q + 0.5 * (before.qd + qd) * time, qd)


def shifted_reference(
    reference: JointReference, before: ShiftedJoints, after: ShiftedJoints, period: float
) -> JointReference:
    """Return references shifted by a correction: the cubic between the shifts at both ends.

    Coordinates and speeds are continuous from slice to slice, accelerations come from the cubic. The
    reference itself is returned where nothing is added, bit by bit.

    Args:
        reference: planned rows for the control ticks of a slice.
        before: shift one control tick before the first row.
        after: shift at the last row.
        period: of a control tick [s].
    """
    if not any(part.any() for part in (before.q, before.qd, after.q, after.qd)):
        return reference
    time = reference.ticks * period
    s = (np.arange(1, reference.ticks + 1) / reference.ticks)[:, None]
    v0, v1, shift = before.qd * time, after.qd * time, after.q - before.q
    c2, c3 = 3.0 * shift - 2.0 * v0 - v1, v0 + v1 - 2.0 * shift
    q = before.q + s * (v0 + s * (c2 + s * c3))
    qd = (v0 + s * (2.0 * c2 + s * 3.0 * c3)) / time
    q[-1], qd[-1] = after.q, after.qd
    qdd = (2.0 * c2 + s * 6.0 * c3) / (time * time)
    return JointReference(reference.q + q, reference.qd + qd, reference.qdd + qdd)
