"""The log of a servo simulation: a growing table and a tally that the compiled slice writes into."""

import numpy as np

from ropsim.dynamics import structure_of
from ropsim.model import RobotModel
from ropsim.simulation.records.row_log import MOST_ROWS, RowLog
from ropsim.simulation.records.tally import Tally
from ropsim.simulation.servo.judged import judged
from ropsim.simulation.servo.log import LogLayout
from ropsim.simulation.servo.plant_code import observe
from ropsim.simulation.servo.slice_log import SliceLog
from ropsim.simulation.servo.state import ServoState
from ropsim.spatial import Array


class Recorder:
    """Collects a row at every control tick that is a multiple of the decimation, the start included.

    A row holds the values at the end of a tick: the state of arm and drives at time tick / control_hz and the
    reference of the same instant, and the output of the amplifiers until then. Judged quantities are checked
    at every control tick, regardless of the number of rows.

    Args:
        robot: the arm; it must have drives.
        start: state at which the recording begins.
        decimation: control ticks between two rows, at least 1.
        most_rows: rows beyond which every second one is dropped and the decimation doubles.
    """

    def __init__(
        self, robot: RobotModel, start: ServoState, decimation: int, most_rows: int = MOST_ROWS
    ) -> None:
        chains = structure_of(robot).drives
        self._robot = robot
        self._layout = LogLayout.of(chains)
        self._log = RowLog(self._layout.width, start.tick, decimation, most_rows)
        self._tally = Tally(judged(chains), self._layout.width)
        if self._log.first_tick == start.tick:
            self._log.begin(self._row_of(start))

    @property
    def decimation(self) -> int:
        """Return the control ticks between two rows that are to be written."""
        return self._log.decimation

    @property
    def tally(self) -> Tally:
        """Return the worst of all control ticks so far."""
        return self._tally

    @property
    def record_ticks(self) -> int:
        """Return the control ticks between two rows that are kept."""
        return self._log.decimation

    @property
    def rows(self) -> int:
        """Return the number of rows so far."""
        return self._log.rows

    @property
    def ticks(self) -> Array:
        """Return the tick of each row, shape (rows,)."""
        return self._log.ticks

    def claim(self, tick: int, ticks: int) -> tuple[Array, int]:
        """Return the log and the first row of the next `ticks` ticks; these rows count from now on.

        Args:
            tick: tick at which they start.
            ticks: how many.
        """
        return self._log.claim(tick, ticks)

    def take(self) -> None:
        """Take notice that the rows claimed have been written."""

    def rewind(self, tick: int, table: Array) -> None:
        """Drop the rows behind a tick, and what the tally has of them.

        Args:
            tick: of the last row that is kept.
            table: of the tally at that tick, shape (4, w).
        """
        self._log.rewind(tick)
        self._tally.restore(table)

    def freeze(self, state: ServoState, ticks: int) -> None:
        """Repeat a state for some ticks: that of an arm of which nothing more is known."""
        row = self._row_of(state)
        self.enter(state.tick, np.tile(row, (ticks, 1)), self._tally.empty().table)

    def slice_log(self) -> SliceLog:
        """Return a log for a single slice, of the same width."""
        return SliceLog(self._tally.empty(), self._layout.width)

    def enter(self, tick: int, rows: Array, tally: Array) -> None:
        """Enter a slice that was written before: only its due rows.

        Args:
            tick: tick at which it starts.
            rows: at every control tick, shape (ticks, w).
            tally: of the slice, with ticks counted from its beginning, shape (4, w).
        """
        self._keep(tick, rows)
        self._tally.merge(tick, tally)

    def q_at(self, tick: float) -> Array:
        """Return the attained joint coordinates at a tick, linear between two rows; shape (n,)."""
        return self.at(tick)["q"]

    def forget(self, tick: int) -> None:
        """Allow discarding coordinates before a tick."""

    def channels(self) -> dict[str, Array]:
        """Return the recorded data by name: views of the log, a column for each joint that has the quantity.

        `LogLayout` has the list of quantities. Those of drives, such as `current`, exist for the joints whose
        drives have them.
        """
        return self._named(self._log.table)

    def at(self, tick: float) -> dict[str, Array]:
        """Return the data of `channels` at a tick, linear between two rows: one number for each column."""
        return {name: values[0] for name, values in self._named(self._log.at(tick)[np.newaxis]).items()}

    def _keep(self, tick: int, rows: Array) -> None:
        """Keep the due rows of the ticks behind `tick`, shape (ticks, w)."""
        table, begin = self._log.claim(tick, len(rows))
        decimation = self._log.decimation
        table[begin : self._log.rows] = rows[-(tick + 1) % decimation :: decimation]

    def _named(self, table: Array) -> dict[str, Array]:
        return {field.name: table[:, field.place] for field in self._layout.fields}

    def _row_of(self, state: ServoState) -> Array:
        row = np.empty(self._layout.width)
        row[self._layout.field("q_ref").place], row[self._layout.field("qd_ref").place] = state.reference[:2]
        observe(self._robot, state.values[: state.layout.integrated], state.output, row)
        return row
