"""Refusals of the path planner for a command pose that the arm cannot take."""

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import MotionKind, MoveInstruction
from ropsim.kinematics import (
    NO_CLOSED_FORM,
    IkStatus,
    Method,
    Miss,
    Reach,
    Shortfall,
    posture,
    solver_of,
)
from ropsim.model import RobotModel
from ropsim.motion import (
    JOINT_OUT_OF_RANGE,
    NO_ARM,
    OUT_OF_REACH,
    OUT_OF_TASK_SPACE,
    POSE_NOT_FOUND,
    POSTURE_CHANGE,
    POSTURE_FOR_LATER,
)
from ropsim.planning.moves.requested_posture import difference
from ropsim.planning.records.conflict import Conflict
from ropsim.planning.records.free_orientation import counted_of, free_hint
from ropsim.planning.records.planned_path import Counts
from ropsim.planning.records.posture_choice import JointRange
from ropsim.planning.records.wording import coordinate, external_notes, figures, passes, shortfall_words
from ropsim.spatial import Array, Pose


def no_arm(move: MoveInstruction, robot: RobotModel) -> tuple[Diagnostic, ...]:
    """Return M518 where a pose or a line is requested from a station without an arm, else nothing."""
    if robot.has_arm or not (isinstance(move.target, Pose) or move.kind == MotionKind.LIN):
        return ()
    axes = ", ".join(f"`{joint.name}`" for joint in robot.axis_joints)
    what = "a straight line" if move.kind == MotionKind.LIN else "a pose"
    finding = NO_ARM.at(
        move.origin.span,
        f"{what} needs an arm, this station has the axis {axes} only",
        label=passes(move.origin),
        hint="move it by `mov joints(…)` with its coordinate",
        data=move.origin.data,
    )
    return (finding,)


_TURNED_OVER = 3.1
"""Angle from the possible orientation from which on its tool is turned over [rad]."""


def _task_space_hint(miss: Miss | None, X_BM: Pose, free: str) -> str:
    """Return the hint for a pose X_BM of the mechanical interface outside the task space; or `free`."""
    if miss is not None and miss.angle > _TURNED_OVER and X_BM.matrix()[2, 2] > 0.0:
        return (
            "the tool points up there; write `; down` behind the coordinates, or with a turn `; down, rz 90`"
        )
    return free or "give the pose the orientation that the arm has there, or use joint coordinates"


def out_of_reach(
    move: MoveInstruction, X_BM: Pose, X_MT: Pose, shortfall: Shortfall, robot: RobotModel, q: Array
) -> Diagnostic:
    """Return M501, M530 or M581 for a command pose X_BM of the mechanical interface without a posture.

    Args:
        move: the instruction.
        X_BM: the pose.
        X_MT: the tool.
        shortfall: the missing amount.
        robot: the arm with its external axes.
        q: joint coordinates with the external axes where they stand [rad | m], shape (n,).
    """
    x, y, z = (1e3 * X_BM.position).tolist()
    position = f"mechanical interface at ({x:.1f}, {y:.1f}, {z:.1f}) mm in the base frame"
    data = {
        "position_m": tuple(X_BM.position.tolist()),
        **move.origin.data,
        **_reach_data(shortfall.reach),
        **_miss_data(shortfall.miss),
    }
    free = free_hint(robot, X_MT, (X_BM @ X_MT).position, q)
    kind, what = _WITHOUT_POSTURE[shortfall.status]
    why = shortfall_words(shortfall)
    return kind.at(
        move.origin.span,
        f"{what}: {why or position}",
        label=passes(move.origin),
        notes=(*((position,) if why else ()), *external_notes(robot, q)),
        hint=_task_space_hint(shortfall.miss, X_BM, free)
        if shortfall.status is IkStatus.OUT_OF_TASK_SPACE
        else free or "move the target or its frame, and look at the units of its coordinates",
        data=data,
    )


_WITHOUT_POSTURE = {
    IkStatus.OUT_OF_REACH: (OUT_OF_REACH, "command pose is out of reach"),
    IkStatus.OUT_OF_TASK_SPACE: (OUT_OF_TASK_SPACE, "this arm cannot take the command pose"),
    IkStatus.NOT_FOUND: (POSE_NOT_FOUND, "no joint coordinates were found for the command pose"),
}


def _reach_data(reach: Reach | None) -> dict[str, object]:
    if reach is None:
        return {}
    return {"distance_m": reach.distance, "shortest_m": reach.shortest, "longest_m": reach.longest}


def _miss_data(miss: Miss | None) -> dict[str, object]:
    return {} if miss is None else {"missing_m": miss.distance, "missing_rad": miss.angle}


def out_of_range(move: MoveInstruction, robot: RobotModel, branches: Array, limits: JointRange) -> Diagnostic:
    """Return M502 for a command pose that every posture reaches only beyond the joint limits.

    The joint that is named is the worst one of the posture that comes nearest to the limits.

    Args:
        move: the instruction.
        robot: the arm.
        branches: of the pose, with their best turns, NaN where absent [rad | m], shape (b, n).
        limits: of the joints.
    """
    turned = branches[~np.isnan(branches).any(axis=1)]
    excess = limits.excess(turned)
    nearest = int(np.argmin(excess.max(axis=1)))
    index = int(np.argmax(excess[nearest]))
    joint, value = limits.joints[index], float(limits.values(turned)[nearest, index])
    limit = joint.upper if value > joint.upper else joint.lower
    count = len(turned)
    reach = "one posture reaches" if count == 1 else f"{count} postures reach"
    none = "not" if count == 1 else "none"
    further = "; there may be others" if solver_of(robot).method is Method.NUMERIC else ""
    return JOINT_OUT_OF_RANGE.at(
        move.origin.span,
        f"command pose needs joint `{joint.name}` at {coordinate(joint, value)}, "
        f"the limit is {coordinate(joint, limit)}",
        label=passes(move.origin),
        notes=(f"{reach} the command pose, {none} within the joint limits{further}",),
        hint="move or turn the target or its frame",
        data={
            **figures(joint, value, limit),
            "postures": count,
            **move.origin.data,
        },
    )


def posture_change(
    move: MoveInstruction, robot: RobotModel, q_start: Array, q_end: Array
) -> tuple[Diagnostic, ...]:
    """Return M511 for a move that cannot keep its posture."""
    before, after = posture(robot, q_start), posture(robot, q_end)
    if before == after:
        return ()
    words = zip(solver_of(robot).parts, before.words, after.words, strict=True)
    changes = ", ".join(f"{part} from {old} to {new}" for part, old, new in words if old != new)
    finding = POSTURE_CHANGE.at(
        move.origin.span,
        f"the posture changes on the way: {changes}",
        label=passes(move.origin),
        hint="the posture of the start does not reach the target within the joint limits",
        data={"cause": changes, **move.origin.data},
    )
    return (finding,)


def posture_for_later(
    move: MoveInstruction, robot: RobotModel, q_nearest: Array, q_end: Array, why: Conflict
) -> tuple[Diagnostic, ...]:
    """Return M585 for a move that takes another posture than the nearest one.

    Args:
        move: the instruction.
        robot: the arm.
        q_nearest: where it would have ended [rad | m], shape (n,).
        q_end: where it ends [rad | m], shape (n,).
        why: the conflict that would follow.
    """
    finding = POSTURE_FOR_LATER.at(
        move.origin.span,
        f"{difference(robot, q_end, q_nearest)}, which is nearest, for the sake of a later move",
        secondary=why.labels,
        label=passes(move.origin),
        notes=(f"otherwise {why.words}",),
        hint="where another posture is wanted, name it with `config`, or shift the later move",
        data=move.origin.data,
    )
    return (finding,)


def numeric_hint(move: MoveInstruction, robot: RobotModel) -> tuple[Diagnostic, ...]:
    """Return M550 for a move that an arm solved numerically makes to a pose."""
    posed = isinstance(move.target, Pose) or move.kind != MotionKind.PTP
    if not posed or counted_of(move, robot) is Counts.POINT or solver_of(robot).method is not Method.NUMERIC:
        return ()
    finding = NO_CLOSED_FORM.at(
        move.origin.span,
        f"`{robot.name}` is solved numerically: further branches than those found may exist",
        label=passes(move.origin),
        hint="where the posture matters, give the target in joint coordinates",
        data=move.origin.data,
    )
    return (finding,)
