"""A growing table of recorded rows with bounded memory."""

import numpy as np

from ropsim.spatial import Array

MOST_ROWS = 4_000_000
"""Rows that a table keeps where nothing else is said: an hour at every control tick of 1 kHz."""

_FIRST_ROWS = 4096


class RowLog:
    """One row at every control tick that is a multiple of the decimation.

    When the rows would become more than `most_rows`, every second one is dropped and the decimation doubles.
    How dense the rows are at the end depends on the last tick alone, not on how the run was cut into slices.

    Args:
        width: numbers in a row.
        tick: control tick at which the recording begins.
        decimation: control ticks between two rows, at least 1.
        most_rows: largest number of rows, at least 2.
    """

    def __init__(self, width: int, tick: int, decimation: int, most_rows: int = MOST_ROWS) -> None:
        self._decimation = decimation
        self._most_rows = max(most_rows, 2)
        self._first_tick = -(-tick // decimation) * decimation
        self._rows = 0
        self._table = np.empty((_FIRST_ROWS, width))

    @property
    def decimation(self) -> int:
        """Return the control ticks between two rows."""
        return self._decimation

    @property
    def rows(self) -> int:
        """Return the number of rows."""
        return self._rows

    @property
    def first_tick(self) -> int:
        """Return the tick of the first row, whether it is there already or not."""
        return self._first_tick

    @property
    def ticks(self) -> Array:
        """Return the tick of each row, shape (rows,)."""
        return self._first_tick + self._decimation * np.arange(self._rows, dtype=np.float64)

    @property
    def table(self) -> Array:
        """Return the rows, shape (rows, width); a view."""
        return self._table[: self._rows]

    def begin(self, row: Array) -> None:
        """Enter the row of the first tick, shape (width,)."""
        self._table[0] = row
        self._rows = 1

    def claim(self, tick: int, ticks: int) -> tuple[Array, int]:
        """Return the table and the first row of the next `ticks` ticks; these rows count from now on.

        Args:
            tick: tick at which they start.
            ticks: how many.
        """
        while self._rows + self._due(tick, ticks) > self._most_rows:
            self._thin()
        begin = self._rows
        self._rows += self._due(tick, ticks)
        if self._rows > self._table.shape[0]:
            grown = np.empty((min(2 * self._rows, self._most_rows), self._table.shape[1]))
            grown[:begin] = self._table[:begin]
            self._table = grown
        return self._table, begin

    def rewind(self, tick: int) -> None:
        """Drop the rows behind a tick."""
        self._rows = min(self._rows, max((tick - self._first_tick) // self._decimation + 1, 0))

    def at(self, tick: float) -> Array:
        """Return the row at a tick, linear between two rows, outside the nearest end; shape (width,)."""
        place = (tick - self._first_tick) / self._decimation
        place = min(max(place, 0.0), self._rows - 1.0)
        row = int(place)
        share = place - row
        before = self._table[row]
        after = self._table[min(row + 1, self._rows - 1)]
        return np.asarray(before + share * (after - before))

    def _due(self, tick: int, ticks: int) -> int:
        return (tick + ticks) // self._decimation - tick // self._decimation

    def _thin(self) -> None:
        odd = self._first_tick // self._decimation % 2
        thinned = self._table[odd : self._rows : 2].copy()
        self._table[: len(thinned)] = thinned
        self._rows = len(thinned)
        self._first_tick += odd * self._decimation
        self._decimation *= 2
