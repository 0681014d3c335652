"""The search for the path parameter at which a path leaves a ball, in plain loops that numba compiles.

It requests distances: the caller evaluates the path at the requested path parameters, and calls it again.
"""

from ropsim.codegen import Array1, Array2, kernel
from ropsim.spatial import Array

SAMPLE_PARAMETERS, SAMPLE_SQUARES, EXCESS = range(3)
"""Rows of samples: path parameters to evaluate, squares of the distances found there, and squares kept from
before."""
SAMPLE_COUNT, FOUND_PARAMETER, PHASE, FIRST, PEAK, LOW, WIDTH, SHARE, SLOPE, MENDED, SEARCH_STATE = range(11)
"""State: number of path parameters to evaluate next, 0 at the end; then the result. The rest belongs to the
search."""
BEGINS, COARSELY, CLOSELY, BETWEEN, MENDS = range(5)
"""Phases: no data yet, or the meaning of the squares."""
AT_ONCE, AT_ONCE_THEN = 20, 8
"""Numbers of path parameters in the first evaluations of the grid, and in later ones: few zones reach far."""
MOST_SAMPLES = 65
"""Maximum number of path parameters of a close evaluation."""
DEGREE = 8
NEAR = -0.2
"""Of the square of the zone: 10 % nearer to its centre."""
QUITE = 1e-6
"""Of the square of the zone: off by no more, one step along the slope is enough."""
MOST_MENDS = 12
STEPS = 60
"""Enough where every one is a bisection."""


@kernel
def next_samples(
    shares: Array1, nodes: Array2, zone: float, clip: float, samples: Array2, state: Array1
) -> None:
    """Take the squares of the distances that were requested, and request the next ones.

    The first interval of the grid at whose end the path is outside is cut where the polynomial through nine
    squares in it is 0; where the path changes its law within it, that is mended. Between two path parameters
    within the zone the path may leave it: where it comes near the border, it is evaluated closely.

    Args:
        shares: of the farthest path parameter, evaluated first, rising from 0, at most `MOST_SAMPLES`,
            shape (g,).
        nodes: shares of an interval, and below the matrix from values there to coefficients, shape (10, 9).
        zone: distance from the position at path parameter 0 [m].
        clip: the greatest path parameter.
        samples: rows as above; the squares [m²] of as many path parameters as were requested, shape (3,
            `MOST_SAMPLES`).
        state: of the search, as above; zeros at first, shape (`SEARCH_STATE`,).
    """
    phase, square = int(state[PHASE]), zone * zone
    if phase == BEGINS:
        if zone <= 0.0 or clip <= 0.0:
            _end(0.0, state)
        else:
            _sample_grid(shares, 0, min(AT_ONCE, shares.shape[0]), clip, samples, state)
    elif phase == COARSELY:
        _take_grid(shares, nodes, square, clip, samples, state)
    elif phase == CLOSELY:
        _take_close(shares, nodes, square, clip, samples, state)
    elif phase == BETWEEN:
        _take_nodes(nodes, square, samples, state)
    else:
        off = samples[SAMPLE_SQUARES, 0] - square
        state[SHARE] = min(max(state[SHARE] - off / state[SLOPE], 0.0), 1.0)
        state[MENDED] += 1.0
        if abs(off) <= QUITE * square or state[MENDED] == MOST_MENDS:
            _end(state[LOW] + state[WIDTH] * state[SHARE], state)
        else:
            _sample_once(samples, state)


def _take_grid(shares: Array, nodes: Array, square: float, clip: float, samples: Array, state: Array) -> None:
    """Go on from squares of the grid: with the next of it where all are within the zone."""
    begin, count = int(state[FIRST]), int(state[SAMPLE_COUNT])
    first = begin
    for i in range(count):
        samples[EXCESS, begin + i] = samples[SAMPLE_SQUARES, i] - square
        if first == begin + i and not samples[EXCESS, first] >= 0.0:
            first += 1
    state[FIRST] = first
    if first == begin + count and first < shares.shape[0]:
        last = min(first + AT_ONCE_THEN, shares.shape[0])
        _sample_grid(shares, first, last, clip, samples, state)
    else:
        _sample_closely(shares, nodes, square, clip, samples, state)


def _take_close(
    shares: Array, nodes: Array, square: float, clip: float, samples: Array, state: Array
) -> None:
    """Go on from squares around a peak: with where the path leaves there, or with the next peak."""
    at = 0
    while at < MOST_SAMPLES and not samples[SAMPLE_SQUARES, at] - square >= 0.0:
        at += 1
    if at < MOST_SAMPLES:
        low = samples[SAMPLE_PARAMETERS, max(at - 1, 0)]
        _sample_between(nodes, low, samples[SAMPLE_PARAMETERS, max(at, 1)] - low, samples, state)
    else:
        _sample_closely(shares, nodes, square, clip, samples, state)


def _take_nodes(nodes: Array, square: float, samples: Array, state: Array) -> None:
    """Go on from squares at nodes: with where the polynomial through them is 0."""
    for k in range(DEGREE + 1):
        total = 0.0
        for i in range(DEGREE + 1):
            total += nodes[1 + k, i] * (samples[SAMPLE_SQUARES, i] - square)
        samples[EXCESS, k] = total
    state[SHARE] = _root(samples[EXCESS])
    state[SLOPE] = _slope(samples[EXCESS], state[SHARE])
    if state[SLOPE] > 0.0:
        _sample_once(samples, state)
    else:
        _end(state[LOW] + state[WIDTH] * state[SHARE], state)


def _sample_grid(shares: Array, first: int, last: int, clip: float, samples: Array, state: Array) -> None:
    """Request the path parameters of the grid from one to another."""
    state[PHASE], state[SAMPLE_COUNT], state[FIRST] = COARSELY, last - first, first
    for i in range(last - first):
        samples[SAMPLE_PARAMETERS, i] = shares[first + i] * clip


def _sample_closely(
    shares: Array, nodes: Array, square: float, clip: float, samples: Array, state: Array
) -> None:
    """Request path parameters around the next peak, or between the last one inside and the first outside."""
    first, peak = int(state[FIRST]), int(state[PEAK]) + 1
    while peak < first - 1:
        here = samples[EXCESS, peak]
        if here >= samples[EXCESS, peak - 1] and here >= samples[EXCESS, peak + 1] and here > NEAR * square:
            break
        peak += 1
    state[PEAK] = peak
    if peak < first - 1:
        begin, end = shares[peak - 1] * clip, shares[peak + 1] * clip
        state[PHASE], state[SAMPLE_COUNT] = CLOSELY, MOST_SAMPLES
        for i in range(MOST_SAMPLES):
            samples[SAMPLE_PARAMETERS, i] = begin + i * ((end - begin) / (MOST_SAMPLES - 1))
    elif first == shares.shape[0]:
        _end(clip, state)
    else:
        low = shares[first - 1] * clip
        _sample_between(nodes, low, shares[first] * clip - low, samples, state)


def _sample_between(nodes: Array, low: float, width: float, samples: Array, state: Array) -> None:
    """Request the path parameters at the nodes of an interval."""
    state[PHASE], state[SAMPLE_COUNT], state[LOW], state[WIDTH] = BETWEEN, DEGREE + 1, low, width
    for i in range(DEGREE + 1):
        samples[SAMPLE_PARAMETERS, i] = low + width * nodes[0, i]


def _sample_once(samples: Array, state: Array) -> None:
    """Request the present path parameter."""
    state[PHASE], state[SAMPLE_COUNT] = MENDS, 1.0
    samples[SAMPLE_PARAMETERS, 0] = state[LOW] + state[WIDTH] * state[SHARE]


def _end(s: float, state: Array) -> None:
    """End the search."""
    state[FOUND_PARAMETER], state[SAMPLE_COUNT] = s, 0.0


def _slope(coefficients: Array, x: float) -> float:
    """Return the derivative of a polynomial at x; its first coefficient is that of x⁰."""
    slope = 0.0
    for power in range(DEGREE, 0, -1):
        slope = slope * x + power * coefficients[power]
    return slope


def _root(coefficients: Array) -> float:
    """Return where a polynomial crosses 0 in [0, 1]; it is negative at 0 (its first coefficient is of x⁰).

    Newton's method, kept between a path parameter below and one above 0.
    """
    low, high, x = 0.0, 1.0, 0.5
    for _ in range(STEPS):
        value, slope = 0.0, 0.0
        for power in range(DEGREE, -1, -1):
            slope = slope * x + value
            value = value * x + coefficients[power]
        if value < 0.0:
            low = x
        else:
            high = x
        step = value / slope if slope > 0.0 else 1.0
        if not low <= x - step <= high:
            step = x - 0.5 * (low + high)
        if x - step == x:
            break
        x -= step
    return x
