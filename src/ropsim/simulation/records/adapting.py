"""Moves of a program with other settings than it gives: what would be if it said so."""

from collections.abc import Callable

from ropsim.flow import MoveInstruction
from ropsim.simulation.records.steps import Step

Adaptation = Callable[[MoveInstruction], MoveInstruction]
"""From a move as the program gives it to the one that is made."""


def as_programmed(move: MoveInstruction) -> MoveInstruction:
    """Return a move as it is."""
    return move


def adapted(advance: Callable[[], Step], adapt: Adaptation) -> Callable[[], Step]:
    """Return what hands out the steps of a program with its moves adapted.

    Args:
        advance: returns the next step of the program.
        adapt: what becomes of a move.
    """

    def step() -> Step:
        found = advance()
        return adapt(found) if isinstance(found, MoveInstruction) else found

    return step
