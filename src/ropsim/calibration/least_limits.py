"""Limits from simple motion sequences, each alone first."""

import math
from collections.abc import Sequence

import numpy as np

from ropsim.calibration.demands import largest, largest_of_tool
from ropsim.calibration.limits import ORDERS, MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence
from ropsim.calibration.replanning import Replan, coordinates, speeds
from ropsim.calibration.sequence_fit import SequenceFit, placed
from ropsim.model import RobotModel
from ropsim.spatial import Array

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
_STANDS = 1e-3
"""Share of its limit up to which an axis or the tool counts as standing."""


def least_limits(
    replan: Replan, robot: RobotModel, logged: Sequence[LoggedSequence], known: MotionSettings
) -> MotionSettings:
    """Return the least limits that allow simple sequences as in the trace.

    What a joint or the tool does in any of them its limit allows, and under the largest of that over all
    sequences none of them can be quicker than it was: each goes as in the trace. Limits of what stands are
    the known ones.

    Args:
        replan: plans the sequences.
        robot: the arm.
        logged: sequences of PTP moves, and of a single move on a path of the tool.
        known: limits before.
    """
    fits = [fit for one in logged if (fit := fit_alone(replan, one, known))]
    joints = [largest(fit.motion, fit.settings) for fit in fits]
    tool = [largest_of_tool(fit.motion, fit.settings, robot) for fit in fits]
    return MotionSettings(_least(joints, known.joints), _least(tool, known.tool), known.look_ahead)


def _least(asked: Sequence[Array], known: Array) -> Array:
    """Return the largest demands, and the known limits where there are next to none."""
    least = np.max([np.zeros_like(known), *asked], axis=0)
    return np.where(least > _STANDS * known, least, known)


def fit_alone(replan: Replan, logged: LoggedSequence, settings: MotionSettings) -> SequenceFit | None:
    """Return the fit of a simple sequence alone, None where it cannot be planned.

    Its joints go together, so one speed, one acceleration and one jerk along its path determine it, whichever
    joints they are of, or of the tool: Levenberg-Marquardt (Marquardt 1963) on the logarithms of common
    factors of all.

    Args:
        replan: plans the sequence.
        logged: the sequence.
        settings: where to begin.
    """
    free = list(range(ORDERS))
    best: SequenceFit | None = None
    factors = np.zeros(ORDERS)
    for begin in _beginnings(replan, logged, settings):
        found = _fit_at(replan, logged, settings, begin)
        if found and (best is None or found.misfit < best.misfit):
            best, factors = found, begin
    damping = 1e-3
    tried = free
    for number in range(_ROUNDS if best else 0):
        assert best is not None
        if best.misfit <= _IN_NOISE * float(np.sqrt(np.mean(logged.noise**2))):
            break
        tried = free if number % _ALL_AGAIN == 0 else tried
        improved = _improved(replan, settings, best, factors, tried, damping)
        if improved is None:
            break
        found, factors, damping, tried = improved
        gained = 1.0 - found.misfit / max(best.misfit, 1e-300)
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
    away = best.logged.q - coordinates(best.motion, best.logged.time - best.start)
    wrong = (best.logged.weights[:, None] * away).ravel()
    A, b = J.T @ J, J.T @ wrong
    least = 1e-12 * float(np.trace(A)) + 1e-300
    for _ in range(_TRIALS):
        step = np.linalg.solve(A + damping * np.diag(np.diag(A) + least), b)[1:]
        trial = factors.copy()
        trial[seen] = np.clip(
            trial[seen] + np.clip(step, -_LARGEST_STEP, _LARGEST_STEP), -_FARTHEST, _FARTHEST
        )
        found = _fit_at(replan, best.logged, settings, trial)
        if found and found.misfit < best.misfit:
            return found, trial, damping / 5.0, seen
        damping = max(damping * 6.0, 1e-6)
    return None


def _slopes(
    replan: Replan, settings: MotionSettings, best: SequenceFit, factors: Array, free: Sequence[int]
) -> tuple[Array, list[int]]:
    """Return how the joints change with start and factors, shape (k·n, 1 + m), and which factors act."""
    times = best.logged.time - best.start
    weights = best.logged.weights[:, None]
    columns, seen = [-(weights * speeds(best.motion, times)).ravel()], []
    here = coordinates(best.motion, times)
    for number in free:
        lower = factors.copy()
        lower[number] -= _STEP
        motion = replan(best.logged.number, _scaled(settings, lower))
        if motion is None:
            continue
        slope = (weights * (coordinates(motion, times) - here)).ravel() / -_STEP
        if float(np.abs(slope).max()) > 1e-7:
            columns.append(slope)
            seen.append(number)
    return np.array(columns).T, seen


def _beginnings(replan: Replan, logged: LoggedSequence, settings: MotionSettings) -> Array:
    """Return factors to begin with, shape (m, 3): ones, and factors that reproduce the time of the trace."""
    found = [np.zeros(ORDERS)]
    motion = replan(logged.number, settings)
    if motion is not None:
        seen = logged.crossings(logged.q)
        lasts = seen[1] - seen[0]
        if math.isfinite(lasts) and lasts > 0.0:
            slower = math.log(motion.duration / lasts)
            slower = min(max(slower, -_FARTHEST / ORDERS), _FARTHEST / ORDERS)
            found.append(slower * np.arange(1.0, ORDERS + 1.0))
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
    return settings.scaled(np.exp(factors), np.exp(factors))
