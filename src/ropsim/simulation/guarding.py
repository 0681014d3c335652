"""Guarded moves: a condition on a channel is looked at while the arm moves."""

from dataclasses import dataclass

from ropsim.flow import Guard
from ropsim.simulation.world import SimulatedWorld


@dataclass(frozen=True, slots=True)
class Lookout:
    """Looks at the condition of a guarded move.

    Attributes:
        guard: the condition.
        world: reads the channel.
        since: when the move began [s].
    """

    guard: Guard
    world: SimulatedWorld
    since: float

    def ends(self) -> bool:
        """Return whether the move ends now: its condition is true, or its time is over; the world is told."""
        guard = self.guard
        self.world.guard_met = guard.holds(self.world.read(guard.channel))
        late = guard.timeout is not None and self.world.now() - self.since >= guard.timeout
        return self.world.guard_met or late
