"""Profiles of joints over one time, and their rows at given times, in loops that numba compiles.

Speed changes by d with jerk ±j and acceleration up to a, which is 0 before and after, in the time d/a + a/j
where d·j >= a², else in 2·√(d/j) (Biagiotti and Melchiorri 2008, Trajectory Planning for Automatic Machines
and Robots, section 3.4).
"""

from math import sqrt

from ropsim.codegen import Array1, Array2, Array3, columns, kernel
from ropsim.motion.time_law.time_law_kernel import LEAST, MOST
from ropsim.spatial import Array


@kernel
def joint_rows(
    q_start: Array1, q_end: Array1, shapes: Array2, duration: float, times: Array1, out: Array3
) -> None:
    """Write coordinates, speeds and accelerations of n joints at k times.

    Args:
        q_start: coordinates at the start [rad | m], shape (n,).
        q_end: at the end [rad | m], shape (n,).
        shapes: of the profiles, see `SynchronisedJoints`, shape (3, n).
        duration: of all profiles [s].
        times: [s], shape (k,); outside of the motion the joints rest.
        out: where the rows go, shape (3, k, n).
    """
    for k in range(times.shape[0]):
        _profiles(q_start, q_end, shapes, duration, times[k], 1.0, 0.0, out[0, k], out[1, k], out[2, k])


@kernel
def joints_in_time(
    q_start: Array1,
    q_end: Array1,
    shapes: Array2,
    duration: float,
    law: Array2,
    first: int,
    until: int,
    at: int,
    total: Array3,
) -> None:
    """Write coordinates and derivatives by time along profiles, see `traced_in_time`.

    Args:
        q_start: as for `joint_rows`.
        q_end: see there.
        shapes: see there.
        duration: see there.
        law: times of the profiles, speeds and accelerations in its rows 1 to 3, shape (4 or more, m).
        first: number of the first time of the motion.
        until: number behind that of the last one.
        at: row of the motion for the time 0 of the law.
        total: the motion, of which rows at + first to at + until are written, shape (3, m, n).
    """
    for k in range(first, until):
        time, v, a = law[1, k], law[2, k], law[3, k]
        _profiles(
            q_start, q_end, shapes, duration, time, v, a, total[0, at + k], total[1, at + k], total[2, at + k]
        )


def _profiles(
    q_start: Array,
    q_end: Array,
    shapes: Array,
    duration: float,
    at: float,
    v: float,
    a: float,
    q: Array,
    qd: Array,
    qdd: Array,
) -> None:
    """Write all joints at a time of their profiles; the second half is the mirror of the first one."""
    time = min(max(at, 0.0), duration)
    if time > 0.5 * duration:
        _half(q_end.shape[0], duration - time, -1.0, v, a, q_end, shapes, q, qd, qdd)
    else:
        _half(q_start.shape[0], time, 1.0, v, a, q_start, shapes, q, qd, qdd)


@columns
def _half(
    count: int,
    u: float,
    sign: float,
    v: float,
    a: float,
    q_end: Array,
    shapes: Array,
    q: Array,
    qd: Array,
    qdd: Array,
) -> None:
    """Write profiles at u from their nearer end, of which jerk x1, x2, negative jerk x3 and x4 lie behind.

    The acceleration is constant in x2, the speed in x4.
    """
    for i in range(count):
        j = shapes[0, i]
        tj = shapes[1, i]
        ta = shapes[2, i]
        x1 = min(u, tj)
        x2 = min(max(u - tj, 0.0), ta)
        x3 = min(max(u - (tj + ta), 0.0), tj)
        x4 = max(u - (2.0 * tj + ta), 0.0)
        most = j * tj
        v1 = 0.5 * most * tj
        v2 = most * (0.5 * tj + ta)
        v3 = most * (tj + ta)
        context = j * x1 * x1 * x1 / 6.0 + (v1 + 0.5 * most * x2) * x2
        distance = context + ((v2 + (0.5 * most - j * x3 / 6.0) * x3) * x3 + v3 * x4)
        d1 = 0.5 * j * (x1 - x3) * (x1 + x3) + most * (x2 + x3)
        q[i] = q_end[i] + sign * distance
        qd[i] = d1 * v
        qdd[i] = sign * (j * (x1 - x3)) * (v * v) + d1 * a


@kernel
def plan_together(distances: Array1, limits: Array2, shapes: Array2, result: Array1) -> None:
    """Write the profiles that take n joints from rest to rest in one time, the least time of the slowest.

    The others are stretched to it: with times longer by a factor f, the jerk is smaller by f³.

    Args:
        distances: of the joints with its sign, shape (n,).
        limits: speed, acceleration and jerk of the joints, shape (3, n).
        shapes: where the profiles go: signed jerk at the start, for how long it lasts [s], and how long the
            acceleration lasts that follows [s]; of shape (3, n).
        result: output for the time [s], or -1 and the index of a joint with a number that no motion can have;
            shape (2,).
    """
    slowest = 0.0
    for i in range(distances.shape[0]):
        length, speed, acceleration, jerk = abs(distances[i]), limits[0, i], limits[1, i], limits[2, i]
        allowed = LEAST <= speed <= MOST and LEAST <= acceleration <= MOST and LEAST <= jerk <= MOST
        if not (allowed and length <= MOST):
            result[0], result[1] = -1.0, i
            return
        peak = _peak(length, speed, acceleration, jerk) if length >= LEAST else 0.0
        if peak > 0.0:
            rise = _time(peak, acceleration, jerk)
            shapes[1, i] = min(0.5 * rise, acceleration / jerk)
            shapes[2, i] = max(rise - 2.0 * shapes[1, i], 0.0)
            shapes[0, i] = length / peak + rise
            slowest = max(slowest, shapes[0, i])
        else:
            shapes[0, i] = shapes[1, i] = shapes[2, i] = 0.0
    for i in range(distances.shape[0]):
        if shapes[0, i] > 0.0:
            factor = slowest / shapes[0, i]
            shapes[1, i] *= factor
            shapes[2, i] *= factor
            rise = 2.0 * shapes[1, i] + shapes[2, i]
            shapes[0, i] = distances[i] / (shapes[1, i] * (shapes[1, i] + shapes[2, i]) * (slowest - rise))
    result[0], result[1] = slowest, 0.0


def _peak(length: float, speed: float, acceleration: float, jerk: float) -> float:
    """Return the highest speed over a distance from rest to rest; a rise and a fall take it as a mean."""
    lag = acceleration * acceleration / jerk
    peak = 2.0 * length * acceleration / (lag + sqrt(lag * lag + 4.0 * length * acceleration))
    if peak < lag:
        ramp = (0.5 * length / jerk) ** (1.0 / 3.0)
        peak = jerk * ramp * ramp
    return min(peak, speed)


def _time(change: float, acceleration: float, jerk: float) -> float:
    """Return the time of a change of speed."""
    if change * jerk >= acceleration * acceleration:
        return change / acceleration + acceleration / jerk
    return 2.0 * sqrt(change / jerk)
