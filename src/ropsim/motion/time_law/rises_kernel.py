"""Rises from the start of a motion, each as long as it can be levelled off; see `time_law_kernel`."""

from math import inf, sqrt
from typing import NamedTuple

from ropsim.motion.time_law.levelling_kernel import (
    LEVELLED,
    LITTLE_LESS,
    NEWTON,
    ROUNDS,
    THIRD,
    between,
    crossing_time,
    level_off,
    levelled_parameter,
    root_share,
    state_after,
    stoppable_speed,
)
from ropsim.spatial import Array


class _Rise(NamedTuple):
    """A rise from speed v and acceleration a, with full jerk until a time, then with most acceleration."""

    v: float
    a: float
    until: float
    most: float


def write_rises(table: Array, rises: Array) -> None:
    """Write the rises over a distance."""
    p = table.shape[1] - 1
    for i in range(p + 1):
        table[6, i] = -1.0
    table[6, 0] = 0.0
    n = k = start = int(table[6, 0])  # a number in the text would be a type of its own for numba
    v, a, reached = 0.0, 0.0, 0.0
    while k < p:
        length, most, jerk = table[0, k], table[2, k], table[3, k]
        until = max(most - a, 0.0) / jerk
        s, v1, _ = state_after(until, v, a, jerk, until, most)
        if s >= length:
            until = end = crossing_time(length, v, a, jerk)
        else:
            rest = length - s
            end = until + 2.0 * rest / (v1 + sqrt(v1 * v1 + 2.0 * most * rest))
        _, v1, a1 = state_after(end, v, a, jerk, until, most)
        if k + 1 < p and v1 <= table[4, k + 1] and a1 <= table[2, k + 1]:
            fault, _, _, top, _, _ = level_off(table, k + 1, 0.0, v1, a1, k)
            if fault == 0:
                n = _add_rise(table, rises, n, k, _Rise(v, a, until, most), end, length, reached)
                k, v, a, reached = k + 1, v1, a1, top
                continue
        last, top, fault, where = _latest(table, k, v, a, until, most, end)
        s, v1, a1 = state_after(last, v, a, jerk, until, most)
        n = _add_rise(table, rises, n, k, _Rise(v, a, until, most), last, min(s, length), reached)
        if fault == 0:
            n, v, a = _add_levelling(table, rises, n, k, min(s, length), v1, a1, top, where)
            v, a, k, reached = min(v, table[4, where]), min(a, table[2, where]), where, top
        else:
            table[7, start], table[8, start] = n, top
            start, k = where, where
            table[6, k], v, a = n, table[4, k], 0.0
            reached = v


def _latest(
    table: Array, k: int, v: float, a: float, until: float, most: float, end: float
) -> tuple[float, float, int, int]:
    """Return until when a rise goes on in a path segment that it cannot cross.

    Returns:
        the time; the speed to which it is levelled off then; 0 where it goes on behind the boundary that
        follows, 1 where a new rise starts there; the boundary.
    """
    length, speed, jerk = table[0, k], table[1, k], table[3, k]
    low, high = 0.0, end
    peak = sqrt(max(0.5 * a * a + jerk * (speed - v), 0.0))
    t = max(peak - a, 0.0) / jerk
    if t > until:
        v1 = v + until * (a + 0.5 * jerk * until)
        t = max(until + (speed - v1 - 0.5 * most * most / jerk) / most, until)
    if t < end:
        s, v1, a1 = state_after(t, v, a, jerk, until, most)
        if levelled_parameter(s, v1, a1, jerk) <= length:
            return t, speed, 1, k + 1
    if levelled_parameter(0.0, v, a, jerk) <= length:
        low = _levelled_at(length, v, a, jerk, until, most, high)
        s, v1, a1 = state_after(low, v, a, jerk, until, most)
        top = v1 + 0.5 * a1 * a1 / jerk
        if top >= table[4, k + 1]:
            return low, top, 1, k + 1
    low, fault, where = _last_within(table, k, v, a, until, most, low, high)
    s, v1, a1 = state_after(low, v, a, jerk, until, most)
    found, path_segment, _, top, there, _ = level_off(table, k, min(s, length), v1, a1, k)
    if found != 0:
        fault, where, path_segment = found, there, there
    where = max(where, k + 2 - fault)  # a rise continues in a later path segment, despite rounding
    if fault == 2:
        if path_segment >= where:
            return low, table[1, where], 1, where + 1
        return low, top, 1, where
    if path_segment < where or where == table.shape[1] - 1:
        return low, top, 1, where
    return low, top, 0, where


def _nearest(
    table: Array, path_segment: int, s: float, v: float, a: float, since: int
) -> tuple[int, int, float]:
    """Return which bound is the first that is broken or else the nearest where a motion is levelled off.

    A boundary bounds nothing as long as the motion is levelled off before it, and little just behind it.

    Returns:
        the fault and its path segment as `level_off` finds them, or would find them; the margin up to the
        bound, as a share of it, below 0 where it is broken.
    """
    p = table.shape[1] - 1
    k, where, margin = path_segment, path_segment + 1, inf
    while True:
        length, jerk = table[0, k], table[3, k]
        t = a / jerk
        end, top = s + t * (v + a * t * THIRD), v + 0.5 * a * t
        left = (length - end) / length
        if end <= length or k + 1 == p:
            break
        t = crossing_time(length - s, v, a, -jerk)
        v += t * (a - 0.5 * jerk * t)
        a = max(a - jerk * t, 0.0)
        s = 0.0
        k += 1
        here = min(table[4, k] - v, (table[2, k] - a) * (table[4, k] / table[2, k]))
        if v > table[4, k] or a > table[2, k]:
            return 1, k, max(here / v, left)
        if here < margin * v:
            where, margin = k, here / v
    if end > length:
        return 1, p, left
    here = (table[1, k] - top) / table[1, k]
    if here < 0.0:
        return 2, k, here
    fault = 1
    for i in range(since, k):
        if table[5, i] < inf:
            most = stoppable_speed(table, k, end, i)
            if top > most:
                return 1, i + 1, (most - top) / top
            if most - top < margin * top:
                where, margin = i + 1, (most - top) / top
    if here < margin:
        fault, where, margin = 2, k, here
    if left < margin and table[4, k + 1] - top < margin * top:
        fault, where, margin = 1, k + 1, max(left, (table[4, k + 1] - top) / top)
    return fault, where, margin


def _last_within(
    table: Array, k: int, v: float, a: float, until: float, most: float, low: float, high: float
) -> tuple[float, int, int]:
    """Return the last time between two at which a rise could be levelled off without breaking a bound.

    Returns:
        the time, a few roundings before the last one; the fault that follows and its path segment.
    """
    jerk = table[3, k]
    s, v1, a1 = state_after(low, v, a, jerk, until, most)
    fault, where, other_margin = _nearest(table, k, s, v1, a1, k)
    if other_margin <= LEVELLED:
        return low, fault, where
    s, v1, a1 = state_after(high, v, a, jerk, until, most)
    fault, where, margin = _nearest(table, k, s, v1, a1, k)
    if margin >= 0.0:
        return high, fault, where
    here, margin, other_end, other_margin, share = high, max(margin, -1.0), low, min(other_margin, 1.0), 0.5
    for _ in range(ROUNDS):
        t = between(here, other_end, share)
        if not min(here, other_end) < t < max(here, other_end):
            break
        s, v1, a1 = state_after(t, v, a, jerk, until, most)
        found, there, seen = _nearest(table, k, s, v1, a1, k)
        if seen < 0.0:
            fault, where = found, there
        elif seen <= LEVELLED:
            return t, found, there
        if (seen >= 0.0) == (margin >= 0.0):
            before, before_margin = here, margin
        else:
            before, before_margin, other_end, other_margin = other_end, other_margin, here, margin
        here, margin = t, seen
        share = root_share(here, margin, other_end, other_margin, before, before_margin)
    return min(here, other_end), fault, where


def _levelled_at(
    length: float, v: float, a: float, jerk: float, until: float, most: float, high: float
) -> float:
    """Return the last time no later than another at which a rise can be levelled off within a length.

    Under jerk the path parameter at which it is levelled off is convex in time, so that Newton's steps fall
    to the root from above; behind that it is a square.
    """
    t = min(until, high)
    s, v1, a1 = state_after(t, v, a, jerk, until, most)
    over, slope = levelled_parameter(s, v1, a1, jerk) - length, v1 + a1 * a1 / jerk
    if over <= 0.0:
        t -= 2.0 * over / (slope + sqrt(slope * slope - 2.0 * most * over))
        return min(t, high) * LITTLE_LESS
    for _ in range(ROUNDS):
        step = 0.5 * over / slope
        t -= step
        if not step > NEWTON * t:
            break
        s, v1, a1 = state_after(t, v, a, jerk, until, most)
        over, slope = levelled_parameter(s, v1, a1, jerk) - length, v1 + a1 * a1 / jerk
    return max(t, 0.0) * LITTLE_LESS


def _add_rise(
    table: Array, rises: Array, n: int, k: int, rise: _Rise, end: float, last: float, reached: float
) -> int:
    """Write the segments of a rise in path segment k up to a time; return the number of all."""
    jerk = table[3, k]
    if end <= rise.until:
        return _add(rises, n, k, 0.0, rise.v, rise.a, jerk, end, last, reached)
    s, v1, _ = state_after(rise.until, rise.v, rise.a, jerk, rise.until, rise.most)
    n = _add(rises, n, k, 0.0, rise.v, rise.a, jerk, rise.until, s, reached)
    _, _, _, top, _, _ = level_off(table, k, s, v1, rise.most, k)
    return _add(rises, n, k, s, v1, rise.most, 0.0, end - rise.until, last, max(top, reached))


def _add_levelling(
    table: Array,
    rises: Array,
    n: int,
    k: int,
    s: float,
    v: float,
    a: float,
    top: float,
    until: int,
) -> tuple[int, float, float]:
    """Level the motion off, not beyond a boundary; return number, speed and acceleration there."""
    while k < until:
        length, jerk = table[0, k], table[3, k]
        end = levelled_parameter(s, v, a, jerk)
        if end <= length or k + 2 == table.shape[1]:
            n = _add(rises, n, k, s, v, a, -jerk, a / jerk, min(end, length), top)
            return n, v + 0.5 * a * a / jerk, 0.0
        t = crossing_time(length - s, v, a, -jerk)
        n = _add(rises, n, k, s, v, a, -jerk, t, length, top)
        v += t * (a - 0.5 * jerk * t)
        a = max(a - jerk * t, 0.0)
        s = 0.0
        k += 1
    return n, v, a


def _add(
    rises: Array,
    n: int,
    path_segment: int,
    s: float,
    v: float,
    a: float,
    jerk: float,
    duration: float,
    end: float,
    top: float,
) -> int:
    """Write a segment; return the number of all."""
    rises[0, n], rises[1, n], rises[2, n], rises[3, n] = path_segment, s, v, a
    rises[4, n], rises[5, n], rises[6, n], rises[7, n] = jerk, duration, end, top
    return n + 1
