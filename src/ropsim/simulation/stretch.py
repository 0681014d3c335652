"""Stretches of a program: moves that are known together before the first of them begins."""

from collections.abc import Callable

from ropsim.core import frozen_dataclass
from ropsim.flow import (
    AwaitInstruction,
    GripAction,
    GripInstruction,
    Instruction,
    MessageInstruction,
    MoveInstruction,
    OutputInstruction,
    PathTracking,
    SyncInstruction,
    WaitInstruction,
)
from ropsim.icr import Finished

Step = Instruction | Finished

_NEEDED_FOR = {
    "HALT": "the program ends",
    "STOP": "the program ends",
    "IN": "the program looks at a signal next",
    "TIME": "the program looks at the time next",
    "CURPOSE": "the program asks for the pose of the arm next",
    "ATTAINED": "the program asks for the pose of the arm next",
    "MET": "the program asks next how the move has ended",
}
"""Why the arm stands before an ICR instruction."""


@frozen_dataclass
class Stretch:
    """Moves of which all but the last have a zone, and what the program says on its way.

    Attributes:
        moves: one or more, in order.
        messages: texts for the operator, each with the number of the move that begins when it is shown;
            behind the last move it is the number of moves.
        next: what the program does then.
    """

    moves: tuple[MoveInstruction, ...]
    messages: tuple[tuple[int, MessageInstruction], ...]
    next: Step

    def said_before(self, number: int) -> tuple[MessageInstruction, ...]:
        """Return what is said when a move begins; for the number of moves, when the last one has ended."""
        return tuple(text for before, text in self.messages if before == number)


def gather(first: MoveInstruction, advance: Callable[[], Step]) -> Stretch:
    """Return the stretch that begins with a move; the interpreter runs ahead to its end.

    A stretch ends with a move without a zone or with a condition that ends it, before and behind a move that
    a sensor corrects, and before anything that needs the arm to stand: an output, a gripper, a wait, an input
    that is read, the end of the program.

    Args:
        first: the move.
        advance: returns the next step of the program.
    """
    moves = [first]
    messages: list[tuple[int, MessageInstruction]] = []
    while True:
        step = advance()
        flows = _flows(moves[-1])
        if isinstance(step, MessageInstruction) and flows:
            messages.append((len(moves), step))
        elif isinstance(step, MoveInstruction) and flows and step.tracking is None:
            moves.append(step)
        else:
            return Stretch(tuple(moves), tuple(messages), step)


def _flows(move: MoveInstruction) -> bool:
    """Return whether the next move may begin before a move has ended."""
    return move.guard is None and move.tracking is None and (move.modal.zone > 0.0 or move.modal.passes)


def why_it_ends(stretch: Stretch) -> str:
    """Return why the arm has to stand at the end of a stretch."""
    match stretch.next:
        case Finished():
            return "the program ends"
        case GripInstruction(action=action):
            word = "opens" if action is GripAction.OPEN else "closes"
            return f"the gripper {word} next, when the arm stands"
        case OutputInstruction(channel=channel):
            return f"output `{channel}` is set next, when the arm stands"
        case WaitInstruction():
            return "the program waits next"
        case AwaitInstruction(channel=channel):
            return f"the program waits for `{channel}` next"
        case SyncInstruction(before=before) if before in _NEEDED_FOR:
            return _NEEDED_FOR[before]
        case MoveInstruction() if stretch.moves[-1].tracking is not None:
            return "a sensor corrects the move"
        case MoveInstruction(tracking=PathTracking()):
            return "a sensor corrects the next move"
        case MoveInstruction():
            return "a condition ends the move"
        case _:
            return "the program waits here until the arm stands"
