"""Paths of the tool that the wrist leads: their joints, or why there are none."""

import numpy as np

from ropsim.controller.entities import Refusal
from ropsim.controller.line_check import Line, end_findings, limit_refusals
from ropsim.controller.planned_path import PlannedPath
from ropsim.controller.posture_choice import JointRange, nearest_turns
from ropsim.controller.wording import passes
from ropsim.controller.wrist_lead import SAME_JOINTS, wrist_lead
from ropsim.controller.wrist_path import WristPath
from ropsim.core import Diagnostic
from ropsim.flow import MotionKind, MoveInstruction, PoseSetpoints
from ropsim.kinematics import IkOptions, Limits, inverse, posture, singular_distances, solver_of
from ropsim.model import RobotModel, held_arm
from ropsim.motion import NO_WRIST_ANGLES, ToolPath, Traced
from ropsim.spatial import Array, Pose, record

LED_KINDS = frozenset({MotionKind.LIN, MotionKind.CIRC})
"""Kinds of moves that the wrist may lead; a curve has orientations of its own at its points."""


@record
class WristPlanner:
    """Leads a tool along a way by turning the joints of the wrist evenly.

    Attributes:
        robot: the arm.
        limits: of its joints.
    """

    robot: RobotModel
    limits: JointRange

    def planned(
        self, move: MoveInstruction, way: ToolPath, q_start: Array, so_far: PlannedPath
    ) -> PlannedPath | Refusal:
        """Return the plan of a move with its joints, or why the wrist cannot lead it: M586, M503.

        Args:
            move: the instruction.
            way: of the tool in the base frame; its positions and its end count.
            q_start: command joint coordinates at its start [rad | m], shape (n,).
            so_far: limits, tool and findings of the move.
        """
        q_end = self._end(move, way, q_start, so_far.X_MT)
        if isinstance(q_end, str):
            return Refusal((no_wrist_angles(move, q_end),))
        lead = wrist_lead(
            self.robot, so_far.X_MT, lambda shares: way.positions(shares * way.length), q_start, q_end
        )
        if lead.share < 1.0:
            where = f"beyond {lead.share:.0%} of the way the other joints cannot keep the TCP on it"
            return Refusal((no_wrist_angles(move, where),))
        if float(np.abs(lead.q[-1] - q_end).max()) > SAME_JOINTS:
            return Refusal(
                (no_wrist_angles(move, "shoulder or elbow would not end as they are at its start"),)
            )
        places = np.linspace(0.0, way.length, len(lead.q))
        line = Line(move, PoseSetpoints(way.length, way.tool(places).matrices), q_start, self.robot)
        refusals = limit_refusals(line, lead.q, self.limits)
        if refusals:
            return Refusal(refusals)
        joints = Traced(way.length, lead.q)
        tool = WristPath(self.robot, way, joints, so_far.X_MT)
        findings = so_far.findings + end_findings(line, q_end)
        return PlannedPath(joints, tool, so_far.limits, so_far.X_MT, findings)

    def _end(self, move: MoveInstruction, way: ToolPath, q_start: Array, X_MT: Pose) -> Array | str:
        """Return the joints at the end, shoulder and elbow as at the start, or why there are none."""
        robot = self.robot
        if singular_distances(robot, q_start) is None:
            return f"`{robot.name}` has no spherical wrist behind three joints that place it"
        arm = posture(robot, q_start).words[:2]
        if move.kind == MotionKind.LIN and isinstance(move.target, tuple):
            wanted = np.array(move.target)
            if posture(robot, wanted).words[:2] == arm:
                return wanted
        X_BT = Pose.from_matrix(way.tool(np.array([way.length])).matrices[0])
        options = IkOptions(Limits.IGNORE, near=q_start)
        branches = nearest_turns(
            inverse(robot, X_BT @ X_MT.inverse(), options).branches, q_start, self.limits
        )
        kept = np.array([name.words[:2] == arm for name in solver_of(robot).postures])
        found = branches[kept & (self.limits.excess(branches) == 0.0).all(axis=1)]  # false for NaN
        if not len(found):
            return "its end is not reached with shoulder and elbow as they are at its start"
        wrist = list((held_arm(robot).axes if robot.external else range(robot.n))[3:])
        nearest: Array = found[int(np.argmin(np.abs(found - q_start)[:, wrist].max(axis=1)))]
        return nearest


def no_wrist_angles(move: MoveInstruction, why: str) -> Diagnostic:
    """Return the error of a move whose tool the angles of the wrist cannot lead, with the reason."""
    return NO_WRIST_ANGLES.at(
        move.origin.span,
        f"the tool cannot be led by the angles of the wrist: {why}",
        label=passes(move.origin),
        hint='use `mov`, or a controller with `orientation = "fixed axis"`',
        data={"pass": move.origin.visit},
    )
