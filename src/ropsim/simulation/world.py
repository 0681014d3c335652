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
        longest_wait: a wait without a timeout ends after this time [s].
        look: is called before each reading.
    """

    sensors: SensorInterface
    now: Callable[[], float]
    stand: Callable[[float], bool]
    period: float
    longest_wait: float
    look: Callable[[], None]

    def read(self, channel: str) -> bool | float:
        """Return the present value of a channel; one that is not valid reads as off."""
        self.look()
        sample = self.sensors.read(channel, self.now())
        return sample.value if sample.valid else False

    def time(self) -> float:
        """Return the simulated time [s]."""
        return self.now()

    def wait(self, channel: str, value: bool | float, timeout: float | None) -> bool:  # noqa: FBT001 - a signal's value
        """Stand still until `channel` has `value`; return False when `timeout` [s] or the run is over before.

        Without a timeout the wait ends after `longest_wait`, so that a run always ends.
        """
        start = self.now()
        limit = self.longest_wait if timeout is None or timeout <= 0.0 else timeout
        while self.read(channel) != value:
            over = self.now() - start >= limit
            if over or not self.stand(min(self.now() + self.period, start + limit)):
                return False
        return True
