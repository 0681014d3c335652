"""Random path limits of sections, and by how much a time law breaks them, written down anew from the laws."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from ropsim.motion import TimeLaw
from ropsim.spatial import Array

Counts = npt.NDArray[np.int64]

CELLS = 600
"""Most path limits of a section."""
LENGTHS = -6.0, 0.0
LEVELS = LENGTHS, (-2.0, 1.0), (-1.0, 3.0), (0.0, 5.0)
"""Powers of ten between which lengths and bounds of speed, acceleration and jerk lie about."""
SPREADS = 0.0, 0.01, 0.1, 1.0, 3.0
"""Powers of ten that lie between the bounds of a section: from smooth to a factor of 1000."""


class LimitsInRows(NamedTuple):
    """Arguments of `jerk_limited`: path limits (s, 6) and how many of them each path segment has, (p,)."""

    bounds: Array
    counts: Array


class Excess(NamedTuple):
    """By how much a time law breaks the laws of motion, relative to what it may; 0 or less is not at all.

    Steps of speed and acceleration are relative to their greatest values, in the unit of the first path
    segment. What the motion does in the least time that the clock can tell apart does not count.

    Attributes:
        speed_step: greatest step of ds/dt between two phases.
        acceleration_step: greatest step of d²s/dt² between two phases.
        bound: greatest excess over a bound of speed, acceleration or jerk, also inside of a phase.
        backwards: greatest speed backwards.
        length: greatest difference between a path parameter at the end of a phase and what the phase leads
            to.
        rest: greatest speed or acceleration at start and end and at stops.
    """

    speed_step: float
    acceleration_step: float
    bound: float
    backwards: float
    length: float
    rest: float


def random_limits(rng: np.random.Generator, most: int = CELLS) -> LimitsInRows:
    """Return path limits of 2 to `most` rows, smooth to wild, with all kinds of units, stops and horizons.

    Args:
        rng: decides.
        most: see there.
    """
    n = int(np.exp(rng.uniform(np.log(2.0), np.log(most + 1))))
    counts = _counts(rng, n)
    first = np.cumsum(np.append(0, counts[:-1]))
    bounds = np.ones((n, 6))
    for column, levels in enumerate(LEVELS):
        bounds[:, column] = 10.0 ** _powers(rng, n, rng.uniform(*levels))
    bounds[:, 0] = np.clip(bounds[:, 0], 10.0 ** LENGTHS[0], 10.0 ** LENGTHS[1])
    if rng.random() < 0.2:
        bounds[:, 0] = 10.0 ** rng.uniform(*LENGTHS, n)
    if rng.random() < 0.5:
        units = 10.0 ** rng.uniform(-2.0, 2.0, len(first))
        bounds[:, :4] *= np.repeat(units, counts)[:, None] / units[0]
        bounds[first[1:], 4] = units[1:] / units[:-1]
    if rng.random() < 0.5:
        bounds[first[1:][rng.random(len(first) - 1) < 0.2], 4] = 0.0
    bounds[:, 5] = _horizons(rng, counts)
    return LimitsInRows(bounds, counts.astype(np.float64))


def _counts(rng: np.random.Generator, n: int) -> Counts:
    """Return how many of n path limits each path segment has."""
    most = int(rng.integers(1, 31))
    ends = np.minimum(np.cumsum(rng.integers(1, most + 1, n)), n)
    return np.diff(np.unique(ends), prepend=0).astype(np.int64)


def _powers(rng: np.random.Generator, n: int, level: float) -> Array:
    """Return powers of ten about a level: each for itself, a random walk or a wave."""
    spread, kind = float(rng.choice(SPREADS) * rng.random()), rng.integers(3)
    if kind == 0:
        found: Array = spread * rng.uniform(-0.5, 0.5, n)
    elif kind == 1:
        found = np.clip(np.cumsum(spread / 3.0 * rng.normal(size=n)), -1.5, 1.5)
    else:
        rate, begin = float(np.exp(rng.uniform(-4.0, 0.0))), rng.uniform(0.0, 6.0)
        found = 0.5 * spread * np.sin(np.arange(n) * rate + begin)
    return level + found


def _horizons(rng: np.random.Generator, counts: Counts) -> Array:
    """Return horizons: of none, of a number of path limits or of path segments, or each for itself."""
    n, kind = int(counts.sum()), rng.integers(5)
    numbers, last = np.arange(n), np.cumsum(counts) - 1
    if kind == 0:
        return np.full(n, -1.0)
    if kind == 1:
        return np.asarray(np.minimum(numbers + rng.integers(0, n), n - 1), dtype=np.float64)
    if kind == 2:
        return rng.integers(numbers, n).astype(np.float64)
    ahead = last[np.minimum(np.arange(len(last)) + rng.integers(0, 12), len(last) - 1)]
    if kind == 3:
        return np.asarray(np.repeat(ahead, counts), dtype=np.float64)
    known = np.full(n, -1.0)
    known[last] = ahead
    return known


def excess_of(bounds: Array, law: TimeLaw) -> Excess:
    """Return by how much a time law breaks the laws.

    Args:
        bounds: path limits, (s, 6).
        law: a path segment of which is one of these.
    """
    number, _, s, v, a, j, h, s_end = law.segments
    row = number.astype(int)
    length, most_v, most_a, most_j, ratio = bounds[row, :5].T
    units = np.cumprod(np.where((bounds[:, 4] > 0.0) & (np.arange(len(bounds)) > 0), bounds[:, 4], 1.0))[row]
    v1, a1 = v + h * (a + 0.5 * h * j), a + h * j
    turning = a * a1 < 0.0  # there is an extreme of the speed inside of the phase
    inside = np.where(turning, v - 0.5 * a * a / np.where(turning, j, 1.0), v)
    greatest_v = (np.maximum(v, v1) / units).max()
    greatest_a = (np.maximum(np.abs(a), np.abs(a1)) / units).max()
    factor = np.where(row[1:] == row[:-1], 1.0, ratio[1:])
    moment = np.spacing(law.duration)
    step_v = np.abs(v1[:-1] * factor - v[1:]) / units[1:] / greatest_v
    step_a = np.abs(a1[:-1] * factor - a[1:])
    step_a -= moment * np.maximum(np.abs(j[:-1]) * factor, np.abs(j[1:]))
    bound = max(
        (np.max([v, v1, inside], axis=0) / most_v).max(),
        (np.maximum(np.abs(a), np.abs(a1)) / most_a).max(),
        (np.abs(j) / most_j).max(),
    )
    reached = s + h * (v + h * (0.5 * a + h * j / 6.0))
    stops = np.append(factor == 0.0, True)
    return Excess(
        float(step_v.max(initial=0.0)),
        float((step_a / units[1:] / greatest_a).max(initial=0.0)),
        float(bound - 1.0),
        float((-np.min([v, v1, inside], axis=0) / most_v).max()),
        float(((np.abs(reached - s_end) - moment * np.maximum(v, v1)) / length).max()),
        max(
            v[0],
            abs(a[0]),
            float((np.abs(v1[stops]) / units[stops]).max() / greatest_v),
            float((np.abs(a1[stops]) / units[stops]).max() / greatest_a),
        ),
    )
