"""One branch of the inverse kinematics along a path, in plain loops that numba compiles."""

from math import pi

import numpy as np

from ropsim.codegen import kernel
from ropsim.kinematics import ALL_ROWS, inverse_row
from ropsim.motion import rows_with_roughness
from ropsim.spatial import Array

TURN = 2.0 * pi


@kernel("void(f8[:,:,::1], f8[::1], f8[:,::1], f8, f8, f8[:,::1], f8[::1])")
def follow_row(
    branches: Array, q_start: Array, axes: Array, close: float, slack: float, q: Array, told: Array
) -> None:
    """Write the coordinates of the branch that is nearest to the start, without jumps by whole turns.

    Args:
        branches: of k poses, NaN where absent [rad | m], shape (k, m, n).
        q_start: joint coordinates at the start [rad | m], shape (n,).
        axes: lower and upper limits [rad | m], and 1 for those that turn, else 0, shape (3, n).
        close: greatest step between two poses [rad | m].
        slack: by which a coordinate may be beyond its limit [rad | m].
        q: where the coordinates go, shape (k, n).
        told: becomes 1 where all steps are so small, else 0, and 1 where no coordinate is beyond its limit,
            else 0, shape (2,).
    """
    row = _nearest(branches[0], q_start, axes[2])
    for k in range(branches.shape[0]):
        for j in range(branches.shape[2]):
            q[k, j] = branches[k, row, j]
    _unwind(q, q_start, axes, close, slack, told)


@kernel(
    "void(f8[::1], f8[:,::1], f8[:,::1], f8[:,:,::1], f8, f8,"
    " f8[:,:,::1], f8[::1], f8, i8, f8[:,::1], f8[:,::1], f8[:,:,::1], f8[:,:,::1], f8[::1])"
)
def lead_wrist(
    arm: Array,
    axes: Array,
    inner: Array,
    sided: Array,
    close: float,
    slack: float,
    T: Array,
    q_start: Array,
    length: float,
    every: int,
    q: Array,
    picked: Array,
    derivatives: Array,
    coarse: Array,
    work: Array,
) -> None:
    """Write what `lead_branch` does for an arm with spherical wrist, of which only one branch is solved.

    Args:
        arm: as `inverse_row` takes it.
        axes: as for `follow_row`.
        inner: as for `lead_branch`, as all that follow but for the poses.
        sided: see there.
        close: see there.
        slack: see there.
        T: poses X_BM at equidistant places, shape (2·m·every + 1, 4, 4), m >= 7.
        q_start: see there.
        length: see there.
        every: see there.
        q: see there.
        picked: see there.
        derivatives: see there.
        coarse: see there.
        work: what is told, as there; shape (3 + m + ROOM_OF_ROWS,).
    """
    m = coarse.shape[1] - 1
    room, rows = work[3 + m :], coarse[0][:8]
    for j in range(6):
        room[j] = 0.0
    inverse_row(arm, room, T[0], ALL_ROWS, rows)
    row = _nearest(rows, q_start, axes[2])
    for k in range(T.shape[0]):
        if k > 0:
            inverse_row(arm, room, T[k], row, rows)
        for j in range(6):
            q[k, j] = rows[row, j]
    _unwind(q, q_start, axes, close, slack, work)
    _smooth(inner, sided, length, every, q, picked, derivatives, coarse, work)


@kernel(
    "void(f8[:,::1], f8[:,::1], f8[:,:,::1], f8, f8,"
    " f8[:,:,::1], f8[::1], f8, i8, f8[:,::1], f8[:,::1], f8[:,:,::1], f8[:,:,::1], f8[::1])"
)
def lead_branch(
    axes: Array,
    inner: Array,
    sided: Array,
    close: float,
    slack: float,
    branches: Array,
    q_start: Array,
    length: float,
    every: int,
    q: Array,
    picked: Array,
    derivatives: Array,
    coarse: Array,
    work: Array,
) -> None:
    """Write what `follow_row` does, the derivatives of its rows, and how rough the way through them is.

    Args:
        axes: as for `follow_row`.
        inner: weights of the differences as for `rows_with_roughness`.
        sided: likewise.
        close: as for `follow_row`.
        slack: as there.
        branches: of poses at equidistant places, as there, shape (2·m·every + 1, b, n).
        q_start: as there.
        length: of the way from the first pose to the last.
        every: of so many rows one is picked, of which all that follows is said.
        q: where the coordinates go [rad | m], shape (2·m·every + 1, n).
        picked: where those of picked rows go, shape (2·m + 1, n); `q` where all are picked.
        derivatives: where those by the number of the picked row go, shape (2, 2·m + 1, n).
        coarse: room to work in, shape (3, m + 1, n).
        work: its first two numbers become what `follow_row` tells, the third the greatest roughness
            [rad | m]; the others are room, shape (3 + m,) or more.
    """
    follow_row(branches, q_start, axes, close, slack, q, work)
    _smooth(inner, sided, length, every, q, picked, derivatives, coarse, work)


@kernel("void(f8[:,::1], f8[::1], f8[::1], f8[::1])")
def nearest_branch(branches: Array, q: Array, revolute: Array, told: Array) -> None:
    """Write the number of the branch whose largest difference to `q` is the least, whole turns aside.

    Args:
        branches: NaN where absent [rad | m], shape (m, n).
        q: joint coordinates [rad | m], shape (n,).
        revolute: 1 for joints that turn, else 0, shape (n,).
        told: where the number goes, shape (1,).
    """
    told[0] = _nearest(branches, q, revolute)


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


def _unwind(q: Array, q_start: Array, axes: Array, close: float, slack: float, told: Array) -> None:
    """Turn coordinates by whole turns so that they continue the start, see `follow_row`."""
    lower, upper, revolute = axes[0], axes[1], axes[2]
    told[0], told[1] = 1.0, 1.0
    for j in range(q.shape[1]):
        before, gone = q_start[j], 0.0
        for k in range(q.shape[0]):
            now = q[k, j]
            step = _turned(now - before, revolute[j])
            if not abs(step) <= close:
                told[0] = 0.0
                return
            gone = step if k == 0 else gone + step
            there = now + revolute[j] * (TURN * np.rint((q_start[j] + gone - now) / TURN))
            if max(lower[j] - there, there - upper[j]) > slack:
                told[1] = 0.0
            q[k, j], before = there, now


def _smooth(
    inner: Array,
    sided: Array,
    length: float,
    every: int,
    q: Array,
    picked: Array,
    derivatives: Array,
    coarse: Array,
    work: Array,
) -> None:
    if work[0] == 0.0:
        return
    if every > 1:
        for k in range(picked.shape[0]):
            for j in range(q.shape[1]):
                picked[k, j] = q[every * k, j]
    rough = work[3 : 2 + coarse.shape[1]]
    rows_with_roughness(picked, inner, sided, length, derivatives, coarse[0], coarse[1:], rough)
    work[2] = 0.0
    for k in range(rough.shape[0]):
        work[2] = max(work[2], rough[k])


def _turned(step: float, revolute: float) -> float:
    """Return a step without whole turns."""
    return step - revolute * (TURN * float(np.rint(step / TURN)))
