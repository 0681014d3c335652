"""Stretches of a program: moves that are known together before the first of them begins."""

from collections.abc import Sequence

from ropsim.core import frozen_dataclass
from ropsim.flow import (
    AwaitInstruction,
    GripAction,
    GripInstruction,
    MessageInstruction,
    MotionKind,
    MoveInstruction,
    OutputInstruction,
    PathTracking,
    SyncInstruction,
    WaitInstruction,
)
from ropsim.icr import Finished
from ropsim.simulation.records.steps import Step, Steps

MOST_AHEAD = 50
"""Paths of the tool that are read behind a motion sequence at most: a program may be endless."""
MOST_MOVES = 20_000
"""Moves that are planned together at most: memory grows with them, and a program may be endless."""
_MOST_STEPS = 1000
"""Steps that are read for them: a program may also print messages endlessly."""

_ENDS = ("HALT", "STOP")
"""ICR instructions with which a program ends."""
_NEEDED_FOR = {
    **dict.fromkeys(_ENDS, "the program ends"),
    "IN": "the program looks at a signal next",
    "TIME": "the program looks at the time next",
    "CURPOSE": "the program asks for the pose of the arm next",
    "ATTAINED": "the program asks for the pose of the arm next",
    "MET": "the program asks next how the move has ended",
}
"""Why the arm stands before an ICR instruction."""


@frozen_dataclass
class ProgramSequence:
    """Moves of which all except the last have a zone, and messages of the program on the way.

    Attributes:
        moves: one or more, in order.
        messages: texts for the operator, each with the number of the move that begins when it is shown;
            behind the last move it is the number of moves.
        next: the next step of the program.
        ahead: paths of the tool that follow upon the stop at its end, in the posture that its last PTP move
            takes; none without a PTP move.
    """

    moves: tuple[MoveInstruction, ...]
    messages: tuple[tuple[int, MessageInstruction], ...]
    next: Step
    ahead: tuple[MoveInstruction, ...] = ()

    def said_before(self, number: int) -> tuple[MessageInstruction, ...]:
        """Return the messages when a move begins; for the number of moves, when the last one has ended."""
        if not self.messages:
            return ()
        return tuple(text for before, text in self.messages if before == number)


def gather(first: MoveInstruction, steps: Steps) -> ProgramSequence:
    """Return the sequence from a move on; the interpreter runs ahead to its end, and to the next PTP.

    A motion sequence ends with a move without a zone or with a condition that ends it, before and behind a
    move that a sensor corrects, and before anything that needs the arm to stand: an output, a gripper, a
    wait, an input that is read, the end of the program; and with `MOST_MOVES` moves. The next step stays to
    be taken.

    Args:
        first: the move.
        steps: of the program behind it.
    """
    moves = [first]
    messages: list[tuple[int, MessageInstruction]] = []
    while True:
        step = steps.ahead(0)
        flows = _flows(moves[-1])
        if isinstance(step, MessageInstruction) and flows:
            messages.append((len(moves), step))
        elif isinstance(step, MoveInstruction) and flows and _may_join(step, moves):
            moves.append(step)
        else:
            return ProgramSequence(tuple(moves), tuple(messages), step, _ahead(moves, steps))
        steps.take()


def _may_join(move: MoveInstruction, moves: Sequence[MoveInstruction]) -> bool:
    """Return whether a move may be planned together with others."""
    return move.tracking is None and len(moves) < MOST_MOVES


def _ahead(moves: Sequence[MoveInstruction], steps: Steps) -> tuple[MoveInstruction, ...]:
    """Return the paths of the tool that follow upon moves in the posture that the last PTP of them takes.

    They go up to the next PTP. Steps are unknown behind a move that a condition ends or a sensor corrects,
    which is no PTP, and behind anything for which the arm has to stand.
    """
    found: list[MoveInstruction] = []
    if moves[-1].guard or not any(one.kind == MotionKind.PTP for one in moves):
        return ()
    for number in range(_MOST_STEPS):
        if len(found) == MOST_AHEAD:
            break
        match steps.ahead(number):
            case MoveInstruction(kind=kind, tracking=None) as move if kind != MotionKind.PTP:
                found.append(move)
                if move.guard is not None:
                    break
            case MessageInstruction():
                continue
            case _:
                break
    return tuple(found)


def _flows(move: MoveInstruction) -> bool:
    """Return whether the next move may begin before a move has ended."""
    return move.guard is None and move.tracking is None and (move.modal.zone > 0.0 or move.modal.passes)


def ends_with_list(sequence: ProgramSequence) -> bool:
    """Return whether the program ends at a point of a list: no zone is missed at the last one."""
    match sequence.next:
        case Finished():
            is_end = True
        case SyncInstruction(before=before):
            is_end = before in _ENDS
        case _:
            is_end = False
    return is_end and sequence.moves[-1].origin.point is not None


def why_it_ends(sequence: ProgramSequence) -> str:
    """Return why the arm has to stand at the end of a sequence."""
    match sequence.next:
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
        case MoveInstruction() if sequence.moves[-1].tracking is not None:
            return "a sensor corrects the move"
        case MoveInstruction(tracking=PathTracking()):
            return "a sensor corrects the next move"
        case MoveInstruction():
            is_full = len(sequence.moves) == MOST_MOVES
            return (
                f"{MOST_MOVES} moves are planned together at most" if is_full else "a condition ends the move"
            )
        case _:
            return "the program waits here until the arm stands"
