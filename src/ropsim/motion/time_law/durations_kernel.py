"""The duration of one motion of all joints with one profile, in plain loops that numba compiles."""

from math import inf, nan, sqrt

from ropsim.codegen import Array1, Array2, kernel

_TINY = 1e-300


@kernel
def write_duration(q_start: Array1, q_end: Array1, limits: Array2, told: Array1) -> None:
    """Write what `durations` tells of one end that is elsewhere.

    Args:
        q_start: [rad | m], shape (n,).
        q_end: [rad | m], shape (n,).
        limits: speed, acceleration and jerk of every joint, shape (3, n).
        told: becomes the duration [s], NaN where limits or ways are none that a motion can have; shape (1,).
    """
    v = a = j = inf
    for i in range(q_start.shape[0]):
        way = max(abs(q_end[i] - q_start[i]), _TINY)
        v, a, j = min(v, limits[0, i] / way), min(a, limits[1, i] / way), min(j, limits[2, i] / way)
    if not (0.0 < v < inf and 0.0 < a < inf and 0.0 < j < inf):
        told[0] = nan
        return
    rise, lag = _rise(v, a, j), a * a / j
    ramps = v * rise
    if ramps <= 1.0:
        told[0] = 2.0 * rise + (1.0 - ramps) / v
        return
    peak = 2.0 * a / (lag + sqrt(lag * lag + 4.0 * a))
    told[0] = 2.0 * (peak / a + a / j) if peak >= lag else 4.0 * (0.5 / j) ** (1.0 / 3.0)


def _rise(v: float, a: float, j: float) -> float:
    """Return the time of a rise from rest to a speed."""
    return v / a + a / j if v * j >= a * a else 2.0 * sqrt(v / j)
