"""At which control ticks joints and tool are at their limits, in plain loops that numba compiles."""

from ropsim.codegen import kernel
from ropsim.spatial import Array

TURNED = 1e-9
"""Entries of rotations that differ by less are the same, but for rounding."""


@kernel("void(f8[:,::1], f8[:,::1], f8[::1], f8[::1], f8[:,::1], f8[:,:,::1], f8, f8, f8[:,:,::1], f8[::1])")
def joints_reached(
    qd: Array,
    qdd: Array,
    looks: Array,
    starts: Array,
    torque: Array,
    most: Array,
    period: float,
    share: float,
    counts: Array,
    reached: Array,
) -> None:
    """Write at how many looks at each move joints are at their limits.

    Args:
        qd: speeds at all control ticks [rad/s | m/s], shape (ticks, n).
        qdd: accelerations [rad/s² | m/s²], shape (ticks, n).
        looks: numbers of the k ticks that are looked at, none of them the last one, shape (k,).
        starts: the first look at each of m moves, and k, shape (m + 1,).
        torque: at the looks [N m | N], shape (k, n).
        most: limits of speed, acceleration, torque and jerk of each move, shape (m, 4, n).
        period: of the control ticks [s].
        share: of a limit from which on it counts as reached.
        counts: where the answers go, shape (m, 4, n).
        reached: becomes 1 for a look at which any limit is reached, else 0, shape (k,).
    """
    for m in range(most.shape[0]):
        for i in range(4):
            for j in range(qd.shape[1]):
                counts[m, i, j] = 0.0
        for k in range(int(starts[m]), int(starts[m + 1])):
            row, found = int(looks[k]), 0.0
            for j in range(qd.shape[1]):
                jerk = (qdd[row + 1, j] - qdd[row, j]) / period
                values = (abs(qd[row, j]), abs(qdd[row, j]), abs(torque[k, j]), abs(jerk))
                for i in range(len(values)):
                    if values[i] >= share * most[m, i, j]:
                        counts[m, i, j] += 1.0
                        found = 1.0
            reached[k] = found


@kernel("void(f8[:,:,::1], f8[::1], f8[:,:,::1], f8[:,:,::1], f8[::1], f8[:,::1])")
def tool_reached(poses: Array, starts: Array, tools: Array, least: Array, used: Array, counts: Array) -> None:
    """Write at how many looks at each group speed, acceleration and jerk of the tool are at their limits.

    Args:
        poses: of the flange at four ticks in a row from each of k looks on, one behind the other, shape
            (4·k, 4, 4); become those of the tool.
        starts: the first look at each of g groups, and k, shape (g + 1,).
        tools: the tool frame X_MT of each group, shape (g, 4, 4).
        least: from which on a step, a change of it, and a change of that count as at the limit: of the
            position [m], then of the orientation [rad], shape (g, 2, 3); infinite for no limits.
        used: whether another limit is reached at a look, else 0, shape (k,).
        counts: where the answers go, first of the position, then of the orientation, 0 where that stays the
            same from the first look to the last; then at how many looks no limit is reached; shape (g, 7).
    """
    for g in range(tools.shape[0]):
        first, last = int(starts[g]), int(starts[g + 1])
        _put_on(poses[4 * first : 4 * last], tools[g])
        for i in range(7):
            counts[g, i] = 0.0
        turns = False
        for i in range(3):
            for j in range(3):
                turns = turns or not abs(poses[4 * first, i, j] - poses[4 * last - 4, i, j]) < TURNED
        for k in range(first, last):
            found = used[k]
            for kind in range(2 if turns else 1):
                squares = _squares(poses[4 * k : 4 * k + 4], kind)
                for i in range(3):
                    if squares[i] >= least[g, kind, i] * least[g, kind, i]:
                        counts[g, 3 * kind + i] += 1.0
                        found = 1.0
            if found == 0.0:
                counts[g, 6] += 1.0


def _put_on(poses: Array, tool: Array) -> None:
    """Make poses of the tool of those of the flange, shape (k, 4, 4), with a tool frame X_MT."""
    for k in range(poses.shape[0]):
        for i in range(3):
            a, b, c = poses[k, i, 0], poses[k, i, 1], poses[k, i, 2]
            for j in range(4):
                moved = a * tool[0, j] + b * tool[1, j] + c * tool[2, j]
                poses[k, i, j] = moved + poses[k, i, 3] if j == 3 else moved


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
