"""The path planner: turns a move instruction into a path, or says why there is none."""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import field, replace
from functools import partial

import numpy as np

from ropsim.core import Diagnostic
from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.kinematics import IkOptions, branches_near, inverse, point_answers, tool_pose
from ropsim.model import ControllerModel, OrientationMode, RobotModel, Synchronisation, Tool
from ropsim.motion import (
    ZERO_LENGTH,
    JointLine,
    JointMotionLimits,
    JointPath,
    ProfileError,
    Standing,
    SynchronisedJoints,
)
from ropsim.planning.entity_checks.chain_check import chain_refusals
from ropsim.planning.entity_checks.entity_faults import guarded, with_reason
from ropsim.planning.entity_checks.path_faults import unusable_tool_path
from ropsim.planning.entity_checks.path_truth import misplaced_tool_path
from ropsim.planning.kinds import TOOL_PATHS, PathRequest, ToolPathMaker
from ropsim.planning.moves.external_check import check_external, with_external
from ropsim.planning.moves.move_check import check_joints, check_kind, check_values, is_near
from ropsim.planning.moves.move_context import MoveContext, move_context_of
from ropsim.planning.moves.point_refusals import point_refused
from ropsim.planning.moves.requested_posture import no_such_posture, with_request
from ropsim.planning.moves.target_refusals import (
    no_arm,
    numeric_hint,
    out_of_range,
    out_of_reach,
    posture_change,
)
from ropsim.planning.moves.wrist_planner import WristPlanner
from ropsim.planning.records.coordination import coordination_along, moved_axes
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.free_orientation import counted_of, with_orientation_of
from ropsim.planning.records.identity_cache import IdentityCache
from ropsim.planning.records.moving_frames import MovingFrame
from ropsim.planning.records.planned_path import Counts, PlannedPath, move_limits
from ropsim.planning.records.posture_choice import JointRange, choose, choose_nearest, nearest_turns
from ropsim.planning.records.work_frames import WorkFrames, inverted
from ropsim.spatial import Array, Pose, frozen, record


@record
class StandardPathPlanner:
    """Plans PTP moves as paths in joint space, all others by the table of tool paths.

    A move takes external axes to the values of its target, and leaves them unchanged without any; they begin
    and end together with the arm. On a path of the tool they move evenly with its path parameter; where they
    move the task frame in force, the path is one in that frame. The target is solved where they end.

    Every move is validated and its target brought into the base frame; a move that cannot be planned is
    refused with all reasons. With a free orientation the points count for an arm with fewer than six axes;
    any other one keeps its orientation of the start, seen from the task frame. Speed override and PTP speed
    share scale the speed limits, the PTP acceleration share scales acceleration and jerk limits.

    Attributes:
        robot: the arm.
        controller: rates, defaults on lines, speed override.
        tools: of the cell, by name.
        frames: task frames of the cell that stand still, X_BK by name.
        default_tool: tool in force where a program names none; empty for none.
        home: joint coordinates of a target without coordinates [rad | m], shape (n,).
        moving: task frames that the external axes of the robot move, by name.
        others: names of the stations that move other task frames, by the name of the frame.
        kinds: tool paths that it makes, by the word of the instruction.
        stops: whether each path ends in a stop, even where a zone is in force.
    """

    robot: RobotModel
    controller: ControllerModel
    tools: Mapping[str, Tool]
    frames: Mapping[str, Pose]
    default_tool: str
    home: Array
    moving: Mapping[str, MovingFrame] = field(default_factory=dict)
    others: Mapping[str, str] = field(default_factory=dict)
    kinds: Mapping[str, ToolPathMaker] = field(default_factory=lambda: TOOL_PATHS)
    stops: bool = False
    _range: JointRange = field(init=False, repr=False)
    _limits: JointMotionLimits = field(init=False, repr=False)
    _work: WorkFrames = field(init=False, repr=False)
    _known: IdentityCache[ModalState, MoveContext | None] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        robot = self.robot
        object.__setattr__(self, "home", frozen(self.home))
        object.__setattr__(self, "_range", JointRange.of(robot))
        limits = JointMotionLimits(robot.max_speeds, robot.max_accelerations, robot.max_jerks)
        object.__setattr__(self, "_limits", limits)
        work = WorkFrames(self.tools, self.frames, self.default_tool, self.moving, self.others)
        object.__setattr__(self, "_work", work)
        known = IdentityCache(partial(move_context_of, robot, limits, self.controller, work))
        object.__setattr__(self, "_known", known)

    def plan(self, move: MoveInstruction, q_start: Array) -> PlannedPath | Refusal:
        """Return the path of a move from `q_start`, or why there is none.

        Args:
            move: the instruction with its modal state.
            q_start: command joint coordinates at the end of the move before [rad | m], shape (n,).
        """
        found = self._planned(move, q_start)
        return replace(found, stops=True) if self.stops and isinstance(found, PlannedPath) else found

    def _planned(self, move: MoveInstruction, q_start: Array) -> PlannedPath | Refusal:
        so_far = self._context(move)
        if isinstance(so_far, Refusal):
            return so_far
        if move.has_free_orientation and isinstance(move.target, Pose):
            so_far = replace(so_far, counts=counted_of(move, self.robot))
            if so_far.counts is Counts.POSE:
                X_BT = tool_pose(self.robot, q_start, so_far.X_MT)
                X_KT = inverted(self._work.frame_pose(move.modal, q_start)) @ X_BT
                move = with_orientation_of(move, X_KT)
        if move.kind not in self.kinds:
            return self._plan_ptp(move, q_start, so_far)
        goal = self._tool_goal(move, q_start, so_far)
        return goal if isinstance(goal, Refusal) else self._plan_tool(move, q_start, so_far, goal)

    def _context(self, move: MoveInstruction) -> PlannedPath | Refusal:
        """Return limits, tool and findings of a move, or why its values cannot be used."""
        target, is_known = move.target, move.kind == MotionKind.PTP or move.kind in self.kinds
        if is_known and isinstance(target, Pose) and not move.external and is_near(target):
            known = self._known(move.modal)
            if known is not None:
                return known.plan
        span = move.origin.span
        X_MT = self._work.tool_pose(move.modal, span)
        problems = (*check_kind(move, self.kinds), *check_values(move))
        if isinstance(X_MT, Diagnostic):
            problems = (*problems, X_MT)
        problems = (*problems, *no_arm(move, self.robot))
        posed = isinstance(move.target, Pose)
        if posed:
            problems = (*problems, *self._work.out_of_hand(move.modal, span))
        if problems or isinstance(X_MT, Diagnostic):
            return Refusal(problems)
        findings = numeric_hint(move, self.robot)
        if posed:
            findings = self._work.frame_findings(move.modal, move.origin) + findings
        limits = move_limits(move.modal, self._limits, self.controller)
        return PlannedPath(None, None, limits, X_MT, findings)

    def _plan_ptp(self, move: MoveInstruction, q_start: Array, so_far: PlannedPath) -> PlannedPath | Refusal:
        if not isinstance(move.target, Pose):
            goal = self._joint_goal(move)
            return goal if isinstance(goal, Refusal) else self._with_joints(move, so_far, q_start, goal)
        wrong = check_external(move, self.robot, self._range)
        if wrong:
            return Refusal(wrong)
        there = with_external(move, q_start, self.robot)
        X_BT = self._work.frame_pose(move.modal, there) @ move.target
        branches = self._branches(move, X_BT, so_far, there)
        if isinstance(branches, Refusal):
            return branches
        if move.posture is not None and move.asks_for_branch and self._range.inside(branches).any():
            as_requested = with_request(self.robot, branches, move.posture)
            if not self._range.inside(as_requested).any():
                return Refusal((no_such_posture(move, self.robot, branches, q_start, self._range),))
            branches = as_requested
        choosing = choose_nearest if so_far.counts is Counts.POINT else choose
        choice = choosing(self.robot, branches, q_start, self._range, so_far.limits.joints)
        if choice is None:
            return Refusal((out_of_range(move, self.robot, branches, self._range),))
        if not choice.keeps_posture and not move.asks_for_branch:
            changed = posture_change(move, self.robot, q_start, choice.q)
            so_far = replace(so_far, findings=so_far.findings + changed)
        return self._with_joints(move, so_far, q_start, choice.q)

    def _with_joints(
        self, move: MoveInstruction, so_far: PlannedPath, q_start: Array, q_end: Array
    ) -> PlannedPath | Refusal:
        """Return the plan of a PTP move; without a path where no joint moves."""
        if max(map(abs, (q_end - q_start).tolist())) <= ZERO_LENGTH:
            return so_far
        joints: JointPath = JointLine(q_start, q_end)
        if self.controller.ptp is Synchronisation.TIME:
            # limits beyond all numbers are left to the line: the move takes too long
            with suppress(ProfileError):
                joints = SynchronisedJoints(q_start, q_end, so_far.limits.joints)
        wrong = chain_refusals(move, self.robot, joints)
        return Refusal(wrong) if wrong else replace(so_far, joints=joints)

    def _plan_tool(
        self, move: MoveInstruction, q_start: Array, so_far: PlannedPath, goal: tuple[Array, Pose]
    ) -> PlannedPath | Refusal:
        q_there, X_BT = goal
        axes = moved_axes(self.robot, q_start, q_there)
        frame = self._work.carried(move.modal, axes)
        X_start = tool_pose(self.robot, q_start, so_far.X_MT)
        if frame:  # all is seen from the frame, which is elsewhere at the end
            X_start, via = frame.pose(q_start).inverse() @ X_start, move.via
            X_end = move.target if isinstance(move.target, Pose) else frame.pose(q_there).inverse() @ X_BT
        else:
            X_BK = self._work.frame_pose(move.modal, q_start)
            X_end, via = X_BT, tuple(X_BK @ X_KT for X_KT in move.via)
        request = PathRequest(move, X_start, via, X_end, self.controller.orientation)
        if so_far.counts is Counts.POINT:
            request = request.of_points()
        make = self.kinds[move.kind]
        path = guarded(make, lambda: make(request), (object,), move)
        if isinstance(path, Refusal):
            return path
        if isinstance(path, tuple):
            return with_reason(make, Refusal(path), move)
        if path is None and not axes:
            return so_far
        if path is None:
            path = Standing(X_end)
        elif wrong := unusable_tool_path(make, path, move) or misplaced_tool_path(make, path, request):
            return wrong
        if axes:
            share = self.controller.speed_override
            along = coordination_along(path, self.robot, q_start, q_there, frame, share)
            so_far = replace(so_far, coordination=along)
        if request.orientation is OrientationMode.WRIST_ANGLES:
            return WristPlanner(self.robot, self._range).planned(move, path, q_start, so_far)
        return replace(so_far, tool=path)

    def _tool_goal(
        self, move: MoveInstruction, q_start: Array, so_far: PlannedPath
    ) -> tuple[Array, Pose] | Refusal:
        """Return where a path of the tool ends: joint coordinates whose external ones count, and X_BT."""
        if not isinstance(move.target, Pose):
            goal = self._joint_goal(move)
            return goal if isinstance(goal, Refusal) else (goal, tool_pose(self.robot, goal, so_far.X_MT))
        wrong = check_external(move, self.robot, self._range)
        if wrong:
            return Refusal(wrong)
        there = with_external(move, q_start, self.robot)
        moves = bool(moved_axes(self.robot, q_start, there))
        there = there if moves else q_start
        X_BT = self._work.frame_pose(move.modal, there) @ move.target
        if move.angle is not None:
            return there, X_BT  # the target determines the circle; neither arm nor axes end there
        branches = self._branches(move, X_BT, so_far, there)
        if isinstance(branches, Refusal):
            return branches
        if not self._range.inside(branches).any():
            return Refusal((out_of_range(move, self.robot, branches, self._range),))
        return there, X_BT

    def _joint_goal(self, move: MoveInstruction) -> Array | Refusal:
        """Return the target in joint coordinates (home without a target)."""
        goal = np.array(move.target) if isinstance(move.target, tuple) else self.home
        problems = check_joints(move, goal, self.robot, self._range)
        return Refusal(problems) if problems else goal

    def _branches(
        self, move: MoveInstruction, X_BT: Pose, so_far: PlannedPath, q_near: Array
    ) -> Array | Refusal:
        """Return all branches that reach X_BT, turned nearest to `q_near`, NaN where absent, (b, n).

        Of a path of points those that reach its position. External axes stand where `q_near` has them.
        """
        if so_far.counts is Counts.POINT:
            answers = point_answers(self.robot, so_far.X_MT, X_BT.position, q_near)
            if not len(answers.branches):
                return Refusal((point_refused(move, X_BT.position, answers, self.robot, q_near),))
            return nearest_turns(answers.branches, q_near, self._range)
        X_BM = X_BT @ inverted(so_far.X_MT)
        branches = branches_near(self.robot, X_BM, q_near)
        if branches is not None:
            return nearest_turns(branches, q_near, self._range)
        shortfall = inverse(self.robot, X_BM, IkOptions(near=q_near)).shortfall
        assert shortfall is not None
        return Refusal((out_of_reach(move, X_BM, so_far.X_MT, shortfall, self.robot, q_near),))
