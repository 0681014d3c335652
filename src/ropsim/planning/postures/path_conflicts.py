"""Conflicts of a path of the tool in one posture that another posture may avoid."""

from functools import lru_cache

import numpy as np

from ropsim.flow import MoveInstruction
from ropsim.model import RobotModel
from ropsim.motion import (
    JOINT_LIMIT_ON_LINE,
    JUMP_ON_LINE,
    NO_WRIST_ANGLES,
    SampledPath,
    durations,
    has_straight_tcp,
    own_law_of,
)
from ropsim.planning.moves.interpolator import even_parameters
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.postures.part_times_kernel import longest_cell, part_times
from ropsim.planning.records.conflict import Conflict
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.posture_choice import JointRange
from ropsim.spatial import Array, frozen

WHIRL = 0.25
"""Share to which a joint may slow a path down before another posture is searched: of the requested speed of
the tool or, where joints are slower all along, of that on half of the path."""

NARROW = np.radians(5.0)
"""Distance from a limit within which an axis that turns has little margin [rad]."""

_STEPS = 64
"""Number of sections of a path in which the travel of the joints is compared."""
_TINY = 1e-300


def conflict_of(robot: RobotModel, move: PlannedMove, number: int) -> Conflict | None:
    """Return where the joints whirl on the path of a move, None where they do not.

    Args:
        robot: the arm.
        move: the move, with a path of the tool.
        number: of the move in the sequence.
    """
    if _is_calm(robot, move):
        return None
    own, joint_times, least = _times(robot, move)
    if least >= WHIRL:
        return None
    times = np.maximum(joint_times.max(axis=1), own)
    shares = np.maximum(own, np.median(times)) / np.maximum(times, _TINY)
    part = int(np.argmin(shares))
    if not shares[part] < WHIRL:
        return None
    joint = robot.axis_joints[int(np.argmax(joint_times[part]))]
    words = f"joint `{joint.name}` slows the path down to {shares[part]:.0%} after {part / _STEPS:.0%} of it"
    return Conflict(number, words, move.move.origin.span)


def conflict_of_refusal(move: MoveInstruction, refusal: Refusal, number: int) -> list[Conflict]:
    """Return why a path cannot be followed, nothing where no other posture would help.

    Args:
        move: that is refused.
        refusal: of it.
        number: of the move in the sequence.
    """
    codes = {JOINT_LIMIT_ON_LINE.code, JUMP_ON_LINE.code, NO_WRIST_ANGLES.code}
    return [
        Conflict(number, found.message, move.origin.span)
        for found in refusal.diagnostics[:1]
        if found.code in codes
    ]


def is_narrow(limits: JointRange, move: PlannedMove) -> bool:
    """Return whether an axis that turns comes near to a limit on the path of a move.

    Args:
        limits: of the joints.
        move: the move.
    """
    if move.joints is None:
        return False
    q = move.joints.joints(np.linspace(0.0, move.joints.length, _STEPS + 1)).q
    margin = np.minimum(q - limits.lower, limits.upper - q)[:, limits.revolute > 0.0]
    return bool((margin < NARROW).any())


def time_of(robot: RobotModel, move: PlannedMove, q_start: Array) -> float:
    """Return the time of a move [s], without that for changes of speed on a path of the tool.

    Args:
        robot: the arm.
        move: the move.
        q_start: command joint coordinates at its start [rad | m], shape (n,).
    """
    if move.joints is None:
        return 0.0
    if own := own_law_of(move.joints):
        return own.duration
    if move.tool is None:
        return float(durations(q_start, move.q_end[np.newaxis], move.planned.limits.joints)[0])
    of_tool, joint_times, _ = _times(robot, move)
    return float(np.maximum(joint_times.max(axis=1), of_tool).sum())


def _is_calm(robot: RobotModel, move: PlannedMove) -> bool:
    """Return whether the joints clearly keep up with a straight line."""
    path, joints = move.tool, move.joints
    if path is None or not has_straight_tcp(path) or type(joints) is not SampledPath:
        return False
    longest = np.empty(1)
    longest_cell(joints.q, joints.derivatives, joints.parameters, max_speeds_of(robot), longest)
    return bool(longest[0] * WHIRL <= 1.0 / max(move.planned.limits.tool.speed, _TINY))


def _times(robot: RobotModel, move: PlannedMove) -> tuple[Array, Array, float]:
    """Return the times [s] of the parts of a path: of the tool, shape (k,), and of the joints, (k, n).

    Behind them stands the least share of the former to the longest of a part.
    """
    assert move.tool is not None
    assert move.joints is not None
    length, limits = move.tool.length, move.planned.limits.tool
    at = even_parameters(length, _STEPS)
    d1, q = move.tool.tool(at).d1, move.joints.joints(at).q
    own, joint_times, result = np.empty(_STEPS), np.empty((_STEPS, robot.n)), np.empty(1)
    speed, turning = max(limits.speed, _TINY), max(limits.orientation_speed, _TINY)
    rows = np.ascontiguousarray(d1, dtype=np.float64), np.ascontiguousarray(q, dtype=np.float64)
    part_times(*rows, length / _STEPS, speed, turning, max_speeds_of(robot), own, joint_times, result)
    return own, joint_times, float(result[0])


@lru_cache(maxsize=64)
def max_speeds_of(robot: RobotModel) -> Array:
    """Return the speed limits of the joints [rad/s | m/s], shape (n,)."""
    return frozen(robot.max_speeds)
