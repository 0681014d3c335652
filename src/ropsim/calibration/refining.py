"""Refining common limits on all sequences at once."""

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence
from ropsim.calibration.replanning import Replan, coordinates, speeds
from ropsim.calibration.sequence_fit import SequenceFit, placed
from ropsim.spatial import Array

_STEP = 0.03
_ROUNDS = 8
_LARGEST_STEP = 0.1
_ENOUGH = 1e-3
_ROUNDED = 1.0 / math.sqrt(12.0)
"""Standard deviation of rounding, in steps."""
_AT_ROUNDING = 1.5
"""Error in terms of that of rounding up to which it counts as rounding."""
_ROUNDED_ALIKE = 100
"""Samples that count as one where only rounding is wrong: it stays alike while an axis is slow."""
_NO_EFFECT = 1e-9
"""Share of the largest effect that is none."""


def fits_under(
    replan: Replan, logged: Sequence[LoggedSequence], settings: MotionSettings
) -> list[SequenceFit | None]:
    """Return the motions of sequences under settings, each when it fits best; None where there is none."""
    motions = [replan(one.number, settings) for one in logged]
    return [
        placed(one, settings, motion) if motion is not None and motion.ticks > 1 else None
        for one, motion in zip(logged, motions, strict=True)
    ]


def total_error(fits: Sequence[SequenceFit | None]) -> float:
    """Return the sum of the squares of the errors, infinite where a sequence has no motion [rad² | m²]."""
    return sum(fit.error**2 if fit else np.inf for fit in fits)


def refined(
    replan: Replan, logged: Sequence[LoggedSequence], settings: MotionSettings, free: npt.NDArray[np.intp]
) -> MotionSettings:
    """Return settings whose free limits fit all sequences together better.

    Gauss-Newton on the logarithms of the limits; the start of each sequence is eliminated (Golub & Pereyra
    1973).

    Args:
        replan: plans the sequences.
        logged: the sequences.
        settings: near the best ones.
        free: numbers of the limits that may change, in the order of `all`, shape (m,).
    """
    fits = fits_under(replan, logged, settings)
    error = total_error(fits)
    for _ in range(_ROUNDS if len(free) and np.isfinite(error) else 0):
        step = _step(replan, [fit for fit in fits if fit], settings, free)
        improved = False
        for share in (1.0, 0.5, 0.25, 0.1):
            changed = settings.all
            changed[free] *= np.exp(np.clip(share * step, -_LARGEST_STEP, _LARGEST_STEP))
            trial = settings.with_all(changed)
            found = fits_under(replan, logged, trial)
            if (less := total_error(found)) < error:
                improved = less < (1.0 - _ENOUGH) * error
                settings, fits, error = trial, found, less
                break
        if not improved:
            break
    return settings


def _step(
    replan: Replan, fits: Sequence[SequenceFit], settings: MotionSettings, free: npt.NDArray[np.intp]
) -> Array:
    A, b = np.zeros((len(free), len(free))), np.zeros(len(free))
    for fit in fits:
        columns, wrong = _slopes(replan, fit, settings, free)
        A += columns.T @ columns / len(wrong)
        b += columns.T @ wrong / len(wrong)
    size = np.diag(A).copy()
    ridge = np.diag(1e-3 * size + 1e-9 * float(size.max(initial=0.0)) + 1e-300)
    return np.asarray(np.linalg.solve(A + ridge, b))


def _slopes(
    replan: Replan, fit: SequenceFit, settings: MotionSettings, free: npt.NDArray[np.intp]
) -> tuple[Array, Array]:
    """Return how the joints of a sequence change with the logarithms of limits, its start aside.

    Returns:
        [rad | m], shape (k, m), and the present error, shape (k,), for all samples of all axes.
    """
    times = fit.logged.time - fit.start
    here, late = coordinates(fit.motion, times).ravel(), speeds(fit.motion, times).ravel()
    columns = np.zeros((len(here), len(free)))
    for column, number in enumerate(free.tolist()):
        lower = settings.all
        lower[number] *= np.exp(-_STEP)
        motion = replan(fit.logged.number, settings.with_all(lower))
        if motion is not None:
            columns[:, column] = (coordinates(motion, times).ravel() - here) / -_STEP
    weight = float(late @ late)
    if weight > 0.0:
        columns -= np.outer(late, late @ columns) / weight
    return columns, fit.logged.q.ravel() - here


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
    typical = math.sqrt(sum(fit.error**2 for fit in fits) / max(len(fits), 1))
    A = np.zeros((len(free), len(free)))
    for fit in fits:
        columns, _ = _slopes(replan, fit, settings, free)
        rounding = _ROUNDED * float(fit.logged.noise.max())
        error = max(fit.error, typical, rounding)
        alike = min(len(columns), _ROUNDED_ALIKE) if error <= _AT_ROUNDING * rounding else len(columns)
        A += columns.T @ columns / (alike * error**2)
    certain = np.linalg.pinv(A, rcond=_NO_EFFECT, hermitian=True) if len(free) else A
    is_determined = np.diag(A @ certain) > 0.5  # of no combination with others that has no effect
    return np.where(is_determined, np.sqrt(np.maximum(np.diag(certain), 0.0)), np.inf)
