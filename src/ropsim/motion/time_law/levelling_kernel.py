"""Levelling a rise off: its acceleration taken back to 0 with full jerk; see `time_law_kernel`."""

from math import inf, sqrt
from typing import NamedTuple

from ropsim.spatial import Array

LEVELLED = 8e-15
"""Relative; a speed that differs by no more from another one is that: so far several path segments round
it."""
ROUNDS = 100
"""More steps than any search here needs, were it by halves alone."""
NEAREST = 4e-16
"""Relative; path parameters nearer to each other are not distinguished."""
LITTLE_LESS = 1.0 - 2.0 * NEAREST
"""Factor on the last value that a search takes as allowed, so that it usually is allowed despite rounding."""
NEWTON = 2e-8
"""Relative; after a step of Newton no greater than this the remainder is its square, which is rounding."""
SIXTH, THIRD = 1.0 / 6.0, 1.0 / 3.0


TO_REST = 9
"""Row of a table at which the fall begins from a path segment to the end of the path; see `write_fall`."""
KEPT = 15
"""Row of the path segment up to which the fall from a horizon is known; -1 for none. It stands behind it."""
BORDER = 22
"""Row of the bound of the speed at the start of a path segment, were there no horizons."""
ROWS = 23
"""Rows of a table."""


class Fall(NamedTuple):
    """A fall to rest, backwards: over the last of its path segments it begins and ends without acceleration.

    Attributes:
        speed: at its start.
        base: speed where those path segments end.
        length: of them.
        acceleration: least of their bounds.
        jerk: least of their bounds.
        most: least bound of the speed at the borders between them.
    """

    speed: float
    base: float
    length: float
    acceleration: float
    jerk: float
    most: float


def from_border(speed: float) -> Fall:
    """Return a fall from a speed without acceleration where a path segment ends."""
    return Fall(speed, speed, 0.0, inf, inf, inf)


def longer_fall(fall: Fall, length: float, acceleration: float, jerk: float, most: float) -> Fall:
    """Return a fall that begins a path segment earlier.

    It begins with the higher speed of two: from where it has no acceleration at the border, or from where it
    has none before, with the least bounds of all path segments from there on.

    Args:
        fall: behind the path segment.
        length: of the path segment.
        acceleration: bound on it.
        jerk: bound on it.
        most: bound of the speed at its start.
    """
    alone = reached_within(fall.speed, length, acceleration, jerk, most)
    if alone < most and fall.length > 0.0:
        longer, a, j = fall.length + length, min(fall.acceleration, acceleration), min(fall.jerk, jerk)
        least = min(most, fall.most)
        together = reached_within(fall.base, longer, a, j, least)
        if alone <= together < most:
            return Fall(together, fall.base, longer, a, j, least)
        alone = max(alone, together)
    if alone >= most:
        return Fall(most, most, 0.0, inf, inf, inf)
    return Fall(alone, fall.speed, length, acceleration, jerk, most)


def stoppable_speed(table: Array, path_segment: int, s: float, ahead: int) -> float:
    """Return a speed, without acceleration, from which the motion can stop before a horizon.

    Segments behind the horizon do not matter if both are equally fast. The backward pass from there is kept.
    """
    known = int(table[5, ahead])
    if path_segment > known:
        return 0.0
    fall = from_border(0.0)
    if table[KEPT, ahead] >= path_segment:
        known = int(table[KEPT, ahead])
        fall = _fall_of(table[KEPT + 1 :, ahead])
    for k in range(known, path_segment, -1):
        fall = longer_fall(fall, table[0, k], table[2, k], table[3, k], table[BORDER, k])
        if fall.length == 0.0 and fall.speed == table[TO_REST, k]:
            fall = _fall_of(table[TO_REST:, path_segment + 1])
            break
    table[KEPT, ahead] = path_segment
    write_fall(fall, table[KEPT + 1 :, ahead])
    length, most = table[0, path_segment] - s, table[1, path_segment]
    return longer_fall(fall, length, table[2, path_segment], table[3, path_segment], most).speed


def write_fall(fall: Fall, column: Array) -> None:
    """Write the numbers of a fall into the first rows of a column."""
    column[0], column[1], column[2] = fall.speed, fall.base, fall.length
    column[3], column[4], column[5] = fall.acceleration, fall.jerk, fall.most


def _fall_of(column: Array) -> Fall:
    return Fall(column[0], column[1], column[2], column[3], column[4], column[5])


def reached_within(speed: float, length: float, acceleration: float, jerk: float, most: float) -> float:
    """Return the result of `_reached`, limited by a bound; usually the bound, by a quick check."""
    change, both, square = most - speed, most + speed, acceleration * acceleration
    if change <= 0.0:
        return most
    if length > 0.0:
        if change * jerk < square:
            if both * both * change <= length * length * jerk:
                return most
        elif both * (change * jerk + square) <= 2.0 * length * acceleration * jerk:
            return most
    return min(_reached(speed, length, acceleration, jerk), most)


def _reached(speed: float, length: float, acceleration: float, jerk: float) -> float:
    """Return the highest speed to which it can rise over a distance, without acceleration at both ends.

    Below the bound of acceleration it rises by w² with w³ + 2·speed·w = length·√jerk: Newton's steps fall to
    the root of a convex function, from the value that either term alone would allow.
    """
    if length <= 0.0:
        return speed
    lag = acceleration * acceleration / jerk
    wide = 2.0 * speed + lag
    if length * jerk >= wide * acceleration:
        half = acceleration * length - speed * lag
        return speed + 4.0 * half / (wide + sqrt(wide * wide + 8.0 * half))
    q: float = length * sqrt(jerk)
    w: float = inf
    if speed > 0.0:
        w = 0.5 * q / speed
    if w * w * w > q:
        w = q ** (1.0 / 3.0)
    for _ in range(ROUNDS):
        step = (w * (w * w + 2.0 * speed) - q) / (3.0 * w * w + 2.0 * speed)
        w -= step
        if not step > NEWTON * w:
            break
    return speed + w * w


def crossing_time(distance: float, v: float, a: float, j: float) -> float:
    """Return the time over a distance from speed v and acceleration a, before a jerk j < 0 ends a.

    The distance is convex in time then, so that Newton's steps fall to the root from above.
    """
    if distance <= 0.0:
        return 0.0
    t: float = inf
    if v > 0.0:
        t = distance / v
    if j > 0.0:
        if a * t * t > 2.0 * distance:
            t = sqrt(2.0 * distance / a)
        if j * t * t * t > 6.0 * distance:
            t = (6.0 * distance / j) ** (1.0 / 3.0)
    else:
        t = min(t, -a / j)
    for _ in range(ROUNDS):
        step = (t * (v + t * (0.5 * a + t * (j * SIXTH))) - distance) / (v + t * (a + 0.5 * t * j))
        t -= step
        if not step > NEWTON * t:
            break
    return t


def level_off(
    table: Array, path_segment: int, s: float, v: float, a: float, since: int
) -> tuple[int, int, float, float, int, float]:
    """Level the motion off from a path parameter; `since` is the first path segment whose horizon counts.

    Returns:
        0 where that keeps all bounds, 1 where it leads too fast over a boundary, 2 where its end is too fast
        for its path segment; path segment, path parameter and speed at the end; the first boundary or path
        segment where it is too fast; how much faster the end is with a little more acceleration at the start,
        as a share of that.
    """
    p = table.shape[1] - 1
    fault, k, where = 0, path_segment, 0
    bent, gained, shifted = 1.0, 0.0, 0.0  # acceleration, speed and s at the same time, as shares
    while True:
        length, jerk = table[0, k], table[3, k]
        t = a / jerk
        end, top = s + t * (v + a * t * THIRD), v + 0.5 * a * t
        if end <= length or k + 1 == p:
            break
        t = crossing_time(length - s, v, a, -jerk)
        shifted += t * (gained + 0.5 * t * bent)
        gained += t * bent
        v += t * (a - 0.5 * jerk * t)
        a = max(a - jerk * t, 0.0)
        s = 0.0
        k += 1
        bent += (jerk - table[3, k]) * shifted / v
        if fault == 0 and (v > table[4, k] or a > table[2, k]):
            fault, where = 1, k
    gained += t * bent
    if fault == 0:
        if end > length:
            fault, where = 1, p
        elif top > table[1, k]:
            fault, where = 2, k
        else:
            for i in range(since, k):
                if table[5, i] < inf and top > stoppable_speed(table, k, end, i):
                    return 1, k, end, top, i + 1, gained
    return fault, k, end, top, where, gained


def state_after(
    t: float, v: float, a: float, jerk: float, until: float, most: float
) -> tuple[float, float, float]:
    """Return path parameter, speed and acceleration at a time of a rise from path parameter 0.

    Args:
        t: since the start [s].
        v: at the start.
        a: at the start.
        jerk: for the time `until` [s].
        until: see there.
        most: acceleration after it.
    """
    if t <= until:
        return t * (v + t * (0.5 * a + t * (jerk * SIXTH))), v + t * (a + 0.5 * jerk * t), a + jerk * t
    s, v = until * (v + until * (0.5 * a + until * (jerk * SIXTH))), v + until * (a + 0.5 * jerk * until)
    rest = t - until
    return s + rest * (v + 0.5 * most * rest), v + most * rest, most


def levelled_parameter(s: float, v: float, a: float, jerk: float) -> float:
    """Return the path parameter at which a motion is levelled off, were its path segment endless."""
    t = a / jerk
    return s + t * (v + a * t * THIRD)


def between(x1: float, x2: float, share: float) -> float:
    """Return the value at a share of an interval, or a little lower, but never one of its ends."""
    low, high = min(x1, x2), max(x1, x2)
    return min(max((x1 + share * (x2 - x1)) * LITTLE_LESS, low + NEAREST * high), high - NEAREST * high)


def root_share(x1: float, f1: float, x2: float, f2: float, x3: float, f3: float) -> float:
    """Return where a root lies between two values, as a share of the difference.

    By inverse quadratic interpolation where that is known to serve, else in the middle (Chandrupatla 1997, A
    new hybrid quadratic/bisection algorithm for finding the zero of a nonlinear function without using
    derivatives, Advances in Engineering Software 28(3)).

    Args:
        x1: evaluated last.
        f1: value there.
        x2: on the other side of the root.
        f2: value there.
        x3: evaluated before.
        f3: value there.
    """
    if f2 == f3 or x2 == x3:
        return 0.5
    share, level = (x1 - x2) / (x3 - x2), (f1 - f2) / (f3 - f2)
    if not (level * level < share and (1.0 - level) * (1.0 - level) < 1.0 - share):
        return 0.5
    bend = (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2)
    return f1 / (f2 - f1) * f3 / (f2 - f3) + bend
