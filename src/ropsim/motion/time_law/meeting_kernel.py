"""The meeting of a rise with a fall at the highest speed that both can have; see `time_law_kernel`."""

from math import sqrt

from ropsim.motion.time_law.levelling_kernel import (
    LEVELLED,
    ROUNDS,
    SIXTH,
    THIRD,
    between,
    crossing_time,
    level_off,
    root_share,
)
from ropsim.spatial import Array

MET = 1e-13
"""Relative; a rise and a fall that leave no more of their distance between them meet."""


def write_meeting(tables: Array, rises: Array, first: int, last: int, rows: Array, n: int) -> int:
    """Write a rise from one boundary and a fall to another; return the number of all segments.

    The highest speed at which a rise is levelled off before a fall is searched by `root_share`.
    """
    there, back, gone, p = tables[0], tables[1], tables[2, 1], tables.shape[2] - 1
    low = max(there[4, first], there[4, last])
    top = max(min(there[8, first], back[8, p - last]), low)
    here, seen, ended = 0.0, 0.0, False
    other_end, other_gap, before, before_gap = low, 0.0, low, 0.0
    row, t, k, x = int(there[6, first]), 0.0, first, 0.0
    other, u, i, y = int(back[6, p - last]), 0.0, last, 0.0
    for step in range(ROUNDS):
        row, t, k, x = _summit(there, rises[0], first, top)
        other, u, i, y = _summit(back, rises[1], p - last, top)
        i = p - 1 - i
        y = there[0, i] - y
        gap = y - x
        if k < i:
            gap = (there[0, k] - x) + (gone[i] - gone[k + 1]) + y
        elif i < k:
            gap = (y - there[0, i]) - (gone[k] - gone[i + 1]) - x
        if ended or (step == 0 and gap >= 0.0) or 0.0 <= gap <= MET * (gone[last] - gone[first]):
            break
        if step == 1:
            gap = max(gap, 0.0)
        if step > 0 and (gap >= 0.0) == (seen >= 0.0):
            before, before_gap = here, seen
        elif step > 0:
            before, before_gap = other_end, other_gap
            other_end, other_gap = here, seen
        here, seen = top, gap
        if step == 0:
            top = low
            continue
        share = 0.5 if step == 1 else root_share(here, seen, other_end, other_gap, before, before_gap)
        top = between(here, other_end, share)
        if not min(here, other_end) < top < max(here, other_end) or step == ROUNDS - 2:
            top, ended = here if seen >= 0.0 else other_end, True
    n, k, x = _copy(there, rises[0], first, row, t, rows, n)
    m, i, y = _copy(back, rises[1], p - last, other, u, rises[2], int(gone[0]))
    i = p - 1 - i
    y = there[0, i] - y
    while k <= i:
        until = y if k == i else there[0, k]
        if until > x:
            _add_row(rows, n, k, x, top, 0.0, 0.0, (until - x) / top)
            n += 1
        k, x = k + 1, 0.0
    for row in range(m - 1, -1, -1):
        i, h = p - 1 - int(rises[2, 0, row]), rises[2, 6, row]
        v, a, j = rises[2, 3, row], rises[2, 4, row], rises[2, 5, row]
        x = there[0, i] - rises[2, 7, row]
        _add_row(rows, n, i, x, v + h * (a + 0.5 * h * j), -(a + h * j), j, h)
        n += 1
    return n


def _summit(table: Array, rises: Array, start: int, top: float) -> tuple[int, float, int, float]:
    """Return where the rise from a boundary is levelled off to a speed, and where that ends.

    Returns:
        segment and time in it; path segment and path parameter.
    """
    first, last = int(table[6, start]), int(table[7, start])
    row, high = first - 1, last - 1
    while high - row > 1:
        middle = (row + high) // 2
        if rises[7, middle + 1] >= top:
            high = middle
        else:
            row = middle
    row = high
    k, v, a, h = int(rises[0, row]), rises[2, row], rises[3, row], rises[5, row]
    most = rises[7, row + 1] if row + 1 < last else table[8, start]
    before, after, under, over = 0.0, h, rises[7, row] - top, most - top
    jerk, change, t = table[3, k], rises[4, row], 0.0
    if over <= 0.0:
        t = h
    elif under >= 0.0:
        t = 0.0
    elif change > 0.0:
        t = (sqrt(max(0.5 * a * a + jerk * (top - v), 0.0)) - a) / jerk
    elif a > 0.0:
        t = (top - v - 0.5 * a * a / jerk) / a
    t = min(max(t, 0.0), h)
    path_segment, s = k, 0.0
    for step in range(ROUNDS):
        x = rises[1, row] + t * (v + t * (0.5 * a + t * (change * SIXTH)))
        a1 = max(a + change * t, 0.0)
        v1 = v + t * (a + 0.5 * change * t)
        _, path_segment, s, found, _, slope = level_off(table, k, min(x, table[0, k]), v1, a1, k)
        if (step == 0 and path_segment == k) or not under < 0.0 < over or abs(found - top) <= LEVELLED * top:
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
    return row, t, path_segment, min(s, table[0, path_segment])


def _copy(
    table: Array, rises: Array, start: int, row: int, t: float, rows: Array, n: int
) -> tuple[int, int, float]:
    """Write the rise from a boundary until a time of a segment, and levelled off behind it.

    Returns:
        the number of all segments, and path segment and path parameter at the end.
    """
    v, a, change = 0.0, 0.0, 0.0
    for i in range(int(table[6, start]), row + 1):
        h = rises[5, i] if i < row else t
        v, a, change = rises[2, i], rises[3, i], rises[4, i]
        _add_row(rows, n, int(rises[0, i]), rises[1, i], v, a, change, h)
        rows[7, n] = rises[6, i]
        n += 1
    k = int(rises[0, row])
    x = rises[6, row]
    if t < rises[5, row]:
        x = min(rises[1, row] + t * (v + t * (0.5 * a + t * (change * SIXTH))), table[0, k])
    rows[7, n - 1] = x
    v, a = v + t * (a + 0.5 * change * t), max(a + change * t, 0.0)
    end, levelled = x, False
    while not levelled:
        length, jerk = table[0, k], table[3, k]
        t = a / jerk
        end = x + t * (v + a * t * THIRD)
        levelled = end <= length or k + 2 == table.shape[1]
        if not levelled:
            t = crossing_time(length - x, v, a, -jerk)
        _add_row(rows, n, k, x, v, a, -jerk, t)
        rows[7, n] = min(end, length) if levelled else length
        n += 1
        v, a = v + t * (a - 0.5 * jerk * t), max(a - jerk * t, 0.0)
        if not levelled:
            k, x = k + 1, 0.0
    return n, k, min(end, table[0, k])


def _add_row(
    rows: Array,
    n: int,
    path_segment: int,
    s: float,
    v: float,
    a: float,
    jerk: float,
    duration: float,
) -> None:
    """Write a segment except its time and the path parameter at its end."""
    rows[0, n], rows[2, n], rows[3, n] = path_segment, s, v
    rows[4, n], rows[5, n], rows[6, n] = a, jerk, duration
