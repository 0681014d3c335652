"""Advancing through reference rows at a rate that follows an override; numba compiles the loops."""

from math import floor, sqrt
from typing import NamedTuple

from ropsim.codegen import Array1, Array3, kernel
from ropsim.spatial import Array

LANDED = 1e-12
"""A rate this near to the override, with a change this small per tick, is at it: the rest is rounding."""
HALVINGS = 4
"""How often the way between the change that is wished for and the one that is safe is halved."""


class ClockNumbers(NamedTuple):
    """Numbers of a motion clock.

    Attributes:
        first: number of the first of the rows.
        last: number of the last row of the motion, where it is at rest.
        override: requested rate, 0..1.
        change: greatest change of the rate [1/s].
        step: greatest step of the change per tick [1/s].
        period: of a control tick [s].
    """

    first: int
    last: int
    override: float
    change: float
    step: float
    period: float


@kernel
def advance_clock(
    rows: Array3, limits: Array1, out: Array3, clock: ClockNumbers, place: float, rate: float, before: float
) -> None:
    """Advance, one control tick for each row of the result but the last.

    Within a tick the change c of the rate w is linear: w += T·(c + c')/2 and place += w + T·(2·c + c')/6.

    Args:
        rows: coordinates, speeds and accelerations of the rows from `first` on, at control ticks of motion
            time [rad | m, 1/s, 1/s²], shape (3, k, n); as far as the result and its look-ahead go.
        limits: of the joint accelerations [rad/s² | m/s²], shape (n,).
        out: references, shape (3, ticks + 1, n); out[:, ticks, 0] becomes place, rate and change at the end.
        clock: numbers of the clock.
        place: of the motion [ticks].
        rate: of the motion there.
        before: change of the rate there [1/s].
    """
    first, last, override, change, step, period = clock
    ticks = out.shape[1] - 1
    for tick in range(ticks):
        requested = _requested_change((override - rate) / period - before / 2.0, before, change, step)
        after = _allowed(rows, limits, clock, place, rate, before, requested)
        stood = place >= last
        place = _next_place(place, rate, before, after, period, last)
        rate = _next_rate(rate, before, after, period)
        if abs(rate - override) <= LANDED and abs(after) * period <= LANDED:
            rate, after = override, 0.0
        before = after
        if not stood and place == floor(place) and rate == 1.0 and before == 0.0:
            _row(rows, int(place) - first, tick, out)
        else:
            _reference(rows, first, last, place, rate, before, period, tick, out)
    out[0, ticks, 0], out[1, ticks, 0], out[2, ticks, 0] = place, rate, before


def _requested_change(difference: float, before: float, change: float, step: float) -> float:
    """Return the change at the next tick that brings the rate to the override in least time.

    A change that decreases from c = m·h + r, 0 <= r < h, by steps of h, is 0 when the rate has advanced by
    T·((m + 1/2)·c - h·m·(m + 1)/2). With the half tick before that makes the greatest c that does
    not lead past the override the solution of (m + 1)·c - h·m·(m + 1)/2 = way.

    Args:
        difference: (override - rate)/T - before/2 [1/s].
        before: the change now [1/s].
        change: greatest change [1/s].
        step: h, greatest step of it [1/s].
    """
    size = abs(difference)
    steps = floor((sqrt(1.0 + 8.0 * size / step) - 1.0) / 2.0)
    landing = min(size / (steps + 1.0) + step * steps / 2.0, change)
    requested = landing if difference > 0.0 else -landing
    return min(max(requested, before - step), before + step)


def _allowed(
    rows: Array,
    limits: Array,
    clock: ClockNumbers,
    place: float,
    rate: float,
    before: float,
    requested: float,
) -> float:
    """Return the change at the next tick: the requested one, or a safe one near it.

    Safe is a change from which full jerk can take it to 0 without a joint beyond its limit on the way; from
    a safe one the step towards 0 is safe again. A rate that does not change is always safe, since it is <= 1.
    """
    if _is_safe(rows, limits, clock, place, rate, before, requested):
        return requested
    safe = _towards_zero(before, clock.step)
    near, far = 0.0, 1.0
    for _ in range(HALVINGS):
        share = (near + far) / 2.0
        tried = safe + share * (requested - safe)
        if _is_safe(rows, limits, clock, place, rate, before, tried):
            near = share
        else:
            far = share
    return safe + near * (requested - safe)


def _is_safe(
    rows: Array, limits: Array, clock: ClockNumbers, place: float, rate: float, before: float, after: float
) -> bool:
    first, last, step, period = clock.first, clock.last, clock.step, clock.period
    while after != 0.0:
        place = _next_place(place, rate, before, after, period, last)
        rate = _next_rate(rate, before, after, period)
        if not _is_within(rows, limits, first, last, place, rate, after):
            return False
        before, after = after, _towards_zero(after, step)
    return True


def _is_within(
    rows: Array, limits: Array, first: int, last: int, place: float, rate: float, change: float
) -> bool:
    """Return whether all joints are within their limits: q''·w² + q'·c by the rows before and behind.

    Between two rows the reference has no speed and no acceleration beyond theirs. Where the rows themselves
    are beyond a limit, they are the limit.
    """
    if place >= last:
        return True
    k = int(place) - first
    for j in range(limits.shape[0]):
        one, two = rows[2, k, j], rows[2, k + 1, j]
        slow, fast = rows[1, k, j] * change, rows[1, k + 1, j] * change
        limit = max(limits[j], abs(one), abs(two))
        if max(one, two) * rate * rate + max(slow, fast) > limit:
            return False
        if min(one, two) * rate * rate + min(slow, fast) < -limit:
            return False
    return True


def _towards_zero(change: float, step: float) -> float:
    if abs(change) <= step:
        return 0.0
    return change - step if change > 0.0 else change + step


def _next_rate(rate: float, before: float, after: float, period: float) -> float:
    return min(max(rate + (before + after) / 2.0 * period, 0.0), 1.0)


def _next_place(place: float, rate: float, before: float, after: float, period: float, last: int) -> float:
    step = rate + (2.0 * before + after) / 6.0 * period
    return min(place + max(step, 0.0), float(last))


def _reference(
    rows: Array,
    first: int,
    last: int,
    place: float,
    rate: float,
    change: float,
    period: float,
    tick: int,
    out: Array,
) -> None:
    """Write one row of the result: q(φ), q'·w and q''·w² + q'·c."""
    k = int(place) - first
    u = place - int(place)
    for j in range(out.shape[2]):
        q, speed, acceleration = rows[0, k, j], rows[1, k, j], rows[2, k, j]
        if place >= last:
            speed, acceleration = 0.0, 0.0
        else:
            if u > 0.0:
                q, speed, acceleration = _between(rows, k, j, u, period)
            acceleration = acceleration * rate * rate + speed * change
            speed = speed * rate
        out[0, tick, j], out[1, tick, j], out[2, tick, j] = q, speed, acceleration


def _row(rows: Array, k: int, tick: int, out: Array) -> None:
    """Write a row unchanged, bit by bit."""
    for axis in range(3):
        for j in range(out.shape[2]):
            out[axis, tick, j] = rows[axis, k, j]


def _between(rows: Array, k: int, j: int, u: float, period: float) -> tuple[float, float, float]:
    """Return coordinate, speed and acceleration of a joint at a share `u` of the way from row k to k + 1.

    The polynomial of fifth degree that has the coordinates, speeds and accelerations of both rows; its speed
    and acceleration are kept within the ones of the two rows, so that between them no limit is passed that
    they keep.
    """
    q, v, a = rows[0, k, j], rows[1, k, j] * period, rows[2, k, j] * period * period
    v_end, a_end = rows[1, k + 1, j] * period, rows[2, k + 1, j] * period * period
    d, e, f = rows[0, k + 1, j] - q - v - a / 2.0, v_end - v - a, a_end - a
    c3, c4, c5 = 10.0 * d - 4.0 * e + f / 2.0, 7.0 * e - 15.0 * d - f, 6.0 * d - 3.0 * e + f / 2.0
    speed = (v + u * (a + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5)))) / period
    acceleration = (a + u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5))) / (period * period)
    return (
        q + u * (v + u * (a / 2.0 + u * (c3 + u * (c4 + u * c5)))),
        _clipped(speed, rows[1, k, j], rows[1, k + 1, j]),
        _clipped(acceleration, rows[2, k, j], rows[2, k + 1, j]),
    )


def _clipped(value: float, one: float, two: float) -> float:
    return min(max(value, min(one, two)), max(one, two))
