"""Which limit sets the time of a move."""

from enum import Enum

from ropsim.core import frozen_dataclass


class LimitQuantity(Enum):
    """What a limit bounds; in a bend, acceleration or jerk of the joint or the tool allow no more speed."""

    SPEED = "speed"
    ACCELERATION = "acceleration"
    JERK = "jerk"
    TORQUE = "torque"
    BEND = "bend"


@frozen_dataclass
class CriticalLimit:
    """The limit that a planned move is at for longest: the move is quicker only where this one is higher.

    Attributes:
        joint: name of the axis; empty for a limit of the tool on its path.
        quantity: what is limited.
        share: of the time of the move during which the limit is reached, in (0, 1].
    """

    joint: str
    quantity: LimitQuantity
    share: float
