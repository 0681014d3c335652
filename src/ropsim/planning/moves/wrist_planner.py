"""Paths of the tool that the wrist leads: their joints, or why there are none."""

from dataclasses import replace

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction, PoseSetpoints
from ropsim.kinematics import IkOptions, Limits, inverse, posture, singular_distances, solver_of
from ropsim.model import RobotModel
from ropsim.motion import NO_WRIST_ANGLES, SampledPath, ToolPath, monotone
from ropsim.planning.moves.line_check import Line, end_findings, limit_refusals
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.planned_path import PlannedPath
from ropsim.planning.records.posture_choice import JointRange, nearest_turns
from ropsim.planning.records.wording import coordinate, passes
from ropsim.planning.wrist.wrist_following import SAME_JOINTS, follow_prescribed_wrist, wrist_joints
from ropsim.planning.wrist.wrist_motion import WristMotion, arm_axes
from ropsim.planning.wrist.wrist_points import WristPoints, points_of
from ropsim.spatial import Array, Pose, record


@record
class WristPlanner:
    """Leads a tool along a path by turning the joints of the wrist smoothly from point to point.

    Attributes:
        robot: the arm with its external axes.
        limits: of its joints.
    """

    robot: RobotModel
    limits: JointRange

    def planned(
        self, move: MoveInstruction, path: ToolPath, q_start: Array, so_far: PlannedPath
    ) -> PlannedPath | Refusal:
        """Return the plan of a move with its joints, or why the wrist cannot be followed: M586, M503.

        Args:
            move: the instruction.
            path: of the tool in the base frame, or in that of the coordination; its positions and its points
                count.
            q_start: command joint coordinates at its start [rad | m], shape (n,).
            so_far: limits, tool, coordination and findings of the move.
        """
        if singular_distances(self.robot, q_start) is None:
            why = f"`{self.robot.name}` has no spherical wrist behind three joints that place it"
            return Refusal((no_wrist_angles(move, why),))
        points = points_of(path, q_start, so_far.coordination)
        q_points = self._solved(move, points, so_far.X_MT)
        if isinstance(q_points, str):
            return Refusal((no_wrist_angles(move, q_points),))
        wrist = monotone(points.parameters, q_points[:, list(arm_axes(self.robot)[3:])])
        motion = WristMotion(self.robot, so_far.X_MT, path, wrist, q_start, so_far.coordination)
        following = follow_prescribed_wrist(motion, points.end)
        if following.share < 1.0:
            where = f"beyond {following.share:.0%} of the way the other joints cannot keep the TCP on it"
            return Refusal((no_wrist_angles(move, where),))
        away = np.abs(SampledPath(path.length, following.q).joints(points.parameters).q - q_points).max(
            axis=1
        )
        if away.max() > SAME_JOINTS:
            number = int(np.argmax(away > SAME_JOINTS))
            where = f"on the way to {points.name(number)}"
            why = f"{where} shoulder or elbow would not stay as they are at its start"
            return Refusal((no_wrist_angles(move, why),))
        q = np.vstack((following.q[:-1], q_points[-1:]))
        line = Line(move, PoseSetpoints(path.length, np.zeros((len(q), 4, 4))), q_start, self.robot)
        refusals = limit_refusals(line, q, self.limits)
        if refusals:
            return Refusal(refusals)
        joints = wrist_joints(motion, q)
        findings = so_far.findings + end_findings(move, q[-1])
        return replace(so_far, joints=joints, tool=motion.led_by(joints), findings=findings)

    def _solved(self, move: MoveInstruction, points: WristPoints, X_MT: Pose) -> Array | str:
        """Return all joints at points (k, n), shoulder and elbow as at the start, or which is not reached.

        From point to point the joints of the wrist turn the nearer way.
        """
        robot, q = self.robot, points.q.copy()
        arm, wrist, external = posture(robot, q[0]).words[:2], list(arm_axes(robot)[3:]), list(robot.external)
        same_arm = np.array([name.words[:2] == arm for name in solver_of(robot).postures])
        for k in range(1, len(q)):
            wanted = _joints_wanted(move) if k == points.end else None
            if wanted is not None and posture(robot, wanted).words[:2] == arm:
                q[k] = wanted
                continue
            near = q[k - 1].copy()
            near[external] = q[k, external]
            X_BM = Pose.from_matrix(points.X_BT[k]) @ X_MT.inverse()
            found = inverse(robot, X_BM, IkOptions(Limits.IGNORE, near=near)).branches[same_arm]
            found = nearest_turns(found, near, self.limits)
            found = found[~np.isnan(found).any(axis=1)]
            within = found[(self.limits.excess(found) == 0.0).all(axis=1)]
            if not len(within):
                where = f"{points.name(k)} is not reached with shoulder and elbow as they are at its start"
                return where + self._beyond(found)
            q[k] = within[int(np.argmin(np.abs(within - near)[:, wrist].max(axis=1)))]
        return q

    def _beyond(self, branches: Array) -> str:
        """Return which joint is beyond its limit in the branch (k, n) that is so least; empty for none."""
        if not len(branches):
            return ""
        excess = self.limits.excess(branches)
        row = int(np.argmin(excess.max(axis=1)))
        number = int(np.argmax(excess[row]))
        joint, value = self.limits.joints[number], float(self.limits.values(branches)[row, number])
        limit = joint.upper if value > joint.upper else joint.lower
        found, allowed = coordinate(joint, value), coordinate(joint, limit)
        return f": joint `{joint.name}` would be at {found}, its limit is {allowed}"


def _joints_wanted(move: MoveInstruction) -> Array | None:
    """Return the joint coordinates at the end of a move, None without a target or beyond the limits."""
    return np.array(move.target) if isinstance(move.target, tuple) and move.angle is None else None


def no_wrist_angles(move: MoveInstruction, why: str) -> Diagnostic:
    """Return the error of a move whose tool the angles of the wrist cannot lead, with the reason."""
    return NO_WRIST_ANGLES.at(
        move.origin.span,
        f"the tool cannot be led by the angles of the wrist: {why}",
        label=passes(move.origin),
        hint='use `mov`, or a controller with `orientation = "fixed axis"`',
        data=move.origin.data,
    )
