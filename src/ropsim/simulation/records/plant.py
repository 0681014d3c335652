"""Followers of joint references: the servo-driven arm, or the ideal arm of a kinematic run."""

from typing import Protocol

import numpy as np

from ropsim.flow import IntegrationFacts, JointReference
from ropsim.model import Payload
from ropsim.simulation.records.tally import Tally
from ropsim.spatial import Array

CONTACT_WRENCH = "contact_wrench"
"""Name of the recorded wrench, in the data of a plant and in the channels of a station."""


class Plant(Protocol):
    """Joint controller, drives and arm as one thing that is driven by references and recorded."""

    @property
    def q(self) -> Array:
        """Return the attained joint coordinates [rad | m], shape (n,)."""
        ...

    @property
    def qd(self) -> Array:
        """Return the attained joint speeds [rad/s | m/s], shape (n,)."""
        ...

    @property
    def sensed(self) -> Array:
        """Return coordinates and speeds as motors measure them, before elastic links, shape (2, n)."""
        ...

    @property
    def effort(self) -> Array:
        """Return the torques of the drives at the joints [N·m | N], shape (n,); 0 without drives."""
        ...

    @property
    def wrench(self) -> Array:
        """Return what the environment exerted on tool and held part over the last control tick, shape (6,).

        Force [N] and moment [N·m] about the origin of the mechanical interface, in the world frame; zeros
        without a contact that the cell declares.
        """
        ...

    @property
    def plant_steps(self) -> int:
        """Return the integration steps of drives and arm per control tick; 1 where nothing is integrated."""
        ...

    @property
    def integration(self) -> IntegrationFacts | None:
        """Return how drives and arm are integrated; None where nothing is."""
        ...

    @property
    def tick(self) -> int:
        """Return the control tick that it has come to."""
        ...

    @property
    def record_ticks(self) -> int:
        """Return the control ticks between two recorded rows."""
        ...

    @property
    def tally(self) -> Tally:
        """Return the worst of all control ticks so far."""
        ...

    def follow(self, reference: JointReference, payload: Payload) -> None:
        """Advance by one control tick per row of `reference`."""
        ...

    def hold(self, q: Array, ticks: int, payload: Payload) -> None:
        """Advance by `ticks` control ticks with a constant reference."""
        ...

    def q_at(self, tick: float) -> Array:
        """Return the attained joint coordinates at a tick that is not forgotten [rad | m], shape (n,).

        They are exact at control ticks, however coarse the recording is, and linear between two of them.
        """
        ...

    def wrench_at(self, tick: float) -> Array:
        """Return the contact wrench over the control tick that ends at a tick, which is not forgotten."""
        ...

    def forget(self, tick: int) -> None:
        """Allow discarding positions of the arm before a tick."""
        ...

    def log(self) -> dict[str, Array]:
        """Return the recorded data: arrays (rows, n) by channel name, and `tick` (rows,)."""
        ...

    def at(self, tick: float) -> dict[str, Array]:
        """Return the data of `log` at a tick, linear between two rows: arrays (n,) by channel name."""
        ...


def constant(q: Array, ticks: int) -> JointReference:
    """Return the reference that stands still at `q`, shape (n,), for `ticks` control ticks."""
    zeros = np.zeros((ticks, len(q)))
    return JointReference(np.tile(q, (ticks, 1)), zeros, zeros)
