"""Refining common limits on all stretches at once."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.logged_stretch import LoggedStretch
from ropsim.calibration.replanning import Replan, coordinates, speeds
from ropsim.calibration.stretch_fit import StretchFit, placed
from ropsim.spatial import Array

_STEP = 0.03
_ROUNDS = 8
_LARGEST_STEP = 0.1
_ENOUGH = 1e-3


def fits_under(
    replan: Replan, logged: Sequence[LoggedStretch], settings: MotionSettings
) -> list[StretchFit | None]:
    """Return the motions of stretches under settings, each when it fits best; None where there is none."""
    motions = [replan(one.number, settings) for one in logged]
    return [
        placed(one, settings, motion) if motion is not None and motion.ticks > 1 else None
        for one, motion in zip(logged, motions, strict=True)
    ]


def total_error(fits: Sequence[StretchFit | None]) -> float:
    """Return the sum of the squares of the errors, infinite where a stretch has no motion [rad² | m²]."""
    return sum(fit.error**2 if fit else np.inf for fit in fits)


def refined(
    replan: Replan, logged: Sequence[LoggedStretch], settings: MotionSettings, free: npt.NDArray[np.intp]
) -> MotionSettings:
    """Return settings whose free limits fit all stretches together better.

    Gauss-Newton on the logarithms of the limits; the start of each stretch is eliminated (Golub & Pereyra
    1973).

    Args:
        replan: plans the stretches.
        logged: the stretches.
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
    replan: Replan, fits: Sequence[StretchFit], settings: MotionSettings, free: npt.NDArray[np.intp]
) -> Array:
    A, b = np.zeros((len(free), len(free))), np.zeros(len(free))
    for fit in fits:
        times = fit.logged.time - fit.start
        here, late = coordinates(fit.motion, times).ravel(), speeds(fit.motion, times).ravel()
        wrong = fit.logged.q.ravel() - here
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
        A += columns.T @ columns / len(here)
        b += columns.T @ wrong / len(here)
    size = np.diag(A).copy()
    ridge = np.diag(1e-3 * size + 1e-9 * float(size.max(initial=0.0)) + 1e-300)
    return np.asarray(np.linalg.solve(A + ridge, b))
