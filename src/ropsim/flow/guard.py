"""The condition on a channel that ends a move before its target."""

from enum import Enum

from ropsim.core import frozen_dataclass


class Comparison(Enum):
    """How the value of a channel is compared with that of a guard."""

    IS = "is"
    ABOVE = "above"
    BELOW = "below"


@frozen_dataclass
class Guard:
    """A guarded move ends where its condition is true.

    Attributes:
        channel: monitored channel.
        comparison: the channel has the value, exceeds it or is less than it.
        value: truth value of a digital channel, number of an analog one; fixed when the move begins.
        timeout: the move ends after this time even if its condition has not come true [s]; None for none.
    """

    channel: str
    comparison: Comparison
    value: bool | float
    timeout: float | None = None

    def holds(self, found: bool | float) -> bool:  # noqa: FBT001 - a signal's value
        """Return whether a value of the channel makes the condition true."""
        if self.comparison is Comparison.IS:
            return bool(found) is bool(self.value)
        return found > self.value if self.comparison is Comparison.ABOVE else found < self.value
