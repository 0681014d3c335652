"""Plans that are kept by the content of their stretches: what was planned before is not planned again."""

from collections.abc import Callable, Sequence
from typing import TypeAlias

from ropsim.controller import MotionChain, MotionPlan, MotionState, Refusal, plan
from ropsim.core import frozen_dataclass
from ropsim.flow import MoveInstruction
from ropsim.model import Cell, Payload
from ropsim.spatial import fingerprint

Planned: TypeAlias = tuple[MotionPlan | None, Refusal | None]
Planning: TypeAlias = Callable[[str, MotionChain, Sequence[MoveInstruction], MotionState, Payload], Planned]
"""Plans a stretch of the station of a name; see `ropsim.controller.plan`."""

MOST_BYTES = 200_000_000
"""So much of references is kept: 20 minutes of motion of six axes at a control rate of 1 kHz."""

_OF_A_MOVE = 10_000
"""What a move takes beside its reference rows, about [bytes]."""


def planned_anew(
    station: str,
    chain: MotionChain,
    stretch: Sequence[MoveInstruction],
    state: MotionState,
    payload: Payload,
) -> Planned:
    """Plan a stretch, whatever was planned before."""
    del station
    return plan(chain, stretch, state, payload)


@frozen_dataclass
class _Kept:
    """A plan, how much room it takes [bytes], and the newest run that has asked for it."""

    planned: Planned
    size: int
    run: int


class KeptPlans:
    """Plans of the stations of a cell, each with the standard entities of its controller.

    A plan depends on the moves of its stretch, with the lines that they have in their text, on where the arm
    stands before it and on its payload; on nothing else, so that one that is kept is the one that would be
    made. When there is no room, plans go that neither this run nor the one before it has asked for.

    Args:
        cell: whose stations are planned for.
        most: room for references [bytes].

    Attributes:
        anew: stretches that were planned, since the run began.
    """

    def __init__(self, cell: Cell, most: int = MOST_BYTES) -> None:
        self.cell = cell
        self.anew: list[tuple[MoveInstruction, ...]] = []
        self._most = most
        self._room = most
        self._run = 0
        self._kept: dict[tuple[str, bytes, str], _Kept] = {}

    @property
    def used(self) -> int:
        """Return how much room is taken, about [bytes]."""
        return self._most - self._room

    def begin(self) -> None:
        """Take notice that another run begins."""
        self._run += 1
        self.anew = []

    def plan(
        self,
        station: str,
        chain: MotionChain,
        stretch: Sequence[MoveInstruction],
        state: MotionState,
        payload: Payload,
    ) -> Planned:
        """Return the plan of a stretch, made now or before.

        Args:
            station: name of the station in the cell.
            chain: its standard entities.
            stretch: moves in order.
            state: at rest.
            payload: tool and part as one body.
        """
        moves = tuple(stretch)
        key = (station, state.q.tobytes(), fingerprint((moves, payload)))
        kept = self._kept.get(key)
        if kept is None:
            self.anew.append(moves)
            planned = plan(chain, moves, state, payload)
            kept = _Kept(planned, _size(planned), self._run)
            if not self._has_room(kept.size):
                return planned
            self._room -= kept.size
        self._kept[key] = _Kept(kept.planned, kept.size, self._run)
        return kept.planned

    def _has_room(self, size: int) -> bool:
        """Return whether there is room for a plan [bytes], made by what is not asked for any more."""
        if size > self._room:
            self._kept = {key: one for key, one in self._kept.items() if one.run >= self._run - 1}
            self._room = self._most - sum(one.size for one in self._kept.values())
        return size <= self._room


def _size(planned: Planned) -> int:
    """Return how much room a plan takes, about [bytes]."""
    made = planned[0]
    if made is None:
        return _OF_A_MOVE
    reference = made.reference
    rows = sum(one.nbytes for one in (reference.q, reference.qd, reference.qdd))
    return rows + _OF_A_MOVE * len(made.moves)
