"""Checks of the joint samples along a path of the tool: limits, and obstacles of the joints."""

from collections.abc import Mapping

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import MotionKind, MoveInstruction, PoseSetpoints
from ropsim.kinematics import IkOptions, IkStatus, inverse, jacobian, singular_distances
from ropsim.model import RobotModel
from ropsim.motion import (
    JOINT_LIMIT_ON_LINE,
    JUMP_ON_LINE,
    OTHER_JOINTS_AT_LINE_END,
    OUT_OF_REACH,
    OUT_OF_TASK_SPACE,
    POSE_NOT_FOUND,
)
from ropsim.planning.moves.branch_following import Follow
from ropsim.planning.records.free_orientation import free_hint
from ropsim.planning.records.posture_choice import JointRange
from ropsim.planning.records.wording import coordinate, external_notes, figures, passes, shortfall_words
from ropsim.spatial import Array, Pose, record

_NEAR_SINGULAR = 0.08  # smallest singular value of the Jacobian [m | -] below which the note names it
_SAME_JOINTS = 1e-6  # [rad | m]
_LEFT = {
    IkStatus.OUT_OF_REACH: (OUT_OF_REACH, "the reach of the arm"),
    IkStatus.OUT_OF_TASK_SPACE: (OUT_OF_TASK_SPACE, "the poses that this arm can take"),
    IkStatus.NOT_FOUND: (POSE_NOT_FOUND, "the poses for which joint coordinates were found"),
}


_NOUNS: Mapping[str, str] = {MotionKind.LIN: "line", MotionKind.CIRC: "arc", MotionKind.SPLINE: "curve"}


@record
class Line:
    """A line in the inverse transform.

    Attributes:
        move: its instruction.
        setpoints: X_BT along the path.
        q_start: joint coordinates at the start [rad | m], shape (n,).
        robot: the arm with its external axes.
        X_MT: the tool.
    """

    move: MoveInstruction
    setpoints: PoseSetpoints
    q_start: Array
    robot: RobotModel
    X_MT: Pose = Pose()

    @property
    def held(self) -> Array:
        """Return coordinates with external ones from the setpoints, shape (k, n).

        Where external axes stand it is the start alone, shape (n,).
        """
        if self.setpoints.external is None:
            return self.q_start
        rows = np.tile(self.q_start, (len(self.setpoints.matrices), 1))
        rows[:, list(self.robot.external)] = self.setpoints.external
        return rows

    @property
    def noun(self) -> str:
        """Return the word for the path in messages: a line, an arc, a curve, or a path of another kind."""
        return _NOUNS.get(self.move.kind, "path")

    def held_at(self, row: int) -> Array:
        """Return coordinates with external ones from setpoint `row`, shape (n,)."""
        return self.q_start if self.setpoints.external is None else self.held[row]

    def share(self, row: int) -> float:
        """Return which share of the path lies behind setpoint `row`."""
        return min(row / (len(self.setpoints.matrices) - 1), 1.0)


def lost(line: Line, found: Follow, matrices: Array) -> Diagnostic:
    """Return M501, M530 or M581 where the line leaves the reach of the arm, or M505 where joints would jump.

    Args:
        line: the line.
        found: how far it can be followed.
        matrices: X_BM at its setpoints, shape (k, 4, 4).
    """
    row, robot = len(found.q), line.robot
    share = line.share(row)
    data = {"share": share, **line.move.origin.data}
    span, label = line.move.origin.span, passes(line.move.origin)
    q = found.q[-1] if row else line.q_start
    if not found.reachable:
        here = line.held_at(row)
        options = IkOptions(near=here)
        shortfall = inverse(robot, Pose.from_matrix(matrices[row]), options).shortfall
        kind, left = _LEFT[shortfall.status if shortfall else IkStatus.OUT_OF_REACH]
        X_BT = line.setpoints.matrices[row]
        x, y, z = (1e3 * X_BT[:3, 3]).tolist()
        return kind.at(
            span,
            f"the {line.noun} leaves {left} at {share:.0%} of the way, "
            f"with the TCP at ({x:.1f}, {y:.1f}, {z:.1f}) mm in the base frame",
            label=label,
            notes=(
                *((shortfall_words(shortfall),) if shortfall else ()),
                *external_notes(robot, here),
            ),
            hint=(kind is OUT_OF_TASK_SPACE and free_hint(robot, line.X_MT, X_BT[:3, 3], q))
            or f"shift the {line.noun}, or use `mov` where the path does not matter",
            data=data,
        )
    return JUMP_ON_LINE.at(
        span,
        f"the joints would have to jump at {share:.0%} of the way",
        label=label,
        notes=singularity_notes(robot, q),
        hint=f"turn the tool a little, shift the {line.noun}, or use `mov` for this part",
        data=data,
    )


def limit_refusals(line: Line, q: Array, limits: JointRange) -> tuple[Diagnostic, ...]:
    """Return M503 for the joint that meets its limit first, or nothing."""
    excess = limits.excess(q)
    outside = np.flatnonzero(excess.any(axis=1))
    if len(outside) == 0:
        return ()
    row = int(outside[0])
    index = int(np.argmax(excess[row]))
    values = limits.values(q)[:, index]
    furthest = float(values[int(np.argmax(excess[:, index]))])
    joint = limits.joints[index]
    limit = joint.upper if values[row] > joint.upper else joint.lower
    share = line.share(row)
    finding = JOINT_LIMIT_ON_LINE.at(
        line.move.origin.span,
        f"joint `{joint.name}` passes its limit of {coordinate(joint, limit)} at {share:.0%} of the way, "
        f"the {line.noun} needs {coordinate(joint, furthest)}",
        label=passes(line.move.origin),
        hint=f"start the {line.noun} in another posture, make it shorter, or use `mov`",
        data={
            **figures(joint, furthest, limit),
            "share": share,
            **line.move.origin.data,
        },
    )
    return (finding,)


def end_findings(move: MoveInstruction, q_end: Array) -> tuple[Diagnostic, ...]:
    """Return M514 where a line to joint coordinates ends in others."""
    target = move.target
    if not isinstance(target, tuple):
        return ()
    if float(np.abs(q_end - np.array(target)).max()) <= _SAME_JOINTS:
        return ()
    finding = OTHER_JOINTS_AT_LINE_END.at(
        move.origin.span,
        "the line reaches the pose of the target, but with other joint coordinates",
        label=passes(move.origin),
        hint="use `mov` to reach exactly these joint coordinates",
        data=move.origin.data,
    )
    return (finding,)


def singularity_notes(robot: RobotModel, q: Array) -> tuple[str, ...]:
    """Return in words which singularity of an arm with spherical wrist is near, if one is.

    The direction in joint space that moves the tool least decides: without the first three joints it is the
    wrist; dominated by joint 1 the shoulder, else the elbow.
    """
    if singular_distances(robot, q) is None:
        return ()
    _, values, directions = np.linalg.svd(jacobian(robot, q))
    if values[-1] > _NEAR_SINGULAR:
        return ()
    arm = np.abs(directions[-1][:3])
    if float(np.linalg.norm(arm)) < 0.3:
        return ("the wrist is near its singularity: the axes of joints 4 and 6 are almost in line",)
    if int(np.argmax(arm)) == 0:
        return ("the shoulder is near its singularity: the wrist is almost on the axis of joint 1",)
    return ("the elbow is near its singularity: upper arm and forearm are almost stretched",)
