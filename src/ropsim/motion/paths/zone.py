"""Zone: where a path leaves the ball around its end, and where it comes out of that around its start."""

from collections.abc import Callable

import numpy as np

from ropsim.spatial import Array, frozen

# shares of the way to search, from the centre of the zone on: finer and finer towards it, 1/32 further out
_GRID = frozen([0.0, *(2.0 ** np.arange(-30, -5)), *(np.arange(2, 33) / 32.0)])
_NODES = frozen((1.0 - np.cos(np.pi * np.arange(9) / 8.0)) / 2.0)  # Chebyshev's extrema in [0, 1]
_TO_POLYNOMIAL = frozen(np.linalg.inv(_NODES[:, None] ** np.arange(9)))
_STEPS = 60  # enough where every one is a bisection
_NEAR = -0.2  # of the square of the zone: 10 % nearer to its centre
_CLOSELY = 65  # places
_QUITE = 1e-6  # of the square of the zone: off by no more, one step along the slope is enough
_MENDS = 12  # steps


def leave(positions: Callable[[Array], Array], length: float, zone: float, clip: float) -> float:
    """Return the place at which a path enters the zone around its end for the last time.

    Args:
        positions: of the TCP at places, shape (k,) to (k, 3) [m].
        length: of the path, in its own unit.
        zone: distance from the end, straight through space [m].
        clip: earliest place, in the unit of the path.

    Returns:
        the place in [clip, length] behind which the path stays within the zone; `clip` where it does so from
        there on, `length` where there is no zone. On lines exact but for rounding, else to 1e-8 of the zone.
    """
    return length - _way_out(lambda way: positions(length - way), zone, length - clip)


def enter(positions: Callable[[Array], Array], length: float, zone: float, clip: float) -> float:
    """Return the place at which a path leaves the zone around its start for the first time.

    Args:
        positions: of the TCP at places, shape (k,) to (k, 3) [m].
        length: of the path, in its own unit.
        zone: distance from the start, straight through space [m].
        clip: last place, in the unit of the path; at most `length`.

    Returns:
        the place in [0, clip] before which the path stays within the zone; `clip` where it does so up to
        there, 0 where there is no zone. On lines exact but for rounding, else to 1e-8 of the zone.
    """
    return _way_out(positions, zone, min(clip, length))


def _way_out(positions: Callable[[Array], Array], zone: float, clip: float) -> float:
    """Return the first way at which the distance from the place at way 0 is `zone`, at most `clip`."""
    if zone <= 0.0 or clip <= 0.0:
        return 0.0
    ways = _GRID * clip
    places = positions(ways)

    def squares(points: Array) -> Array:
        # the square of the distance is smooth at the centre, too, and on a line a parabola
        return np.asarray(np.sum(np.square(points - places[0]), axis=1) - zone * zone)

    def beyond(ways: Array) -> Array:
        return squares(positions(ways))

    found = _first_outside(ways, squares(places), zone, beyond)
    if found is None:
        return clip
    low, width = found
    polynomial = _TO_POLYNOMIAL @ beyond(low + width * _NODES)
    x = _root(polynomial)
    slope = _slope(polynomial, x)
    for _ in range(_MENDS if slope > 0.0 else 0):
        # where the path changes its law within the interval, the polynomial is not quite it
        off = float(beyond(np.array([low + width * x]))[0])
        x = min(max(x - off / slope, 0.0), 1.0)
        if abs(off) <= _QUITE * zone * zone:
            break
    return low + width * x


def _first_outside(
    ways: Array, squares: Array, zone: float, beyond: Callable[[Array], Array]
) -> tuple[float, float] | None:
    """Return start and width of the interval in which the path leaves first; None where it stays within.

    Between two places within the zone it may peep out: where it comes near, it is looked at closely.
    """
    first = int(np.argmax(squares >= 0.0)) if (squares >= 0.0).any() else len(ways)
    inner = squares[:first]
    peaks = np.flatnonzero((inner[1:-1] >= inner[:-2]) & (inner[1:-1] >= inner[2:])) + 1
    for peak in peaks[inner[peaks] > _NEAR * zone * zone]:
        close = np.linspace(ways[peak - 1], ways[peak + 1], _CLOSELY)
        outside = beyond(close) >= 0.0
        if outside.any():
            at = int(np.argmax(outside))
            return float(close[at - 1]), float(close[at] - close[at - 1])
    if first == len(ways):
        return None
    return float(ways[first - 1]), float(ways[first] - ways[first - 1])


def _slope(coefficients: Array, x: float) -> float:
    """Return the derivative of a polynomial at x; its first coefficient is that of x⁰."""
    slope = 0.0
    for power, c in zip(range(len(coefficients) - 1, 0, -1), coefficients[:0:-1].tolist(), strict=True):
        slope = slope * x + power * c
    return slope


def _root(coefficients: Array) -> float:
    """Return where a polynomial crosses 0 in [0, 1]; it is negative at 0 (its first row is that of x⁰).

    Newton's method, kept between a place below and one above 0.
    """
    falling = coefficients[::-1].tolist()
    low, high, x = 0.0, 1.0, 0.5
    for _ in range(_STEPS):
        value, slope = 0.0, 0.0
        for c in falling:
            slope = slope * x + value
            value = value * x + c
        low, high = (x, high) if value < 0.0 else (low, x)
        step = value / slope if slope > 0.0 else 1.0
        if not low <= x - step <= high:
            step = x - 0.5 * (low + high)
        if x - step == x:
            break
        x -= step
    return x
