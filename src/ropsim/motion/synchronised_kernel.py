"""Profiles of joints over one time, and their rows at given times, in loops that numba compiles.

Speed changes by d with jerk ±j and acceleration up to a, which is 0 before and after, in the time d/a + a/j
where d·j >= a², else in 2·√(d/j) (Biagiotti and Melchiorri 2008, Trajectory Planning for Automatic Machines
and Robots, section 3.4).
"""

from math import sqrt

from ropsim.codegen import kernel
from ropsim.motion.time_law_kernel import LEAST, MOST
from ropsim.spatial import Array


@kernel("void(f8[::1], f8[::1], f8[:,::1], f8, f8[::1], f8[:,:,::1])")
def joint_rows(
    q_start: Array, q_end: Array, shapes: Array, duration: float, times: Array, out: Array
) -> None:
    """Write coordinates, speeds and accelerations of n joints at k times.

    The second half of a profile is the mirror of its first one: at u from the nearer end there lie behind x1
    of jerk, x2 of constant acceleration, x3 of negative jerk and x4 of constant speed.

    Args:
        q_start: coordinates at the start [rad | m], shape (n,).
        q_end: at the end [rad | m], shape (n,).
        shapes: of the profiles, see `SynchronisedJoints`, shape (3, n).
        duration: of all profiles [s].
        times: [s], shape (k,); outside of the motion the joints rest.
        out: where the rows go, shape (3, k, n).
    """
    for k in range(times.shape[0]):
        time = min(max(times[k], 0.0), duration)
        mirrored = time > 0.5 * duration
        u = duration - time if mirrored else time
        for i in range(q_start.shape[0]):
            j, tj, ta = shapes[0, i], shapes[1, i], shapes[2, i]
            x1 = min(u, tj)
            x2 = min(max(u - tj, 0.0), ta)
            x3 = min(max(u - (tj + ta), 0.0), tj)
            x4 = max(u - (2.0 * tj + ta), 0.0)
            a = j * tj
            v1, v2, v3 = 0.5 * a * tj, a * (0.5 * tj + ta), a * (tj + ta)
            way = j * x1 * x1 * x1 / 6.0 + (v1 + 0.5 * a * x2) * x2
            way += (v2 + (0.5 * a - j * x3 / 6.0) * x3) * x3 + v3 * x4
            change = j * (x1 - x3)
            out[0, k, i] = q_end[i] - way if mirrored else q_start[i] + way
            out[1, k, i] = 0.5 * j * (x1 - x3) * (x1 + x3) + a * (x2 + x3)
            out[2, k, i] = -change if mirrored else change


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
        peak = _peak(length, speed, acceleration, jerk) if length >= LEAST else 0.0
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


def _peak(length: float, speed: float, acceleration: float, jerk: float) -> float:
    """Return the highest speed on a way from rest to rest; a rise and a fall take it as a mean."""
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
