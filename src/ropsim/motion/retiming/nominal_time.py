"""How far a motion has come at a time, where it is slowed: nominal time over real time."""

import numpy as np
import numpy.typing as npt

from ropsim.motion.retiming.nominal_time_kernel import motion_time_at, timed
from ropsim.spatial import Array, frozen, record


@record
class NominalTime:
    """Nominal time φ over real time t, with rates dφ/dt in ]0, 1] that have no kinks.

    Between two knots the rate is the cubic with their rates and changes at both ends, and φ its integral.

    Attributes:
        times: real times of the knots [s], from 0 on, rising, shape (m,).
        phi: nominal times there [s], from 0 on, rising, shape (m,).
        rates: dφ/dt there, shape (m,).
        changes: d²φ/dt² there [1/s], shape (m,).
    """

    times: Array
    phi: Array
    rates: Array
    changes: Array

    def __post_init__(self) -> None:
        for name in ("times", "phi", "rates", "changes"):
            object.__setattr__(self, name, frozen(getattr(self, name)))

    @property
    def duration(self) -> float:
        """Return the real time that the whole motion takes [s]."""
        return float(self.times[-1])

    def at(self, times: Array) -> Array:
        """Return nominal time [s], rate and change of the rate [1/s] at real times [s], (k,) to (3, k).

        Times before the start and after the end count as these. Where nothing is slowed, φ is t bit by bit.
        """
        out = np.empty((3, len(times)))
        requested = np.ascontiguousarray(times, dtype=np.float64)
        motion_time_at(self.times, self.phi, self.rates, self.changes, requested, out)
        return out

    def times_of(self, phi: npt.ArrayLike) -> Array:
        """Return about when nominal times are reached [s], evenly between knots.

        Args:
            phi: nominal times [s], shape (k,).
        """
        return np.asarray(np.interp(np.asarray(phi), self.phi, self.times))

    def slower(self, share: float) -> "NominalTime":
        """Return the same timing at a share, in ]0, 1], of all its rates."""
        return NominalTime(self.times / share, self.phi, self.rates * share, self.changes * share**2)


def unslowed(duration: float) -> NominalTime:
    """Return the nominal time of a motion [s] that runs as planned."""
    return NominalTime(np.array([0.0, duration]), np.array([0.0, duration]), np.ones(2), np.zeros(2))


def motion_time(phi: Array, rates: Array, changes: Array) -> NominalTime:
    """Return the nominal time with given rates.

    The time from knot to knot is that in which the integral of the cubic rate is the interval between them:
    the smaller root of Δφ = (w + w')·Δt/2 + (c - c')·Δt²/12 with rates w, w' and changes c, c'. Changes that
    would lead a rate out of ]0, 1] between two knots are brought down.

    Args:
        phi: nominal times of the knots [s], rising, shape (m,).
        rates: in ]0, 1], shape (m,).
        changes: d²φ/dt² [1/s], shape (m,).
    """
    moved, times = np.array(changes, dtype=np.float64), np.empty(len(phi))
    timed(phi, rates, moved, times)
    return NominalTime(times, phi, rates, moved)
