"""Limits required by a motion: lower bounds, and the limits that it reaches."""

import numpy as np

from ropsim.calibration.limits import ORDERS, MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence
from ropsim.calibration.replanning import Replan, difference
from ropsim.calibration.sequence_fit import SequenceFit
from ropsim.planning import MotionPlan
from ropsim.spatial import Array, frozen, record

RAISED = 1.1
"""Factor by which a limit is raised to see whether the motion is at it."""
_NOISE, _LEAST = 3.0, 2e-5
"""By how much the joints are elsewhere then: a number of encoder steps, and a tolerance [rad | m]."""


@record
class Demand:
    """Limits required by a motion.

    Attributes:
        joints: largest speed, acceleration and jerk of each axis, by the shares that the program allows of
            the limits [rad | m, by s, s², s³], shape (3, n): no limit can be lower.
        at_joints: whether common speeds, accelerations, jerks of the joints set its time, shape (3,).
        at_tool: whether limits of TCP and orientation are reached, shape (3, 2).
    """

    joints: Array
    at_joints: Array
    at_tool: Array

    def __post_init__(self) -> None:
        for name in ("joints", "at_joints", "at_tool"):
            object.__setattr__(self, name, frozen(getattr(self, name)))


def demand(replan: Replan, fit: SequenceFit) -> Demand:
    """Return the limits required by a fitted motion sequence."""
    settings = fit.settings
    at_joints, at_tool = np.zeros(ORDERS), np.zeros((ORDERS, 2))
    for order in range(ORDERS):
        joints, tool = settings.joints.copy(), settings.tool.copy()
        joints[order] *= RAISED
        at_joints[order] = _is_quicker(replan, fit, MotionSettings(joints, tool, settings.look_ahead))
        for part in range(2):
            raised = settings.tool.copy()
            raised[order, part] *= RAISED
            changed = MotionSettings(settings.joints, raised, settings.look_ahead)
            at_tool[order, part] = _is_quicker(replan, fit, changed)
    return Demand(largest(fit.motion, settings), at_joints, at_tool)


def is_felt(logged: LoggedSequence, motion: MotionPlan, higher: MotionPlan) -> bool:
    """Return whether a motion with a higher limit differs measurably in a trace.

    Args:
        logged: the sequence.
        motion: with the present limit.
        higher: the same with a limit that is `RAISED`.
    """
    least = _NOISE * float(logged.noise.max()) + _LEAST
    return higher.ticks <= motion.ticks and difference(motion, higher) > least


def _is_quicker(replan: Replan, fit: SequenceFit, settings: MotionSettings) -> bool:
    motion = replan(fit.logged.number, settings)
    return motion is not None and is_felt(fit.logged, fit.motion, motion)


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
