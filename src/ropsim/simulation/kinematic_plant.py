"""The ideal arm: it is where its reference is."""

import numpy as np

from ropsim.flow import JointReference
from ropsim.model import Payload
from ropsim.simulation.plant import constant
from ropsim.spatial import Array


class KinematicPlant:
    """Follows every reference exactly; records references and nothing else.

    Args:
        q: joint coordinates at time 0 [rad | m], shape (n,).
        record_ticks: control ticks between two recorded rows.
    """

    def __init__(self, q: Array, record_ticks: int) -> None:
        self._q = np.array(q)
        self._tick = 0
        self._record_ticks = record_ticks
        self._rows: list[tuple[Array, Array, Array]] = [
            (np.zeros(1), np.array(q)[None], np.zeros((1, len(q))))
        ]

    @property
    def q(self) -> Array:
        """Return the joint coordinates [rad | m], shape (n,)."""
        return self._q

    def follow(self, reference: JointReference, payload: Payload) -> None:
        """Advance to the end of `reference`; the payload changes nothing here."""
        del payload
        ticks = self._tick + 1 + np.arange(reference.ticks)
        kept = ticks % self._record_ticks == 0
        self._rows.append((ticks[kept].astype(np.float64), reference.q[kept], reference.qd[kept]))
        self._q = np.array(reference.q[-1])
        self._tick += reference.ticks

    def hold(self, q: Array, ticks: int, payload: Payload) -> None:
        """Stand still at `q` for `ticks` control ticks."""
        self.follow(constant(q, ticks), payload)

    def log(self) -> dict[str, Array]:
        """Return tick, q, qd, q_ref and qd_ref."""
        tick, q, qd = (np.concatenate([row[k] for row in self._rows]) for k in range(3))
        return {"tick": tick, "q": q, "qd": qd, "q_ref": q, "qd_ref": qd}
