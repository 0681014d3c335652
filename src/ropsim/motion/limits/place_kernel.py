"""What a course lacks at the places that it is planned with, in loops that numba compiles."""

import math

from ropsim.codegen import kernel
from ropsim.motion.limits.rounding_kernel import greatest_nearby
from ropsim.motion.limits.strain_kernel import BESIDE, MOST_AT_ONCE, RATE, STEADY, SWING, WINDOW
from ropsim.spatial import Array

_TINY = 1e-300
_WIDEST = 8.0
"""Greatest width of windows over their first one."""


@kernel(
    "void(f8[:,::1], f8[:,::1], f8[::1], f8[::1], f8[::1], f8[::1], f8[:,::1], f8[:,::1],"
    " f8, f8, f8[:,::1], f8[::1])"
)
def lacks_at(
    first: Array,
    second: Array,
    times: Array,
    rates: Array,
    changes: Array,
    speed: Array,
    swing: Array,
    jerk: Array,
    allowed: float,
    more: float,
    lacks: Array,
    told: Array,
) -> None:
    """Write what n joints and r paths lack at m places, as `strain_of` does at control ticks; torque aside.

    The jerk of a way is the greater one of its two ends: its mean, and what the slope of the change of the
    rate has there beyond its own mean.

    Args:
        first: first derivatives by motion time, shape (m, n + r).
        second: second ones.
        times: real times at the places [s], rising, shape (m,).
        rates: dφ/dt there, shape (m,).
        changes: of the rates there [1/s], shape (m,).
        speed: limits of the joints, shape (n,).
        swing: limits of acceleration, shape (m, n + r), or (1, n + r) for the same at all places.
        jerk: limits of jerk likewise.
        allowed: what may be used of a limit, 1 and rounding.
        more: added to the logarithm of each excess.
        lacks: become logarithms of what rate and acceleration are to be divided by, windows to be multiplied
            with, and torque to be divided by, shape (4, m).
        told: becomes how many excesses there are, shape (1,).
    """
    told[0] = 0.0
    constant = swing.shape[0] == 1
    for i in range(first.shape[0]):
        for row in range(lacks.shape[0]):
            lacks[row, i] = 0.0
        w, c, here = rates[i], changes[i], 0 if constant else i
        square = w * w
        for j in range(first.shape[1]):
            if j < speed.shape[0] and abs(first[i, j]) * w > allowed * speed[j]:
                lack = math.log(min(abs(first[i, j]) * w / speed[j], MOST_AT_ONCE)) + more
                _raise(lacks, RATE, i, lack, told)
            swung = abs(second[i, j] * square + first[i, j] * c)
            if swung > allowed * swing[here, j]:
                _raise(lacks, SWING, i, math.log(min(swung / swing[here, j], MOST_AT_ONCE)) + more, told)
        if i == 0:
            continue
        v, b = rates[i - 1], changes[i - 1]
        per, less = 1.0 / (times[i] - times[i - 1]), v * v
        mean, slope = (c - b) * per, 6.0 * (w - v) * per * per
        begin, end = slope - (4.0 * b + 2.0 * c) * per - mean, (2.0 * b + 4.0 * c) * per - slope - mean
        for j in range(first.shape[1]):
            swung = second[i, j] * square + first[i, j] * c - (second[i - 1, j] * less + first[i - 1, j] * b)
            level = swung * per
            most = max(abs(level + first[i - 1, j] * begin), abs(level + first[i, j] * end))
            if most > allowed * jerk[here, j]:
                path = abs(second[i, j] - second[i - 1, j]) * square
                bend = abs(second[i, j] * (square - less)) + abs((first[i, j] - first[i - 1, j]) * c)
                change = abs(first[i, j] * (c - b))
                whole = math.log(min(most / jerk[here, j], MOST_AT_ONCE)) + more
                whole /= max(path + bend + change, _TINY)
                for k in range(i - 1, i + 1):
                    _raise(lacks, RATE, k, path * STEADY * whole, told)
                    _raise(lacks, SWING, k, (bend + BESIDE * change) * whole, told)
                    _raise(lacks, WINDOW, k, change * whole, told)


def _raise(lacks: Array, row: int, place: int, lack: float, told: Array) -> None:
    """Keep the greatest lack, and count it."""
    lacks[row, place] = max(lacks[row, place], lack)
    told[0] += 1.0


@kernel("void(f8[::1], f8[:,::1], f8[:,::1], f8[:,::1])")
def give_up(sigma: Array, lacks: Array, room: Array, shares: Array) -> None:
    """Make shares smaller, and windows wider, by the greatest lacks in the windows around places.

    Args:
        sigma: places in windows, see `smooth_course`, shape (m,).
        lacks: logarithms, as from `lacks_at`, shape (4, m).
        room: to work in, shape (2, m).
        shares: of rate and acceleration, width of windows, and share of torque, shape (4, m).
    """
    for row in range(lacks.shape[0]):
        greatest = 0.0
        for i in range(sigma.shape[0]):
            greatest = max(greatest, lacks[row, i])
        if greatest == 0.0:
            continue
        greatest_nearby(sigma, lacks[row], room[0], room[1])
        for i in range(sigma.shape[0]):
            if room[1, i] > 0.0:
                factor = math.exp(room[1, i])
                if row == WINDOW:
                    shares[row, i] = min(shares[row, i] * factor, _WIDEST)
                else:
                    shares[row, i] /= factor
