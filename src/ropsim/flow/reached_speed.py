"""How near a move comes to the speed that is programmed for its path, and what keeps it below."""

from enum import Enum

from ropsim.core import frozen_dataclass
from ropsim.flow.critical_limit import LimitQuantity


class SpeedCause(Enum):
    """What keeps a move below the speed of the program."""

    ACCELERATION = "path acceleration"
    JERK = "path jerk"
    TURN_SPEED = "rotation speed"
    TURN_ACCELERATION = "rotation acceleration"
    ZONE = "zone"
    BEND = "bend"
    JOINT = "joint"
    EXTERNAL = "external axis"
    LOOK_AHEAD = "look-ahead"


@frozen_dataclass
class ReachedSpeed:
    """A planned move on a path of the tool that is slower than programmed.

    Speeding up from a stop and slowing down to one is no time lost.

    Attributes:
        top: greatest speed of the TCP on its path [m/s].
        length: of the way of the TCP [m].
        turn: angle by which the tool turns on it [rad].
        lost: time beyond that which it would take if the way from stop to stop were a straight line [s].
        cause: what takes most of it.
        value: what counts: acceleration [m/s²] or jerk [m/s³] of the path, speed [rad/s] or acceleration
            [rad/s²] of rotation, the zone [m], the least radius of a bend [m]; 0 for other causes.
        corner: angle between the directions before and behind the zone [rad], 0 for other causes.
        joint: name of the axis, empty for other causes.
        quantity: of the joint; None for other causes.
        singularity: which one is near where the joint is slow: `wrist`, `elbow`, `shoulder`, or empty.
        helps: limits of the path, acceleration or jerk, that make it quicker when they are raised, the most
            helpful one first; together if neither does alone. None where that was not looked for: of the
            moves of a line only the one that loses most is looked at.
        points: how many points a curve leads through; 0 for other paths.
    """

    top: float
    length: float
    turn: float
    lost: float
    cause: SpeedCause
    value: float = 0.0
    corner: float = 0.0
    joint: str = ""
    quantity: LimitQuantity | None = None
    singularity: str = ""
    helps: tuple[LimitQuantity, ...] | None = None
    points: int = 0
