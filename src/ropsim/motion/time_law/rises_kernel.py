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
    levelled_place,
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


def write_rises(way: Array, rises: Array) -> None:
    """Write the rises over a way."""
    p = way.shape[1] - 1
    for i in range(p + 1):
        way[6, i] = -1.0
    way[6, 0] = 0.0
    n = k = start = int(way[6, 0])  # a number in the text would be a type of its own for numba
    v, a, reached = 0.0, 0.0, 0.0
    while k < p:
        length, most, jerk = way[0, k], way[2, k], way[3, k]
        until = max(most - a, 0.0) / jerk
        place, v1, _ = state_after(until, v, a, jerk, until, most)
        if place >= length:
            until = end = crossing_time(length, v, a, jerk)
        else:
            rest = length - place
            end = until + 2.0 * rest / (v1 + sqrt(v1 * v1 + 2.0 * most * rest))
        _, v1, a1 = state_after(end, v, a, jerk, until, most)
        if k + 1 < p and v1 <= way[4, k + 1] and a1 <= way[2, k + 1]:
            fault, _, _, top, _, _ = level_off(way, k + 1, 0.0, v1, a1, k)
            if fault == 0:
                n = _add_rise(way, rises, n, k, _Rise(v, a, until, most), end, length, reached)
                k, v, a, reached = k + 1, v1, a1, top
                continue
        last, top, fault, where = _latest(way, k, v, a, until, most, end)
        place, v1, a1 = state_after(last, v, a, jerk, until, most)
        n = _add_rise(way, rises, n, k, _Rise(v, a, until, most), last, min(place, length), reached)
        if fault == 0:
            n, v, a = _add_levelling(way, rises, n, k, min(place, length), v1, a1, top, where)
            v, a, k, reached = min(v, way[4, where]), min(a, way[2, where]), where, top
        else:
            way[7, start], way[8, start] = n, top
            start, k = where, where
            way[6, k], v, a = n, way[4, k], 0.0
            reached = v


def _latest(
    way: Array, k: int, v: float, a: float, until: float, most: float, end: float
) -> tuple[float, float, int, int]:
    """Return until when a rise goes on in a path segment that it cannot cross.

    Returns:
        the time; the speed to which it is levelled off then; 0 where it goes on behind the boundary that
        follows, 1 where a new rise starts there; the boundary.
    """
    length, speed, jerk = way[0, k], way[1, k], way[3, k]
    low, high = 0.0, end
    peak = sqrt(max(0.5 * a * a + jerk * (speed - v), 0.0))
    t = max(peak - a, 0.0) / jerk
    if t > until:
        v1 = v + until * (a + 0.5 * jerk * until)
        t = max(until + (speed - v1 - 0.5 * most * most / jerk) / most, until)
    if t < end:
        place, v1, a1 = state_after(t, v, a, jerk, until, most)
        if levelled_place(place, v1, a1, jerk) <= length:
            return t, speed, 1, k + 1
    if levelled_place(0.0, v, a, jerk) <= length:
        low = _levelled_at(length, v, a, jerk, until, most, high)
        place, v1, a1 = state_after(low, v, a, jerk, until, most)
        top = v1 + 0.5 * a1 * a1 / jerk
        if top >= way[4, k + 1]:
            return low, top, 1, k + 1
    low, fault, where = _last_kept(way, k, v, a, until, most, low, high)
    place, v1, a1 = state_after(low, v, a, jerk, until, most)
    found, path_segment, _, top, there, _ = level_off(way, k, min(place, length), v1, a1, k)
    if found != 0:
        fault, where, path_segment = found, there, there
    where = max(where, k + 2 - fault)  # a rise continues in a later path segment, despite rounding
    if fault == 2:
        if path_segment >= where:
            return low, way[1, where], 1, where + 1
        return low, top, 1, where
    if path_segment < where or where == way.shape[1] - 1:
        return low, top, 1, where
    return low, top, 0, where


def _nearest(
    way: Array, path_segment: int, place: float, v: float, a: float, since: int
) -> tuple[int, int, float]:
    """Return which bound is the first that is broken or else the nearest where a motion is levelled off.

    A boundary bounds nothing as long as the motion is levelled off before it, and little just behind it.

    Returns:
        the fault and its place as `level_off` finds them, or would find them; the room up to the bound, as a
        share of it, below 0 where it is broken.
    """
    p = way.shape[1] - 1
    k, where, room = path_segment, path_segment + 1, inf
    while True:
        length, jerk = way[0, k], way[3, k]
        t = a / jerk
        end, top = place + t * (v + a * t * THIRD), v + 0.5 * a * t
        left = (length - end) / length
        if end <= length or k + 1 == p:
            break
        t = crossing_time(length - place, v, a, -jerk)
        v += t * (a - 0.5 * jerk * t)
        a = max(a - jerk * t, 0.0)
        place = 0.0
        k += 1
        here = min(way[4, k] - v, (way[2, k] - a) * (way[4, k] / way[2, k]))
        if v > way[4, k] or a > way[2, k]:
            return 1, k, max(here / v, left)
        if here < room * v:
            where, room = k, here / v
    if end > length:
        return 1, p, left
    here = (way[1, k] - top) / way[1, k]
    if here < 0.0:
        return 2, k, here
    fault = 1
    for i in range(since, k):
        if way[5, i] < inf:
            most = stoppable_speed(way, k, end, i)
            if top > most:
                return 1, i + 1, (most - top) / top
            if most - top < room * top:
                where, room = i + 1, (most - top) / top
    if here < room:
        fault, where, room = 2, k, here
    if left < room and way[4, k + 1] - top < room * top:
        fault, where, room = 1, k + 1, max(left, (way[4, k + 1] - top) / top)
    return fault, where, room


def _last_kept(
    way: Array, k: int, v: float, a: float, until: float, most: float, low: float, high: float
) -> tuple[float, int, int]:
    """Return the last time between two at which a rise could be levelled off without breaking a bound.

    Returns:
        the time, a few roundings before the last one; the fault that follows and its place.
    """
    jerk = way[3, k]
    place, v1, a1 = state_after(low, v, a, jerk, until, most)
    fault, where, other_room = _nearest(way, k, place, v1, a1, k)
    if other_room <= LEVELLED:
        return low, fault, where
    place, v1, a1 = state_after(high, v, a, jerk, until, most)
    fault, where, room = _nearest(way, k, place, v1, a1, k)
    if room >= 0.0:
        return high, fault, where
    here, room, other_end, other_room, share = high, max(room, -1.0), low, min(other_room, 1.0), 0.5
    for _ in range(ROUNDS):
        t = between(here, other_end, share)
        if not min(here, other_end) < t < max(here, other_end):
            break
        place, v1, a1 = state_after(t, v, a, jerk, until, most)
        found, there, seen = _nearest(way, k, place, v1, a1, k)
        if seen < 0.0:
            fault, where = found, there
        elif seen <= LEVELLED:
            return t, found, there
        if (seen >= 0.0) == (room >= 0.0):
            before, before_room = here, room
        else:
            before, before_room, other_end, other_room = other_end, other_room, here, room
        here, room = t, seen
        share = root_share(here, room, other_end, other_room, before, before_room)
    return min(here, other_end), fault, where


def _levelled_at(
    length: float, v: float, a: float, jerk: float, until: float, most: float, high: float
) -> float:
    """Return the last time no later than another at which a rise can be levelled off within a length.

    Under jerk the place at which it is levelled off is convex in time, so that Newton's steps fall to the
    root from above; behind that it is a square.
    """
    t = min(until, high)
    place, v1, a1 = state_after(t, v, a, jerk, until, most)
    over, slope = levelled_place(place, v1, a1, jerk) - length, v1 + a1 * a1 / jerk
    if over <= 0.0:
        t -= 2.0 * over / (slope + sqrt(slope * slope - 2.0 * most * over))
        return min(t, high) * LITTLE_LESS
    for _ in range(ROUNDS):
        step = 0.5 * over / slope
        t -= step
        if not step > NEWTON * t:
            break
        place, v1, a1 = state_after(t, v, a, jerk, until, most)
        over, slope = levelled_place(place, v1, a1, jerk) - length, v1 + a1 * a1 / jerk
    return max(t, 0.0) * LITTLE_LESS


def _add_rise(
    way: Array, rises: Array, n: int, k: int, rise: _Rise, end: float, last: float, reached: float
) -> int:
    """Write the segments of a rise in path segment k up to a time and place; return the number of all."""
    jerk = way[3, k]
    if end <= rise.until:
        return _add(rises, n, k, 0.0, rise.v, rise.a, jerk, end, last, reached)
    place, v1, _ = state_after(rise.until, rise.v, rise.a, jerk, rise.until, rise.most)
    n = _add(rises, n, k, 0.0, rise.v, rise.a, jerk, rise.until, place, reached)
    _, _, _, top, _, _ = level_off(way, k, place, v1, rise.most, k)
    return _add(rises, n, k, place, v1, rise.most, 0.0, end - rise.until, last, max(top, reached))


def _add_levelling(
    way: Array,
    rises: Array,
    n: int,
    k: int,
    place: float,
    v: float,
    a: float,
    top: float,
    until: int,
) -> tuple[int, float, float]:
    """Level the motion off, not beyond a boundary; return number, speed and acceleration there."""
    while k < until:
        length, jerk = way[0, k], way[3, k]
        end = levelled_place(place, v, a, jerk)
        if end <= length or k + 2 == way.shape[1]:
            n = _add(rises, n, k, place, v, a, -jerk, a / jerk, min(end, length), top)
            return n, v + 0.5 * a * a / jerk, 0.0
        t = crossing_time(length - place, v, a, -jerk)
        n = _add(rises, n, k, place, v, a, -jerk, t, length, top)
        v += t * (a - 0.5 * jerk * t)
        a = max(a - jerk * t, 0.0)
        place = 0.0
        k += 1
    return n, v, a


def _add(
    rises: Array,
    n: int,
    path_segment: int,
    place: float,
    v: float,
    a: float,
    jerk: float,
    duration: float,
    end: float,
    top: float,
) -> int:
    """Write a segment; return the number of all."""
    rises[0, n], rises[1, n], rises[2, n], rises[3, n] = path_segment, place, v, a
    rises[4, n], rises[5, n], rises[6, n], rises[7, n] = jerk, duration, end, top
    return n + 1
