"""When a motion leaves a stop, from its first steps."""

import numpy as np

from ropsim.spatial import Array

_SEEN = 6.0
"""Steps of the encoders from which on a way is evaluated."""
_WINDOWS = (3.0, 4.0, 6.0, 10.0)
"""Times since the departure in terms of that at which its way is seen, up to which it is evaluated: shortest
first, while a way that grows with the cube of time has few samples in it."""
_FEWEST = 4
"""Samples that are enough."""


def lateness(time: Array, way: Array, other: Array, noise: float) -> float | None:
    """Return how much later one motion leaves the stop of another one [s], None where too little is seen.

    Joints leave a stop with a jerk, so that the cube root of their way grows in proportion to the time since
    the departure; a line through the samples of the first steps leads back to it. Where the acceleration has
    its full value soon this is wrong, in both motions alike. Limits of the other motion have no part in the
    answer, other than those of a formula that continues it under the first steps.

    Args:
        time: of the samples, rising [s], shape (k,).
        way: distances of joint coordinates from the stop [rad | m], shape (k, n).
        other: distances of the other motion at the same times [rad | m], shape (k, n).
        noise: step of the encoders, or their noise [rad | m].
    """
    ways = [np.abs(one).max(axis=1) for one in (way, other)]
    least = _SEEN * noise
    for window in _WINDOWS:
        found = [_departure(time, way, least, window**3 * least) for way in ways]
        if found[0] is not None and found[1] is not None:
            return found[0] - found[1]
    return None


def _departure(time: Array, way: Array, least: float, most: float) -> float | None:
    """Return the time at which a way is zero by its samples between two levels [s]."""
    beyond = np.flatnonzero(way > most)
    last = int(beyond[0]) if beyond.size else len(way)
    seen = np.flatnonzero(way[:last] <= least)
    first = int(seen[-1]) + 1 if seen.size else 0
    if last - first < _FEWEST:
        return None
    times, roots = time[first:last], np.cbrt(way[first:last])
    late, root = times - times.mean(), roots - roots.mean()
    spread = float(root @ root)
    return float(times.mean() - roots.mean() * float(root @ late) / spread) if spread > 0.0 else None
