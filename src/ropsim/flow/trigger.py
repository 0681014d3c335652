"""An output that is set at a place of a move, not at its end."""

from enum import Enum

from ropsim.core import frozen_dataclass


class Side(Enum):
    """From which end of a move the place of a trigger is counted."""

    BEFORE_END = "before end"
    AFTER_START = "after start"


@frozen_dataclass
class Trigger:
    """Set an output channel where a move is some way or some time from one of its ends.

    Attributes:
        channel: output that is set.
        value: new value.
        side: end of the move from which is counted.
        distance: way of the TCP from there [m], ≥ 0; None where a time is given.
        time: time from there, as planned [s], ≥ 0; None where a distance is given.
    """

    channel: str
    value: bool | int | float
    side: Side
    distance: float | None = None
    time: float | None = None
