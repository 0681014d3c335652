"""Utilisation of the limits at control ticks, and what a motion gives up for it, in loops for numba."""

import math
from typing import NamedTuple

from ropsim.codegen import Array1, Array2, Array3, columns, kernel
from ropsim.motion.retiming.smooth_rates_kernel import greatest_nearby
from ropsim.spatial import Array

ENDLESS = math.inf
AT_ONCE = 16
"""Ticks whose numbers are taken as one row."""
ROWS_OF_MOTION, ROWS_OF_TORQUE = 7, 2
"""Rows to work in: reciprocals of limits of all columns, what is used of them, and zeros."""
REST = 6
"""Row of zeros: joints rest before the first and after the last tick."""


@kernel
def used_by_motion(
    qd: Array1, qdd: Array1, limits: Array2, work: Array2, used: Array2, peaks: Array1
) -> None:
    """Compute what n joints use of speed, acceleration and jerk at k control ticks, as `utilisation_of` does.

    Args:
        qd: speeds [rad/s | m/s], shape (k·n,).
        qdd: accelerations [rad/s² | m/s²], shape (k·n,).
        limits: of speed, acceleration and change of acceleration in one tick, shape (3, n).
        work: to work in, shape (ROWS_OF_MOTION, AT_ONCE·n).
        used: becomes what is used by the joint that uses most, in its first three rows, shape (4, k).
        peaks: becomes the most of each, in its first three numbers, shape (4,).
    """
    n, ticks = limits.shape[1], used.shape[1]
    for k in range(AT_ONCE):
        for j in range(n):
            work[0, k * n + j], work[1, k * n + j] = 1.0 / limits[0, j], 1.0 / limits[1, j]
            work[2, k * n + j], work[REST, k * n + j] = 1.0 / limits[2, j], 0.0
    begin, most_speed, most_acceleration, most_jerk = 0, 0.0, 0.0, 0.0
    while begin < ticks:
        end = min(begin + AT_ONCE, ticks) if begin else 1
        first, count = begin * n, (end - begin) * n
        before = qdd[first - n :] if begin else work[REST]
        _motion_shares(count, qd[first:], qdd[first:], before, work)
        for k in range(begin, end):
            speed, acceleration, jerk = 0.0, 0.0, 0.0
            for j in range((k - begin) * n, (k - begin + 1) * n):
                speed = max(speed, work[3, j])
                acceleration = max(acceleration, work[4, j])
                jerk = max(jerk, work[5, j])
            if k == ticks - 1:
                _motion_shares(n, qd[k * n :], qdd[k * n :], work[REST], work)
                for j in range(n):
                    jerk = max(jerk, work[5, j])
            used[SPEED, k], used[ACCELERATION, k], used[JERK, k] = speed, acceleration, jerk
            most_speed = max(most_speed, speed)
            most_acceleration = max(most_acceleration, acceleration)
            most_jerk = max(most_jerk, jerk)
        begin = end
    peaks[SPEED], peaks[ACCELERATION], peaks[JERK] = most_speed, most_acceleration, most_jerk


@kernel
def used_by_torque(torque: Array1, limit: Array1, work: Array2, used: Array2, peaks: Array1) -> None:
    """Compute what n joints use of their torque at k control ticks, as `utilisation_of` does.

    Args:
        torque: of the joints [N m | N], shape (k·n,).
        limit: of each [N m | N], shape (n,).
        work: to work in, shape (ROWS_OF_TORQUE, AT_ONCE·n).
        used: its last row becomes what is used by the joint that uses most, shape (4, k).
        peaks: its last number becomes the most of that, shape (4,).
    """
    n, ticks, peak = limit.shape[0], used.shape[1], 0.0
    for k in range(AT_ONCE):
        for j in range(n):
            work[0, k * n + j] = 1.0 / limit[j]
    for begin in range(0, ticks, AT_ONCE):
        end = min(begin + AT_ONCE, ticks)
        _torque_shares((end - begin) * n, torque[begin * n :], work)
        for k in range(begin, end):
            most = 0.0
            for j in range((k - begin) * n, (k - begin + 1) * n):
                most = max(most, work[1, j])
            used[TORQUE, k] = most
            peak = max(peak, most)
    peaks[TORQUE] = peak


@columns
def _motion_shares(count: int, qd: Array, qdd: Array, before: Array, work: Array) -> None:
    """Write what is used of limits of speed, acceleration and jerk; no number counts as infinity."""
    for j in range(count):
        work[3, j] = min(ENDLESS, abs(qd[j]) * work[0, j])
        work[4, j] = min(ENDLESS, abs(qdd[j]) * work[1, j])
        work[5, j] = min(ENDLESS, abs(qdd[j] - before[j]) * work[2, j])


@columns
def _torque_shares(count: int, torque: Array, work: Array) -> None:
    """Write what is used of limits of torque."""
    for j in range(count):
        work[1, j] = min(ENDLESS, abs(torque[j]) * work[0, j])


_TINY = 1e-300
_CLEARLY = 1.0 - 1e-12
"""Share of what may be used below which rounding decides nothing."""
MOST_AT_ONCE = 2.0
"""Greatest excess that is made good at once."""
STEADY = 1.0 / 3.0
"""Power of a jerk's excess by which the rate falls where the path itself causes it."""
SWING_SHARE = 0.2
"""Share of a lack of width that accelerations make good."""
SPEED, ACCELERATION, JERK, TORQUE = range(4)
"""Rows of what is used, of peaks and of limits, in the order of `Quantity`."""
RATE, SWING, WINDOW, LOAD = range(4)
"""Rows of lacks: rate and acceleration are divided by them, windows multiplied, torque divided."""


class Derivatives(NamedTuple):
    """Derivatives of joints and paths by nominal time.

    Attributes:
        first: shape (k, n + r).
        second: of the same shape.
    """

    first: Array2
    second: Array2


class JointLoad(NamedTuple):
    """n joints, then r paths, at k control ticks.

    Attributes:
        qd: speeds of joints [rad/s | m/s], then of paths, shape (k, n + r).
        qdd: accelerations [rad/s² | m/s²], of the same shape.
        torque: of joints [N m | N], shape (k, n), or (k, 0) where it does not count.
    """

    qd: Array2
    qdd: Array2
    torque: Array2


class Grid(NamedTuple):
    """Points at which a motion is planned.

    Attributes:
        phi: nominal times [s], rising, shape (m,).
        still: torque of creeping there [N m | N], shape (m, n), or (m, 0).
    """

    phi: Array1
    still: Array2


class Used(NamedTuple):
    """Utilisation of the limits; all numbers begin as 0.

    Attributes:
        used: becomes the greatest share of each limit, 1 for all of it, in the order of `Quantity`, (4, k).
        peaks: becomes the greatest excess of each, shape (4,).
        lacks: become logarithms of what rate and acceleration are to be divided by, windows to be multiplied
            with, and torque to be divided by, at the points on both sides of the ticks, (4, m).
    """

    used: Array2
    peaks: Array1
    lacks: Array2


@kernel
def utilisation_of(
    load: JointLoad,
    path: Derivatives,
    timing: Array2,
    grid: Grid,
    limits: Array3,
    allowed: float,
    more: float,
    inverse: Array2,
    out: Used,
) -> None:
    """Compute utilisation and lacks of n joints and r paths at k control ticks; no number counts as infinity.

    Jerk is the difference of accelerations of neighbouring ticks, at the later one of the two; joints rest
    before the first and after the last tick. It has three causes: the path itself asks for a lower rate,
    changes of rate on a bent path for lower accelerations, changes of acceleration along the path for wider
    windows. Of a torque that is too much only what dry friction and gravity leave can be given up. Most ticks
    keep all limits; those are done with as soon as that is seen.

    Args:
        load: of the joints at the ticks.
        path: derivatives at the ticks.
        timing: nominal times φ [s], rising, rates dφ/dt, and their changes [1/s], shape (3, k).
        grid: points of the plan.
        limits: of speed, acceleration, change of acceleration in one tick, and torque, shape (4, k, n + r),
            or (4, 1, n + r) where they are the same at all ticks.
        allowed: what may be used of a limit, 1 and rounding.
        more: added to the logarithm of each excess.
        inverse: work, shape (4, n + r).
        out: the results.
    """
    qd, qdd, torque = load.qd, load.qdd, load.torque
    grid_phi, still, used, peaks = grid.phi, grid.still, out.used, out.peaks
    interval, last, constant = 0, grid_phi.shape[0] - 2, limits.shape[1] == 1
    kinds = 4 if torque.shape[1] else 3
    for k in range(qd.shape[0]):
        before = max(k - 1, 0)
        while interval < last and grid_phi[interval + 1] <= timing[0, k]:
            interval += 1
        here = 0 if constant else k
        if k == 0 or not constant:
            _invert(limits, here, inverse)
        if 0 < k < qd.shape[0] - 1 and _keeps(load, inverse, k, allowed, used, peaks):
            continue
        for j in range(qd.shape[1]):
            effort = abs(torque[k, j]) if j < torque.shape[1] else 0.0
            values = (abs(qd[k, j]), abs(qdd[k, j]), _jump(qdd, k, j), effort)
            for kind in range(kinds):
                value = values[kind]
                share = value * inverse[kind, j]
                if not share < allowed * _CLEARLY:
                    share = _of(value, limits[kind, here, j])
                used[kind, k] = max(used[kind, k], share)
                if share <= allowed:
                    peaks[kind] = max(peaks[kind], share)
                    continue
                if kind == TORQUE:
                    past = (timing[0, k] - grid_phi[interval]) / (grid_phi[interval + 1] - grid_phi[interval])
                    held = still[interval, j] + past * (still[interval + 1, j] - still[interval, j])
                    held = math.copysign(held, held * torque[k, j])
                    share = (value - held) / max(limits[TORQUE, here, j] - held, _TINY)
                peaks[kind] = max(peaks[kind], share)
                lack = math.log(min(max(share, 1.0), MOST_AT_ONCE)) + more
                given = _given_up(kind, lack, path, timing, j, before, k)
                for row in range(len(given)):
                    for i in range(interval, interval + 2):
                        out.lacks[row, i] = max(out.lacks[row, i], given[row])


def _causes(path: Derivatives, timing: Array, j: int, before: int, now: int) -> tuple[float, float, float]:
    """Return the shares that the path, changes of rate on it and changes of acceleration have in a jerk."""
    w, c, first, second = timing[1, now], timing[2, now], path.first, path.second
    faster = w * w - timing[1, before] * timing[1, before]
    by_path = abs(second[now, j] - second[before, j]) * w * w
    bend = abs(second[now, j] * faster) + abs((first[now, j] - first[before, j]) * c)
    change = abs(first[now, j] * (c - timing[2, before]))
    whole = max(by_path + bend + change, _TINY)
    return by_path / whole, bend / whole, change / whole


@kernel
def by_real_time(first: Array2, second: Array2, timing: Array2, out: Array3) -> None:
    """Write speeds q'·w and accelerations q''·w² + q'·c of a motion at the rate w, which changes by c.

    Args:
        first: first derivatives by nominal time, shape (k, n).
        second: second ones.
        timing: nominal times [s], rates w = dφ/dt, and their changes c [1/s], shape (3, k).
        out: where they go, shape (2, k, n).
    """
    for k in range(first.shape[0]):
        w, c = timing[1, k], timing[2, k]
        for j in range(first.shape[1]):
            out[0, k, j] = first[k, j] * w
            out[1, k, j] = second[k, j] * (w * w) + first[k, j] * c


def _jump(qdd: Array, k: int, j: int) -> float:
    """Return how much the acceleration of a joint changes towards a tick; it rests before and behind all."""
    jump = abs(qdd[k, j]) if k == 0 else abs(qdd[k, j] - qdd[k - 1, j])
    if k == qdd.shape[0] - 1:
        jump = max(jump, abs(qdd[k, j]))
    return float(jump)


def _invert(limits: Array, here: int, inverse: Array) -> None:
    """Write the inverse of the limits at a tick."""
    for kind in range(inverse.shape[0]):
        for j in range(inverse.shape[1]):
            inverse[kind, j] = 1.0 / limits[kind, here, j]


def _keeps(state: JointLoad, inverse: Array, k: int, allowed: float, used: Array, peaks: Array) -> bool:
    """Return whether a tick between others clearly keeps all limits; if so its shares are noted."""
    qd, qdd, torque = state.qd, state.qdd, state.torque
    speed, acceleration, jerk, load, whole = 0.0, 0.0, 0.0, 0.0, 0.0
    for j in range(qd.shape[1]):
        fast, swing, jump = abs(qd[k, j]), abs(qdd[k, j]), abs(qdd[k, j] - qdd[k - 1, j])
        whole += fast + jump + swing
        speed = max(speed, fast * inverse[SPEED, j])
        acceleration = max(acceleration, swing * inverse[ACCELERATION, j])
        jerk = max(jerk, jump * inverse[JERK, j])
    for j in range(torque.shape[1]):
        whole += abs(torque[k, j])
        load = max(load, abs(torque[k, j]) * inverse[TORQUE, j])
    if not (whole < math.inf and max(speed, acceleration, jerk, load) < allowed * _CLEARLY):
        return False
    used[SPEED, k], used[ACCELERATION, k], used[JERK, k], used[TORQUE, k] = speed, acceleration, jerk, load
    peaks[SPEED], peaks[ACCELERATION] = max(peaks[SPEED], speed), max(peaks[ACCELERATION], acceleration)
    peaks[JERK], peaks[TORQUE] = max(peaks[JERK], jerk), max(peaks[TORQUE], load)
    return True


def _given_up(
    kind: int, lack: float, path: Derivatives, timing: Array, j: int, before: int, now: int
) -> tuple[float, float, float, float]:
    """Return what is to be given up for a lack, in the order of the rows of lacks."""
    if kind == JERK:
        by_path, bend, change = _causes(path, timing, j, before, now)
        return by_path * STEADY * lack, (bend + SWING_SHARE * change) * lack, lack * change, 0.0
    if kind == ACCELERATION:
        return 0.0, lack, 0.0, 0.0
    if kind == TORQUE:
        return 0.0, 0.0, 0.0, lack
    return lack, 0.0, 0.0, 0.0  # whatever it is, slowing is what helps


def _of(value: float, limit: float) -> float:
    """Return what a value is of its limit; no number counts as infinity."""
    share = value / limit
    return share if share < math.inf else math.inf


_WIDEST = 8.0
"""Greatest width of windows over their first one."""


@kernel
def give_up(sigma: Array1, lacks: Array2, work: Array2, shares: Array2) -> None:
    """Make shares smaller, and windows wider, by the greatest lacks in the windows around grid points.

    Args:
        sigma: positions in windows, see `smooth_timing`, shape (m,).
        lacks: logarithms, as from `lacks_at`, shape (4, m).
        work: to work in, shape (2, m).
        shares: of rate and acceleration, width of windows, and share of torque, shape (4, m).
    """
    for row in range(lacks.shape[0]):
        greatest = 0.0
        for i in range(sigma.shape[0]):
            greatest = max(greatest, lacks[row, i])
        if greatest == 0.0:
            continue
        greatest_nearby(sigma, lacks[row], work[0], work[1])
        for i in range(sigma.shape[0]):
            if work[1, i] > 0.0:
                factor = math.exp(work[1, i])
                if row == WINDOW:
                    shares[row, i] = min(shares[row, i] * factor, _WIDEST)
                else:
                    shares[row, i] /= factor
