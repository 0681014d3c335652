"""At which control ticks joints and tool are at their limits, in plain loops that numba compiles."""

from ropsim.codegen import kernel
from ropsim.spatial import Array

TURNED = 1e-9
"""Entries of rotations that differ by less are the same, but for rounding."""


@kernel("void(f8[:,::1], f8[:,::1], f8[::1], f8[:,::1], f8[:,::1], f8, f8, f8[:,:,::1])")
def joints_reached(
    qd: Array, qdd: Array, looks: Array, torque: Array, most: Array, period: float, share: float, out: Array
) -> None:
    """Write 1 where a joint is at a limit, else 0.

    Args:
        qd: speeds at all control ticks [rad/s | m/s], shape (ticks, n).
        qdd: accelerations [rad/s² | m/s²], shape (ticks, n).
        looks: numbers of the k ticks that are looked at, none of them the last one, shape (k,).
        torque: at these [N m | N], shape (k, n).
        most: limits of speed, acceleration, torque and jerk, shape (4, n).
        period: of the control ticks [s].
        share: of a limit from which on it counts as reached.
        out: where the answers go, rows as in the limits, shape (4, k, n).
    """
    for k in range(looks.shape[0]):
        row = int(looks[k])
        for j in range(qd.shape[1]):
            jerk = (qdd[row + 1, j] - qdd[row, j]) / period
            values = (abs(qd[row, j]), abs(qdd[row, j]), abs(torque[k, j]), abs(jerk))
            for i in range(len(values)):
                out[i, k, j] = 1.0 if values[i] >= share * most[i, j] else 0.0


@kernel("void(f8[:,:,::1], f8[:,::1], f8[:,::1])")
def tool_reached(poses: Array, least: Array, out: Array) -> None:
    """Write 1 where speed, acceleration or jerk of the tool are at their limits, else 0.

    Args:
        poses: of the tool at four ticks in a row from each of k looks on, one behind the other, (4·k, 4, 4).
        least: from which on a step, a change of it, and a change of that count as at the limit: of the
            position [m], then of the orientation [rad], shape (2, 3).
        out: where the answers go, first of the position, then of the orientation, 0 where that stays the same
            from the first look to the last, shape (6, k).
    """
    last, turns = poses.shape[0] - 4, False
    for i in range(3):
        for j in range(3):
            turns = turns or not abs(poses[0, i, j] - poses[last, i, j]) < TURNED
    for k in range(out.shape[1]):
        for kind in range(2 if turns else 1):
            squares = _squares(poses[4 * k : 4 * k + 4], kind)
            for i in range(3):
                out[3 * kind + i, k] = 1.0 if squares[i] >= least[kind, i] * least[kind, i] else 0.0


def _squares(X: Array, kind: int) -> tuple[float, float, float]:
    """Return the squares of the first step, of the change to the second, and of the change of that.

    Args:
        X: poses at four ticks in a row, shape (4, 4, 4).
        kind: 0 for the position, 1 for the orientation.
    """
    first, second, third = 0.0, 0.0, 0.0
    for axis in range(3):
        one, two, three = _step(X, 0, kind, axis), _step(X, 1, kind, axis), _step(X, 2, kind, axis)
        first += one * one
        second += (two - one) * (two - one)
        third += (three - 2.0 * two + one) * (three - 2.0 * two + one)
    return first, second, third


def _step(X: Array, tick: int, kind: int, axis: int) -> float:
    """Return what one axis of the tool does from a tick to the next: its way, or its small turn."""
    if kind == 0:
        return float(X[tick + 1, axis, 3] - X[tick, axis, 3])
    a, b = (axis + 2) % 3, (axis + 1) % 3
    there, back = 0.0, 0.0
    for c in range(3):
        there += X[tick, c, a] * X[tick + 1, c, b]
        back += X[tick, c, b] * X[tick + 1, c, a]
    return 0.5 * (there - back)
