"""Places of a motion, as dense as it must be slow there."""

import numpy as np

from ropsim.motion.limits.joint_bounds import JointBounds
from ropsim.motion.limits.kept import Motion
from ropsim.motion.paths.path import JointPoints
from ropsim.spatial import Array

_FEWEST = 8
_ROUNDS = 12
_MOST_PARTS = 64
_LEAST_PART = 1e-4
"""Ways that are shorter than this share of the grid are not divided further."""
_LONG = 1.5
"""Greatest real time between two places, over the time that was asked for."""
_STEEP = 0.4
"""Greatest change of the logarithm of the speed that a joint allows, from place to place."""


def places_of(
    motion: Motion, bounds: JointBounds, spacing: float, phi: Array, rates: Array
) -> tuple[Array, JointPoints]:
    """Return motion times [s] from 0 to the end, about one real time apart, (m,), and the motion there.

    Where joints must go a long way, or the speed that they allow changes steeply, ways are divided.

    Args:
        motion: the plan.
        bounds: of the joints.
        spacing: real time between two places [s].
        phi: motion times at which rates are known, rising, shape (k,).
        rates: estimates of dφ/dt there, in ]0, 1], shape (k,).
    """
    count = max(int(np.ceil(motion.duration / spacing)), _FEWEST)
    places = np.linspace(0.0, motion.duration, count + 1)
    slow = -onto(places, phi, -rates, -1.0)
    places = _divided(places, np.ceil(1.0 / np.minimum(slow[1:], slow[:-1])))
    for _ in range(_ROUNDS):
        points = motion.at(places)
        lasts = np.max(np.abs(np.diff(points.q, axis=0)) / bounds.speed, axis=1)
        steep = np.abs(np.diff(np.log(speed_caps(points, bounds))))
        parts = np.ceil(np.maximum(lasts / (_LONG * spacing), steep / _STEEP))
        parts[np.diff(places) < _LEAST_PART * spacing] = 1.0
        if not np.max(parts) > 1.0:
            return places, points
        places = _divided(places, parts)
    return places, motion.at(places)


def speed_caps(points: JointPoints, bounds: JointBounds) -> Array:
    """Return the greatest rates, at most 1, at which no joint is too fast, shape (m,)."""
    return np.asarray(1.0 / np.maximum(np.max(np.abs(points.d1) / bounds.speed, axis=1), 1.0))


def onto(places: Array, phi: Array, values: Array, lowest: float) -> Array:
    """Return at each place the greatest of the values on the ways beside it, or `lowest`, shape (m,).

    Args:
        places: rising, shape (m,).
        phi: where the values are, shape (k,).
        values: shape (k,).
        lowest: where there is none.
    """
    result = np.full(len(places), lowest)
    way = np.clip(np.searchsorted(places, phi, "right") - 1, 0, len(places) - 2)
    np.maximum.at(result, way, values)
    np.maximum.at(result, way + 1, values)
    return result


def _divided(places: Array, parts: Array) -> Array:
    """Return the places with the ways between them in equal parts, (m,) and (m - 1,)."""
    counts = np.clip(parts, 1.0, _MOST_PARTS).astype(np.int64)
    way = np.repeat(np.arange(len(counts)), counts)
    number = np.arange(len(way)) - np.repeat(np.cumsum(counts) - counts, counts)
    return np.append(places[way] + np.diff(places)[way] * (number / counts[way]), places[-1])
