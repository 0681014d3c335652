"""The log of a servo simulation: one growing array that the compiled slice writes into."""

import numpy as np

from ropsim.dynamics import torque_constants
from ropsim.model import RobotModel
from ropsim.simulation.servo_source import LOG_COLUMNS
from ropsim.simulation.servo_state import ServoState
from ropsim.spatial import Array

_FIRST_ROWS = 4096


class Recorder:
    """Collects a row at every control tick that is a multiple of the decimation, the start included.

    A row holds what is at the end of a tick: q, qd and current at time tick / control_hz, beside the voltage
    that led there and the reference for that time. The row of the start holds the start itself as reference
    and the voltage that would keep its current.

    Args:
        robot: the arm; it must have drives.
        start: state at which the recording begins.
        decimation: control ticks between two rows, at least 1.
    """

    def __init__(self, robot: RobotModel, start: ServoState, decimation: int) -> None:
        self._robot = robot
        self._n = robot.n
        self._decimation = decimation
        self._rows = 0
        self._log = np.empty((_FIRST_ROWS, len(LOG_COLUMNS) * robot.n))
        self._first_tick = -(-start.tick // decimation) * decimation
        if self._first_tick == start.tick:
            motors = zip(robot.drives, start.current, start.qd, strict=True)
            voltage = [
                d.motor.resistance * i + d.motor.back_emf_constant * d.ratio * qd for d, i, qd in motors
            ]
            self._log[0] = np.concatenate([start.q, start.qd, start.current, voltage, start.q, start.qd])
            self._rows = 1

    @property
    def decimation(self) -> int:
        """Return the control ticks between two rows."""
        return self._decimation

    @property
    def rows(self) -> int:
        """Return the number of rows so far."""
        return self._rows

    @property
    def ticks(self) -> Array:
        """Return the tick of each row, shape (rows,)."""
        return self._first_tick + self._decimation * np.arange(self._rows, dtype=np.float64)

    def claim(self, tick: int, ticks: int) -> tuple[Array, int]:
        """Return the log and the row at which those of the next `ticks` ticks begin; they count from now on.

        Args:
            tick: tick at which they start.
            ticks: how many.
        """
        begin = self._rows
        self._rows += (tick + ticks) // self._decimation - tick // self._decimation
        if self._rows > self._log.shape[0]:
            grown = np.empty((2 * self._rows, self._log.shape[1]))
            grown[:begin] = self._log[:begin]
            self._log = grown
        return self._log, begin

    def channels(self) -> dict[str, Array]:
        """Return what was recorded: arrays of shape (rows, n), views of the log where possible.

        Names: q [rad | m], qd, current [A], voltage [V], q_ref, qd_ref, and tau, the torque of the drive at
        the joint before friction, G·Kt·i [N·m | N].
        """
        n = self._n
        blocks = {name: self._log[: self._rows, k * n : (k + 1) * n] for k, name in enumerate(LOG_COLUMNS)}
        return {**blocks, "tau": blocks["current"] * torque_constants(self._robot.drives)}
