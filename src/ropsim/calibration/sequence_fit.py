"""Fitting one sequence: by which factors its limits must change for it to go as in the trace."""

import math
from collections.abc import Sequence

import numpy as np

from ropsim.calibration.limits import ORDERS, MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence
from ropsim.calibration.replanning import Replan, coordinates, speeds
from ropsim.planning import MotionPlan
from ropsim.spatial import Array, record

_STEP = 0.03
"""Change of a factor by which its effect is seen; downward, since raising a limit may have no effect."""
_ROUNDS = 14
_TRIALS = 7
_FARTHEST = math.log(30.0)
_LARGEST_STEP = 0.5
_IN_NOISE = 0.4
"""Error in steps of the encoders below which nothing is left to fit; rounding alone is 0.29 of them."""
_ALL_AGAIN = 4
"""Rounds after which factors without an effect are tried again."""
_ENOUGH = 1e-3
"""Improvement of the error below which a fit has ended."""


@record
class SequenceFit:
    """How a sequence goes as in the trace.

    Attributes:
        logged: the sequence.
        settings: under which it does.
        motion: it then.
        start: when it begins, on the times of the sequence [s].
        error: of the joints, root of the mean square [rad | m].
    """

    logged: LoggedSequence
    settings: MotionSettings
    motion: MotionPlan
    start: float
    error: float


def placed(logged: LoggedSequence, settings: MotionSettings, motion: MotionPlan) -> SequenceFit:
    """Return a planned motion at the time at which it fits the trace best.

    Gauss-Newton on its start alone, from where half of the way is done in both.
    """
    rows = np.arange(0.0, motion.duration, motion.period)
    start = _halfway(logged.time, logged.q, logged.noise) - _halfway(
        rows, coordinates(motion, rows), np.zeros(len(logged.noise))
    )
    for _ in range(8):
        wrong = logged.q - coordinates(motion, logged.time - start)
        slope = speeds(motion, logged.time - start)
        weight = float((slope * slope).sum())
        if weight == 0.0:
            break
        step = float((wrong * slope).sum()) / weight
        start -= min(max(step, -0.1), 0.1)
        if abs(step) < 1e-6:
            break
    wrong = logged.q - coordinates(motion, logged.time - start)
    return SequenceFit(logged, settings, motion, start, float(np.sqrt(np.mean(wrong * wrong))))


def fit_sequence(
    replan: Replan, logged: LoggedSequence, settings: MotionSettings, groups: Sequence[int]
) -> SequenceFit | None:
    """Return the fit of a sequence, None where it cannot be planned.

    Levenberg-Marquardt (Marquardt 1963) on the logarithms of common factors of all speeds, accelerations
    and jerks.

    Args:
        replan: plans the sequence.
        logged: the sequence.
        settings: where to begin.
        groups: which limits may change: 0 of the joints, 1 of the tool.
    """
    free = [group * ORDERS + order for group in groups for order in range(ORDERS)]
    best: SequenceFit | None = None
    factors = np.zeros(2 * ORDERS)
    allowed = np.isin(np.arange(2 * ORDERS), free)
    for begin in _beginnings(replan, logged, settings) * allowed:
        found = _fit_at(replan, logged, settings, begin)
        if found and (best is None or found.error < best.error):
            best, factors = found, begin
    damping = 1e-3
    tried = free
    for number in range(_ROUNDS if best else 0):
        assert best is not None
        if best.error <= _IN_NOISE * float(np.sqrt(np.mean(logged.noise**2))):
            break
        tried = free if number % _ALL_AGAIN == 0 else tried
        improved = _improved(replan, settings, best, factors, tried, damping)
        if improved is None:
            break
        found, factors, damping, tried = improved
        gained = 1.0 - found.error / max(best.error, 1e-300)
        best = found
        if gained < _ENOUGH:
            break
    return best


def _improved(
    replan: Replan,
    settings: MotionSettings,
    best: SequenceFit,
    factors: Array,
    free: Sequence[int],
    damping: float,
) -> tuple[SequenceFit, Array, float, list[int]] | None:
    """Return a better fit, its factors, the damping for the next one, and which factors have an effect.

    Returns None where there is no better one.
    """
    J, seen = _slopes(replan, settings, best, factors, free)
    if not seen:
        return None
    wrong = (best.logged.q - coordinates(best.motion, best.logged.time - best.start)).ravel()
    A, b = J.T @ J, J.T @ wrong
    least = 1e-12 * float(np.trace(A)) + 1e-300
    for _ in range(_TRIALS):
        step = np.linalg.solve(A + damping * np.diag(np.diag(A) + least), b)[1:]
        trial = factors.copy()
        trial[seen] = np.clip(
            trial[seen] + np.clip(step, -_LARGEST_STEP, _LARGEST_STEP), -_FARTHEST, _FARTHEST
        )
        found = _fit_at(replan, best.logged, settings, trial)
        if found and found.error < best.error:
            return found, trial, damping / 5.0, seen
        damping = max(damping * 6.0, 1e-6)
    return None


def _slopes(
    replan: Replan, settings: MotionSettings, best: SequenceFit, factors: Array, free: Sequence[int]
) -> tuple[Array, list[int]]:
    """Return how the joints change with start and factors, shape (k·n, 1 + m), and which factors act."""
    times = best.logged.time - best.start
    columns, seen = [-speeds(best.motion, times).ravel()], []
    here = coordinates(best.motion, times).ravel()
    for number in free:
        lower = factors.copy()
        lower[number] -= _STEP
        motion = replan(best.logged.number, _scaled(settings, lower))
        if motion is None:
            continue
        slope = (coordinates(motion, times).ravel() - here) / -_STEP
        if float(np.abs(slope).max()) > 1e-7:
            columns.append(slope)
            seen.append(number)
    return np.array(columns).T, seen


def _beginnings(replan: Replan, logged: LoggedSequence, settings: MotionSettings) -> Array:
    """Return factors to begin with, shape (m, 6): ones, and factors that reproduce the time of the trace."""
    found = [np.zeros(2 * ORDERS)]
    motion = replan(logged.number, settings)
    if motion is not None:
        seen = logged.crossings(logged.q)
        lasts = seen[1] - seen[0]
        if math.isfinite(lasts) and lasts > 0.0:
            slower = math.log(motion.duration / lasts)
            slower = min(max(slower, -_FARTHEST / ORDERS), _FARTHEST / ORDERS)
            found.append(np.tile(slower * np.arange(1.0, ORDERS + 1.0), 2))
    return np.array(found)


def _fit_at(
    replan: Replan, logged: LoggedSequence, settings: MotionSettings, factors: Array
) -> SequenceFit | None:
    scaled = _scaled(settings, factors)
    motion = replan(logged.number, scaled)
    return placed(logged, scaled, motion) if motion is not None and motion.ticks > 1 else None


def _scaled(settings: MotionSettings, factors: Array) -> MotionSettings:
    if not factors.any():
        return settings
    return settings.scaled(np.exp(factors[:ORDERS]), np.exp(factors[ORDERS:]))


def _halfway(time: Array, q: Array, noise: Array) -> float:
    """Return when half of the way is done [s]; steps of the noise are none."""
    steps = np.diff(q, axis=0)
    steps = np.linalg.norm(np.where(np.abs(steps) > 1.5 * noise, steps, 0.0), axis=1)
    way = np.concatenate(([0.0], np.cumsum(steps)))
    return float(np.interp(0.5 * way[-1], way, time))
