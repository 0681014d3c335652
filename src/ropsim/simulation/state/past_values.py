"""The immediate past of a run: values that change in steps, and for how long it is kept."""

from collections import deque
from math import ceil
from typing import Generic, TypeVar

from ropsim.model import Cell, ForceTorqueSensor

Value = TypeVar("Value")
_ACCELERATING = 2
"""Control ticks before the present one that accelerations are found from."""


class PastValues(Generic[Value]):
    """Changes from the first tick on that others may still request.

    Args:
        value: that holds from the beginning.
    """

    def __init__(self, value: Value) -> None:
        self._changes: deque[tuple[int, Value]] = deque([(0, value)])

    def set(self, tick: int, value: Value) -> None:
        """Let a value hold from a tick on, which is not before any other change."""
        if self._changes[-1][0] == tick:
            self._changes.pop()
        self._changes.append((tick, value))

    def forget(self, tick: int) -> None:
        """Drop what does not hold at a tick or later any more."""
        while len(self._changes) > 1 and self._changes[1][0] <= tick:
            self._changes.popleft()

    def at(self, tick: int) -> Value:
        """Return the value that holds at a tick; before those that are kept, the first one."""
        known = (value for since, value in reversed(self._changes) if since <= tick)
        return next(known, self._changes[0][1])


def memory_of(cell: Cell) -> float:
    """Return the greatest age of what a sensor of a cell tells [s]; 0 where all tell the present."""
    sensors = [signal.sensor for signal in cell.signals.values() if signal.sensor is not None]
    return max((one.errors.period + one.errors.delay for one in sensors), default=0.0)


def memory_ticks(cell: Cell, hz: int) -> int:
    """Return for how many control ticks a station keeps where its arm was; 0 for no longer than others need.

    Args:
        cell: with the sensors.
        hz: control ticks per second of the station.
    """
    sensors = [signal.sensor for signal in cell.signals.values()]
    weighs = any(isinstance(one, ForceTorqueSensor) and not one.compensated for one in sensors)
    age = memory_of(cell)
    return (ceil(age * hz) + 1 if age else 0) + (_ACCELERATING if weighs else 0)
