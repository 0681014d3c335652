"""The parts of a time: motion, zones, settling, gripper, waits."""

from collections.abc import Mapping
from enum import Enum

from ropsim.core import frozen_dataclass


class Kind(Enum):
    """Kind of time of a station."""

    MOTION = "motion"
    BLENDING = "blending"
    SETTLING = "settling"
    GRIPPER = "gripper"
    SIGNALS = "signals"
    PARTNERS = "partners"
    TIMERS = "timers"
    OTHER = "other"


Ticks = Mapping[Kind, int]
"""Control ticks by kind."""


@frozen_dataclass
class CycleParts:
    """Composition of a time; every part is a whole number of control ticks.

    Attributes:
        total: the time itself [s]; to the tick the sum of the others.
        motion: on the way, outside of zones [s].
        blending: on the way within zones [s].
        settling: at stops, until the arm was in position [s].
        gripper: while a gripper opened or closed [s].
        signals: at waits for signals that no program sets, including loops that only read them [s].
        partners: at waits for signals that the program of another station sets [s].
        timers: at waits for a time [s].
        other: everything else, such as standing held by hand between two statements [s].
    """

    total: float = 0.0
    motion: float = 0.0
    blending: float = 0.0
    settling: float = 0.0
    gripper: float = 0.0
    signals: float = 0.0
    partners: float = 0.0
    timers: float = 0.0
    other: float = 0.0

    @classmethod
    def of(cls, ticks: Ticks, hz: float) -> "CycleParts":
        """Return the parts of a time.

        Args:
            ticks: control ticks by kind.
            hz: control ticks per second.
        """
        parts = {kind.value: count / hz for kind, count in ticks.items()}
        return cls(sum(ticks.values()) / hz, **parts)

    @property
    def moving(self) -> float:
        """Return the time on the way, outside of zones and within them [s]."""
        return self.motion + self.blending

    @property
    def waits(self) -> float:
        """Return the time at waits of all kinds [s]."""
        return self.signals + self.partners + self.timers
