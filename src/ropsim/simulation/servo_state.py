"""The state of a servo-driven arm: one flat vector with a named layout."""

from dataclasses import dataclass

import numpy as np

from ropsim.spatial import Array, record


@dataclass(frozen=True, slots=True)
class StateLayout:
    """Where things stand in the state vector: q, qd, current, rows of the law's state; n numbers each.

    Attributes:
        n: number of joints.
        law_rows: rows of the law's state.
    """

    n: int
    law_rows: int

    @property
    def size(self) -> int:
        """Return the length of the vector."""
        return (3 + self.law_rows) * self.n

    @property
    def q(self) -> slice:
        """Return the place of the joint coordinates [rad | m]."""
        return slice(0, self.n)

    @property
    def qd(self) -> slice:
        """Return the place of the joint speeds [rad/s | m/s]."""
        return slice(self.n, 2 * self.n)

    @property
    def current(self) -> slice:
        """Return the place of the motor currents [A]."""
        return slice(2 * self.n, 3 * self.n)

    @property
    def law(self) -> slice:
        """Return the place of the law's state, by rows."""
        return slice(3 * self.n, self.size)


@record
class ServoState:
    """Everything that the future of a servo-driven arm depends on, besides a law written in Python.

    Attributes:
        tick: control ticks since time 0.
        values: the state vector, shape (layout.size,), read-only.
        layout: its layout.
    """

    tick: int
    values: Array
    layout: StateLayout

    def __post_init__(self) -> None:
        self.values.flags.writeable = False

    @property
    def q(self) -> Array:
        """Return the joint coordinates [rad | m], shape (n,)."""
        return self.values[self.layout.q]

    @property
    def qd(self) -> Array:
        """Return the joint speeds [rad/s | m/s], shape (n,)."""
        return self.values[self.layout.qd]

    @property
    def current(self) -> Array:
        """Return the motor currents [A], shape (n,)."""
        return self.values[self.layout.current]

    @property
    def law(self) -> Array:
        """Return the law's state, shape (rows, n)."""
        return self.values[self.layout.law].reshape(self.layout.law_rows, self.layout.n)

    def is_finite(self) -> bool:
        """Return whether every number is finite."""
        return bool(np.isfinite(self.values).all())
