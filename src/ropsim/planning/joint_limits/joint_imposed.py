"""Path speed required at ticks at which joints cannot follow."""

from functools import lru_cache

import numpy as np

from ropsim.motion import ROUNDING, JointBounds, torques
from ropsim.planning.joint_limits.arm_limits import ArmBounds
from ropsim.planning.joint_limits.joint_imposed_kernel import AlongPath, OfJoints, limits_imposed
from ropsim.spatial import Array, record

_CREEP = 0.02
"""Share of the speed at which dry friction is as in motion and nothing else counts."""


@record
class JointImposedLimits:
    """Bounds along a path that joints set, h of them.

    Attributes:
        rows: in columns kind of the bound (of speed, acceleration or jerk), its value along the path, number
            of the tick, joint that sets it, and number of the quantity that it has too little of, of shape
            (5, h or more).
        count: of them, h.
        parameters: between which caps of each tick count, shape (2, b).
    """

    rows: Array
    count: int
    parameters: Array


@record
class EvaluatedPath:
    """A path at b ticks and at the ticks before them; two rows of each, the ticks before first.

    Attributes:
        parameters: on the path, shape (2, b).
        speeds: along it, shape (2, b).
        accelerations: along it, shape (2, b).
        jerks: along it, behind these times, shape (2, b).
        d1: first derivatives of the joints by the path parameter, shape (2, b, n).
        d2: second ones.
        q: joint coordinates at the ticks [rad | m], shape (b, n).
        qd: speeds [rad/s | m/s], of all motions that go on, shape (b, n).
        qdd: accelerations [rad/s² | m/s²] in the same order, shape (2, b, n).
        torque: at the ticks [N m | N], shape (b, n); None where it does not count.
    """

    parameters: Array
    speeds: Array
    accelerations: Array
    jerks: Array
    d1: Array
    d2: Array
    q: Array
    qd: Array
    qdd: Array
    torque: Array | None


def imposed_limits(
    evaluated: EvaluatedPath, arm: ArmBounds, period: float, used: float
) -> JointImposedLimits:
    """Return the joint-imposed limits along a path where joints are beyond their limits.

    With the path q(s), its speed v and acceleration a: q̈ = q″·v² + q′·a. The term with the greatest part in
    an excess is reduced by it, by no more than a half at once; if none is great, the speed is reduced, on
    which all terms depend. Where motions overlap, each is reduced by its part of the sum: reducing each by
    the whole excess would make both too slow; for torque each takes the whole excess. An excessive jerk is
    caused by the path, by speed and bend, or by the jerk along the path.

    Args:
        evaluated: the path at ticks at which a limit is exceeded.
        arm: limits of the joints.
        period: of the ticks [s].
        used: share of the limits that is aimed at, in ]0, 1].
    """
    rows, count = np.empty((5, 5 * evaluated.q.size)), np.empty(1)
    b, n = evaluated.q.shape
    slopes = evaluated.d1.reshape(2 * b, n), evaluated.d2.reshape(2 * b, n)
    path = AlongPath(
        evaluated.speeds.ravel(), evaluated.accelerations.ravel(), evaluated.jerks.ravel(), *slopes
    )
    joints = OfJoints(evaluated.qd, evaluated.qdd, _loads(evaluated, arm))
    limits = joint_limits(arm.joints, period)
    limits_imposed(path, joints, limits, period, used, 1.0 + ROUNDING, rows, count)
    return JointImposedLimits(rows, int(count[0]), evaluated.parameters)


@lru_cache(maxsize=16)
def joint_limits(joints: JointBounds, period: float) -> Array:
    """Return limits of speed, acceleration, change of acceleration in a tick, and torque, shape (4, n).

    Args:
        joints: their bounds.
        period: of the ticks [s].
    """
    effort = np.full(len(joints.speed), np.inf) if joints.effort is None else joints.effort
    return np.array([joints.speed, joints.acceleration, period * joints.jerk, effort])


def _loads(evaluated: EvaluatedPath, arm: ArmBounds) -> Array:
    """Return torques, and their parts proportional to the square of the speed and to the acceleration.

    Returns:
        shape (3, b, n) [N m | N], or (3, 0, n) where torque does not count.
    """
    if evaluated.torque is None or arm.effort is None or arm.joints.effort is None:
        return np.empty((3, 0, evaluated.q.shape[1]))
    nothing = np.zeros_like(evaluated.q)
    held = torques(arm.effort, evaluated.q, _CREEP * evaluated.qd, nothing)
    rest = torques(arm.effort, evaluated.q, nothing, nothing)
    gone = evaluated.d1[1] * evaluated.accelerations[1, :, None]
    along = torques(arm.effort, evaluated.q, nothing, gone) - rest
    return np.array((evaluated.torque, evaluated.torque - held - along, along))
