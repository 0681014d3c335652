"""Plain runs: consecutive moves of one kind to poses, for which one compiled loop does the same."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ropsim.codegen import Compiled
from ropsim.controller.begun import Begun
from ropsim.controller.by_identity import ByIdentity
from ropsim.flow import ModalState, MotionKind, MoveInstruction
from ropsim.spatial import Array, Pose


@dataclass(frozen=True, slots=True, eq=False)
class MoveWork:
    """What moves of one modal state have in common.

    Attributes:
        begun: limits and tool.
        lead: a compiled loop behind task frame and tool; one and the same for equal ones.
        in_base: whether targets are given in the base frame.
    """

    begun: Begun
    lead: Compiled
    in_base: bool


_MOST = 64
"""Moves of a run: where one is left to be made by itself, those behind it are looked at again."""

Works = ByIdentity[ModalState, MoveWork | None]
"""What is known of modal states; None where moves are to be planned one by one."""


def run_of(moves: Sequence[MoveInstruction], first: int, kind: MotionKind, works: Works) -> list[MoveWork]:
    """Return what is known of the moves of a run; none where the first one is not plain.

    A run has so few moves that what is found of a stretch takes a time in proportion to its moves.

    Args:
        moves: in order.
        first: number of the move with which the run begins.
        kind: of its moves.
        works: what is known of modal states.
    """
    found = list[MoveWork]()
    for move in moves[first : first + _MOST]:
        is_plain = move.kind == kind and isinstance(move.target, Pose) and not move.external
        work = works(move.modal) if is_plain else None
        if work is None or (found and work.lead is not found[0].lead):
            break
        found.append(work)
    return found


def targets_of(moves: Sequence[MoveInstruction]) -> Array:
    """Return targets that are poses: positions [m] and unit quaternions (w, x, y, z), shape (m, 7)."""
    parts = [part for move in moves for part in _parts(move.target)]
    return np.concatenate(parts).reshape(len(moves), 7)


def _parts(target: object) -> tuple[Array, Array]:
    assert isinstance(target, Pose)
    return target.position, target.orientation
