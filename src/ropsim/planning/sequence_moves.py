"""The planned moves of a sequence: each from the end of the one before, in postures that suit later ones."""

from collections.abc import Sequence
from dataclasses import replace

from ropsim.flow import MoveInstruction
from ropsim.planning.moves.planned_move import PlannedMove, planned_moves
from ropsim.planning.postures.path_conflicts import conflict_of, conflict_of_refusal
from ropsim.planning.postures.posture_search import has_choice, search
from ropsim.planning.postures.requested_conflict import conflict_with_request, last_request, without_request
from ropsim.planning.records.conflict import Conflict
from ropsim.planning.records.entities import Refusal
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.spatial import Array


def sequence_moves(
    chain: MotionChain, sequence: Sequence[MoveInstruction], ahead: Sequence[MoveInstruction], q_start: Array
) -> tuple[list[PlannedMove], Refusal | None]:
    """Return the planned moves of a sequence up to the first infeasible one, and why it cannot.

    Every move takes the nearest posture by default. Where a path of the tool then meets a joint limit or a
    singularity, or whirls the joints near one, other postures are tried for the PTP moves before it; that one
    is taken in which most moves can be made. Where a path cannot be followed in a requested posture, but
    could without the request, a finding says so.

    Args:
        chain: the entities.
        sequence: moves in order.
        ahead: moves that follow upon the stop at its end, up to the next PTP move.
        q_start: command joint coordinates at their start [rad | m], shape (n,).
    """
    moves, count = (*sequence, *ahead), len(sequence)
    planned, refusal = _chosen(chain, moves, q_start)
    if refusal:
        planned = _explained(chain, moves, q_start, planned, refusal)
    return planned[:count], refusal if len(planned) < count else None


def _explained(
    chain: MotionChain,
    moves: Sequence[MoveInstruction],
    q_start: Array,
    planned: list[PlannedMove],
    refusal: Refusal,
) -> list[PlannedMove]:
    """Return planned moves with a finding on the move whose requested posture makes a later one infeasible.

    Args:
        chain: the entities.
        moves: in order.
        q_start: command joint coordinates at their start [rad | m], shape (n,).
        planned: planned moves before the refused one.
        refusal: of that.
    """
    refused = len(planned)
    requested = last_request(moves[:refused])
    conflicts = conflict_of_refusal(moves[refused], refusal, refused)
    if requested is None or not conflicts:
        return planned
    free, _ = _chosen(chain, without_request(moves[: refused + 1], requested), q_start)
    if len(free) <= refused:
        return planned
    said = conflict_with_request(chain.robot, planned[requested], free[requested], conflicts[0])
    return [
        *planned[:requested],
        replace(planned[requested], findings=planned[requested].findings + said),
        *planned[requested + 1 :],
    ]


def _chosen(
    chain: MotionChain, sequence: Sequence[MoveInstruction], q_start: Array
) -> tuple[list[PlannedMove], Refusal | None]:
    moves, refusal = planned_moves(chain, sequence, q_start)
    conflicts = _conflicts(chain, sequence, moves, refusal)
    if not conflicts:
        return moves, refusal
    best = search(chain, sequence, q_start, conflicts)
    return (moves, refusal) if best.changes == 0 else (list(best.moves), best.refusal)


def _conflicts(
    chain: MotionChain,
    sequence: Sequence[MoveInstruction],
    moves: Sequence[PlannedMove],
    refusal: Refusal | None,
) -> list[Conflict]:
    """Return the conflicts that another posture may avoid, in order of the moves; empty without a choice."""
    first = next((number for number, move in enumerate(moves) if has_choice(move.move)), len(moves))
    conflicts = [
        found
        for number, move in enumerate(moves[first:], first)
        if move.tool is not None and (found := conflict_of(chain.robot, move, number))
    ]
    if refusal and first < len(moves):
        conflicts += conflict_of_refusal(sequence[len(moves)], refusal, len(moves))
    return conflicts
