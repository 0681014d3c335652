"""The ideal arm: it is where its reference is."""

import numpy as np

from ropsim.flow import JointReference
from ropsim.model import Payload, RobotModel
from ropsim.simulation.records.fields import fields
from ropsim.simulation.records.past import Past
from ropsim.simulation.records.row_log import MOST_ROWS, RowLog
from ropsim.simulation.records.tally import Tally
from ropsim.simulation.records.tally_kernel import enter_rows
from ropsim.simulation.state.touching import Touching
from ropsim.simulation.station.wrench_log import WrenchLog
from ropsim.spatial import Array


class KinematicPlant:
    """Follows every reference exactly; records references and nothing else.

    Args:
        robot: with the ranges of its joints.
        q: joint coordinates at time 0 [rad | m], shape (n,).
        record_ticks: control ticks between two recorded rows.
        most_rows: rows beyond which every second one is dropped.
        touching: meant contacts, whose wrench is recorded and moves nothing; None where there are none.
        period: of a control tick [s].
    """

    def __init__(
        self,
        robot: RobotModel,
        q: Array,
        record_ticks: int,
        most_rows: int = MOST_ROWS,
        touching: Touching | None = None,
        period: float = 1e-3,
    ) -> None:
        self._half = 0.5 * period
        self._pressed = WrenchLog(touching, 0, record_ticks, most_rows) if touching is not None else None
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
    def wrench(self) -> Array:
        """Return the contact force [N] and moment [N·m] at the mechanical interface; see `Plant.wrench`."""
        return self._pressed.wrench if self._pressed else np.zeros(6)

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
        self._press(reference.q, reference.qd)
        table, row = self._log.claim(self._tick, reference.ticks)
        self._judge(reference.q, reference.qd, table, row, -(self._tick + 1) % self._log.decimation)
        self._past.enter(self._tick + 1, reference.q)
        self._q, self._qd = reference.q[-1], reference.qd[-1]
        self._stands = False
        self._tick += reference.ticks

    def hold(self, q: Array, ticks: int, payload: Payload) -> None:
        """Stand still at `q` for `ticks` control ticks: a single row represents all holds there."""
        del payload
        self._press(np.tile(q, (ticks, 1)), np.zeros((ticks, len(q))))
        table, row = self._log.claim(self._tick, ticks)
        if not (self._stands and np.array_equal(q, self._q)):
            self._q, self._qd = np.array(q), np.zeros(len(q))
            self._row = np.concatenate((self._q, self._qd))
            self._judge(self._q[np.newaxis], self._qd[np.newaxis], table, row, 1)
            self._past.enter(self._tick + 1, self._q[np.newaxis])
            self._stands = True
        table[row : self._log.rows] = self._row
        self._tick += ticks

    def _press(self, q: Array, qd: Array) -> None:
        """Enter the wrench of the next ticks, at coordinates and speeds at their ends, shape (k, n) each."""
        if self._pressed is None:
            return
        done = 0
        while done < len(q):
            tick = self._tick + done
            found = self._pressed.touching.exerted(q[done] - self._half * qd[done], qd[done], tick)
            until = min(done + max(found.quiet, 1), len(q))
            self._pressed.enter(tick, until - done, found.wrench)
            done = until

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

    def wrench_at(self, tick: float) -> Array:
        """Return the contact wrench at a tick that is not forgotten, as `wrench`; shape (6,)."""
        return self._pressed.wrench_at(tick) if self._pressed else np.zeros(6)

    def forget(self, tick: int) -> None:
        """Allow discarding positions of the arm before a tick."""
        self._past.forget(tick)
        if self._pressed:
            self._pressed.forget(tick)

    def log(self) -> dict[str, Array]:
        """Return tick, q, qd, q_ref and qd_ref, and the contact wrench where something may be touched."""
        pressed = self._pressed.channels() if self._pressed else {}
        return {"tick": self._log.ticks, **self._named(self._log.table), **pressed}

    def at(self, tick: float) -> dict[str, Array]:
        """Return q, qd, q_ref and qd_ref at a tick, shape (n,)."""
        named = {name: values[0] for name, values in self._named(self._log.at(tick)[np.newaxis]).items()}
        return {**named, **(self._pressed.at(tick) if self._pressed else {})}

    def _named(self, table: Array) -> dict[str, Array]:
        q, qd = np.ascontiguousarray(table[:, : len(self._q)]), np.ascontiguousarray(table[:, len(self._q) :])
        return {"q": q, "qd": qd, "q_ref": q, "qd_ref": qd}
