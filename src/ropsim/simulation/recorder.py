"""The log of a servo simulation: a growing table that the compiled slice writes into."""

import numpy as np

from ropsim.dynamics import torque_constants
from ropsim.model import RobotModel
from ropsim.simulation.row_log import MOST_ROWS, RowLog
from ropsim.simulation.servo_source import LOG_COLUMNS
from ropsim.simulation.servo_state import ServoState
from ropsim.spatial import Array


class Recorder:
    """Collects a row at every control tick that is a multiple of the decimation, the start included.

    A row holds what is at the end of a tick: q, qd and current at time tick / control_hz, beside the voltage
    that led there and the reference for that time. The row of the start holds the start itself as reference
    and the voltage that would keep its current.

    Args:
        robot: the arm; it must have drives.
        start: state at which the recording begins.
        decimation: control ticks between two rows, at least 1.
        most_rows: rows beyond which every second one is dropped and the decimation doubles.
    """

    def __init__(
        self, robot: RobotModel, start: ServoState, decimation: int, most_rows: int = MOST_ROWS
    ) -> None:
        self._robot = robot
        self._n = robot.n
        self._log = RowLog(len(LOG_COLUMNS) * robot.n, start.tick, decimation, most_rows)
        if self._log.first_tick == start.tick:
            motors = zip(robot.drives, start.current, start.qd, strict=True)
            voltage = [
                d.motor.resistance * i + d.motor.back_emf_constant * d.ratio * qd for d, i, qd in motors
            ]
            self._log.begin(np.concatenate([start.q, start.qd, start.current, voltage, start.q, start.qd]))

    @property
    def decimation(self) -> int:
        """Return the control ticks between two rows."""
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
        """Return the log and the row at which those of the next `ticks` ticks begin; they count from now on.

        Args:
            tick: tick at which they start.
            ticks: how many.
        """
        return self._log.claim(tick, ticks)

    def channels(self) -> dict[str, Array]:
        """Return what was recorded: arrays of shape (rows, n), views of the log where possible.

        Names: q [rad | m], qd, current [A], voltage [V], q_ref, qd_ref, and tau, the torque of the drive at
        the joint before friction, G·Kt·i [N·m | N].
        """
        return self._named(self._log.table)

    def at(self, tick: float) -> dict[str, Array]:
        """Return what `channels` holds at a tick, linear between two rows: arrays of shape (n,)."""
        return {name: values[0] for name, values in self._named(self._log.at(tick)[np.newaxis]).items()}

    def _named(self, table: Array) -> dict[str, Array]:
        n = self._n
        blocks = {name: table[:, k * n : (k + 1) * n] for k, name in enumerate(LOG_COLUMNS)}
        return {**blocks, "tau": blocks["current"] * torque_constants(self._robot.drives)}
