"""The ideal arm: it is where its reference is."""

import numpy as np

from ropsim.flow import JointReference
from ropsim.model import Payload, RobotModel
from ropsim.simulation.records.fields import fields
from ropsim.simulation.records.past import Past
from ropsim.simulation.records.row_log import MOST_ROWS, RowLog
from ropsim.simulation.records.tally import Tally
from ropsim.simulation.records.tally_kernel import enter_rows
from ropsim.spatial import Array


class KinematicPlant:
    """Follows every reference exactly; records references and nothing else.

    Args:
        robot: with the ranges of its joints.
        q: joint coordinates at time 0 [rad | m], shape (n,).
        record_ticks: control ticks between two recorded rows.
        most_rows: rows beyond which every second one is dropped.
    """

    def __init__(self, robot: RobotModel, q: Array, record_ticks: int, most_rows: int = MOST_ROWS) -> None:
        self._limits = np.array((robot.lower_limits, robot.upper_limits))
        self._q = np.array(q)
        self._qd = np.zeros(len(q))
        self._stands = False  # since it was judged where it is
        self._tick = 0
        self._log = RowLog(2 * len(q), 0, record_ticks, most_rows)
        self._past = Past(0, self._q)
        self._tally = Tally(fields((("overrun", "qd"),) * len(q), 0), 2 * len(q))
        self._worst = np.empty((2, len(q)))
        self._row = np.concatenate([q, np.zeros(len(q))])  # standing still
        self._log.begin(self._row)

    @property
    def q(self) -> Array:
        """Return the joint coordinates [rad | m], shape (n,)."""
        return self._q

    @property
    def qd(self) -> Array:
        """Return the joint speeds [rad/s | m/s], shape (n,)."""
        return self._qd

    @property
    def sensed(self) -> Array:
        """Return coordinates and speeds as motors measure them, shape (2, n)."""
        return np.array([self._q, self._qd])

    @property
    def effort(self) -> Array:
        """Return zeros: nothing drives an ideal arm, shape (n,)."""
        return np.zeros(len(self._q))

    @property
    def plant_steps(self) -> int:
        """Return the integration steps of drives and arm per control tick; 1 where nothing is integrated."""
        return 1

    @property
    def integration(self) -> None:
        """Return None: nothing is integrated."""

    @property
    def tick(self) -> int:
        """Return the control tick that it has come to."""
        return self._tick

    @property
    def record_ticks(self) -> int:
        """Return the control ticks between two recorded rows."""
        return self._log.decimation

    @property
    def tally(self) -> Tally:
        """Return the worst of all control ticks so far."""
        return self._tally

    def follow(self, reference: JointReference, payload: Payload) -> None:
        """Advance to the end of `reference`; the payload changes nothing here."""
        del payload
        table, row = self._log.claim(self._tick, reference.ticks)
        self._judge(reference.q, reference.qd, table, row, -(self._tick + 1) % self._log.decimation)
        self._past.enter(self._tick + 1, reference.q)
        self._q, self._qd = reference.q[-1], reference.qd[-1]
        self._stands = False
        self._tick += reference.ticks

    def hold(self, q: Array, ticks: int, payload: Payload) -> None:
        """Stand still at `q` for `ticks` control ticks: a single row represents all holds there."""
        del payload
        table, row = self._log.claim(self._tick, ticks)
        if not (self._stands and np.array_equal(q, self._q)):
            self._q, self._qd = np.array(q), np.zeros(len(q))
            self._row = np.concatenate((self._q, self._qd))
            self._judge(self._q[np.newaxis], self._qd[np.newaxis], table, row, 1)
            self._past.enter(self._tick + 1, self._q[np.newaxis])
            self._stands = True
        table[row : self._log.rows] = self._row
        self._tick += ticks

    def _judge(self, q: Array, qd: Array, log: Array, row: int, first: int) -> None:
        """Enter coordinates and speeds of the next ticks, shape (k, n) each, into tally and log.

        Args:
            q: coordinates [rad | m].
            qd: speeds [rad/s | m/s].
            log: table of recorded rows.
            row: of it, the first one that is written.
            first: which of the ticks stands there; k or more for none.
        """
        rows, speeds = np.ascontiguousarray(q), np.ascontiguousarray(qd)
        judged = self._limits, self._tally.table, self._tick + 1.0, self._worst
        enter_rows(rows, speeds, *judged, log, row, first, self._log.decimation)

    def q_at(self, tick: float) -> Array:
        """Return the joint coordinates at a tick that is not forgotten [rad | m], shape (n,)."""
        return self._past.at(tick)

    def forget(self, tick: int) -> None:
        """Allow discarding positions of the arm before a tick."""
        self._past.forget(tick)

    def log(self) -> dict[str, Array]:
        """Return tick, q, qd, q_ref and qd_ref."""
        return {"tick": self._log.ticks, **self._named(self._log.table)}

    def at(self, tick: float) -> dict[str, Array]:
        """Return q, qd, q_ref and qd_ref at a tick, shape (n,)."""
        return {name: values[0] for name, values in self._named(self._log.at(tick)[np.newaxis]).items()}

    def _named(self, table: Array) -> dict[str, Array]:
        q, qd = np.ascontiguousarray(table[:, : len(self._q)]), np.ascontiguousarray(table[:, len(self._q) :])
        return {"q": q, "qd": qd, "q_ref": q, "qd_ref": qd}
