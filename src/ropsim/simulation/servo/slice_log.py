"""The rows of one slice at every control tick, and its judged quantities."""

from typing import Protocol

import numpy as np

from ropsim.simulation.records.tally import Tally
from ropsim.spatial import Array


class Log(Protocol):
    """Destination of the rows of a slice."""

    @property
    def decimation(self) -> int:
        """Return the control ticks between two rows that are to be written."""
        ...

    @property
    def tally(self) -> Tally:
        """Return the worst of all control ticks so far."""
        ...

    def claim(self, tick: int, ticks: int) -> tuple[Array, int]:
        """Return a table and the first row of the next `ticks` ticks; these rows count from now on.

        Args:
            tick: tick at which they start.
            ticks: how many.
        """
        ...


class SliceLog:
    """A log of a slice alone; it may be entered into the log of a run.

    Args:
        tally: with nothing in it.
        width: numbers in a row.
    """

    def __init__(self, tally: Tally, width: int) -> None:
        self.rows = np.empty((0, width))
        self._tally = tally

    @property
    def decimation(self) -> int:
        """Return 1: a row is written at every control tick."""
        return 1

    @property
    def tally(self) -> Tally:
        """Return the worst of the slice."""
        return self._tally

    def claim(self, tick: int, ticks: int) -> tuple[Array, int]:
        """Return the table of the slice, and 0."""
        del tick
        self.rows = np.empty((ticks, self.rows.shape[1]))
        return self.rows, 0
