"""Adding a correction to the joint references of a slice, so that speeds have no step."""

import numpy as np

from ropsim.controller.correction_room import ShiftedJoints
from ropsim.flow import JointReference


def shifted_reference(
    reference: JointReference, before: ShiftedJoints, after: ShiftedJoints, period: float
) -> JointReference:
    """Return references with what a correction adds: the cubic between what it adds at both ends.

    Coordinates and speeds are continuous from slice to slice, accelerations are those of the cubic. The
    reference itself is returned where nothing is added, bit by bit.

    Args:
        reference: planned rows for the control ticks of a slice.
        before: what is added one control tick before the first row.
        after: what is added at the last row.
        period: of a control tick [s].
    """
    if not any(part.any() for part in (before.q, before.qd, after.q, after.qd)):
        return reference
    time = reference.ticks * period
    s = (np.arange(1, reference.ticks + 1) / reference.ticks)[:, None]
    v0, v1, way = before.qd * time, after.qd * time, after.q - before.q
    c2, c3 = 3.0 * way - 2.0 * v0 - v1, v0 + v1 - 2.0 * way
    q = before.q + s * (v0 + s * (c2 + s * c3))
    qd = (v0 + s * (2.0 * c2 + s * 3.0 * c3)) / time
    q[-1], qd[-1] = after.q, after.qd
    qdd = (2.0 * c2 + s * 6.0 * c3) / (time * time)
    return JointReference(reference.q + q, reference.qd + qd, reference.qdd + qdd)
