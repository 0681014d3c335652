"""A planned move: one move with its path in joint space."""

from collections.abc import Sequence

from ropsim.core import Diagnostic
from ropsim.flow import MoveInstruction
from ropsim.motion import JointPath, ToolPath, end_of
from ropsim.planning.entity_checks.entity_faults import guarded
from ropsim.planning.entity_checks.path_faults import unusable_path, unusable_plan, unusable_tool_path
from ropsim.planning.moves.move_check import check_duration
from ropsim.planning.moves.move_curve import OnCurve
from ropsim.planning.moves.path_following import follow_path
from ropsim.planning.moves.requested_posture import other_posture
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.free_orientation import explained
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.planned_path import PlannedPath
from ropsim.spatial import Array, record


@record
class PlannedMove:
    """A move that can be made.

    Attributes:
        move: the instruction.
        planned: path, limits, tool.
        joints: the path of the joints over the length of the path; None where the move has no length.
        q_end: command joint coordinates at its end [rad | m], shape (n,).
        findings: of planner and inverse transform.
        on_curve: where it is on the curve that takes the place of its path and of those next to it; None
            where its own path is flown.
    """

    move: MoveInstruction
    planned: PlannedPath
    joints: JointPath | None
    q_end: Array
    findings: tuple[Diagnostic, ...]
    on_curve: OnCurve | None = None

    @property
    def tool(self) -> ToolPath | None:
        """Return the path of the tool, None for a path in joint space."""
        return self.planned.tool


def planned_moves(
    chain: MotionChain, moves: Sequence[MoveInstruction], q_start: Array
) -> tuple[list[PlannedMove], Refusal | None]:
    """Return planned moves up to the first one that cannot be made, and why it cannot.

    Args:
        chain: the entities.
        moves: in order.
        q_start: command joint coordinates at their start [rad | m], shape (n,).
    """
    planned, q = list[PlannedMove](), q_start
    for move in moves:
        planned_move = planned_move_of(chain, move, q)
        if isinstance(planned_move, Refusal):
            return planned, planned_move
        planned.append(planned_move)
        q = planned_move.q_end
    return planned, None


def planned_move_of(chain: MotionChain, move: MoveInstruction, q_start: Array) -> PlannedMove | Refusal:
    """Return the planned move that begins at `q_start`, or why it cannot be made.

    Args:
        chain: the entities.
        move: the instruction with its modal state.
        q_start: command joint coordinates at the end of the move before [rad | m], shape (n,).
    """
    made = _made(chain, move, q_start)
    return explained(move, chain.robot, made) if isinstance(made, Refusal) else made


def _made(chain: MotionChain, move: MoveInstruction, q_start: Array) -> PlannedMove | Refusal:
    planner = chain.planner
    planned = guarded(planner, lambda: planner.plan(move, q_start), (PlannedPath,), move)
    if isinstance(planned, Refusal):
        return planned
    wrong = unusable_plan(chain, planned, q_start, move)
    if wrong:
        return wrong
    joints: JointPath | None = planned.joints
    found: tuple[Diagnostic, ...] = ()
    if planned.tool is not None:
        wrong = unusable_tool_path(planner, planned.tool, move)
        if wrong:
            return wrong
        if late := check_duration(
            move, planned.least_time
        ):  # before samples of an overlong path fill the memory
            return Refusal(late)
    if planned.tool is not None and joints is None:
        traced = follow_path(chain, planned.tool, q_start, move, planned.coordination)
        if isinstance(traced, Refusal):
            return traced
        joints, found = traced
    elif joints is not None:
        wrong = unusable_path(planner, joints, q_start, move)
        if wrong:
            return wrong
    if joints is None:
        return PlannedMove(move, planned, None, q_start, planned.findings)
    return _ended(chain, move, planned, joints, found)


def _ended(
    chain: MotionChain,
    move: MoveInstruction,
    planned: PlannedPath,
    joints: JointPath,
    found: tuple[Diagnostic, ...],
) -> PlannedMove:
    """Return the planned move of a path of the joints, with its findings."""
    q_end = end_of(joints)
    found += other_posture(move, chain.robot, q_end)
    return PlannedMove(move, planned, joints, q_end, planned.findings + found)
