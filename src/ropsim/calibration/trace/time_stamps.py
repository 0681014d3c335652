"""How wrong the times of the samples of a trace are."""

import math

import numpy as np
import numpy.typing as npt

from ropsim.calibration.trace.trace import Trace
from ropsim.spatial import Array

_BESIDE = (-2, -1, 1, 2)
"""Samples from which one between them is foretold."""
_FAST = 0.25
"""Speed from which on samples count, as a share of one that few exceed."""
_FEW = 0.95
_MEDIAN = 0.455
"""Median of the square of a normal variable with standard deviation 1."""
_FEWEST = 20
"""Samples that are enough."""


def time_noise(trace: Trace) -> float:
    """Return the standard deviation of the times at which samples were taken from those they name [s].

    A sample differs from the cubic polynomial through its two neighbours on either side (Lagrange's formula)
    by its own error and by theirs. Along the way, and divided by the speed, that is an error of time. The
    median over fast samples is not moved by places where the acceleration changes.

    Args:
        trace: of n axes.
    """
    time, q = trace.time, trace.q
    k = np.arange(2, len(time) - 2)
    if len(k) < _FEWEST:
        return 0.0
    shares = [_share(time, k, one) for one in _BESIDE]
    foretold = np.zeros((len(k), trace.n))
    for share, one in zip(shares, _BESIDE, strict=True):
        foretold += share[:, None] * q[k + one]
    gain = 1.0 + (np.array(shares) ** 2).sum(axis=0)
    speed = (q[k + 1] - q[k - 1]) / (time[k + 1] - time[k - 1])[:, None]
    squares = (speed * speed).sum(axis=1)
    fast = squares > _FAST**2 * max(float(np.quantile(squares, _FEW)), 1e-18)
    if int(fast.sum()) < _FEWEST:
        return 0.0
    late = ((q[k] - foretold) * speed).sum(axis=1)[fast] / squares[fast]
    return math.sqrt(float(np.median(late * late / gain[fast])) / _MEDIAN)


def _share(time: Array, k: npt.NDArray[np.intp], one: int) -> Array:
    """Return the share of a neighbour in the cubic polynomial through all, shape (k,)."""
    found = np.ones(len(k))
    for other in _BESIDE:
        if other != one:
            found = found * (time[k] - time[k + other]) / (time[k + one] - time[k + other])
    return found
