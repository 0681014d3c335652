"""Which limit sets the time of a move."""

from enum import Enum

from ropsim.core import frozen_dataclass


class LimitQuantity(Enum):
    """Quantity of a limit; in a bend, acceleration or jerk limits of joints or tool bound the speed."""

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
        quantity: limited quantity.
        share: of the time of the move during which the limit is reached, in (0, 1].
    """

    joint: str
    quantity: LimitQuantity
    share: float
