"""At which control ticks joints and tool are at their limits, in plain loops that numba compiles."""

from typing import NamedTuple

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.spatial import Array

TURNED = 1e-9
"""Entries of rotations that differ by less are the same, but for rounding."""


@kernel
def sample_moves(
    q: Array2,
    qd: Array2,
    qdd: Array2,
    spans: Array2,
    most: int,
    samples: Array1,
    starts: Array1,
    rows: Array3,
) -> None:
    """Choose the control ticks at which moves are evaluated, evenly spaced, and copy their rows.

    Args:
        q: coordinates at all control ticks [rad | m], shape (ticks, n).
        qd: speeds [rad/s | m/s], of the same shape.
        qdd: accelerations [rad/s² | m/s²], of the same shape.
        spans: the last tick before each of m moves begins, and the last one on it, shape (m, 2).
        most: samples at a move, at most.
        samples: where the numbers of the ticks go, without the last one of each move, shape (size,).
        starts: becomes the first sample of each move, and how many there are, k, shape (m + 1,).
        rows: where coordinates, speeds and accelerations there go, shape (3, size, n).
    """
    n, k = q.shape[1], 0
    for m in range(spans.shape[0]):
        starts[m] = k
        first, end = int(spans[m, 0]), int(spans[m, 1]) - 1
        for tick in range(first, end, (end - first + most - 1) // most):
            samples[k] = tick
            for j in range(n):
                rows[0, k, j], rows[1, k, j], rows[2, k, j] = q[tick, j], qd[tick, j], qdd[tick, j]
            k += 1
    starts[spans.shape[0]] = k


class Reached(NamedTuple):
    """Results of `limits_reached`.

    Attributes:
        counts: number of samples of each move at which a limit is reached, shape (m, 4, n).
        longest: becomes the number among these of the greatest count of each move, and its share of the
            samples, shape (m, 2).
        reached: becomes 1 for a sample at which any limit is reached, else 0, shape (k,).
    """

    counts: Array3
    longest: Array2
    reached: Array1


@kernel
def limits_reached(
    qd: Array2,
    qdd: Array2,
    samples: Array1,
    starts: Array1,
    torque: Array2,
    most: Array3,
    period: float,
    share: float,
    out: Reached,
) -> None:
    """Write at how many samples of each move joints are at their limits.

    Args:
        qd: speeds at all control ticks [rad/s | m/s], shape (ticks, n).
        qdd: accelerations [rad/s² | m/s²], shape (ticks, n).
        samples: numbers of the k ticks that are evaluated, none of them the last one, shape (k,).
        starts: the first sample of each of m moves, and k, shape (m + 1,).
        torque: at the samples [N m | N], shape (k, n).
        most: limits of speed, acceleration, torque and jerk of each move, shape (m, 4, n).
        period: of the control ticks [s].
        share: of a limit from which on it counts as reached.
        out: the results.
    """
    counts, longest, reached = out
    for m in range(most.shape[0]):
        for i in range(4):
            for j in range(qd.shape[1]):
                counts[m, i, j] = 0.0
        for k in range(int(starts[m]), int(starts[m + 1])):
            row, found = int(samples[k]), 0.0
            for j in range(qd.shape[1]):
                jerk = (qdd[row + 1, j] - qdd[row, j]) / period
                values = (abs(qd[row, j]), abs(qdd[row, j]), abs(torque[k, j]), abs(jerk))
                for i in range(len(values)):
                    if values[i] >= share * most[m, i, j]:
                        counts[m, i, j] += 1.0
                        found = 1.0
            reached[k] = found
        longest[m, 0], longest[m, 1] = 0.0, 0.0
        for i in range(4):
            for j in range(qd.shape[1]):
                share_of_move = counts[m, i, j] / (starts[m + 1] - starts[m])
                if share_of_move > longest[m, 1]:
                    longest[m, 0], longest[m, 1] = i * qd.shape[1] + j, share_of_move


@kernel
def four_in_sequence(
    q: Array2,
    samples: Array1,
    reached: Array1,
    starts: Array1,
    chosen: Array1,
    rows: Array2,
    samples_here: Array1,
    reached_here: Array1,
    starts_here: Array1,
) -> None:
    """Copy four rows from each sample on, of the moves that are chosen; behind the last row that goes on.

    Args:
        q: coordinates at all control ticks [rad | m], shape (ticks, n).
        samples: numbers of the ticks that are evaluated, shape (size,).
        reached: what else is known of each sample, shape (size,).
        starts: the first sample of each of m moves, and how many there are, shape (m + 1,).
        chosen: numbers of the moves, rising, shape (t,).
        rows: where the rows go, one behind the other, shape (4·size, n).
        samples_here: becomes `samples` of these moves alone, shape (size,).
        reached_here: as `reached`.
        starts_here: as `starts`, shape (t + 1,).
    """
    k, last = 0, q.shape[0] - 1
    for c in range(chosen.shape[0]):
        starts_here[c] = k
        m = int(chosen[c])
        for sample in range(int(starts[m]), int(starts[m + 1])):
            samples_here[k], reached_here[k] = samples[sample], reached[sample]
            for four in range(4):
                tick = min(int(samples[sample]) + four, last)
                for j in range(q.shape[1]):
                    rows[4 * k + four, j] = q[tick, j]
            k += 1
    starts_here[chosen.shape[0]] = k


@kernel
def tool_on_segments(
    poses: Array3, starts: Array1, tools: Array3, samples: Array1, path_segments: Array2, on: Array1
) -> None:
    """Put the tools on, and write on which path segments samples lie; see `put_on` and `segment_numbers`."""
    put_on(poses, starts, tools)
    count = int(starts[tools.shape[0]])
    segment_numbers(samples[:count], path_segments, on[:count])


@kernel
def put_on(poses: Array3, starts: Array1, tools: Array3) -> None:
    """Make poses of the tool of those of the flange.

    Args:
        poses: at four ticks in a row from each of k samples on, one behind the other, shape (4·k, 4, 4).
        starts: the first sample of each of m moves, and k, shape (m + 1,).
        tools: the tool frame X_MT of each move, shape (m, 4, 4).
    """
    for m in range(tools.shape[0]):
        tool = tools[m]
        for k in range(4 * int(starts[m]), 4 * int(starts[m + 1])):
            for i in range(3):
                a, b, c = poses[k, i, 0], poses[k, i, 1], poses[k, i, 2]
                for j in range(4):
                    moved = a * tool[0, j] + b * tool[1, j] + c * tool[2, j]
                    poses[k, i, j] = moved + poses[k, i, 3] if j == 3 else moved


@kernel
def segment_numbers(samples: Array1, path_segments: Array2, on: Array1) -> None:
    """Write the numbers of the path segments on which samples lie.

    Args:
        samples: numbers of the ticks that are evaluated, rising, shape (k,).
        path_segments: the last tick before each of them begins, and the last one on it, rising, shape (p, 2).
        on: where the answers go, -1.0 for no path segment, shape (k,).
    """
    path_segment = 0
    for k in range(samples.shape[0]):
        while path_segment < path_segments.shape[0] and path_segments[path_segment, 1] <= samples[k]:
            path_segment += 1
        on[k] = (
            path_segment
            if path_segment < path_segments.shape[0] and path_segments[path_segment, 0] <= samples[k]
            else -1.0
        )


@kernel
def tool_reached(
    poses: Array3,
    starts: Array1,
    on: Array1,
    least: Array3,
    used: Array1,
    counts: Array2,
    longest: Array2,
    idle: Array1,
) -> None:
    """Write at how many samples of each move speed, acceleration and jerk of the tool are at their limits.

    Samples of a move on one path segment are taken together, and so are those that lie on none.

    Args:
        poses: of the tool at four ticks in a row from each of k samples on, in the frame of the path segment,
            one behind the other, shape (4·k, 4, 4).
        starts: the first sample of each of m moves, and k, shape (m + 1,).
        on: number of the path segment on which each sample lies, -1.0 for none, shape (k,).
        least: from which on a step, a change of it, and a change of that count as at the limit: of the
            position [m], then of the orientation [rad], shape (m, 2, 3).
        used: whether another limit is reached at a sample, else 0, shape (k,).
        counts: where the answers go, first of the position, then of the orientation, 0 where that stays the
            same from the first sample on a path segment to the last; shape (m, 6).
        longest: becomes the number of the greatest answer for each move, 0 to 2 for speed, acceleration and
            jerk, and that, shape (m, 2).
        idle: becomes the number of the path segment for a sample at which no limit is reached, else -1.0,
            shape (k,).
    """
    for m in range(least.shape[0]):
        begin, end = int(starts[m]), int(starts[m + 1])
        for i in range(6):
            counts[m, i] = 0.0
        first = begin
        while first < end:
            last = first
            while last + 1 < end and on[last + 1] == on[first]:
                last += 1
            if on[first] >= 0.0:
                _count(poses, on, first, last, least[m], used, counts[m], idle)
            first = last + 1
        while begin < end and on[begin] >= 0.0:
            begin += 1
        while end > begin and on[end - 1] >= 0.0:
            end -= 1
        if begin < end:
            _count(poses, on, begin, end - 1, least[m], used, counts[m], idle)
        longest[m, 0], longest[m, 1] = 0.0, counts[m, 0]
        for i in range(1, 6):
            if counts[m, i] > longest[m, 1]:
                longest[m, 0], longest[m, 1] = i % 3, counts[m, i]


def _count(
    poses: Array, on: Array, first: int, last: int, least: Array, used: Array, counts: Array, idle: Array
) -> None:
    """Count the samples from one to another that lie on the same path segment as these."""
    turns = False
    for i in range(3):
        for j in range(3):
            turns = turns or not abs(poses[4 * first, i, j] - poses[4 * last, i, j]) < TURNED
    for k in range(first, last + 1):
        if on[k] != on[first]:
            continue
        found = used[k]
        for kind in range(2 if turns else 1):
            squares = _squares(poses[4 * k : 4 * k + 4], kind)
            for i in range(3):
                if squares[i] >= least[kind, i] * least[kind, i]:
                    counts[3 * kind + i] += 1.0
                    found = 1.0
        idle[k] = on[k] if found == 0.0 else -1.0


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
    """Return what one axis of the tool does from a tick to the next: its shift, or its small turn."""
    if kind == 0:
        return float(X[tick + 1, axis, 3] - X[tick, axis, 3])
    a, b = (axis + 2) % 3, (axis + 1) % 3
    there, back = 0.0, 0.0
    for c in range(3):
        there += X[tick, c, a] * X[tick + 1, c, b]
        back += X[tick, c, b] * X[tick + 1, c, a]
    return 0.5 * (there - back)
