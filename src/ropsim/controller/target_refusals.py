"""What the path planner says about a command pose that the arm cannot take."""

import numpy as np

from ropsim.controller.posture_choice import JointRange
from ropsim.controller.wording import coordinate, distance_words, figures, passes
from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction
from ropsim.kinematics import Reach, posture
from ropsim.model import RobotModel
from ropsim.motion import JOINT_OUT_OF_RANGE, OUT_OF_REACH, POSTURE_CHANGE
from ropsim.spatial import Array, Pose


def out_of_reach(move: MoveInstruction, X_BM: Pose, reach: Reach | None) -> Diagnostic:
    """Return M501 for a command pose X_BM of the mechanical interface that no posture reaches.

    Args:
        move: the instruction.
        X_BM: the pose.
        reach: how far the wrist centre is and may be, where it is known.
    """
    x, y, z = (1e3 * X_BM.position).tolist()
    place = f"mechanical interface at ({x:.1f}, {y:.1f}, {z:.1f}) mm in the base frame"
    data: dict[str, object] = {"position_m": tuple(X_BM.position.tolist()), "pass": move.origin.visit}
    message = f"command pose is out of reach: {place}"
    notes: tuple[str, ...] = ()
    if reach is not None:
        message, notes = f"command pose is out of reach: {distance_words(reach)}", (f"{place}",)
        data |= {
            "distance_m": reach.distance,
            "shortest_m": reach.shortest,
            "longest_m": reach.longest,
        }
    return OUT_OF_REACH.at(
        move.origin.span,
        message,
        label=passes(move.origin),
        notes=notes,
        hint="move the target or its frame, and look at the units of its coordinates",
        data=data,
    )


def out_of_range(move: MoveInstruction, branches: Array, robot: RobotModel, limits: JointRange) -> Diagnostic:
    """Return M502 for a command pose that every posture reaches only beyond the joint limits.

    The joint that is named is the worst one of the posture that comes nearest to the limits.

    Args:
        move: the instruction.
        branches: of the pose, with their best turns, NaN where absent [rad | m], shape (8, n).
        robot: the arm.
        limits: of the joints.
    """
    turned = branches[~np.isnan(branches).any(axis=1)]
    excess = limits.excess(turned)
    nearest = int(np.argmin(excess.max(axis=1)))
    index = int(np.argmax(excess[nearest]))
    joint, value = robot.joints[index], float(turned[nearest, index])
    limit = joint.upper if value > joint.upper else joint.lower
    count = len(turned)
    reach = "one posture reaches" if count == 1 else f"{count} postures reach"
    none = "not" if count == 1 else "none"
    return JOINT_OUT_OF_RANGE.at(
        move.origin.span,
        f"command pose needs joint `{joint.name}` at {coordinate(joint, value)}, "
        f"the limit is {coordinate(joint, limit)}",
        label=passes(move.origin),
        notes=(f"{reach} the command pose, {none} within the joint limits",),
        hint="move or turn the target or its frame",
        data={
            **figures(joint, value, limit),
            "postures": count,
            "pass": move.origin.visit,
        },
    )


def posture_change(
    move: MoveInstruction, robot: RobotModel, q_start: Array, q_end: Array
) -> tuple[Diagnostic, ...]:
    """Return M511 for a move that cannot keep its posture; only at its first visit."""
    before, after = posture(robot, q_start), posture(robot, q_end)
    if move.origin.visit > 1 or before == after:
        return ()
    changes = ", ".join(
        f"{part} from {old.name.lower()} to {new.name.lower()}"
        for part, old, new in (
            ("shoulder", before.shoulder, after.shoulder),
            ("elbow", before.elbow, after.elbow),
            ("wrist", before.wrist, after.wrist),
        )
        if old is not new
    )
    finding = POSTURE_CHANGE.at(
        move.origin.span,
        f"the posture changes on the way: {changes}",
        hint="the posture of the start does not reach the target within the joint limits",
    )
    return (finding,)
