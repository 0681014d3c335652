"""The clock of a live run: simulated time that passes with the wall's, at the speed chosen by the user."""

import math
from collections.abc import Callable

SLOWEST, FASTEST = 0.1, 8.0
"""Range of speeds [simulated seconds per second]."""

SLACK = 0.05
"""Delays of the process up to this are made up for, after longer ones the clock has stood [s of the wall]."""


class PacedClock:
    """Simulated time that is shown; it never passes the computed time.

    Args:
        wall: returns the time of the wall clock [s]; only differences count.
        speed: simulated seconds per second.
    """

    def __init__(self, wall: Callable[[], float], speed: float) -> None:
        self._wall = wall
        self._since = wall()
        self._time = 0.0
        self._speed = within_range(speed)
        self._horizon = 0.0

    @property
    def speed(self) -> float:
        """Return the simulated seconds per second."""
        return self._speed

    def now(self) -> float:
        """Return the simulated time that is shown [s]; it stands at the horizon."""
        wall = self._wall()
        self._time += (wall - self._since) * self._speed
        self._since = wall
        return min(self._time, self._horizon)

    def extend(self, horizon: float) -> None:
        """Let the clock pass on to a new horizon [s]; a long stand at the old one is lost."""
        shown = self.now()
        if self._time > shown + SLACK * self._speed:
            self._time = shown
        self._horizon = max(self._horizon, horizon)

    def wait_for(self, time: float) -> float:
        """Return how long it takes on the wall until the clock shows a time [s]; at least 0."""
        return max(time - self.now(), 0.0) / self._speed

    def set_speed(self, speed: float) -> None:
        """Go on at another speed."""
        self._time = self.now()
        self._speed = within_range(speed)


def within_range(speed: float) -> float:
    """Return the nearest speed that the clock can have; 1 for NaN."""
    return 1.0 if math.isnan(speed) else min(max(speed, SLOWEST), FASTEST)
