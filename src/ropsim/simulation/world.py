"""What the interpreter sees of the simulated cell: time and channels."""

from collections.abc import Callable
from dataclasses import dataclass

from ropsim.controller import SensorInterface


@dataclass(frozen=True, slots=True)
class SimulatedWorld:
    """The interpreter's window on a run (`ropsim.icr.World`).

    Attributes:
        sensors: delivers the channels.
        now: returns the simulated time [s].
        stand: lets the arm stand still until a time [s]; returns whether the run goes on then.
        period: how often a waiting program looks at a channel [s].
    """

    sensors: SensorInterface
    now: Callable[[], float]
    stand: Callable[[float], bool]
    period: float

    def read(self, channel: str) -> bool | float:
        """Return the present value of a channel; one that is not valid reads as off."""
        sample = self.sensors.read(channel, self.now())
        return sample.value if sample.valid else False

    def time(self) -> float:
        """Return the simulated time [s]."""
        return self.now()

    def wait(self, channel: str, value: bool | float, timeout: float | None) -> bool:  # noqa: FBT001 - a signal's value
        """Stand still until `channel` has `value`; return False when `timeout` [s] or the run is over before.

        Without a timeout the wait ends after `LONGEST_WAIT`, so that a run always ends.
        """
        start = self.now()
        limit = LONGEST_WAIT if timeout is None or timeout <= 0.0 else timeout
        while self.read(channel) != value:
            over = self.now() - start >= limit
            if over or not self.stand(min(self.now() + self.period, start + limit)):
                return False
        return True


#: A program that waits longer than this for a signal is ended with a finding [s].
LONGEST_WAIT = 600.0
