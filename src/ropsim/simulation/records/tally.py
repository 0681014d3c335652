"""Extreme values of the judged quantities, over all control ticks: magnitude and time."""

import numpy as np

from ropsim.simulation.records.fields import Field
from ropsim.simulation.records.tally_kernel import merge_tables
from ropsim.spatial import Array


class Tally:
    """Running maxima; a recording that is thinner than the control ticks has no say in them.

    Args:
        fields: places of the judged quantities in a row of numbers.
        width: numbers in that row.
    """

    def __init__(self, fields: tuple[Field, ...], width: int) -> None:
        self._fields = {field.name: field for field in fields}
        self._table = np.zeros((4, width))

    @property
    def table(self) -> Array:
        """Return the table for a judge to write into, shape (4, width).

        The rows are the largest magnitude so far, its control tick, the number of ticks at the limit, and the
        last one of these.
        """
        return self._table

    def axes(self, name: str) -> tuple[int, ...]:
        """Return the joints that have a quantity; empty if none has it."""
        return self._fields[name].axes if name in self._fields else ()

    def worst(self, name: str) -> tuple[Array, Array]:
        """Return the largest magnitudes of a quantity and their ticks, shape (k,) each, k its axes."""
        place = self._fields[name].place
        return self._table[0, place], self._table[1, place]

    def at_limit(self, name: str) -> tuple[Array, Array]:
        """Return how many ticks a quantity was at its limit, and the last of them, shape (k,) each."""
        place = self._fields[name].place
        return self._table[2, place], self._table[3, place]

    def empty(self) -> "Tally":
        """Return a tally of the same quantities with nothing in it."""
        return Tally(tuple(self._fields.values()), self._table.shape[1])

    def since(self, tick: int) -> Array:
        """Return the table with ticks counted from a tick on, shape (4, width)."""
        return np.asarray(self._table - np.array([[0.0], [tick], [0.0], [tick]]))

    def restore(self, table: Array) -> None:
        """Take back what was entered since a copy of the table was made, shape (4, width)."""
        self._table[:] = table

    def merge(self, tick: int, table: Array) -> None:
        """Enter another tally, of later ticks.

        Args:
            tick: from which the ticks of the other one are counted.
            table: of the other one, see `since`, shape (4, width).
        """
        merge_tables(self._table, table, float(tick))

    def enter(self, tick: int, rows: Array, full: Array | None = None, first: int = 0) -> None:
        """Enter the rows of the ticks from `tick` on.

        Args:
            tick: of the first row.
            rows: values of the judged quantities, shape (ticks, w).
            full: magnitudes from which on a value is at its limit, shape (w,); None for no limits.
            first: place of the first of these quantities.
        """
        if not len(rows):
            return
        table = self._table[:, first : first + rows.shape[1]]
        sizes = np.abs(np.ascontiguousarray(rows.T))  # along rows without gaps it takes a quarter of the time
        largest = sizes.max(axis=1)
        grown = np.flatnonzero(largest > table[0])
        if len(grown):
            table[0, grown], table[1, grown] = largest[grown], tick + sizes[grown].argmax(axis=1)
        if full is not None:
            there = sizes >= full[:, None]
            some = there.any(axis=1)
            table[2] += there.sum(axis=1)
            last = tick + len(rows) - 1 - there[:, ::-1].argmax(axis=1)
            table[3, some] = last[some]
