"""A planned motion sequence laid over its trace."""

import math

import numpy as np

from ropsim.calibration.limits import MotionSettings
from ropsim.calibration.logged_sequence import LoggedSequence
from ropsim.calibration.replanning import coordinates, speeds
from ropsim.planning import MotionPlan
from ropsim.spatial import Array, record

_SHORTEST = 100.0
"""Steps of the encoders that the way of a sequence counts at least."""
_ANOTHER_WAY = 0.05
"""Distance from the planned path from which on a sequence went another way, as a share of its way."""
_NOISE = 1.3
"""Factor of the square of noise that may be in an error by chance."""
_DENSE = 400
"""Points of the planned path with which a trace is compared."""


@record
class SequenceFit:
    """How a sequence goes beside the trace.

    Attributes:
        logged: the sequence.
        settings: limits in force.
        motion: it under them.
        start: when it begins, on the times of the sequence [s].
        error: of the joints, root of the mean square [rad | m].
        misfit: the same of the weighted samples [rad | m].
        noise: the part of that that differs from sample to sample, as wrong times of samples do [rad | m].
    """

    logged: LoggedSequence
    settings: MotionSettings
    motion: MotionPlan
    start: float
    error: float
    misfit: float
    noise: float

    @property
    def left(self) -> float:
        """Return the error without noise as a share of the way: that of limits, which is smooth."""
        return math.sqrt(max(self.misfit**2 - _NOISE * self.noise**2, 0.0)) / way_of(self.logged)

    @property
    def share(self) -> float:
        """Return the misfit as a share of the way: about half the share by which times are wrong."""
        return self.misfit / way_of(self.logged)

    @property
    def goes_there(self) -> bool:
        """Return whether the trace goes along the planned path, whenever it is where."""
        motion = self.motion
        rows = np.linspace(0.0, motion.duration, _DENSE)
        path = coordinates(motion, rows)
        apart = np.array([np.linalg.norm(path - q, axis=1).min() for q in self.logged.q])
        off = float(np.sqrt(np.mean(apart * apart)))
        steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
        return off <= _ANOTHER_WAY * way_of(self.logged) + 3.0 * float(self.logged.noise.max()) + float(
            steps.max(initial=0.0)
        )


def way_of(logged: LoggedSequence) -> float:
    """Return the longest way of a joint in a sequence [rad | m], at least some steps of the encoders."""
    way = float(np.ptp(logged.q, axis=0).max())
    return max(way, _SHORTEST * float(logged.noise.max()), 1e-9)


def placed(logged: LoggedSequence, settings: MotionSettings, motion: MotionPlan) -> SequenceFit:
    """Return a planned motion at the time at which it fits the trace best.

    Gauss-Newton on its start alone, from where half of the way is done in both.
    """
    rows = np.arange(0.0, motion.duration, motion.period)
    start = _halfway(logged.time, logged.q, logged.noise) - _halfway(
        rows, coordinates(motion, rows), np.zeros(len(logged.noise))
    )
    weights = logged.weights[:, None]
    for _ in range(8):
        wrong = weights * (logged.q - coordinates(motion, logged.time - start))
        slope = weights * speeds(motion, logged.time - start)
        weight = float((slope * slope).sum())
        if weight == 0.0:
            break
        step = float((wrong * slope).sum()) / weight
        start -= min(max(step, -0.1), 0.1)
        if abs(step) < 1e-6:
            break
    wrong = logged.q - coordinates(motion, logged.time - start)
    weighed = weights * wrong
    jumps = np.diff(weighed, axis=0) / math.sqrt(2.0)
    error, misfit, noise = (math.sqrt(float(np.mean(one * one))) for one in (wrong, weighed, jumps))
    return SequenceFit(logged, settings, motion, start, error, misfit, noise)


def _halfway(time: Array, q: Array, noise: Array) -> float:
    """Return when half of the way is done [s]; steps of the noise are none."""
    steps = np.diff(q, axis=0)
    steps = np.linalg.norm(np.where(np.abs(steps) > 1.5 * noise, steps, 0.0), axis=1)
    way = np.concatenate(([0.0], np.cumsum(steps)))
    return float(np.interp(0.5 * way[-1], way, time))
