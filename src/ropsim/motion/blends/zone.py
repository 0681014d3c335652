"""Zone: where a path leaves the ball around its end, and where it comes out of that around its start."""

from collections.abc import Callable

import numpy as np

from ropsim.motion.blends.zone_kernel import (
    DEGREE,
    FOUND_PARAMETER,
    MOST_SAMPLES,
    SAMPLE_COUNT,
    SAMPLE_PARAMETERS,
    SAMPLE_SQUARES,
    SEARCH_STATE,
    next_samples,
)
from ropsim.spatial import Array, frozen

ZONE_SHARES = frozen([0.0, *(2.0 ** np.arange(-30, -5, 2)), *(np.arange(2, 33) / 32.0)])
"""Of the range to search, from the centre of the zone on: finer and finer towards it, 1/32 further out."""
_EXTREMA = (1.0 - np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE)) / 2.0  # Chebyshev's, in [0, 1]
ZONE_NODES = frozen(np.vstack((_EXTREMA, np.linalg.inv(_EXTREMA[:, None] ** np.arange(DEGREE + 1)))))
"""Shares of an interval, and the matrix from values there to coefficients of a polynomial, shape (10, 9)."""


def leave(positions: Callable[[Array], Array], length: float, zone: float, clip: float) -> float:
    """Return the path parameter at which a path enters the zone around its end for the last time.

    Args:
        positions: of the TCP at path parameters, shape (k,) to (k, 3) [m].
        length: of the path, in its own unit.
        zone: distance from the end, straight through space [m].
        clip: earliest path parameter, in the unit of the path.

    Returns:
        the path parameter in [clip, length] behind which the path stays within the zone; `clip` where it does
        so from there on, `length` where there is no zone. On lines exact within rounding, else to 1e-8 of the
        zone.
    """
    return length - _first_exit(lambda distance: positions(length - distance), zone, length - clip)


def enter(positions: Callable[[Array], Array], length: float, zone: float, clip: float) -> float:
    """Return the path parameter at which a path leaves the zone around its start for the first time.

    Args:
        positions: of the TCP at path parameters, shape (k,) to (k, 3) [m].
        length: of the path, in its own unit.
        zone: distance from the start, straight through space [m].
        clip: last path parameter, in the unit of the path; at most `length`.

    Returns:
        the path parameter in [0, clip] before which the path stays within the zone; `clip` where it does so
        up to there, 0 where there is no zone. On lines exact within rounding, else to 1e-8 of the zone.
    """
    return _first_exit(positions, zone, min(clip, length))


def _first_exit(positions: Callable[[Array], Array], zone: float, clip: float) -> float:
    """Return the first path parameter at the distance `zone` from the position at 0, at most `clip`."""
    samples, state, centre = np.empty((3, MOST_SAMPLES)), np.zeros(SEARCH_STATE), np.zeros(3)
    next_samples(ZONE_SHARES, ZONE_NODES, zone, clip, samples, state)
    first = True
    while count := int(state[SAMPLE_COUNT]):
        found = positions(samples[SAMPLE_PARAMETERS, :count].copy())
        centre = found[0] if first else centre
        # the square of the distance is also smooth at the centre, and on a line a parabola
        samples[SAMPLE_SQUARES, :count] = np.sum(np.square(found - centre), axis=1)
        next_samples(ZONE_SHARES, ZONE_NODES, zone, clip, samples, state)
        first = False
    return float(state[FOUND_PARAMETER])
