"""A path of several path segments in little time, in plain loops that numba compiles.

A rise starts without acceleration and takes as much jerk, then as much acceleration, as its path segment
allows, while it can still be levelled off (its acceleration taken back to 0 with the full jerk of the path
segments that this leads through) without breaking a bound. Where it could no longer, it is levelled off until
the path segment that was in the way is reached. Where a rise is too fast for the following segments, a new
one starts at the bound there. A fall is a rise backwards. So there is a chain of rises from the start,
one of falls from the end, and the motion follows the lower one of both. Where a rise meets a fall, both are
levelled off to the highest speed at which one is still before the other. Passes from both ends follow
time-optimal motions along paths (Bobrow, Dubowsky and Gibson 1985, Time-Optimal Control of Robotic
Manipulators Along Specified Paths, Int. J. Robotics Research 4(3)), segments follow the S-curve (Biagiotti
and Melchiorri 2008, Trajectory Planning for Automatic Machines and Robots, section 3.4).

In a table of a path stand, in a column for each path segment: length, speed, acceleration, jerk, bound of the
speed at its start, horizon; then, where a rise starts at a path segment, its first segment, the one behind
its last, and the speed to which its end can be levelled off; then the fall from its start to the end of the
path (see `Fall`); for its horizon, a path segment and the fall behind it with which the motion stops in time,
if already found; at last the bound of the speed at its start, were there no horizons. The last column is the
end of the path. In a table of segments stand path segment, path parameter, speed, acceleration, jerk,
duration, path parameter at the end, and the speed to which its start can be levelled off.
"""

from math import inf

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.motion.time_law.levelling_kernel import (
    BORDER,
    KEPT,
    TO_REST,
    from_border,
    longer_fall,
    stoppable_speed,
    write_fall,
)
from ropsim.motion.time_law.meeting_kernel import write_meeting
from ropsim.motion.time_law.rises_kernel import write_rises
from ropsim.spatial import Array

LEAST, MOST = 1e-50, 1e50
"""Between them lie the numbers of a path segment; values computed from them are then finite."""


@kernel
def plan_segments(
    bounds: Array2, tables: Array3, rises: Array3, rows: Array2, ends: Array1, result: Array1
) -> None:
    """Write the segments of constant jerk that take the motion from rest to rest over p path segments.

    Args:
        bounds: of the path segments in columns: length, speed, acceleration, jerk, ratio, horizon (see
            `Interval`), of shape (p, 6).
        tables: work: the tables forwards and backwards, units and lengths, shape (3, `ROWS`, p + 1).
        rises: work: the tables of rises, of falls, and segments backwards, of shape
            (3, 8, 8·p).
        rows: where the segments go: path segment, time at the start [s], path parameter, speed, acceleration,
            jerk, duration [s], path parameter at the end; of shape (8, 16·p).
        ends: where the times [s] go at which the path segments end, shape (p,).
        result: becomes the number of segments, or -1 and the index of a path segment whose bounds no motion
            can have, shape (2,).
    """
    p = bounds.shape[0]
    there, back = tables[0], tables[1]
    wrong = _lay_out(bounds, tables)
    if wrong >= 0:
        result[0], result[1] = -1.0, wrong
        return
    write_rises(there, rises[0])
    write_rises(back, rises[1])
    n = first = int(tables[2, 1, 0])  # 0; a number in the text would be a type of its own for numba
    for i in range(1, p + 1):
        if there[6, i] >= 0.0 and back[6, p - i] >= 0.0:
            n = write_meeting(tables, rises, first, i, rows, n)
            first = i
    result[0], result[1] = _time(bounds, tables[2, 0], rows, n, ends), 0.0


def _lay_out(bounds: Array, tables: Array) -> int:
    """Write the tables forwards and backwards; return the index of a path segment that is wrong, or -1."""
    p = bounds.shape[0]
    there, back, units, gone = tables[0], tables[1], tables[2, 0], tables[2, 1]
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
        gone[i + 1] = gone[i] + there[0, i]
        there[4, i] = 0.0 if i == 0 or bounds[i, 4] == 0.0 else min(there[1, i - 1], there[1, i])
        there[BORDER, i] = there[4, i]
    there[4, p] = 0.0
    _look_ahead(there)
    for i in range(p):
        for k in range(4):
            back[k, i] = there[k, p - 1 - i]
        back[4, i], back[5, i] = there[4, p - i], inf
    back[4, p] = 0.0
    return -1


def _time(bounds: Array, units: Array, rows: Array, n: int, ends: Array) -> int:
    """Write the times of n segments, and all in the units of their path segments; return how many last."""
    time, count = 0.0, 0
    for k in range(n):
        i = int(rows[0, k])
        context = count > 0 and rows[0, count - 1] == i
        if rows[6, k] > 0.0 and (time + rows[6, k] > time or not context):
            if count > 0 and not context:
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


def _is_wrong(bounds: Array, table: Array, i: int) -> bool:
    """Return whether a number of a path segment is none that a motion can have."""
    for k in range(4):
        if not (LEAST <= bounds[i, k] <= MOST and LEAST <= table[k, i] <= MOST):
            return True
    if not (bounds[i, 4] == 0.0 or LEAST <= bounds[i, 4] <= MOST):
        return True
    return not (bounds[i, 5] == -1.0 or bounds[i, 5] >= i)


def _look_ahead(table: Array) -> None:
    """Lower the bounds at the starts of path segments to speeds that stop before a horizon, if one counts.

    The falls keep to the bounds from before: with lowered ones they would differ from those that lowered
    them, and a rise could be slower where it should end than the one that begins there.
    """
    p, limited = table.shape[1] - 1, False
    for i in range(p):
        limited = limited or table[5, i] < inf
        table[KEPT, i] = -1.0
    if not limited:
        return
    fall = from_border(0.0)
    write_fall(fall, table[TO_REST:, p])
    for k in range(p - 1, -1, -1):
        fall = longer_fall(fall, table[0, k], table[2, k], table[3, k], table[BORDER, k])
        write_fall(fall, table[TO_REST:, k])
    for k in range(1, p):
        if table[5, k - 1] < inf and table[4, k] > 0.0:
            table[4, k] = min(table[4, k], stoppable_speed(table, k, 0.0, k - 1))
