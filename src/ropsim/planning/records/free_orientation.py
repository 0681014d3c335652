"""Targets with free orientation: what of them counts for an arm, and the orientation that is kept."""

from dataclasses import replace

from ropsim.flow import MoveInstruction
from ropsim.kinematics import chooses_points_only, point_answers
from ropsim.model import RobotModel
from ropsim.motion import (
    JOINT_LIMIT_ON_LINE,
    JOINT_OUT_OF_RANGE,
    JUMP_ON_LINE,
    OUT_OF_REACH,
    OUT_OF_TASK_SPACE,
    POSE_NOT_FOUND,
    POSTURE_OUT_OF_REACH,
)
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.planned_path import Counts
from ropsim.spatial import Array, Pose


def counted_of(move: MoveInstruction, robot: RobotModel) -> Counts:
    """Return what of the poses of a move counts for an arm.

    With a free orientation and fewer than six axes the points do.

    Args:
        move: the instruction.
        robot: the arm.
    """
    return Counts.POINT if move.has_free_orientation and chooses_points_only(robot) else Counts.POSE


def with_orientation_of(move: MoveInstruction, X_KT: Pose) -> MoveInstruction:
    """Return a move to the same points with the orientation in which the tool stands.

    Args:
        move: to a pose.
        X_KT: the tool at the start, in the task frame in force.
    """
    assert isinstance(move.target, Pose)
    turn = X_KT.orientation
    via = tuple(Pose(one.position, turn) for one in move.via)
    return replace(move, target=Pose(move.target.position, turn), via=via)


def explained(move: MoveInstruction, robot: RobotModel, refusal: Refusal) -> Refusal:
    """Return a refusal that says which orientation was kept, where that may be its cause.

    Args:
        move: that is refused.
        robot: the arm.
        refusal: of it.
    """
    if not move.has_free_orientation or counted_of(move, robot) is Counts.POINT:
        return refusal
    return Refusal(
        tuple(
            replace(one, notes=(*one.notes, _KEPT), hint=_GIVE) if one.code in _CAUSED else one
            for one in refusal.diagnostics
        )
    )


def free_hint(robot: RobotModel, X_MT: Pose, point: Array, q: Array) -> str:
    """Return a hint that names `free` where a pose is not reached and its point is; else nothing.

    Args:
        robot: the arm.
        X_MT: the tool.
        point: of its TCP in the base frame [m], shape (3,).
        q: joint coordinates with the external axes where they stand [rad | m], shape (n,).
    """
    if not chooses_points_only(robot) or not len(point_answers(robot, X_MT, point, q).branches):
        return ""
    return "where only the position counts, write `free` behind the target: its orientation follows then"


_CAUSED = {
    kind.code
    for kind in (
        OUT_OF_REACH,
        OUT_OF_TASK_SPACE,
        POSE_NOT_FOUND,
        JOINT_OUT_OF_RANGE,
        POSTURE_OUT_OF_REACH,
        JOINT_LIMIT_ON_LINE,
        JUMP_ON_LINE,
    )
}
_KEPT = "the orientation is free: the tool keeps the one that it has at the start of the move"
_GIVE = "turn the tool before, or give the target an orientation that can be reached, in place of `free`"
