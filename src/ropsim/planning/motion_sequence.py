"""Input of planning a motion sequence: its moves, the state of the arm, and its payload."""

from ropsim.flow import MoveInstruction
from ropsim.model import Payload
from ropsim.spatial import Array, frozen, record


@record
class MotionSequence:
    """A sequence before it is planned.

    Attributes:
        moves: in order; all except the last may be blended.
        q_start: command joint coordinates at its start [rad | m], shape (n,).
        payload: tool and part as one body.
        ahead: moves that are known to come behind them, in the posture in which they end.
    """

    moves: tuple[MoveInstruction, ...]
    q_start: Array
    payload: Payload
    ahead: tuple[MoveInstruction, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "q_start", frozen(self.q_start))
