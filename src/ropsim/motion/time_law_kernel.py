"""A way of several pieces in the shortest time, in plain loops that numba compiles.

Speed changes from v0 to v1 with jerk ±j and acceleration up to a, which is zero before and after: with
d = |v1 - v0| in the time T = d/a + a/j where d·j >= a², else T = 2·√(d/j), over the way (v0 + v1)/2·T
(Biagiotti and Melchiorri 2008, Trajectory Planning for Automatic Machines and Robots, section 3.4). So the
greatest d over a given way is a root of a quadratic or of w³ + 2·v0·w = way·√j with d = w². A pass over
the pieces from the end keeps every speed so low that the motion can come to rest, a second one from the
start takes the highest speeds that can be reached, as for paths (Bobrow, Dubowsky and Gibson 1985,
Time-Optimal Control of Robotic Manipulators Along Specified Paths, Int. J. Robotics Research 4(3)).

Bounds of a piece stand in columns: length, speed, acceleration, jerk, ratio, horizon; see `Stage`.
"""

from math import sqrt

from ropsim.codegen import kernel
from ropsim.spatial import Array

HALF_BIT = 1.2e-16
"""Relative; taken off, a number becomes the next smaller one."""
ROUNDING = 1e-15
"""Relative; a way that remains below this share of a piece is none."""
LEAST, MOST = 1e-50, 1e50
"""Between them lie the numbers of a piece; what is computed from them is then finite."""
ROUNDS = 60
"""More steps of Newton's method than any convex function of one variable here needs."""


@kernel("void(f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[::1])")
def plan_segments(bounds: Array, room: Array, rows: Array, ends: Array, told: Array) -> None:
    """Write the segments of constant jerk that take the motion from rest to rest over p pieces.

    Args:
        bounds: of the pieces, shape (p, 6).
        room: room to work in, shape (2, p + 1).
        rows: where the segments go: piece, time at the start [s], place, speed, acceleration, jerk, duration
            [s], place at the end; of shape (8, 7·p).
        ends: where the times [s] go at which the pieces end, shape (p,).
        told: where the number of segments goes, or -1 and the index of a piece whose bounds no motion can
            have, shape (2,).
    """
    p = bounds.shape[0]
    least, speeds = room[0], room[1]  # at the end of the piece before, in its unit: bound, and what is driven
    for i in range(p):
        if _is_wrong(bounds, i):
            told[0], told[1] = -1.0, i
            return
        least[i] = _bound(bounds, i)
    least[p] = 0.0
    _look_ahead(bounds, least, speeds)
    for i in range(p - 1, 0, -1):
        length, acceleration, jerk = bounds[i, 0], bounds[i, 2], bounds[i, 3]
        fastest = _reached(least[i + 1], length, acceleration, jerk)
        least[i] = _before(fastest, bounds[i, 4], least[i])
    n, time = 0, 0.0
    speeds[0] = 0.0
    for i in range(p):
        v0 = 0.0 if i == 0 else bounds[i, 4] * speeds[i]
        v1 = _reached(v0, bounds[i, 0], bounds[i, 2], bounds[i, 3])
        speeds[i + 1] = min(v1, least[i + 1])
        n, time = _add_piece(bounds, i, v0, speeds[i + 1], rows, n, time)
        ends[i] = time
    for k in range(n):
        piece = rows[0, k]
        goes_on = k + 1 < n and rows[0, k + 1] == piece
        rows[7, k] = rows[2, k + 1] if goes_on else bounds[int(piece), 0]
    told[0], told[1] = n, 0.0


@kernel("void(f8[::1], f8[:,::1], f8[:,::1], f8[::1])")
def plan_together(way: Array, limits: Array, shapes: Array, told: Array) -> None:
    """Write the profiles that take n joints from rest to rest in one time, the least time of the slowest.

    The others are stretched to it: with times longer by a factor f, the jerk is smaller by f³.

    Args:
        way: of the joints with its sign, shape (n,).
        limits: speed, acceleration and jerk of the joints, shape (3, n).
        shapes: where the profiles go: signed jerk at the start, for how long it lasts [s], and how long the
            acceleration lasts that follows [s]; of shape (3, n).
        told: where the time goes [s], or -1 and the index of a joint with a number that no motion can have;
            shape (2,).
    """
    slowest = 0.0
    for i in range(way.shape[0]):
        length, speed, acceleration, jerk = abs(way[i]), limits[0, i], limits[1, i], limits[2, i]
        allowed = LEAST <= speed <= MOST and LEAST <= acceleration <= MOST and LEAST <= jerk <= MOST
        if not (allowed and length <= MOST):
            told[0], told[1] = -1.0, i
            return
        peak = _rise(0.0, 0.0, length, speed, acceleration, jerk) if length >= LEAST else 0.0
        if peak > 0.0:
            rise = _time(peak, acceleration, jerk)
            shapes[1, i] = min(0.5 * rise, acceleration / jerk)
            shapes[2, i] = max(rise - 2.0 * shapes[1, i], 0.0)
            shapes[0, i] = length / peak + rise
            slowest = max(slowest, shapes[0, i])
        else:
            shapes[0, i] = shapes[1, i] = shapes[2, i] = 0.0
    for i in range(way.shape[0]):
        if shapes[0, i] > 0.0:
            factor = slowest / shapes[0, i]
            shapes[1, i] *= factor
            shapes[2, i] *= factor
            rise = 2.0 * shapes[1, i] + shapes[2, i]
            shapes[0, i] = way[i] / (shapes[1, i] * (shapes[1, i] + shapes[2, i]) * (slowest - rise))
    told[0], told[1] = slowest, 0.0


def _is_wrong(bounds: Array, i: int) -> bool:
    """Return whether a number of a piece is none that a motion can have."""
    for k in range(4):
        if not LEAST <= bounds[i, k] <= MOST:
            return True
    if not (bounds[i, 4] == 0.0 or LEAST <= bounds[i, 4] <= MOST):
        return True
    return not (bounds[i, 5] == -1.0 or bounds[i, 5] >= i)


def _bound(bounds: Array, i: int) -> float:
    """Return the bound of the speed at the start of piece i, in the unit of the piece before."""
    ratio = bounds[i, 4]
    if i == 0 or ratio == 0.0:
        return 0.0
    return _before(bounds[i, 1], ratio, bounds[i - 1, 1])


def _before(speed: float, ratio: float, bound: float) -> float:
    """Return the greatest speed up to `bound` before a piece that is then not faster than `speed`."""
    if ratio == 0.0:
        return 0.0
    if ratio * bound <= speed:
        return bound
    found = speed / ratio
    for _ in range(4):
        if ratio * found <= speed:
            break
        found -= found * HALF_BIT
    return found


def _look_ahead(bounds: Array, least: Array, speeds: Array) -> None:
    """Lower the bounds so that the motion can end with the last piece that is known at the time.

    Pieces in a row with one horizon share a pass from there; `speeds` is room to work in.
    """
    p = bounds.shape[0]
    for i in range(p):
        speeds[i] = _bound(bounds, i)
    high = p - 1
    while high >= 0:
        horizon = bounds[high, 5]
        low = high
        while low > 0 and bounds[low - 1, 5] == horizon:
            low -= 1
        if 0.0 <= horizon < p - 1:
            speed = 0.0
            for k in range(int(horizon), low - 1, -1):
                if k <= high:
                    least[k + 1] = min(least[k + 1], speed)
                if k > 0:
                    fastest = _reached(speed, bounds[k, 0], bounds[k, 2], bounds[k, 3])
                    speed = _before(fastest, bounds[k, 4], speeds[k])
        high = low - 1


def _reached(speed: float, length: float, acceleration: float, jerk: float) -> float:
    """Return the highest speed to which it can rise over a way, never rounded up."""
    lag = acceleration * acceleration / jerk
    wide = 2.0 * speed + lag
    if length * jerk >= wide * acceleration:
        half = acceleration * length - speed * lag
        gain = 4.0 * half / (wide + sqrt(wide * wide + 8.0 * half))
    else:
        w = _cubic_root(2.0 * speed, length * sqrt(jerk))
        gain = w * w
    found = speed + gain
    if found - speed > gain:
        found = max(speed, found - found * HALF_BIT)
    return found


def _cubic_root(p: float, q: float) -> float:
    """Return the real root of w³ + p·w = q for p >= 0, q > 0, by Cardano's formula without cancellation."""
    third, half = p / 3.0, 0.5 * q
    u: float = (half + sqrt(half * half + third * third * third)) ** (1.0 / 3.0)
    v = third / u
    w = q / (u * u + third + v * v)
    return w - (w * (w * w + p) - q) / (3.0 * w * w + p)  # the power above is not exact to the last bit


def _time(change: float, acceleration: float, jerk: float) -> float:
    """Return the time of a change of speed."""
    if change * jerk >= acceleration * acceleration:
        return change / acceleration + acceleration / jerk
    return 2.0 * sqrt(change / jerk)


def _way(low: float, change: float, acceleration: float, jerk: float) -> float:
    """Return the way of a change of speed from or to `low`."""
    return (low + 0.5 * change) * _time(change, acceleration, jerk)


def _rise(v0: float, v1: float, length: float, speed: float, acceleration: float, jerk: float) -> float:
    """Return by how much the speed rises above the higher one of both ends.

    The way that a rise to top + w² and the fall from there take is convex in w, so that Newton's steps fall
    to its root once they are above it.
    """
    top, fall = max(v0, v1), abs(v1 - v0)
    low = top - fall
    spare = length - _way(low, fall, acceleration, jerk)
    if spare <= ROUNDING * length or speed <= top:
        return 0.0
    room = speed - top
    ways = _way(top, room, acceleration, jerk) + _way(low, room + fall, acceleration, jerk)
    if ways <= length:
        return room
    lag = acceleration * acceleration / jerk
    wide = 2.0 * top + lag
    half = acceleration * length - top * lag - 0.5 * (top + low) * (fall + lag)
    if half > 0.0:
        found = 2.0 * half / (wide + sqrt(wide * wide + 4.0 * half))
        if found >= lag:
            return min(found, room)
    if fall == 0.0:
        w = _cubic_root(2.0 * top, 0.5 * length * sqrt(jerk))
        return min(w * w, room)
    w = _cubic_root(2.0 * top, spare * sqrt(jerk))
    for _ in range(ROUNDS):
        change = w * w
        first, second = _time(change, acceleration, jerk), _time(change + fall, acceleration, jerk)
        over = (top + 0.5 * change) * first + (low + 0.5 * (change + fall)) * second - length
        slope = w * (first + second)
        slope += (2.0 * top + change) * _slope_of_time(w, w, acceleration, jerk)
        slope += (top + low + change) * _slope_of_time(w, sqrt(change + fall), acceleration, jerk)
        step = over / slope
        w -= step
        if step <= ROUNDING * w:
            break
    return min(w * w, room)


def _slope_of_time(w: float, root: float, acceleration: float, jerk: float) -> float:
    """Return half the derivative by w of the time for a change of root² = w² + constant."""
    if root * root * jerk >= acceleration * acceleration:
        return w / acceleration
    return w / (root * sqrt(jerk))


def _add_piece(
    bounds: Array, i: int, v0: float, v1: float, rows: Array, n: int, time: float
) -> tuple[int, float]:
    """Write the segments of piece i from speed v0 to v1; return the number of all segments, and the time.

    Places are counted from the nearer end, so that the last segment ends at the length.
    """
    length, speed, acceleration, jerk = bounds[i, 0], bounds[i, 1], bounds[i, 2], bounds[i, 3]
    rise = _rise(v0, v1, length, speed, acceleration, jerk)
    top = max(v0, v1)
    up, down, peak = (top - v0) + rise, (top - v1) + rise, top + rise
    up_time, down_time = _time(up, acceleration, jerk), _time(down, acceleration, jerk)
    up_way, down_way = (v0 + 0.5 * up) * up_time, (v1 + 0.5 * down) * down_time
    rest = length - up_way - down_way
    if up > 0.0:
        ramp = min(0.5 * up_time, acceleration / jerk)
        steady, reached, gained = max(up_time - 2.0 * ramp, 0.0), jerk * ramp, 0.5 * jerk * ramp * ramp
        n = _add(rows, n, i, time, 0.0, v0, 0.0, jerk, ramp)
        if steady > ROUNDING * up_time:
            place = (v0 + gained / 3.0) * ramp
            n = _add(rows, n, i, time + ramp, place, v0 + gained, reached, 0.0, steady)
        place = up_way - (peak - gained / 3.0) * ramp
        n = _add(rows, n, i, time + (ramp + steady), place, peak - gained, reached, -jerk, ramp)
        time += up_time
    turn = up_way
    if rest > ROUNDING * length:
        turn = length - down_way
        n = _add(rows, n, i, time, up_way, peak, 0.0, 0.0, rest / peak)
        time += rest / peak
    if down > 0.0:
        ramp = min(0.5 * down_time, acceleration / jerk)
        steady, reached, lost = max(down_time - 2.0 * ramp, 0.0), -jerk * ramp, 0.5 * jerk * ramp * ramp
        n = _add(rows, n, i, time, turn, peak, 0.0, -jerk, ramp)
        if steady > ROUNDING * down_time:
            place = length - down_way + (peak - lost / 3.0) * ramp
            n = _add(rows, n, i, time + ramp, place, peak - lost, reached, 0.0, steady)
        place = length - (v1 + lost / 3.0) * ramp
        n = _add(rows, n, i, time + (ramp + steady), place, v1 + lost, reached, jerk, ramp)
        time += down_time
    return n, time


def _add(
    rows: Array,
    n: int,
    i: int,
    time: float,
    place: float,
    speed: float,
    acceleration: float,
    jerk: float,
    duration: float,
) -> int:
    """Write a segment but for the place at its end; return the number of all."""
    rows[0, n], rows[1, n], rows[2, n], rows[3, n] = i, time, place, speed
    rows[4, n], rows[5, n], rows[6, n] = acceleration, jerk, duration
    return n + 1
