"""Plans that are kept by the content of their motion sequences, so that nothing is planned twice."""

from collections.abc import Hashable

from ropsim.flow import ModalState, MoveInstruction
from ropsim.model import Cell
from ropsim.planning import MotionChain, MotionSequence
from ropsim.simulation.kept.replaced_lines import on_lines_of
from ropsim.simulation.records.kept_results import KeptResults
from ropsim.simulation.records.planned_sequence import PlannedSequence, planned_anew
from ropsim.spatial import bits_of, bits_without, fingerprint

MOST_BYTES = 200_000_000
"""Number of reference rows that are kept: 20 minutes of motion of six axes at a control rate of 1 kHz."""

_OF_A_MOVE = 10_000
"""Approximate memory of a move in addition to its reference rows [bytes]."""

_MOST_MOVES = 100
"""Keys of moves that are remembered from sequence to sequence."""

_content = bits_without(MoveInstruction, "origin", "modal")


class KeptPlans:
    """Plans of the stations of a cell, each with the standard entities of its controller.

    A plan depends on the moves of its sequence, their passes and their points of lists, on the moves
    known to follow, on the position of the arm before it and on its payload; on nothing else, so that a kept
    plan equals a new one.
    If the lines of its moves have moved in their text, the lines of its findings move also.

    Args:
        cell: whose stations are planned for.
        most: room for references [bytes].

    Attributes:
        anew: sequences that were planned, since the run began.
    """

    def __init__(self, cell: Cell, most: int = MOST_BYTES) -> None:
        self.cell = cell
        self.anew: list[tuple[MoveInstruction, ...]] = []
        self._modal: tuple[ModalState | None, Hashable] = (None, None)
        self._moves: dict[int, tuple[MoveInstruction, Hashable]] = {}
        self._kept: KeptResults[tuple[tuple[MoveInstruction, ...], PlannedSequence]] = KeptResults(most)

    @property
    def used(self) -> int:
        """Return how much room is taken, about [bytes]."""
        return self._kept.used

    def begin(self) -> None:
        """Take notice that another run begins."""
        self._kept.begin()
        self.anew = []

    def plan(self, station: str, chain: MotionChain, order: MotionSequence) -> PlannedSequence:
        """Return the plan of a sequence, made now or before.

        Args:
            station: name of the station in the cell.
            chain: its standard entities.
            order: the moves, and where the arm stands.
        """
        moves = (*order.moves, *order.ahead)
        moves_key = tuple([self._bits(move) for move in moves])
        key = (station, order.q_start.tobytes(), fingerprint(order.payload), moves_key, len(order.ahead))
        kept = self._kept.get(key)
        found = on_lines_of(moves, *kept) if kept else None
        if found is None:
            self.anew.append(order.moves)
            found = planned_anew(station, chain, order)
            self._kept.put(key, (moves, found), _size(found))
        return found

    def _bits(self, move: MoveInstruction) -> Hashable:
        """Return the key of a move, which may be known from the sequence that it was ahead of."""
        known = self._moves.get(id(move))
        if known is None or known[0] is not move:
            if len(self._moves) > _MOST_MOVES:
                self._moves.clear()
            known = move, (_content(move), self._modal_bits(move.modal), move.origin.visit, move.origin.point)
            self._moves[id(move)] = known
        return known[1]

    def _modal_bits(self, modal: ModalState) -> Hashable:
        """Return the key of a modal state, mostly that of the move before."""
        if modal is not self._modal[0]:
            self._modal = modal, bits_of(modal)
        return self._modal[1]


def _size(planned: PlannedSequence) -> int:
    """Return how much room a plan takes, about [bytes]."""
    if planned.motion is None:
        return _OF_A_MOVE
    reference = planned.motion.plan.reference
    rows = sum(one.nbytes for one in (reference.q, reference.qd, reference.qdd))
    return rows + _OF_A_MOVE * len(planned.motion.plan.moves)
