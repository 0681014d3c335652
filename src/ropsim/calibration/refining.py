"""Limits that fit all motion sequences at once."""

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence
from ropsim.calibration.replanning import Replan
from ropsim.calibration.sequence_fit import SequenceFit, placed, way_of
from ropsim.calibration.slopes import LimitSlopes
from ropsim.core import frozen_dataclass
from ropsim.spatial import Array

_ROUNDS = 16
_TRIALS = 5
_DAMPING = 1e-3
_MOST_DAMPING = 10.0
_LARGEST_STEP = 0.4
"""Change of the logarithm of a limit in one step at most."""
_ENOUGH = 0.03
"""Improvement of the squared error, as a share of its part without noise, below which the steps end."""
_SWEEPS, _STILL = 200, 1e-6
"""Sweeps over all coordinates at most, and the change of the logarithm of a limit that is none."""
_LEAPS = (0.4, 0.12, 0.04)
"""Changes of the logarithm of a single limit that are tried where steps of all together do not help."""
FITS_WELL = 4e-5
"""Share of its way by which a sequence may be elsewhere for nothing to be left to fit."""
_ROUNDED = 1.0 / math.sqrt(12.0)
"""Standard deviation of rounding, in steps."""
_AT_ROUNDING = 1.5
"""Error in terms of that of rounding up to which it counts as rounding."""
_ROUNDED_ALIKE = 100
"""Samples that count as one where only rounding is wrong: it stays alike while an axis is slow."""
_NO_EFFECT = 1e-9
"""Share of the largest effect that is none."""


@frozen_dataclass
class Trial:
    """Settings with the motions under them.

    Attributes:
        settings: limits and look-ahead.
        fits: of the sequences; None where one has no motion.
    """

    settings: MotionSettings
    fits: tuple[SequenceFit | None, ...]

    @property
    def error(self) -> float:
        """Return the sum of the squared shares, infinite where a sequence has no motion."""
        return total_error(self.fits)

    @property
    def left(self) -> float:
        """Return the share that is left beside noise, root of the mean square over the sequences."""
        return math.sqrt(sum(fit.left**2 if fit else np.inf for fit in self.fits) / max(len(self.fits), 1))

    @property
    def excess(self) -> float:
        """Return the part of the error beyond noise that differs from sample to sample."""
        return self.error - sum((fit.noise / way_of(fit.logged)) ** 2 if fit else 0.0 for fit in self.fits)

    @property
    def is_good(self) -> bool:
        """Return whether nothing is left to fit."""
        return self.left <= FITS_WELL


def fits_under(
    replan: Replan, logged: Sequence[LoggedSequence], settings: MotionSettings
) -> tuple[SequenceFit | None, ...]:
    """Return the motions of sequences under settings, each when it fits best; None where there is none."""
    motions = [replan(one.number, settings) for one in logged]
    return tuple(
        placed(one, settings, motion) if motion is not None and motion.ticks > 1 else None
        for one, motion in zip(logged, motions, strict=True)
    )


def total_error(fits: Sequence[SequenceFit | None]) -> float:
    """Return the sum of the squared shares, infinite where a sequence has no motion."""
    return sum(fit.share**2 if fit else np.inf for fit in fits)


def refined(
    replan: Replan,
    logged: Sequence[LoggedSequence],
    settings: MotionSettings,
    free: npt.NDArray[np.intp],
    rounds: int = _ROUNDS,
) -> Trial:
    """Return settings whose free limits fit all sequences together, with the motions under them.

    Levenberg-Marquardt (Marquardt 1963) on the logarithms of the limits. A limit that a motion just reaches
    acts only downward, and some act upward only together, so steps are sums of what limits do on either side,
    and some of them together. Where no such step helps, single limits are tried farther away: limits that
    nothing reaches have no slope.

    Args:
        replan: plans the sequences.
        logged: the sequences.
        settings: to begin with.
        free: numbers of the limits that may change, in the order of `all`, shape (m,).
        rounds: steps at most.
    """
    best = Trial(settings, fits_under(replan, logged, settings))
    damping, leaps = _DAMPING, list(_LEAPS)
    for _ in range(rounds if len(free) and logged and np.isfinite(best.error) else 0):
        if best.is_good:
            break
        enough = best.error - _ENOUGH * max(best.excess, 0.0)
        found, damping = _stepped(replan, logged, best, free, damping)
        if found.error > enough and leaps:
            found = _leapt(replan, logged, found, free, leaps.pop(0))
            damping = _DAMPING
        best = found
        if best.error > enough and not leaps:
            break
    return best


def _stepped(
    replan: Replan,
    logged: Sequence[LoggedSequence],
    best: Trial,
    free: npt.NDArray[np.intp],
    damping: float,
) -> tuple[Trial, float]:
    """Return a better trial by a step of all limits, the same one where there is none, and the damping."""
    slopes = LimitSlopes(replan, [fit for fit in best.fits if fit], free)
    ways, along = slopes.directions()
    for _ in range(_TRIALS):
        step = ways @ _least_squares(along, slopes.wrong, damping)
        limits = best.settings.all
        limits[free] *= np.exp(np.clip(step, -_LARGEST_STEP, _LARGEST_STEP))
        trial = _tried(replan, logged, best.settings.with_all(limits))
        if trial.error < best.error:
            return trial, max(damping / 6.0, 1e-7)
        if damping > _MOST_DAMPING:
            break
        damping = max(damping * 12.0, 1e-5)
    return best, damping


def _least_squares(A: Array, b: Array, damping: float) -> Array:
    """Return x >= 0 for which A x is nearest to b, damped, shape (m,).

    One coordinate after the other (Franc, Hlavac & Navara 2005, Sequential coordinate-wise algorithm for the
    non-negative least squares problem).
    """
    G, g = A.T @ A, A.T @ b
    size = np.diag(G)
    ridge = damping * size + 1e-9 * float(size.max(initial=0.0)) + 1e-300
    G = G + np.diag(ridge)
    x = np.zeros(len(g))
    for _ in range(_SWEEPS):
        before = x.copy()
        for one in range(len(x)):
            x[one] = max(0.0, x[one] + (g[one] - G[one] @ x) / G[one, one])
        if float(np.abs(x - before).max(initial=0.0)) < _STILL:
            break
    return x


def _leapt(
    replan: Replan, logged: Sequence[LoggedSequence], best: Trial, free: npt.NDArray[np.intp], leap: float
) -> Trial:
    """Return the best trial with each limit in turn lower or higher by a leap, where that helps."""
    for limit in free.tolist():
        for way in (-leap, leap):
            limits = best.settings.all
            limits[limit] *= math.exp(way)
            trial = _tried(replan, logged, best.settings.with_all(limits), best)
            if trial.error < best.error:
                best = trial
                break
    return best


def _tried(
    replan: Replan, logged: Sequence[LoggedSequence], settings: MotionSettings, best: Trial | None = None
) -> Trial:
    """Return a trial; it ends early where it is worse than another one."""
    if best is None:
        return Trial(settings, fits_under(replan, logged, settings))
    fits: list[SequenceFit | None] = []
    most = best.error
    for one in logged:
        fits += fits_under(replan, [one], settings)
        if total_error(fits) > most:
            break
    fits += [None] * (len(logged) - len(fits))
    return Trial(settings, tuple(fits))


def spreads(
    replan: Replan, logged: Sequence[LoggedSequence], settings: MotionSettings, free: npt.NDArray[np.intp]
) -> Array:
    """Return the uncertainty of limits given the trace, as shares, shape (m,).

    They are standard deviations of the logarithms, from the slopes of the joints at the solution and the
    residual error, at least that of rounding to a step of the encoder (Seber & Wild 2003, Nonlinear
    Regression, 2.1). Errors of a sequence beyond rounding are correlated, so its samples count as one. A
    sequence with a small error counts no more than a typical one: wrong limits may also fit it. Limits that
    have an effect only together with others are as uncertain as these leave them.

    Args:
        replan: plans the sequences.
        logged: the sequences.
        settings: that fit best.
        free: numbers of the limits, in the order of `all`.
    """
    fits = [fit for fit in fits_under(replan, logged, settings) if fit is not None]
    typical = math.sqrt(sum(fit.misfit**2 for fit in fits) / max(len(fits), 1))
    A = np.zeros((len(free), len(free)))
    for fit in fits:
        columns = LimitSlopes(replan, [fit], free).down * (way_of(fit.logged) * math.sqrt(fit.logged.q.size))
        rounding = _ROUNDED * float(fit.logged.noise.max())
        error = max(fit.misfit, typical, rounding)
        alike = min(len(columns), _ROUNDED_ALIKE) if error <= _AT_ROUNDING * rounding else len(columns)
        A += columns.T @ columns / (alike * error**2)
    certain = np.linalg.pinv(A, rcond=_NO_EFFECT, hermitian=True) if len(free) else A
    is_determined = np.diag(A @ certain) > 0.5  # of no combination with others that has no effect
    return np.where(is_determined, np.sqrt(np.maximum(np.diag(certain), 0.0)), np.inf)
