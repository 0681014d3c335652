"""A way of several pieces in little time, in plain loops that numba compiles.

A rise starts without acceleration and takes as much jerk, then as much acceleration, as its piece allows,
while it can still be levelled off (its acceleration taken back to 0 with the full jerk of the pieces that
this leads through) without breaking a bound. Where it could no longer, it is levelled off until the piece
that was in the way is reached. Where a rise is too fast for the following segments, a new one starts at the
bound there. A fall is a rise on the way back. So there is a course of rises from the start, one of falls from
the end, and the motion follows the lower one of both. Where a rise meets a fall, both are levelled off to the
highest speed at which one is still before the other. Passes from both ends follow time-optimal motions along
paths (Bobrow, Dubowsky and Gibson 1985, Time-Optimal Control of Robotic Manipulators Along Specified Paths,
Int. J. Robotics Research 4(3)), segments follow the S-curve (Biagiotti and Melchiorri 2008, Trajectory
Planning for Automatic Machines and Robots, section 3.4).

In a table of a way stand, piece by piece: length, speed, acceleration, jerk, bound of the speed at its start,
horizon; then, where a rise starts at a piece, its first segment, the one behind its last, and the speed to
which its end can be levelled off; then the speed at its start from which all of the rest can be made; at
last, for its horizon, a piece and the speed at the end of that from which the motion can stop in time, if
already found. The last column is the end of the way. In a table of segments stand piece, place, speed,
acceleration, jerk, duration, place at the end, and the speed to which its start can be levelled off.
"""

from math import inf, sqrt
from typing import NamedTuple

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.spatial import Array

LEVELLED = 8e-15
"""Relative; a speed that differs by no more from another one is that: so far several pieces round it."""
LEAST, MOST = 1e-50, 1e50
"""Between them lie the numbers of a piece; values computed from them are then finite."""
ROUNDS = 100
"""More steps than any search here needs, were it by halves alone."""
MET = 1e-13
"""Relative; a rise and a fall that leave no more of their way between them meet."""
NEAREST = 4e-16
"""Relative; places nearer to each other are not distinguished."""
LITTLE_LESS = 1.0 - 2.0 * NEAREST
"""Factor on the last value that a search takes as allowed, so that it usually is allowed despite rounding."""
NEWTON = 2e-8
"""Relative; after a step of Newton no greater than this the remainder is its square, which is rounding."""
SIXTH, THIRD = 1.0 / 6.0, 1.0 / 3.0


class _Rise(NamedTuple):
    """A rise from speed v and acceleration a, with full jerk until a time, then with most acceleration."""

    v: float
    a: float
    until: float
    most: float


@kernel
def plan_segments(
    bounds: Array2, ways: Array3, courses: Array3, rows: Array2, ends: Array1, told: Array1
) -> None:
    """Write the segments of constant jerk that take the motion from rest to rest over p pieces.

    Args:
        bounds: of the pieces in columns: length, speed, acceleration, jerk, ratio, horizon (see `Stage`), of
            shape (p, 6).
        ways: room for the tables of the way there, the way back, and units and lengths, shape (3, 12, p + 1).
        courses: room for the tables of rises, of falls, and for segments on the way back, of shape
            (3, 8, 8·p).
        rows: where the segments go: piece, time at the start [s], place, speed, acceleration, jerk, duration
            [s], place at the end; of shape (8, 16·p).
        ends: where the times [s] go at which the pieces end, shape (p,).
        told: output for the number of segments, or -1 and the index of a path segment whose bounds no motion
            can have, shape (2,).
    """
    p = bounds.shape[0]
    there, back = ways[0], ways[1]
    wrong = _lay_out(bounds, ways)
    if wrong >= 0:
        told[0], told[1] = -1.0, wrong
        return
    _climb(there, courses[0])
    _climb(back, courses[1])
    n = first = int(ways[2, 1, 0])  # 0; a number in the text would be a type of its own for numba
    for i in range(1, p + 1):
        if there[6, i] >= 0.0 and back[6, p - i] >= 0.0:
            n = _join(ways, courses, first, i, rows, n)
            first = i
    told[0], told[1] = _time(bounds, ways[2, 0], rows, n, ends), 0.0


def _lay_out(bounds: Array, ways: Array) -> int:
    """Write the tables of the way there and back; return the index of a piece that is wrong, or -1."""
    p = bounds.shape[0]
    there, back, units, gone = ways[0], ways[1], ways[2, 0], ways[2, 1]
    units[0], gone[0] = 1.0, 0.0
    for i in range(p):
        if i > 0:
            units[i] = units[i - 1] * (bounds[i, 4] if bounds[i, 4] > 0.0 else 1.0)
        for k in range(4):
            there[k, i] = bounds[i, k] / units[i]
        if _is_wrong(bounds, there, i):
            return i
        horizon = bounds[i, 5]
        there[5, i] = horizon if 0.0 <= horizon < p - 1 else inf
        there[9, i], gone[i + 1] = inf, gone[i] + there[0, i]
        there[4, i] = 0.0 if i == 0 or bounds[i, 4] == 0.0 else min(there[1, i - 1], there[1, i])
    there[4, p], there[9, p] = 0.0, inf
    if _look_ahead(there):
        for i in range(p - 1):
            if there[5, i] < inf and there[4, i + 1] > 0.0:
                there[4, i + 1] = min(there[4, i + 1], _stoppable(there, i + 1, 0.0, i))
        _look_ahead(there)
    for i in range(p):
        for k in range(4):
            back[k, i] = there[k, p - 1 - i]
        back[4, i], back[5, i] = there[4, p - i], inf
    back[4, p] = 0.0
    return -1


def _time(bounds: Array, units: Array, rows: Array, n: int, ends: Array) -> int:
    """Write the times of n segments, and all in the units of their pieces; return how many last."""
    time, count = 0.0, 0
    for k in range(n):
        i = int(rows[0, k])
        begun = count > 0 and rows[0, count - 1] == i
        if rows[6, k] > 0.0 and (time + rows[6, k] > time or not begun):
            if count > 0 and not begun:
                ends[i - 1] = time
            rows[0, count], rows[1, count], rows[6, count] = i, time, rows[6, k]
            for row in range(2, 5):
                rows[row, count] = rows[row, k] * units[i]
            change = rows[5, k]
            rows[5, count] = bounds[i, 3] if change > 0.0 else -bounds[i, 3] if change < 0.0 else 0.0
            time += rows[6, k]
            count += 1
    ends[bounds.shape[0] - 1] = time
    for k in range(count):
        goes_on = k + 1 < count and rows[0, k + 1] == rows[0, k]
        rows[7, k] = rows[2, k + 1] if goes_on else bounds[int(rows[0, k]), 0]
    return count


def _is_wrong(bounds: Array, way: Array, i: int) -> bool:
    """Return whether a number of a piece is none that a motion can have."""
    for k in range(4):
        if not (LEAST <= bounds[i, k] <= MOST and LEAST <= way[k, i] <= MOST):
            return True
    if not (bounds[i, 4] == 0.0 or LEAST <= bounds[i, 4] <= MOST):
        return True
    return not (bounds[i, 5] == -1.0 or bounds[i, 5] >= i)


def _look_ahead(way: Array) -> bool:
    """Write from which speeds, without acceleration, it can stop at the end; say whether a horizon counts.

    Existing ones were found before bounds were lowered: only lower ones are found again. Initially they are
    infinite.
    """
    p, limited = way.shape[1] - 1, False
    for i in range(p):
        limited = limited or way[5, i] < inf
        way[10, i] = -1.0
    if not limited:
        return False
    lower = way[9, p] > 0.0
    way[9, p] = 0.0
    for k in range(p - 1, -1, -1):
        before = way[9, k]
        if lower:
            way[9, k] = _within(way[9, k + 1], way[0, k], way[2, k], way[3, k], way[4, k])
        else:
            way[9, k] = min(before, way[4, k])
        lower = way[9, k] < before
    return True


def _stoppable(way: Array, piece: int, place: float, ahead: int) -> float:
    """Return a speed, without acceleration, from which the motion can stop before the horizon of a piece.

    Segments behind the horizon do not matter if both are equally fast. The backward pass from there is kept.
    """
    known, speed = int(way[5, ahead]), 0.0
    if piece > known:
        return speed
    if way[10, ahead] >= piece:
        known, speed = int(way[10, ahead]), way[11, ahead]
    for k in range(known, piece, -1):
        speed = _within(speed, way[0, k], way[2, k], way[3, k], way[4, k])
        if speed == way[9, k]:
            speed = way[9, piece + 1]
            break
    way[10, ahead], way[11, ahead] = piece, speed
    return _within(speed, way[0, piece] - place, way[2, piece], way[3, piece], way[1, piece])


def _within(speed: float, length: float, acceleration: float, jerk: float, most: float) -> float:
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
    """Return the highest speed to which it can rise over a way, without acceleration at both ends.

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


def _crossing(way: float, v: float, a: float, j: float) -> float:
    """Return the time over a way with speed v and acceleration a at its start, before a jerk j < 0 ends a.

    The way is convex in time then, so that Newton's steps fall to the root from above.
    """
    if way <= 0.0:
        return 0.0
    t: float = inf
    if v > 0.0:
        t = way / v
    if j > 0.0:
        if a * t * t > 2.0 * way:
            t = sqrt(2.0 * way / a)
        if j * t * t * t > 6.0 * way:
            t = (6.0 * way / j) ** (1.0 / 3.0)
    else:
        t = min(t, -a / j)
    for _ in range(ROUNDS):
        step = (t * (v + t * (0.5 * a + t * (j * SIXTH))) - way) / (v + t * (a + 0.5 * t * j))
        t -= step
        if not step > NEWTON * t:
            break
    return t


def _level(
    way: Array, piece: int, place: float, v: float, a: float, since: int
) -> tuple[int, int, float, float, int, float]:
    """Level the motion off from a place; `since` is the first piece whose horizon counts.

    Returns:
        0 where that keeps all bounds, 1 where it leads too fast over a boundary, 2 where its end is too fast
        for its piece; piece, place and speed at the end; the first boundary or piece where it is too fast;
        how much faster the end is with a little more acceleration at the start, as a share of that.
    """
    p = way.shape[1] - 1
    fault, k, where = 0, piece, 0
    bent, gained, shifted = 1.0, 0.0, 0.0  # acceleration, speed and place at the same time, as shares
    while True:
        length, jerk = way[0, k], way[3, k]
        t = a / jerk
        end, top = place + t * (v + a * t * THIRD), v + 0.5 * a * t
        if end <= length or k + 1 == p:
            break
        t = _crossing(length - place, v, a, -jerk)
        shifted += t * (gained + 0.5 * t * bent)
        gained += t * bent
        v += t * (a - 0.5 * jerk * t)
        a = max(a - jerk * t, 0.0)
        place = 0.0
        k += 1
        bent += (jerk - way[3, k]) * shifted / v
        if fault == 0 and (v > way[4, k] or a > way[2, k]):
            fault, where = 1, k
    gained += t * bent
    if fault == 0:
        if end > length:
            fault, where = 1, p
        elif top > way[1, k]:
            fault, where = 2, k
        else:
            for i in range(since, k):
                if way[5, i] < inf and top > _stoppable(way, k, end, i):
                    return 1, k, end, top, i + 1, gained
    return fault, k, end, top, where, gained


def _after(
    t: float, v: float, a: float, jerk: float, until: float, most: float
) -> tuple[float, float, float]:
    """Return place, speed and acceleration at a time of a rise from place 0.

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
    place, v = until * (v + until * (0.5 * a + until * (jerk * SIXTH))), v + until * (a + 0.5 * jerk * until)
    rest = t - until
    return place + rest * (v + 0.5 * most * rest), v + most * rest, most


def _levelled(place: float, v: float, a: float, jerk: float) -> float:
    """Return the place at which a motion is levelled off, were its piece endless."""
    t = a / jerk
    return place + t * (v + a * t * THIRD)


def _climb(way: Array, course: Array) -> None:
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
        place, v1, _ = _after(until, v, a, jerk, until, most)
        if place >= length:
            until = end = _crossing(length, v, a, jerk)
        else:
            rest = length - place
            end = until + 2.0 * rest / (v1 + sqrt(v1 * v1 + 2.0 * most * rest))
        _, v1, a1 = _after(end, v, a, jerk, until, most)
        if k + 1 < p and v1 <= way[4, k + 1] and a1 <= way[2, k + 1]:
            fault, _, _, top, _, _ = _level(way, k + 1, 0.0, v1, a1, k)
            if fault == 0:
                n = _add_rise(way, course, n, k, _Rise(v, a, until, most), end, length, reached)
                k, v, a, reached = k + 1, v1, a1, top
                continue
        last, top, fault, where = _latest(way, k, v, a, until, most, end)
        place, v1, a1 = _after(last, v, a, jerk, until, most)
        n = _add_rise(way, course, n, k, _Rise(v, a, until, most), last, min(place, length), reached)
        if fault == 0:
            n, v, a = _add_levelling(way, course, n, k, min(place, length), v1, a1, top, where)
            v, a, k, reached = min(v, way[4, where]), min(a, way[2, where]), where, top
        else:
            way[7, start], way[8, start] = n, top
            start, k = where, where
            way[6, k], v, a = n, way[4, k], 0.0
            reached = v


def _latest(
    way: Array, k: int, v: float, a: float, until: float, most: float, end: float
) -> tuple[float, float, int, int]:
    """Return until when a rise goes on in a piece that it cannot cross.

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
        place, v1, a1 = _after(t, v, a, jerk, until, most)
        if _levelled(place, v1, a1, jerk) <= length:
            return t, speed, 1, k + 1
    if _levelled(0.0, v, a, jerk) <= length:
        low = _levelled_at(length, v, a, jerk, until, most, high)
        place, v1, a1 = _after(low, v, a, jerk, until, most)
        top = v1 + 0.5 * a1 * a1 / jerk
        if top >= way[4, k + 1]:
            return low, top, 1, k + 1
    low, fault, where = _last_kept(way, k, v, a, until, most, low, high)
    place, v1, a1 = _after(low, v, a, jerk, until, most)
    found, piece, _, top, there, _ = _level(way, k, min(place, length), v1, a1, k)
    if found != 0:
        fault, where, piece = found, there, there
    where = max(where, k + 2 - fault)  # a rise continues in a later path segment, despite rounding
    if fault == 2:
        if piece >= where:
            return low, way[1, where], 1, where + 1
        return low, top, 1, where
    if piece < where or where == way.shape[1] - 1:
        return low, top, 1, where
    return low, top, 0, where


def _nearest(way: Array, piece: int, place: float, v: float, a: float, since: int) -> tuple[int, int, float]:
    """Return which bound is the first that is broken or else the nearest where a motion is levelled off.

    A boundary bounds nothing as long as the motion is levelled off before it, and little just behind it.

    Returns:
        the fault and its place that `_level` finds, or would find; how much room there is to the bound, as a
        share of it, below 0 where it is broken.
    """
    p = way.shape[1] - 1
    k, where, room = piece, piece + 1, inf
    while True:
        length, jerk = way[0, k], way[3, k]
        t = a / jerk
        end, top = place + t * (v + a * t * THIRD), v + 0.5 * a * t
        left = (length - end) / length
        if end <= length or k + 1 == p:
            break
        t = _crossing(length - place, v, a, -jerk)
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
            most = _stoppable(way, k, end, i)
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
    place, v1, a1 = _after(low, v, a, jerk, until, most)
    fault, where, other_room = _nearest(way, k, place, v1, a1, k)
    if other_room <= LEVELLED:
        return low, fault, where
    place, v1, a1 = _after(high, v, a, jerk, until, most)
    fault, where, room = _nearest(way, k, place, v1, a1, k)
    if room >= 0.0:
        return high, fault, where
    here, room, other_end, other_room, share = high, max(room, -1.0), low, min(other_room, 1.0), 0.5
    for _ in range(ROUNDS):
        t = _inside(here, other_end, share)
        if not min(here, other_end) < t < max(here, other_end):
            break
        place, v1, a1 = _after(t, v, a, jerk, until, most)
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
        share = _share(here, room, other_end, other_room, before, before_room)
    return min(here, other_end), fault, where


def _levelled_at(
    length: float, v: float, a: float, jerk: float, until: float, most: float, high: float
) -> float:
    """Return the last time no later than another at which a rise can be levelled off within a length.

    Under jerk the place at which it is levelled off is convex in time, so that Newton's steps fall to the
    root from above; behind that it is a square.
    """
    t = min(until, high)
    place, v1, a1 = _after(t, v, a, jerk, until, most)
    over, slope = _levelled(place, v1, a1, jerk) - length, v1 + a1 * a1 / jerk
    if over <= 0.0:
        t -= 2.0 * over / (slope + sqrt(slope * slope - 2.0 * most * over))
        return min(t, high) * LITTLE_LESS
    for _ in range(ROUNDS):
        step = 0.5 * over / slope
        t -= step
        if not step > NEWTON * t:
            break
        place, v1, a1 = _after(t, v, a, jerk, until, most)
        over, slope = _levelled(place, v1, a1, jerk) - length, v1 + a1 * a1 / jerk
    return max(t, 0.0) * LITTLE_LESS


def _add_rise(
    way: Array, course: Array, n: int, k: int, rise: _Rise, end: float, last: float, reached: float
) -> int:
    """Write the segments of a rise in piece k up to a time and place; return the number of all."""
    jerk = way[3, k]
    if end <= rise.until:
        return _add(course, n, k, 0.0, rise.v, rise.a, jerk, end, last, reached)
    place, v1, _ = _after(rise.until, rise.v, rise.a, jerk, rise.until, rise.most)
    n = _add(course, n, k, 0.0, rise.v, rise.a, jerk, rise.until, place, reached)
    _, _, _, top, _, _ = _level(way, k, place, v1, rise.most, k)
    return _add(course, n, k, place, v1, rise.most, 0.0, end - rise.until, last, max(top, reached))


def _add_levelling(
    way: Array,
    course: Array,
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
        end = _levelled(place, v, a, jerk)
        if end <= length or k + 2 == way.shape[1]:
            n = _add(course, n, k, place, v, a, -jerk, a / jerk, min(end, length), top)
            return n, v + 0.5 * a * a / jerk, 0.0
        t = _crossing(length - place, v, a, -jerk)
        n = _add(course, n, k, place, v, a, -jerk, t, length, top)
        v += t * (a - 0.5 * jerk * t)
        a = max(a - jerk * t, 0.0)
        place = 0.0
        k += 1
    return n, v, a


def _add(
    course: Array,
    n: int,
    piece: int,
    place: float,
    v: float,
    a: float,
    jerk: float,
    duration: float,
    end: float,
    top: float,
) -> int:
    """Write a segment; return the number of all."""
    course[0, n], course[1, n], course[2, n], course[3, n] = piece, place, v, a
    course[4, n], course[5, n], course[6, n], course[7, n] = jerk, duration, end, top
    return n + 1


def _summit(way: Array, course: Array, start: int, top: float) -> tuple[int, float, int, float]:
    """Return where the rise from a boundary is levelled off to a speed, and where that ends.

    Returns:
        segment and time in it; piece and place.
    """
    first, last = int(way[6, start]), int(way[7, start])
    row, high = first - 1, last - 1
    while high - row > 1:
        middle = (row + high) // 2
        if course[7, middle + 1] >= top:
            high = middle
        else:
            row = middle
    row = high
    k, v, a, h = int(course[0, row]), course[2, row], course[3, row], course[5, row]
    most = course[7, row + 1] if row + 1 < last else way[8, start]
    before, after, under, over = 0.0, h, course[7, row] - top, most - top
    jerk, change, t = way[3, k], course[4, row], 0.0
    if over <= 0.0:
        t = h
    elif under >= 0.0:
        t = 0.0
    elif change > 0.0:
        t = (sqrt(max(0.5 * a * a + jerk * (top - v), 0.0)) - a) / jerk
    elif a > 0.0:
        t = (top - v - 0.5 * a * a / jerk) / a
    t = min(max(t, 0.0), h)
    piece, place = k, 0.0
    for step in range(ROUNDS):
        x = course[1, row] + t * (v + t * (0.5 * a + t * (change * SIXTH)))
        a1 = max(a + change * t, 0.0)
        v1 = v + t * (a + 0.5 * change * t)
        _, piece, place, found, _, slope = _level(way, k, min(x, way[0, k]), v1, a1, k)
        if (step == 0 and piece == k) or not under < 0.0 < over or abs(found - top) <= LEVELLED * top:
            break
        if found <= top:
            before = t
        else:
            after = t
        t -= (found - top) / (slope * (change + jerk))
        if step % 8 == 7 or not before < t < after:
            t = 0.5 * (before + after)
            if not before < t < after:
                t = before
                under = 0.0
    return row, t, piece, min(place, way[0, piece])


def _join(ways: Array, courses: Array, first: int, last: int, rows: Array, n: int) -> int:
    """Write a rise from one boundary and a fall to another; return the number of all segments.

    The highest speed at which a rise is levelled off before a fall is searched by `_share`.
    """
    there, back, gone, p = ways[0], ways[1], ways[2, 1], ways.shape[2] - 1
    low = max(there[4, first], there[4, last])
    top = max(min(there[8, first], back[8, p - last]), low)
    here, seen, ended = 0.0, 0.0, False
    other_end, other_room, before, before_room = low, 0.0, low, 0.0
    row, t, k, x = int(there[6, first]), 0.0, first, 0.0
    other, u, i, y = int(back[6, p - last]), 0.0, last, 0.0
    for step in range(ROUNDS):
        row, t, k, x = _summit(there, courses[0], first, top)
        other, u, i, y = _summit(back, courses[1], p - last, top)
        i = p - 1 - i
        y = there[0, i] - y
        room = y - x
        if k < i:
            room = (there[0, k] - x) + (gone[i] - gone[k + 1]) + y
        elif i < k:
            room = (y - there[0, i]) - (gone[k] - gone[i + 1]) - x
        if ended or (step == 0 and room >= 0.0) or 0.0 <= room <= MET * (gone[last] - gone[first]):
            break
        if step == 1:
            room = max(room, 0.0)
        if step > 0 and (room >= 0.0) == (seen >= 0.0):
            before, before_room = here, seen
        elif step > 0:
            before, before_room = other_end, other_room
            other_end, other_room = here, seen
        here, seen = top, room
        if step == 0:
            top = low
            continue
        share = 0.5 if step == 1 else _share(here, seen, other_end, other_room, before, before_room)
        top = _inside(here, other_end, share)
        if not min(here, other_end) < top < max(here, other_end) or step == ROUNDS - 2:
            top, ended = here if seen >= 0.0 else other_end, True
    n, k, x = _copy(there, courses[0], first, row, t, rows, n)
    m, i, y = _copy(back, courses[1], p - last, other, u, courses[2], int(gone[0]))
    i = p - 1 - i
    y = there[0, i] - y
    while k <= i:
        until = y if k == i else there[0, k]
        if until > x:
            _add_row(rows, n, k, x, top, 0.0, 0.0, (until - x) / top)
            n += 1
        k, x = k + 1, 0.0
    for row in range(m - 1, -1, -1):
        i, h = p - 1 - int(courses[2, 0, row]), courses[2, 6, row]
        v, a, j = courses[2, 3, row], courses[2, 4, row], courses[2, 5, row]
        x = there[0, i] - courses[2, 7, row]
        _add_row(rows, n, i, x, v + h * (a + 0.5 * h * j), -(a + h * j), j, h)
        n += 1
    return n


def _inside(x1: float, x2: float, share: float) -> float:
    """Return the value at a share of an interval, or a little lower, but never one of its ends."""
    low, high = min(x1, x2), max(x1, x2)
    return min(max((x1 + share * (x2 - x1)) * LITTLE_LESS, low + NEAREST * high), high - NEAREST * high)


def _share(x1: float, f1: float, x2: float, f2: float, x3: float, f3: float) -> float:
    """Return where a root lies between two places, as a share of the way from the first to the second.

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


def _copy(
    way: Array, course: Array, start: int, row: int, t: float, rows: Array, n: int
) -> tuple[int, int, float]:
    """Write the rise from a boundary until a time of a segment, and levelled off behind it.

    Returns:
        the number of all segments, and piece and place at the end.
    """
    v, a, change = 0.0, 0.0, 0.0
    for i in range(int(way[6, start]), row + 1):
        h = course[5, i] if i < row else t
        v, a, change = course[2, i], course[3, i], course[4, i]
        _add_row(rows, n, int(course[0, i]), course[1, i], v, a, change, h)
        rows[7, n] = course[6, i]
        n += 1
    k = int(course[0, row])
    x = course[6, row]
    if t < course[5, row]:
        x = min(course[1, row] + t * (v + t * (0.5 * a + t * (change * SIXTH))), way[0, k])
    rows[7, n - 1] = x
    v, a = v + t * (a + 0.5 * change * t), max(a + change * t, 0.0)
    end, levelled = x, False
    while not levelled:
        length, jerk = way[0, k], way[3, k]
        t = a / jerk
        end = x + t * (v + a * t * THIRD)
        levelled = end <= length or k + 2 == way.shape[1]
        if not levelled:
            t = _crossing(length - x, v, a, -jerk)
        _add_row(rows, n, k, x, v, a, -jerk, t)
        rows[7, n] = min(end, length) if levelled else length
        n += 1
        v, a = v + t * (a - 0.5 * jerk * t), max(a - jerk * t, 0.0)
        if not levelled:
            k, x = k + 1, 0.0
    return n, k, min(end, way[0, k])


def _add_row(
    rows: Array,
    n: int,
    piece: int,
    place: float,
    v: float,
    a: float,
    jerk: float,
    duration: float,
) -> None:
    """Write a segment except its time and the path parameter at its end."""
    rows[0, n], rows[2, n], rows[3, n] = piece, place, v
    rows[4, n], rows[5, n], rows[6, n] = a, jerk, duration
