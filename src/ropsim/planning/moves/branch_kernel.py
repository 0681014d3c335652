"""One branch of the inverse kinematics along a path, in plain loops that numba compiles."""

from math import pi

import numpy as np

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics import inverse_branch, inverse_rows
from ropsim.spatial import Array

TURN = 2.0 * pi


@kernel
def follow_row(
    branches: Array3, q_start: Array1, axes: Array2, close: float, slack: float, q: Array2, result: Array1
) -> None:
    """Write the coordinates of the branch that is nearest to the start, without jumps by whole turns.

    Args:
        branches: of k poses, NaN where absent [rad | m], shape (k, m, n).
        q_start: joint coordinates at the start [rad | m], shape (n,).
        axes: lower and upper limits [rad | m], and 1 for turning ones, else 0, shape (3, n).
        close: greatest step between two poses [rad | m].
        slack: by which a coordinate may be beyond its limit [rad | m].
        q: where the coordinates go, shape (k, n).
        result: set to 1 if all steps are small enough, else 0, and 1 where no coordinate is beyond its limit,
            else 0, shape (2,).
    """
    row = _nearest(branches[0], q_start, axes[2])
    for k in range(branches.shape[0]):
        for j in range(branches.shape[2]):
            q[k, j] = branches[k, row, j]
    unwind(q, q_start, axes, close, slack, result)


@kernel
def follow_wrist(
    arm: Array1,
    axes: Array2,
    close: float,
    slack: float,
    T: Array3,
    q_start: Array1,
    q: Array2,
    rows: Array3,
    work: Array1,
    result: Array1,
) -> None:
    """Write the result of `follow_row` for an arm with spherical wrist, of which only one branch is solved.

    Args:
        arm: as `inverse_rows` takes it.
        axes: as for `follow_row`.
        close: as there.
        slack: as there.
        T: poses X_BM, shape (k, 4, 4).
        q_start: as there.
        q: where the coordinates go [rad | m], shape (k, 6).
        rows: work for branches, shape (1, 8 or more, 6).
        work: to work in, shape (ROOM_OF_ROWS,) or more.
        result: as there, shape (2,) or more.
    """
    for j in range(6):
        work[j] = 0.0
    inverse_rows(arm, work, T[:1], rows)
    nearest_branch(rows[0, :8], q_start, axes[2], result)
    inverse_branch(arm, work, T, int(result[0]), q)
    unwind(q, q_start, axes, close, slack, result)


@kernel
def unwind(q: Array2, q_start: Array1, axes: Array2, close: float, slack: float, result: Array1) -> None:
    """Turn coordinates by whole turns so that they continue the start.

    Args:
        q: of one branch [rad | m], shape (k, n).
        q_start: as for `follow_row`, as all later ones.
        axes: see there.
        close: see there.
        slack: see there.
        result: see there.
    """
    lower, upper, revolute = axes[0], axes[1], axes[2]
    result[0], result[1] = 1.0, 1.0
    for j in range(q.shape[1]):
        before, gone = q_start[j], 0.0
        for k in range(q.shape[0]):
            now = q[k, j]
            step = _turned(now - before, revolute[j])
            if not abs(step) <= close:
                result[0] = 0.0
                return
            gone = step if k == 0 else gone + step
            there = now + revolute[j] * (TURN * np.rint((q_start[j] + gone - now) / TURN))
            if max(lower[j] - there, there - upper[j]) > slack:
                result[1] = 0.0
            q[k, j], before = there, now


@kernel
def nearest_branch(branches: Array2, q: Array1, revolute: Array1, result: Array1) -> None:
    """Write the number of the branch whose largest difference to `q` is the least, whole turns aside.

    Args:
        branches: NaN where absent [rad | m], shape (m, n).
        q: joint coordinates [rad | m], shape (n,).
        revolute: 1 for joints that turn, else 0, shape (n,).
        result: output for the number, shape (1,).
    """
    result[0] = _nearest(branches, q, revolute)


def _nearest(branches: Array, q: Array, revolute: Array) -> int:
    best, least = 0, np.inf
    for i in range(branches.shape[0]):
        most = 0.0
        for j in range(branches.shape[1]):
            step = abs(_turned(branches[i, j] - q[j], revolute[j]))
            most = step if step > most else most
            if not step < np.inf:
                most = np.inf
        if most < least:
            best, least = i, most
    return best


def _turned(step: float, revolute: float) -> float:
    """Return a step without whole turns."""
    return step - revolute * (TURN * float(np.rint(step / TURN)))
