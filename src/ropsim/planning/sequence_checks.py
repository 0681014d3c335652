"""Checks of a motion sequence before it is timed: start, correction, speeds, and moves that take too long."""

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from ropsim.core import Diagnostic, Severity, define
from ropsim.flow import MoveInstruction
from ropsim.kinematics import speed_bound
from ropsim.model import RobotModel
from ropsim.motion import NO_SPLINE, PATH_NOT_CORRECTED, SPEED_BEYOND_ARM, JointBounds, constant_derivatives
from ropsim.planning.joint_limits.arm_limits import ArmBounds
from ropsim.planning.moves.move_check import MAX_DURATION, check_duration
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_plan import MotionState
from ropsim.planning.records.planned_path import Counts
from ropsim.planning.records.wording import passes
from ropsim.planning.trajectory.segments import PathSegment
from ropsim.spatial import Array, Pose

NOT_AT_REST = define(
    "C605",
    "not-at-rest",
    Severity.ERROR,
    "a motion sequence starts from an invalid state, or from one that is not at rest",
    """
A motion sequence begins and ends at rest. `plan` got speeds or accelerations other than 0, numbers that are
not finite, or another number of them than the robot has axes. The moves are not planned.

**How to mend it.** Plan from `MotionState.at_rest(q)`, with the joint coordinates at which the arm rests. A
motion that is under way is slowed, held and ended by the motion clock, not by planning it anew.
""",
)


def check_start(state: MotionState, robot: RobotModel, move: MoveInstruction) -> Refusal | None:
    """Return C605 where a motion cannot begin at a state, None where it can.

    Args:
        state: where the first move begins.
        robot: the arm.
        move: the first move.
    """
    rows = {"coordinates": state.q, "speeds": state.qd, "accelerations": state.qdd}
    for name, row in rows.items():
        values = np.asarray(row, dtype=np.float64)
        if values.shape != (robot.n,):
            return _refused(f"{name} of shape {values.shape}, allowed is ({robot.n},)", move)
        numbers = values.tolist()
        if not all(map(math.isfinite, numbers)):
            return _refused(f"{name} {numbers}, allowed are finite numbers", move)
        if name != "coordinates" and any(numbers):
            return _refused(f"{name} {numbers}, allowed are zeros", move)
    return None


def _refused(found: str, move: MoveInstruction) -> Refusal:
    return Refusal((NOT_AT_REST.at(move.origin.span, f"the motion is to begin with {found}"),))


PLANNED_SPEED, PLANNED_ACCELERATION = 0.8, 0.7
"""Shares of speed and acceleration of the joints for the move itself; the rest is for the correction."""


def correction_refusal(planned_move: PlannedMove) -> Refusal | None:
    """Return M587 for a move that a sensor is to correct and cannot."""
    move, planned = planned_move.move, planned_move.planned
    if move.tracking is None or planned_move.joints is None:
        return None
    if planned.tool is None:
        why, hint = "it has no path of the tool", "correct a path of the tool, such as that of `lin`"
    elif planned.coordination is not None:
        why = "external axes go along with it"
        hint = "move the external axes before, and leave them where they are on this move"
    elif planned.counts is Counts.POINT:
        why = "its orientation is free, and the arm has too few axes to keep it while the tool is shifted"
        hint = "leave the correction out, or compute points of the path that is wanted"
    else:
        return None
    finding = PATH_NOT_CORRECTED.at(
        move.origin.span,
        f"signal `{move.tracking.channel}` cannot correct this path: {why}",
        label=passes(move.origin),
        hint=hint,
        data={"channel": move.tracking.channel, **move.origin.data},
    )
    return Refusal((finding,))


def with_correction(bounds: ArmBounds) -> ArmBounds:
    """Return the joint limits for a move itself if a correction is added to it."""
    joints = bounds.joints
    speed, acceleration = joints.speed * PLANNED_SPEED, joints.acceleration * PLANNED_ACCELERATION
    lowered = replace(joints, speed=speed, acceleration=acceleration)
    return replace(bounds, joints=lowered)


def beyond_arm(moves: Sequence[PlannedMove], robot: RobotModel) -> tuple[Diagnostic, ...]:
    """Return M588 for each path of the tool with a speed that no motion of the arm has.

    Args:
        moves: the moves.
        robot: the arm.
    """
    return tuple(
        _beyond(move, speed, bound)
        for move in moves
        if move.tool is not None
        if (speed := move.move.modal.path_speed) is not None
        if speed > (bound := _bound(robot, move.planned.X_MT))
    )


@lru_cache(maxsize=256)
def _bound(robot: RobotModel, X_MT: Pose) -> float:
    return speed_bound(robot, X_MT.position)


def _beyond(move: PlannedMove, speed: float, bound: float) -> Diagnostic:
    return SPEED_BEYOND_ARM.at(
        move.move.origin.span,
        f"the speed of {speed:.4g} m/s is beyond the arm: with this tool none of its motions is faster than "
        f"{bound:.2g} m/s",
        label=passes(move.move.origin),
        hint="give the speed that is meant; a unit behind it says which, as in `speed 250 mm/s`",
        data={"speed_m_s": speed, "bound_m_s": bound, **move.move.origin.data},
    )


_SHARES = np.linspace(0.0, 1.0, 33)
_SPARE = 2.0
"""Multiple of the range of a joint that bounds its travel between two path parameters."""
_NOTHING = 1e-12
"""A bound of speed, acceleration or jerk that is less stands for a path on which nothing can move."""


def standing_refusal(move: PlannedMove, path_segment: PathSegment) -> Refusal | None:
    """Return M567 for a curve that turns back in a point, where the tool would have to stand for ever.

    Args:
        move: the move.
        path_segment: a part of its path.
    """
    tool = move.planned.tool
    if tool is None or constant_derivatives(tool) is not None:
        return None
    path_limits = path_segment.path_limits.rows
    if len(path_limits) == 1:
        _, v, a, j = path_limits[0].tolist()
        if _NOTHING < v < math.inf and _NOTHING < a < math.inf and _NOTHING < j < math.inf:
            return None
    least = path_segment.path_limits.bounds.min(axis=1)
    wrong = np.flatnonzero(~((least > _NOTHING) & (least < math.inf)))
    if len(wrong) == 0:
        return None
    share = (path_segment.begin + float(path_limits[: wrong[0], 0].sum())) / tool.length
    finding = NO_SPLINE.at(
        move.move.origin.span,
        f"the curve turns back after {share:.0%} of its way, so sharply that the tool cannot pass",
        label=passes(move.move.origin),
        hint="put the points further apart, or in an order in which the curve goes on",
        data={"place": share, **move.move.origin.data},
    )
    return Refusal((finding,))


@lru_cache(maxsize=256)
def may_take_too_long(robot: RobotModel, bounds: JointBounds) -> bool:
    """Return whether joints may need far too long for a move within their ranges, by a lower bound.

    Args:
        robot: the arm.
        bounds: capabilities of its joints.
    """
    distances = _SPARE * (robot.upper_limits - robot.lower_limits)
    rises = np.maximum(
        np.sqrt(4.0 * distances / bounds.acceleration), np.cbrt(32.0 * distances / bounds.jerk)
    )
    longest = np.maximum((len(_SHARES) - 1) * distances / bounds.speed, rises)
    return not bool((longest <= MAX_DURATION).all())


def joints_refusal(move: PlannedMove, speeds: Array) -> Refusal | None:
    """Return M513 for a path of the tool on which a joint needs too long at its greatest speed.

    Args:
        move: the move.
        speeds: limits of the joints [rad/s | m/s], shape (n,).
    """
    if move.tool is None or move.joints is None:
        return None
    distances = np.abs(np.diff(move.joints.joints(_SHARES * move.joints.length).q, axis=0)).sum(axis=0)
    found = check_duration(move.move, float((distances / speeds).max()))
    return Refusal(found) if found else None


def rest_to_rest_refusal(
    moves: Sequence[PlannedMove], q_start: Array, bounds: JointBounds
) -> tuple[int, Refusal] | None:
    """Return M513 for moves from one stop to the next for which a joint needs too long by its limits alone.

    On any path, a joint that comes to rest at a distance d needs at least d/v, √(4·d/a) and ∛(32·d/j)
    (Biagiotti and Melchiorri 2008, Trajectory Planning for Automatic Machines and Robots, section 3.4).

    Args:
        moves: the moves, from one stop to the next.
        q_start: joint coordinates at their start [rad | m], shape (n,).
        bounds: capabilities of the joints.

    Returns:
        the number of the move in which that joint goes furthest, and the refusal; None where there is time.
    """
    ends = np.array([q_start, *(move.q_end for move in moves)])
    distances = np.abs(ends[-1] - q_start)
    rises = np.sqrt(4.0 * distances / bounds.acceleration), np.cbrt(32.0 * distances / bounds.jerk)
    times = np.maximum(distances / bounds.speed, np.maximum(*rises))
    number = int(np.abs(np.diff(ends[:, int(np.argmax(times))])).argmax())
    found = check_duration(moves[number].move, float(times.max()) / len(moves))
    return (number, Refusal(found)) if found else None
