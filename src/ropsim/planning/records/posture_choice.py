"""Posture choice: which of the branches of the inverse kinematics a PTP move takes, and with which turns."""

from collections.abc import Callable
from functools import lru_cache

import numpy as np

from ropsim.kinematics import FollowerLimits, Posture, follower_limits, solver_of, turning_axes
from ropsim.model import Joint, RobotModel, held_arm
from ropsim.motion import JointMotionLimits, durations
from ropsim.planning.records.turns_kernel import rows_inside, turn_rows
from ropsim.spatial import Array, record

_TURN = 2.0 * np.pi
_SIDE = 1e-6  # [rad | m]; a step off a singularity that no drive notices
LIMIT_SLACK = 1e-9
"""Rounding of inverse kinematics at a coordinate that stands on its limit [rad | m]."""


@record
class JointRange:
    """The limits of all joints as arrays: of the n axes, and of m joints that follow them.

    Attributes:
        lower: of the axes [rad | m], shape (n,).
        upper: of the axes [rad | m], shape (n,).
        revolute: whether an axis turns (and may add whole turns), shape (n,).
        joints: of the axes, and of the followers, n + m of them.
        coupled: limits of the followers.
    """

    lower: Array
    upper: Array
    revolute: Array
    joints: tuple[Joint, ...]
    coupled: FollowerLimits

    @classmethod
    def of(cls, robot: RobotModel) -> "JointRange":
        """Return the range of an arm."""
        coupled = follower_limits(robot)
        joints = (*robot.axis_joints, *coupled.joints)
        return cls(robot.lower_limits, robot.upper_limits, turning_axes(robot), joints, coupled)

    def excess(self, q: Array) -> Array:
        """Return how far each coordinate lies outside its limits [rad | m]: 0 inside, NaN for NaN.

        Args:
            q: of the axes [rad | m], shape (k, n).

        Returns:
            Of all joints, shape (k, n + m).
        """
        beyond: Array = np.maximum(np.maximum(self.lower - q, q - self.upper), 0.0)
        own = np.where(beyond <= LIMIT_SLACK, 0.0, beyond)
        return np.concatenate((own, self.coupled.excess(q)), axis=1) if self.coupled.joints else own

    def inside(self, q: Array) -> Array:
        """Return which rows lie within all limits, false for NaN; q of the axes [rad | m], shape (k, n)."""
        if self.coupled.joints:
            return np.asarray((self.excess(q) == 0.0).all(axis=1))
        result = np.empty(len(q))
        rows_inside(np.ascontiguousarray(q), self.lower, self.upper, LIMIT_SLACK, result)
        return np.asarray(result > 0.0)

    def values(self, q: Array) -> Array:
        """Return coordinates of all joints [rad | m], shape (k, n + m), from those of the axes (k, n)."""
        return np.concatenate((q, self.coupled.values(q)), axis=1)


@record
class Choice:
    """The joint coordinates chosen for a pose.

    Attributes:
        q: [rad | m], shape (n,).
        keeps_posture: whether the posture is that of the start.
    """

    q: Array
    keeps_posture: bool


def nearest_turns(branches: Array, q_near: Array, limits: JointRange) -> Array:
    """Return the branches with each turning joint moved by whole turns.

    A coordinate is taken as near to `q_near` as the limits allow; where no turn lies inside the limits, as
    near to the limits as possible.

    Args:
        branches: joint coordinates [rad | m], shape (m, n).
        q_near: [rad | m], shape (n,).
        limits: of the joints.
    """
    turned, rows = np.empty(branches.shape), np.ascontiguousarray(branches)
    turn_rows(rows, q_near, limits.lower, limits.upper, limits.revolute, LIMIT_SLACK, turned)
    return turned


def turned_branches(branches: Array, limits: JointRange) -> Array:
    """Return all branches within the limits, each also with single joints one turn further either way.

    Args:
        branches: joint coordinates [rad | m], NaN where absent, shape (b, n).
        limits: of the joints.

    Returns:
        First the branches themselves, then the turned ones, shape (m, n).
    """
    steps = [
        turn * row for row in np.diag(_TURN * (limits.revolute > 0.0)) for turn in (-1.0, 1.0) if row.any()
    ]
    rows = np.concatenate([branches, *(branches + step for step in steps)])
    within: Array = rows[limits.inside(rows)]
    return within


def choose(
    robot: RobotModel, branches: Array, q_start: Array, limits: JointRange, motion: JointMotionLimits
) -> Choice | None:
    """Return the joint coordinates for a PTP move, or None where no branch lies within the limits.

    The posture of the start is kept where possible; among equals the shortest motion in time wins.

    Args:
        robot: the arm.
        branches: of the target, with their turns, NaN where absent [rad | m], rows as in the postures of the
            arm's solver, shape (b, n).
        q_start: [rad], shape (n,).
        limits: of the joints.
        motion: speed, acceleration and jerk limits of the move.
    """
    inside: list[bool] = limits.inside(branches).tolist()
    if True not in inside:
        return None
    same = [row for row in _start_rows(robot, q_start) if inside[row]]
    rows = same or [row for row, is_inside in enumerate(inside) if is_inside]
    if len(rows) == 1:
        return Choice(branches[rows[0]], keeps_posture=bool(same))
    shortest = int(np.argmin(durations(q_start, branches[rows], motion)))
    return Choice(branches[rows[shortest]], keeps_posture=bool(same))


def choose_nearest(
    robot: RobotModel, branches: Array, q_start: Array, limits: JointRange, motion: JointMotionLimits
) -> Choice | None:
    """Return the joint coordinates that are reached soonest, in any posture; arguments as in `choose`."""
    del robot
    inside = np.flatnonzero(limits.inside(branches))
    if not len(inside):
        return None
    shortest = int(np.argmin(durations(q_start, branches[inside], motion)))
    return Choice(branches[inside[shortest]], keeps_posture=True)


def _start_rows(robot: RobotModel, q_start: Array) -> list[int]:
    """Return the rows of the postures of the start; a singular one has the rows on either side of it."""
    standing, rows = _postures(robot)
    here = [rows.get(standing(q_start + side).words, ()) for side in (_SIDE, -_SIDE)]
    return sorted({*here[0], *here[1]})


@lru_cache(maxsize=64)
def _postures(robot: RobotModel) -> tuple[Callable[[Array], Posture], dict[tuple[str, ...], list[int]]]:
    """Return the function for the posture of joint coordinates, and the rows by words."""
    solver, axes = solver_of(robot), list(held_arm(robot).axes) if robot.external else None
    rows: dict[tuple[str, ...], list[int]] = {}
    for row, name in enumerate(solver.postures):
        rows.setdefault(name.words, []).append(row)
    return (solver.posture if axes is None else lambda q: solver.posture(q[axes])), rows
