"""Shares of limits that a motion takes, and whether a trace shows the change of one."""

import numpy as np

from ropsim.calibration.limits import ORDERS, MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence
from ropsim.calibration.replanning import difference
from ropsim.kinematics import jacobians_at
from ropsim.model import RobotModel
from ropsim.planning import MotionPlan
from ropsim.spatial import Array

RAISED = 1.1
"""Factor by which a limit is raised to see whether the motion is at it."""
_NOISE, _LEAST = 3.0, 2e-5
"""By how much the joints are elsewhere then: a number of encoder steps, and a tolerance [rad | m]."""

_PARTS = (slice(0, 3), slice(3, 6))
"""Rows of the Jacobian for the TCP and for the orientation."""
_OWN_SPEED = 1e-6
"""Share by which the speed of a move differs from that of the controller if the program sets it."""


def is_felt(logged: LoggedSequence, motion: MotionPlan, higher: MotionPlan) -> bool:
    """Return whether a motion with a higher limit differs measurably in a trace.

    Args:
        logged: the sequence.
        motion: with the present limit.
        higher: the same with a limit that is `RAISED`.
    """
    least = _NOISE * float(logged.noise.max()) + _LEAST
    return higher.ticks <= motion.ticks and difference(motion, higher) > least


def largest(motion: MotionPlan, settings: MotionSettings) -> Array:
    """Return the largest speeds, accelerations and jerks of the joints in a motion, as limits: shape (3, n).

    Where a move has the joints for itself, they are divided by the shares of the limits that the program
    allows.
    """
    n = settings.joints.shape[1]
    reference = motion.reference
    jerk = np.diff(reference.qdd, axis=0, prepend=0.0) / motion.period
    rates = np.abs(np.array((reference.qd, reference.qdd, jerk)))
    within = np.zeros(motion.ticks, dtype=np.bool_)
    for first, last in motion.blends:
        within[first:last] = True
    found, first = np.zeros((ORDERS, n)), 0
    for move in motion.moves:
        rows = slice(first, move.last)
        first = move.last
        if move.limits is None or rows.stop <= rows.start:
            continue
        own, shared = rates[:, rows][:, ~within[rows]], rates[:, rows][:, within[rows]]
        limits = move.limits.joints
        share = np.array((limits.speed, limits.acceleration, limits.jerk)) / settings.joints
        if move.on_tool_path:
            share = np.ones_like(share)
        found = np.maximum(found, own.max(axis=1, initial=0.0) / share)
        found = np.maximum(found, shared.max(axis=1, initial=0.0))
    return found


def largest_of_tool(motion: MotionPlan, settings: MotionSettings, robot: RobotModel) -> Array:
    """Return the largest speeds, accelerations and jerks of the tool in a motion, as limits: shape (3, 2).

    They are those along a single move on a path of the tool [m, rad, by s, s², s³], divided by the shares of
    the limits that the program allows; zeros for other motions. A speed that the program gives is not that of
    the controller and counts as zero.
    """
    (move, *others), reference = motion.moves, motion.reference
    if others or not move.on_tool_path or move.limits is None:
        return np.zeros((ORDERS, 2))
    _, J = jacobians_at(robot, reference.q, move.X_MT)
    twist = np.einsum("kij,kj->ki", J, reference.qd)
    speed = np.column_stack([np.linalg.norm(twist[:, part], axis=1) for part in _PARTS])
    acceleration = np.diff(speed, axis=0, prepend=0.0) / motion.period
    jerk = np.diff(acceleration, axis=0, prepend=0.0) / motion.period
    found: Array = np.array([np.abs(one).max(axis=0) for one in (speed, acceleration, jerk)])
    shares = np.array(move.limits.tool.all).reshape(2, ORDERS).T / settings.tool
    found /= shares
    if abs(shares[0, 0] - 1.0) > _OWN_SPEED:
        found[0, 0] = 0.0
    return found
