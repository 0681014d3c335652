"""Moves of a program with other settings than in the program, for what-if runs."""

from collections.abc import Callable

from ropsim.flow import MoveInstruction
from ropsim.simulation.records.steps import Step

Adaptation = Callable[[MoveInstruction], MoveInstruction]
"""From a move as programmed to the one that is made."""


def as_programmed(move: MoveInstruction) -> MoveInstruction:
    """Return a move unchanged."""
    return move


def adapted(advance: Callable[[], Step], adapt: Adaptation) -> Callable[[], Step]:
    """Return a function that returns the steps of a program with its moves adapted.

    Args:
        advance: returns the next step of the program.
        adapt: maps a move to its adapted form.
    """

    def step() -> Step:
        found = advance()
        return adapt(found) if isinstance(found, MoveInstruction) else found

    return step
