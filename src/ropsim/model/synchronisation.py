"""How the joints of a pose-to-pose move go together."""

from enum import Enum


class Synchronisation(Enum):
    """What the joints of a PTP move share beside start and end.

    With the phase they share one profile: at each time all have the same share of their way behind them, and
    the way is straight in joint space. With the time alone each has a profile of its own, as fast as its
    own limits allow and stretched to the time of the slowest one.
    """

    PHASE = "phase"
    TIME = "time"
