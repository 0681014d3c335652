"""What a course lacks at the places that it is planned with, in loops that numba compiles."""

import math

from ropsim.codegen import Array1, Array2, columns, kernel
from ropsim.motion.retiming.utilisation_kernel import BESIDE, MOST_AT_ONCE, RATE, STEADY, SWING, WINDOW
from ropsim.spatial import Array

_TINY = 1e-300
_UNEVEN = 49.0
"""Greatest length of one part of a way over the other one where jerks beside it tell that of its parts."""
ROWS_OF_PLACES = 7
"""Rows to work in: accelerations at two places, jerks of three ways, excesses, and jerks by real time."""


@kernel
def lacks_at(
    first: Array2,
    second: Array2,
    places: Array1,
    times: Array1,
    rates: Array1,
    changes: Array1,
    speed: Array1,
    swing: Array2,
    jerk: Array2,
    allowed: float,
    more: float,
    room: Array2,
    lacks: Array2,
    told: Array1,
) -> None:
    """Write what n joints and r paths lack at m places, as `strain_of` does at control ticks; torque aside.

    The jerk of a way is the greater one of its two ends: its mean, and what the slope of the change of the
    rate has there beyond its own mean. Where the jerk of the path is one between those of the ways beside it,
    the path may have gone over from the one to the other on the way: then these count at its ends as well.

    Args:
        first: first derivatives by motion time, shape (m, n + r).
        second: second ones.
        places: motion times [s], rising, shape (m,).
        times: real times there [s], rising, shape (m,).
        rates: dφ/dt there, shape (m,).
        changes: of the rates there [1/s], shape (m,).
        speed: limits of the joints, and infinity for paths, shape (n + r,).
        swing: limits of acceleration, shape (m, n + r), or (1, n + r) for the same at all places.
        jerk: limits of jerk likewise.
        allowed: what may be used of a limit, 1 and rounding.
        more: added to the logarithm of each excess.
        room: to work in, shape (ROWS_OF_PLACES, n + r).
        lacks: become logarithms of what rate and acceleration are to be divided by, windows to be multiplied
            with, and torque to be divided by, shape (4, m).
        told: becomes how many excesses there are, shape (1,).
    """
    told[0] = 0.0
    n, last, constant = first.shape[1], first.shape[0] - 1, swing.shape[0] == 1
    lacks[:] = 0.0
    room[:] = 0.0
    per, begin, end = 0.0, 0.0, 0.0
    now, past, fore, own, aft = 0, 1, 2, 3, 4
    for i in range(last + 1):
        w, c, here, before = rates[i], changes[i], 0 if constant else i, max(i - 1, 0)
        v, b, square = rates[before], changes[before], w * w
        now, past, fore, own, aft = past, now, own, aft, fore
        swung = room[now]
        _swing(n, square, c, first[i], second[i], swung)
        if i < last:
            _jerk(n, 1.0 / (places[i + 1] - places[i]), second[i + 1], second[i], room[aft])
        if i > 0:
            per = 1.0 / (times[i] - times[i - 1])
            mean, slope = (c - b) * per, 6.0 * (w - v) * per * per
            begin = slope - (4.0 * b + 2.0 * c) * per - mean
            end = (2.0 * b + 4.0 * c) * per - slope - mean
        cube = square * w if 1 < i < last else 0.0
        jerks, paths = (room[fore], room[own], room[aft]), (first[before], first[i])
        limits = speed, swing[here], jerk[here]
        _beyond(
            n, allowed, w, cube, per, begin, end, room[past], swung, *jerks, *paths, *limits, room[5], room[6]
        )
        for j in range(n):
            if not room[5, j] > 0.0:
                continue
            fast, most = abs(first[i, j]) * w, room[6, j]
            if fast > allowed * speed[j]:
                _raise(lacks, RATE, i, math.log(min(fast / speed[j], MOST_AT_ONCE)) + more, told)
            if abs(swung[j]) > allowed * swing[here, j]:
                lack = math.log(min(abs(swung[j]) / swing[here, j], MOST_AT_ONCE)) + more
                _raise(lacks, SWING, i, lack, told)
            if most > allowed * jerk[here, j]:
                path = abs(second[i, j] - second[before, j]) * square
                bend = abs(second[i, j] * (square - v * v)) + abs((first[i, j] - first[before, j]) * c)
                change = abs(first[i, j] * (c - b))
                whole = math.log(min(most / jerk[here, j], MOST_AT_ONCE)) + more
                whole /= max(path + bend + change, _TINY)
                for k in range(i - 1, i + 1):
                    _raise(lacks, RATE, k, path * STEADY * whole, told)
                    _raise(lacks, SWING, k, (bend + BESIDE * change) * whole, told)
                    _raise(lacks, WINDOW, k, change * whole, told)


@columns
def _swing(count: int, square: float, c: float, first: Array, second: Array, out: Array) -> None:
    """Write accelerations by real time."""
    for j in range(count):
        out[j] = second[j] * square + first[j] * c


@columns
def _jerk(count: int, per: float, behind: Array, before: Array, out: Array) -> None:
    """Write mean jerks by motion time on a way."""
    for j in range(count):
        out[j] = (behind[j] - before[j]) * per


@columns
def _beyond(
    count: int,
    allowed: float,
    w: float,
    cube: float,
    per: float,
    begin: float,
    end: float,
    was: Array,
    swung: Array,
    fore: Array,
    own: Array,
    aft: Array,
    before: Array,
    first: Array,
    speed: Array,
    swing: Array,
    jerk: Array,
    out: Array,
    most: Array,
) -> None:
    """Write what is beyond limits at a place and on the way to it, below 0 for none, and the jerk there.

    Args:
        count: of joints and paths.
        allowed: what may be used of a limit.
        w: rate at the place.
        cube: its third power; 0 where no way is before that to the place, or none behind it.
        per: inverse of the real time on the way [1/s].
        begin: what the change of the rate adds to jerk at its begin, for a first derivative of 1 [1/s²].
        end: likewise at its end.
        was: acceleration at the place before.
        swung: at this one.
        fore: mean jerk of the path by motion time on the way before.
        own: on this one.
        aft: on that behind.
        before: first derivatives at the place before.
        first: at this one.
        speed: limits.
        swing: limits.
        jerk: limits.
        out: becomes the greatest excess.
        most: becomes the jerk by real time.
    """
    for j in range(count):
        level = (swung[j] - was[j]) * per
        start = level + before[j] * begin
        stop = level + first[j] * end
        rise = (aft[j] - own[j]) * cube
        fall = (fore[j] - own[j]) * cube
        behind = max(min(rise, _UNEVEN * max(0.0 - fall, 0.0)), 0.0 - _UNEVEN * max(fall, 0.0))
        ahead = max(min(fall, _UNEVEN * max(0.0 - rise, 0.0)), 0.0 - _UNEVEN * max(rise, 0.0))
        at_start = max(abs(start), abs(start + ahead))
        at_stop = max(abs(stop), abs(stop + behind))
        far = max(at_start, at_stop)
        most[j] = far
        excess = max(abs(first[j]) * w - allowed * speed[j], abs(swung[j]) - allowed * swing[j])
        out[j] = max(excess, far - allowed * jerk[j])


def _raise(lacks: Array, row: int, place: int, lack: float, told: Array) -> None:
    """Keep the greatest lack, and count it."""
    lacks[row, place] = max(lacks[row, place], lack)
    told[0] += 1.0
