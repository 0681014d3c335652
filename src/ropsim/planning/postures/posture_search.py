"""Search for postures: branches at the ends of PTP moves for which later paths of the tool are feasible.

A PTP move to a pose may end in any branch of the inverse kinematics within the joint limits; a path of the
tool keeps the branch in which it begins. So the branches of each target of this kind are the nodes of a graph
in layers, and the best way to each node is found from the nodes of the layer before (Bellman 1957, Dynamic
Programming).
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ropsim.flow import MotionKind, MoveInstruction
from ropsim.kinematics import (
    IkOptions,
    Limits,
    forward_batch,
    inverse,
    point_answers,
    posture,
    tool_pose,
)
from ropsim.model import RobotModel
from ropsim.motion import POSTURE_CHANGE
from ropsim.planning.moves.planned_move import PlannedMove, planned_move_of, planned_moves
from ropsim.planning.moves.requested_posture import has_requested_posture
from ropsim.planning.moves.target_refusals import posture_for_later
from ropsim.planning.postures.path_conflicts import conflict_of, is_narrow, time_of
from ropsim.planning.records.conflict import Conflict
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.planned_path import Counts
from ropsim.planning.records.posture_choice import JointRange, nearest_turns, turned_branches
from ropsim.spatial import Array, Pose, record

MOST_MOVES = 2000
"""Legs that are tried at most; targets behind them take the nearest posture."""

_SAME = 1e-6
"""Joint coordinates that differ by less are one branch [rad | m]."""


@record
class CandidatePlan:
    """A candidate plan of the first moves of a sequence.

    Attributes:
        q: where it ends [rad | m], shape (n,).
        moves: planned moves.
        refusal: why the next move cannot be made; None where it can, or has not been tried.
        conflicts: how many of its paths whirl the joints.
        changes: for each PTP move that does not end in the nearest branch 1, and 1 for each word of the
            posture that differs.
        narrow: how many of its paths of the tool lead near to a joint limit.
        time: that the moves take, without changes of speed on paths of the tool [s].
    """

    q: Array
    moves: tuple[PlannedMove, ...] = ()
    refusal: Refusal | None = None
    conflicts: int = 0
    changes: int = 0
    narrow: int = 0
    time: float = 0.0

    @property
    def rank(self) -> tuple[int, int, int, int, float]:
        """Return the key to be minimised: minus the moves made, conflicts, changes, narrow, time."""
        return -len(self.moves), self.conflicts, self.changes, self.narrow, self.time


def has_choice(move: MoveInstruction) -> bool:
    """Return whether a move may end in more than one branch: in any, or in the requested ones."""
    return move.kind == MotionKind.PTP and isinstance(move.target, Pose)


def search(
    chain: MotionChain, sequence: Sequence[MoveInstruction], q_start: Array, conflicts: Sequence[Conflict]
) -> CandidatePlan:
    """Return the best candidate plan of a sequence.

    That is the one on which most moves can be made, then fewest paths whirl the joints, then least is changed
    of the nearest postures, then fewest paths lead near to a joint limit, then the time is least.

    Args:
        chain: the entities.
        sequence: moves in order.
        q_start: command joint coordinates at their start [rad | m], shape (n,).
        conflicts: of the candidate plan of the nearest postures, in order; one or more.
    """
    limits = JointRange.of(chain.robot)
    bounds = [*(number for number, move in enumerate(sequence) if has_choice(move)), len(sequence)]
    candidates, ended, tried = (
        [_onward(chain, limits, CandidatePlan(q_start), sequence[: bounds[0]])],
        list[CandidatePlan](),
        0,
    )
    for number, behind in pairwise(bounds):
        starts = list[_Start]()
        for candidate in candidates:
            planned_move = planned_move_of(chain, sequence[number], candidate.q)
            if isinstance(planned_move, Refusal):
                ended.append(replace(candidate, refusal=planned_move))
            else:
                starts.append(_Start(candidate, planned_move))
        goals = _goals(chain, starts, limits) if tried < MOST_MOVES else [one.nearest.q_end for one in starts]
        candidates = []
        for q_end in goals:
            there = _taken(chain, starts, q_end, _reason(conflicts, number))
            if there is None:
                continue
            candidate = _onward(chain, limits, there, sequence[number + 1 : behind])
            tried += len(candidate.moves) - number
            (ended if candidate.refusal else candidates).append(candidate)
    return min(candidates or ended, key=lambda candidate: candidate.rank)


@record
class _Start:
    """A candidate plan up to a PTP move, and the move as the planner makes it."""

    candidate: CandidatePlan
    nearest: PlannedMove


def _goals(chain: MotionChain, starts: Sequence[_Start], limits: JointRange) -> list[Array]:
    """Return all joint coordinates that reach a target as requested, the nearest ones first."""
    found: list[Array] = []
    for start in starts:
        _put(found, start.nearest.q_end)
    if found:
        q = found[0]
        branches = _branches(chain, starts[0].nearest, q)
        request = starts[0].nearest.move.posture
        for row in turned_branches(nearest_turns(branches, q, limits), limits):
            if request is None or has_requested_posture(chain.robot, row, request):
                _put(found, row)
    return found


def _branches(chain: MotionChain, nearest: PlannedMove, q: Array) -> Array:
    """Return all branches that reach the target of a move, which ends at q (n,), shape (b, n)."""
    robot, planned = chain.robot, nearest.planned
    if planned.counts is Counts.POINT:
        point = tool_pose(robot, q, planned.X_MT).position
        return point_answers(robot, planned.X_MT, point, q).branches
    X_BM = Pose.from_matrix(forward_batch(robot, q[np.newaxis])[0])
    return inverse(robot, X_BM, IkOptions(Limits.IGNORE, near=q)).branches


def _put(found: list[Array], q: Array) -> None:
    if not any(_is_same(q, other) for other in found):
        found.append(q)


def _is_same(q: Array, other: Array) -> bool:
    return float(np.abs(q - other).max()) <= _SAME


def _change(robot: RobotModel, q_nearest: Array, q_end: Array) -> int:
    nearest, taken = posture(robot, q_nearest), posture(robot, q_end)
    return 1 + sum(one != other for one, other in zip(nearest.words, taken.words, strict=True))


def _taken(chain: MotionChain, starts: Sequence[_Start], q_end: Array, why: Conflict) -> CandidatePlan | None:
    """Return the best way to joint coordinates; None where the planner makes none.

    Args:
        chain: the entities.
        starts: where the move may begin.
        q_end: where it ends [rad | m], shape (n,).
        why: the conflict that requires another posture than the nearest one.
    """
    best: CandidatePlan | None = None
    for start in starts:
        candidate, move = start.candidate, start.nearest
        changes = candidate.changes
        if not _is_same(move.q_end, q_end):
            other = _to_joints(chain, start, q_end, why)
            if isinstance(other, Refusal):
                continue
            move, changes = other, changes + _change(chain.robot, move.q_end, q_end)
        time = candidate.time + time_of(chain.robot, move, candidate.q)
        found = CandidatePlan(
            move.q_end, (*candidate.moves, move), None, candidate.conflicts, changes, candidate.narrow, time
        )
        if best is None or found.rank < best.rank:
            best = found
    return best


def _to_joints(chain: MotionChain, start: _Start, q_end: Array, why: Conflict) -> PlannedMove | Refusal:
    """Return the move to other joint coordinates of its target, with a hint instead of M511."""
    move = start.nearest.move
    there = replace(move, target=tuple(q_end.tolist()), external=())
    planned_move = planned_move_of(chain, there, start.candidate.q)
    if isinstance(planned_move, Refusal):
        return planned_move
    said = tuple(one for one in start.nearest.findings if one.code != POSTURE_CHANGE.code)
    hint = posture_for_later(move, chain.robot, start.nearest.q_end, q_end, why)
    return replace(planned_move, move=move, findings=said + hint)


def _reason(conflicts: Sequence[Conflict], number: int) -> Conflict:
    """Return the first trouble behind a move, without one the last of all."""
    return next((one for one in conflicts if one.number > number), conflicts[-1])


def _onward(
    chain: MotionChain, limits: JointRange, candidate: CandidatePlan, moves: Sequence[MoveInstruction]
) -> CandidatePlan:
    """Return the candidate plan with moves that have no choice, up to the first infeasible one."""
    q, time, conflicts, narrow = candidate.q, candidate.time, candidate.conflicts, candidate.narrow
    planned, refusal = planned_moves(chain, moves, q)
    for move in planned:
        time += time_of(chain.robot, move, q)
        if move.tool is not None:
            conflicts += conflict_of(chain.robot, move, 0) is not None
            narrow += is_narrow(limits, move)
        q = move.q_end
    return CandidatePlan(q, (*candidate.moves, *planned), refusal, conflicts, candidate.changes, narrow, time)
