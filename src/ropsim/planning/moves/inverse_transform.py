"""The inverse transform: pose setpoints to joint samples on one branch of the inverse kinematics."""

from collections.abc import Mapping
from dataclasses import field
from functools import lru_cache

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import JointSamples, MoveInstruction, PoseSetpoints
from ropsim.kinematics import (
    Method,
    followed,
    is_followed,
    path_derivatives,
    redundant_solver_of,
    solver_of,
)
from ropsim.model import RobotModel, Tool
from ropsim.planning.moves.branch_following import BranchFollower, Follow
from ropsim.planning.moves.line_check import Line, end_findings, limit_refusals, lost
from ropsim.planning.moves.point_transform import solve_points
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.free_orientation import counted_of
from ropsim.planning.records.planned_path import Counts
from ropsim.planning.records.posture_choice import JointRange
from ropsim.planning.records.work_frames import WorkFrames
from ropsim.spatial import Array, Pose, frozen, record


@record
class StandardInverseTransform:
    """Solves all setpoints of a path at once and follows the branch of the start.

    Of a move with free orientation an arm with fewer than six axes follows the points, see `solve_points`.

    Attributes:
        robot: the arm.
        tools: of the cell, by name.
        default_tool: tool in force where a program names none; empty for none.
    """

    robot: RobotModel
    tools: Mapping[str, Tool]
    default_tool: str
    _range: JointRange = field(init=False, repr=False)
    _follower: BranchFollower = field(init=False, repr=False)
    _work: WorkFrames = field(init=False, repr=False)

    def __post_init__(self) -> None:
        limits = JointRange.of(self.robot)
        axes = frozen((limits.lower, limits.upper, limits.revolute))
        object.__setattr__(self, "_range", limits)
        object.__setattr__(self, "_follower", BranchFollower(self.robot, axes))
        object.__setattr__(self, "_work", WorkFrames(self.tools, {}, self.default_tool))

    def solve(
        self, setpoints: PoseSetpoints, q_start: Array, move: MoveInstruction
    ) -> JointSamples | Refusal:
        """Return joint samples that continue `q_start` without a jump, or say where it is impossible.

        Args:
            setpoints: X_BT along the path, k rows, with the external axes where those move.
            q_start: joint coordinates at the start [rad | m], shape (n,).
            move: the instruction; names the tool, and its source line stands in the refusals.

        Returns:
            the samples, with M514 as a finding, or a refusal: M501 where the path leaves the reach, M503 at
            a joint limit, M505 at a jump, M506 without a tool, M530 where an arm with few joints cannot take
            a pose of the path.
        """
        X_MT = self.tool_of(move)
        if isinstance(X_MT, Diagnostic):
            return Refusal((X_MT,))
        line = Line(move, setpoints, q_start, self.robot, X_MT)
        if counted_of(move, self.robot) is Counts.POINT:
            return solve_points(line, X_MT, self._range)
        matrices = setpoints.matrices @ _backwards(X_MT)  # X_BM, (k, 4, 4)
        held, derivatives = line.held, None
        if setpoints.parameters is not None and setpoints.derivatives is not None and is_followed(self.robot):
            along = setpoints.parameters, matrices, q_start, X_MT, setpoints.derivatives
            smooth = followed(self.robot, *along)
            found = Follow(q_start[np.newaxis], complete=False) if smooth is None else Follow(smooth[0])
            derivatives = None if smooth is None else smooth[1]
        elif not has_named_branches(self.robot):
            found = self._follower.follow_numerically(matrices, q_start, held)
        else:
            found = self._follower.follow(matrices, q_start, held)
        if not found.within or self._range.coupled.joints:
            refusals = limit_refusals(line, found.q, self._range)
            if not refusals and not found.complete:
                refusals = (lost(line, found, matrices),)
            if refusals:
                return Refusal(refusals)
        if derivatives is None and setpoints.derivatives is not None and setpoints.external is None:
            derivatives = path_derivatives(self.robot, found.q, X_MT, setpoints.derivatives)
        findings = end_findings(move, found.q[-1])
        return JointSamples(setpoints.length, found.q, findings, setpoints.parameters, derivatives)

    def tool_of(self, move: MoveInstruction) -> Pose | Diagnostic:
        """Return X_MT of the tool of a move, or M506."""
        return self._work.tool_pose(move.modal, move.origin.span)


@lru_cache(maxsize=64)
def has_named_branches(robot: RobotModel) -> bool:
    """Return whether the branches of an arm have names, by which one is followed."""
    return solver_of(robot).method is Method.CLOSED_FORM and redundant_solver_of(robot) is None


@lru_cache(maxsize=64)
def _backwards(X_MT: Pose) -> Array:
    """Return the matrix of X_TM, shape (4, 4)."""
    return frozen(X_MT.inverse().matrix())
