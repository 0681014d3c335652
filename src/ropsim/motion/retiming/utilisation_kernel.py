"""Utilisation of the limits at control ticks, and what a motion gives up for it, in loops for numba."""

import math
from typing import NamedTuple

from ropsim.codegen import Array1, Array2, Array3, columns, kernel
from ropsim.motion.retiming.path_load_kernel import (
    PathLoad,
    most_acceleration,
    most_step,
    path_acceleration,
    path_jump,
)
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
    """Derivatives of n joints by nominal time.

    Attributes:
        first: shape (k, n).
        second: of the same shape.
    """

    first: Array2
    second: Array2


class JointLoad(NamedTuple):
    """n joints at k control ticks.

    Attributes:
        qd: speeds [rad/s | m/s], shape (k, n).
        qdd: accelerations [rad/s² | m/s²], of the same shape.
        torque: [N m | N], shape (k, n), or (k, 0) where it does not count.
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
    joints: Derivatives,
    paths: PathLoad,
    timing: Array2,
    grid: Grid,
    limits: Array3,
    period: float,
    allowed: float,
    more: float,
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
        joints: their derivatives at the ticks.
        paths: at the ticks.
        timing: nominal times φ [s], rising, rates dφ/dt, and their changes [1/s], shape (3, k).
        grid: points of the plan.
        limits: of speed, acceleration, change of acceleration in one tick, and torque of each joint, and
            their inverses, shape (2, 4, n).
        period: of the control ticks [s].
        allowed: what may be used of a limit, 1 and rounding.
        more: added to the logarithm of each excess.
        out: the results.
    """
    qd, qdd, torque = load.qd, load.qdd, load.torque
    grid_phi, still, used, peaks = grid.phi, grid.still, out.used, out.peaks
    interval, last, ticks = 0, grid_phi.shape[0] - 2, qd.shape[0]
    kinds = 4 if torque.shape[1] else 3
    for k in range(ticks):
        while interval < last and grid_phi[interval + 1] <= timing[0, k]:
            interval += 1
        if 0 < k < ticks - 1 and _keeps(load, paths, timing, limits[1], period, k, allowed, used, peaks):
            continue
        for j in range(qd.shape[1]):
            effort = abs(torque[k, j]) if j < torque.shape[1] else 0.0
            values = (abs(qd[k, j]), abs(qdd[k, j]), _jump(qdd, k, j), effort)
            for kind in range(kinds):
                value, limit = values[kind], limits[0, kind, j]
                share = _share(value, limit, limits[1, kind, j], allowed)
                used[kind, k] = max(used[kind, k], share)
                if share <= allowed:
                    peaks[kind] = max(peaks[kind], share)
                    continue
                if kind == TORQUE:
                    past = (timing[0, k] - grid_phi[interval]) / (grid_phi[interval + 1] - grid_phi[interval])
                    held = still[interval, j] + past * (still[interval + 1, j] - still[interval, j])
                    held = math.copysign(held, held * torque[k, j])
                    share = (value - held) / max(limit - held, _TINY)
                peaks[kind] = max(peaks[kind], share)
                lack = math.log(min(max(share, 1.0), MOST_AT_ONCE)) + more
                _give(out.lacks, interval, _given_up(kind, lack, joints.first, joints.second, timing, j, k))
        for j in range(paths.first.shape[1]):
            values_of_path = (path_acceleration(paths, timing, k, j), path_jump(paths, timing, k, j, ticks))
            limits_of_path = (most_acceleration(paths, k, j), most_step(paths, timing, k, j, period))
            for kind in range(ACCELERATION, JERK + 1):
                value, limit = abs(values_of_path[kind - 1]), limits_of_path[kind - 1]
                share = _share(value, limit, 1.0 / limit, allowed)
                used[kind, k] = max(used[kind, k], share)
                peaks[kind] = max(peaks[kind], share)
                if share > allowed:
                    lack = math.log(min(max(share, 1.0), MOST_AT_ONCE)) + more
                    _give(out.lacks, interval, _given_up(kind, lack, paths.first, paths.second, timing, j, k))


def _share(value: float, limit: float, inverse: float, allowed: float) -> float:
    """Return what a value is of its limit: exactly where it decides something."""
    share = value * inverse
    return share if share < allowed * _CLEARLY else _of(value, limit)


def _give(lacks: Array, interval: int, given: tuple[float, float, float, float]) -> None:
    """Enter what is to be given up at the points on both sides of a tick."""
    for row in range(len(given)):
        for i in range(interval, interval + 2):
            lacks[row, i] = max(lacks[row, i], given[row])


def _causes(first: Array, second: Array, timing: Array, j: int, now: int) -> tuple[float, float, float]:
    """Return the shares that the path, changes of rate on it and changes of acceleration have in a jerk."""
    before = max(now - 1, 0)
    w, c = timing[1, now], timing[2, now]
    faster = w * w - timing[1, before] * timing[1, before]
    by_path = abs(second[now, j] - second[before, j]) * w * w
    bend = abs(second[now, j] * faster) + abs((first[now, j] - first[before, j]) * c)
    change = abs(first[now, j] * (c - timing[2, before]))
    whole = max(by_path + bend + change, _TINY)
    return by_path / whole, bend / whole, change / whole


def _jump(qdd: Array, k: int, j: int) -> float:
    """Return how much the acceleration of a joint changes towards a tick; it rests before and behind all."""
    jump = abs(qdd[k, j]) if k == 0 else abs(qdd[k, j] - qdd[k - 1, j])
    if k == qdd.shape[0] - 1:
        jump = max(jump, abs(qdd[k, j]))
    return float(jump)


def _keeps(
    state: JointLoad,
    paths: PathLoad,
    timing: Array,
    inverse: Array,
    period: float,
    k: int,
    allowed: float,
    used: Array,
    peaks: Array,
) -> bool:
    """Return whether a tick between others clearly keeps all limits; if so its shares are noted."""
    qd, qdd, torque = state.qd, state.qdd, state.torque
    speed, acceleration, jerk, load, whole = 0.0, 0.0, 0.0, 0.0, 0.0
    for j in range(qd.shape[1]):
        fast, swing, jump = abs(qd[k, j]), abs(qdd[k, j]), abs(qdd[k, j] - qdd[k - 1, j])
        whole += fast + jump + swing
        speed = max(speed, fast * inverse[SPEED, j])
        acceleration = max(acceleration, swing * inverse[ACCELERATION, j])
        jerk = max(jerk, jump * inverse[JERK, j])
    for j in range(paths.first.shape[1]):
        now = path_acceleration(paths, timing, k, j)
        swing, jump = abs(now), abs(now - path_acceleration(paths, timing, k - 1, j))
        whole += abs(paths.first[k, j] * timing[1, k]) + jump + swing
        acceleration = max(acceleration, swing * (1.0 / most_acceleration(paths, k, j)))
        jerk = max(jerk, jump * (1.0 / most_step(paths, timing, k, j, period)))
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
    kind: int, lack: float, first: Array, second: Array, timing: Array, j: int, now: int
) -> tuple[float, float, float, float]:
    """Return what is to be given up for a lack, in the order of the rows of lacks."""
    if kind == JERK:
        by_path, bend, change = _causes(first, second, timing, j, now)
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
