"""A recorder that also keeps the position of the arm at every control tick of its immediate past."""

import numpy as np

from ropsim.model import RobotModel
from ropsim.simulation.records.past import Past
from ropsim.simulation.records.row_log import MOST_ROWS
from ropsim.simulation.servo.recorder import Recorder
from ropsim.simulation.servo.state import ServoState
from ropsim.spatial import Array


class TickRecorder(Recorder):
    """Has a row written at every control tick and keeps the due ones; the bits are the same.

    Args:
        robot: the arm; it must have drives.
        start: state at which the recording begins.
        decimation: control ticks between two rows that are kept, at least 1.
        most_rows: rows beyond which every second one is dropped and the decimation doubles.
    """

    def __init__(
        self, robot: RobotModel, start: ServoState, decimation: int, most_rows: int = MOST_ROWS
    ) -> None:
        super().__init__(robot, start, decimation, most_rows)
        self._past = Past(start.tick, start.q)
        self._written: list[tuple[int, Array]] = []

    @property
    def decimation(self) -> int:
        """Return 1: a row is written at every control tick."""
        return 1

    def claim(self, tick: int, ticks: int) -> tuple[Array, int]:
        """Return a table for the rows of the next `ticks` ticks; they count when `take` is called.

        Args:
            tick: tick at which they start.
            ticks: how many.
        """
        self._written.append((tick, np.empty((ticks, self._layout.width))))
        return self._written[-1][1], 0

    def q_at(self, tick: float) -> Array:
        """Return the attained joint coordinates at a tick that is not forgotten, exact; shape (n,)."""
        return self._past.at(tick)

    def forget(self, tick: int) -> None:
        """Drop the coordinates before a tick."""
        self._past.forget(tick)

    def rewind(self, tick: int, table: Array) -> None:
        """Drop the rows behind a tick, and what the tally has of them; see `Recorder.rewind`."""
        self._written.clear()
        super().rewind(tick, table)

    def take(self) -> None:
        """Keep the due ones of the rows that have been written since the last call."""
        if not self._written:
            return
        tick, rows = self._written[0][0], np.concatenate([rows for _, rows in self._written])
        self._written.clear()
        self._keep(tick, rows)

    def _keep(self, tick: int, rows: Array) -> None:
        """Keep the due rows, and all coordinates for a while."""
        self._past.enter(tick + 1, rows[:, self._layout.field("q").place].copy())
        super()._keep(tick, rows)
