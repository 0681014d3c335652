"""The wrench that the environment exerts on a station, over time."""

from math import ceil

import numpy as np

from ropsim.simulation.records.plant import CONTACT_WRENCH
from ropsim.simulation.records.row_log import RowLog
from ropsim.simulation.state.past_values import PastValues
from ropsim.simulation.state.touching import Touching
from ropsim.spatial import Array


class WrenchLog:
    """Present and recorded wrench at the mechanical interface.

    Args:
        touching: finds it.
        tick: control tick at which the recording begins.
        decimation: control ticks between two rows.
        most_rows: rows beyond which every second one is dropped.
    """

    def __init__(self, touching: Touching, tick: int, decimation: int, most_rows: int) -> None:
        self.touching = touching
        self.wrench = np.zeros(6)
        self._past = PastValues(self.wrench)
        self._log = RowLog(6, tick, decimation, most_rows)
        if self._log.first_tick == tick:
            self._log.begin(self.wrench)

    def enter(self, tick: int, ticks: int, wrench: Array) -> None:
        """Enter a wrench that was exerted over the next ticks, shape (6,)."""
        table, row = self._log.claim(tick, ticks)
        table[row : self._log.rows] = wrench
        self.wrench = wrench
        self._past.set(tick + 1, wrench)

    def wrench_at(self, tick: float) -> Array:
        """Return what was exerted over the control tick that ends at a tick, exact; shape (6,)."""
        return self._past.at(ceil(tick))

    def forget(self, tick: int) -> None:
        """Drop what was exerted before a tick."""
        self._past.forget(tick)

    def channels(self) -> dict[str, Array]:
        """Return the rows by name, shape (rows, 6)."""
        return {CONTACT_WRENCH: self._log.table}

    def at(self, tick: float) -> dict[str, Array]:
        """Return the wrench at a tick by name, linear between two rows, shape (6,)."""
        return {CONTACT_WRENCH: self._log.at(tick)}
