"""Configurations that fill the range of an arm's joints evenly, always the same ones."""

import numpy as np

from ropsim.model import Mechanism
from ropsim.spatial import Array


def configurations(robot: Mechanism, count: int) -> Array:
    """Return configurations that fill the range of the joints evenly, shape (count, n) [rad | m]."""
    return spread_between(robot.lower_limits, robot.upper_limits, count)


def spread_between(lower_limits: Array, upper_limits: Array, count: int) -> Array:
    """Return configurations that fill the range between limits (n,) evenly, shape (count, n) [rad | m].

    The additive recurrence of M. Roberts, 2018 (a generalised golden ratio): point k has coordinate i at
    frac(k·φ⁻ⁱ), i = 1 … n, where φ is the positive root of φⁿ⁺¹ = φ + 1.
    """
    n = len(lower_limits)
    phi = 2.0
    for _ in range(64):  # contracts to the root to the last bit
        phi = (1.0 + phi) ** (1.0 / (n + 1))
    shares = np.modf(np.outer(np.arange(1, count + 1), phi ** -np.arange(1.0, n + 1.0)))[0]
    turn = 2.0 * np.pi  # further turns are the same arm
    wide = upper_limits - lower_limits > turn
    lower = np.where(wide, np.maximum(lower_limits, -np.pi), lower_limits)
    upper = np.minimum(upper_limits, lower + turn)
    return np.asarray(lower + shares * (upper - lower))
