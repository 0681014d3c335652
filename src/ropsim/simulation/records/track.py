"""A piecewise constant quantity over control ticks: active line, gripper, payload, signals."""

import math
from bisect import bisect_left, bisect_right
from dataclasses import dataclass, field

import numpy as np

from ropsim.spatial import Array


@dataclass(slots=True)
class Track:
    """Changes of one value; grows during a run.

    Attributes:
        ticks: control ticks at which the value changes, ascending.
        values: value from that tick on.
    """

    ticks: list[int] = field(default_factory=list)
    values: list[float] = field(default_factory=list)

    def set(self, tick: int, value: float) -> None:
        """Let the quantity be `value` from `tick` on."""
        if self.values and self.values[-1] == value:
            return
        if self.ticks and self.ticks[-1] == tick:
            self.values[-1] = value
            if self.values[-2:-1] == [value]:
                del self.ticks[-1], self.values[-1]
            return
        self.ticks.append(tick)
        self.values.append(value)

    def value(self, tick: float) -> float:
        """Return the value in force during the control period that ends at a tick."""
        return self.values[max(bisect_left(self.ticks, tick) - 1, 0)] if self.ticks else 0.0

    def until(self, last: int) -> tuple[Array, Array]:
        """Return the ticks and values of the changes up to a tick, that one included, shape (m,) each."""
        count = bisect_right(self.ticks, last)
        return np.array(self.ticks[:count], dtype=np.float64), np.array(self.values[:count], dtype=np.float64)


def tick_at(time: float, hz: int) -> int:
    """Return the first tick that is not before a time [s], so that a time that is one comes back exactly."""
    tick = math.ceil(time * hz)
    return tick - 1 if (tick - 1) / hz >= time else tick
