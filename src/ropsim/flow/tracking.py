"""The signal by which a move corrects its path while it goes on."""

from enum import StrEnum

from ropsim.core import frozen_dataclass


class ToolDirection(StrEnum):
    """A direction of the tool frame."""

    X = "x"
    Y = "y"
    Z = "z"
    MINUS_X = "-x"
    MINUS_Y = "-y"
    MINUS_Z = "-z"

    @property
    def vector(self) -> tuple[float, float, float]:
        """Return its unit vector in the tool frame."""
        return _VECTORS[self.value]


_VECTORS = {
    "x": (1.0, 0.0, 0.0),
    "y": (0.0, 1.0, 0.0),
    "z": (0.0, 0.0, 1.0),
    "-x": (-1.0, 0.0, 0.0),
    "-y": (0.0, -1.0, 0.0),
    "-z": (0.0, 0.0, -1.0),
}


STANDARD_GAIN = 10.0
"""Gain of a motion that names none: a difference of lengths decays with a time constant of 0.1 s."""


@frozen_dataclass
class PathTracking:
    """A move is shifted along a direction of its tool so that a channel comes to have a value.

    Attributes:
        channel: measured channel, a number.
        value: which it is to have; fixed when the move begins.
        direction: along which the tool goes where the channel reads too much.
        gain: speed of that for each unit of the difference, > 0: [1/s] where the channel is a length [m],
            [m/(N·s)] where it is a force.
    """

    channel: str
    value: float
    direction: ToolDirection = ToolDirection.Z
    gain: float = STANDARD_GAIN
