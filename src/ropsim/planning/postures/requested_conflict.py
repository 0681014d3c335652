"""A posture that the program requests and in which a later path of the tool cannot be followed."""

from collections.abc import Sequence
from dataclasses import replace

from ropsim.core import Diagnostic
from ropsim.flow import MotionKind, MoveInstruction
from ropsim.model import RobotModel
from ropsim.motion import POSTURE_IN_THE_WAY
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.moves.requested_posture import difference, requested_of
from ropsim.planning.records.conflict import Conflict
from ropsim.planning.records.wording import passes
from ropsim.spatial import Pose


def last_request(sequence: Sequence[MoveInstruction]) -> int | None:
    """Return the number of the last move with a posture request; None without one."""
    numbers = range(len(sequence) - 1, -1, -1)
    return next((number for number in numbers if _asks(sequence[number])), None)


def without_request(sequence: Sequence[MoveInstruction], number: int) -> list[MoveInstruction]:
    """Return the moves of a sequence, of which one may end in any posture."""
    move = sequence[number]
    posture = move.posture.of_any_branch if move.posture else None
    return [*sequence[:number], replace(move, posture=posture), *sequence[number + 1 :]]


def conflict_with_request(
    robot: RobotModel, refused: PlannedMove, free: PlannedMove, conflict: Conflict
) -> tuple[Diagnostic, ...]:
    """Return M589 for a move with a posture request.

    Args:
        robot: the arm.
        refused: the move as planned with its request.
        free: of the same move without a request.
        conflict: of the later path with the request.
    """
    move = refused.move
    finding = POSTURE_IN_THE_WAY.at(
        move.origin.span,
        f"{requested_of(move)}, which this move asks for, a later path cannot be followed",
        secondary=conflict.labels,
        label=passes(move.origin),
        notes=(conflict.words,),
        hint=f"leave that out: {difference(robot, free.q_end, refused.q_end)}, and it can be followed",
        data=move.origin.data,
    )
    return (finding,)


def _asks(move: MoveInstruction) -> bool:
    return move.kind == MotionKind.PTP and isinstance(move.target, Pose) and move.asks_for_branch
