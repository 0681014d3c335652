"""Timings of a motion, each with less of the limits where the one before lacked something."""

import numpy as np

from ropsim.motion.retiming.binding import rates_needed
from ropsim.motion.retiming.constraint_rows import ConstraintRows
from ropsim.motion.retiming.fastest import Speeds
from ropsim.motion.retiming.nominal_time import NominalTime, unslowed
from ropsim.motion.retiming.point_kernel import WORK_ROWS, PointLimits, TimedPoints, lacks_at
from ropsim.motion.retiming.smooth_rates_kernel import SLACK, WORK, smooth_timing, windows_last
from ropsim.motion.retiming.utilisation import ROUNDING
from ropsim.motion.retiming.utilisation_kernel import LOAD, RATE, SWING, WINDOW, Derivatives, give_up
from ropsim.spatial import Array

_ROUNDS_AT_POINTS = 6
_BETWEEN = 2e-7
"""Share of a rate that is reserved for speeds beyond their limits between two grid points."""
_ENDLESS = 1e100


class Attempts:
    """Timings through m grid points of a motion, as fast as shares of its limits allow.

    Args:
        requested: constraint rows of the motion at the grid points.
        planned: the same, or without torque, which then does not count.
        grid_phi: nominal times [s], rising from 0 to the end, shape (m,).
        period: of the control ticks [s].
    """

    def __init__(
        self, requested: ConstraintRows, planned: ConstraintRows, grid_phi: Array, period: float
    ) -> None:
        self._requested, self._grid_phi, m = requested, grid_phi, len(grid_phi)
        self._lasting, self._steps = window_times(requested, float(grid_phi[-1])), np.diff(grid_phi)
        needed = rates_needed(requested, grid_phi, period)
        self._caps = np.where(needed < 1.0 - SLACK, needed * (1.0 - _BETWEEN), 1.0)
        self._shares, self._sigma, self._x = np.ones((4, m)), grid_phi, self._caps**2
        self._work, self._lacks, self._count = np.empty((2, m)), np.empty((4, m)), np.empty(1)
        self.clock: NominalTime = unslowed(float(grid_phi[-1]))
        self.plan_with(planned)

    def plan_with(self, planned: ConstraintRows) -> None:
        """Go on to the timing that is planned with another demand, such as one in which torque counts."""
        self._speeds = Speeds(planned, self._steps)
        self._go()

    @property
    def slowest(self) -> tuple[int, float]:
        """Return the grid point with the lowest rate that limits leave, and its square."""
        point = int(self._x.argmin())
        return point, float(self._x[point])

    def give_up(self, lacks: Array) -> None:
        """Go on to the timing with less of the limits around lacks, of shape (4, m), see `give_up`."""
        give_up(self._sigma, lacks, self._work, self._shares)
        self._go()

    def give_up_at_points(self, more: float) -> None:
        """Reduce by the excess of speed, acceleration and jerk at grid points: few ticks then exceed more.

        Args:
            more: taken off beyond each lack, as a share.
        """
        first, second = self._requested.along()
        paths = first.shape[1] - len(self._requested.bounds.speed)
        speed = np.append(self._requested.bounds.speed, np.full(paths, np.inf))
        most, jerk = np.array(self._requested.most()), np.array(self._requested.most_jerk())
        path, limits, beyond = (
            Derivatives(first, second),
            PointLimits(speed, most, jerk),
            float(np.log1p(more)),
        )
        work, lacks, count = np.empty((WORK_ROWS, first.shape[1])), self._lacks, self._count
        for _ in range(_ROUNDS_AT_POINTS):
            clock = self.clock
            timing = TimedPoints(self._grid_phi, clock.times, clock.rates, clock.changes)
            lacks_at(path, timing, limits, 1.0 + ROUNDING, beyond, work, lacks, count)
            if count[0] == 0.0:
                return
            self.give_up(lacks)

    def _go(self) -> None:
        shares = self._shares
        imposed = (self._caps * shares[RATE]) ** 2
        self._x = self._speeds.under(imposed, self._x, shares[SWING], shares[LOAD])
        self._sigma, self.clock = timing_below(self._grid_phi, self._x, self._lasting, shares[WINDOW])


def timing_below(grid_phi: Array, x: Array, lasting: Array, width: Array) -> tuple[Array, NominalTime]:
    """Return the positions in windows, see `smooth_timing`, shape (m,), and the nominal time.

    Args:
        grid_phi: nominal times [s], rising, shape (m,).
        x: squares of rates; these are nowhere exceeded, except for the least rate that counts, shape (m,).
        lasting: real times that windows last at least, see `window_times` [s], shape (m,).
        width: factor of the windows, shape (m,).
    """
    m = len(grid_phi)
    sigma, times, smooth, changes = np.empty((4, m))
    smooth_timing(grid_phi, x, lasting, width, np.empty((2 + WORK, m + 2)), sigma, times, smooth, changes)
    return sigma, NominalTime(times, grid_phi, smooth, changes)


def window_times(requested: ConstraintRows, longest: float) -> Array:
    """Return how long windows last, so that jerk limits let accelerations swing in them [s], shape (m,).

    Args:
        requested: constraint rows of the plan.
        longest: bound of the result [s].
    """
    bounds, paths = requested.bounds, requested.path_motion
    fast = np.append(
        np.minimum(bounds.speed, _ENDLESS) / bounds.jerk, np.abs(paths.speeds) / paths.most_jerks
    )
    lasting = np.empty(len(requested.points.q))
    windows_last(
        requested.along()[0],
        requested.most(),
        requested.most_jerk(),
        float(np.sqrt(fast.max())),
        longest,
        lasting,
    )
    return lasting
