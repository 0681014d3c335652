"""Joints that are led along a path of the tool: one branch, its derivatives, how rough it is, in loops."""

from ropsim.codegen import kernel
from ropsim.controller.branch_kernel import follow_row, nearest_branch, unwind
from ropsim.kinematics import inverse_branch, inverse_rows
from ropsim.motion import rows_with_roughness
from ropsim.spatial import Array


@kernel(
    "void(f8[::1], f8[:,::1], f8[:,::1], f8[:,:,::1], f8, f8,"
    " f8[:,:,::1], f8[::1], i8, f8[:,::1], f8[:,::1], f8[:,:,::1], f8[:,:,::1], f8[::1])"
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
    every: int,
    q: Array,
    picked: Array,
    derivatives: Array,
    coarse: Array,
    work: Array,
) -> None:
    """Write what `lead_branch` does for an arm with spherical wrist, of which only one branch is solved.

    Args:
        arm: as `inverse_rows` takes it.
        axes: as for `follow_row`.
        inner: as for `lead_branch`, as all that follow but for the poses.
        sided: see there.
        close: see there.
        slack: see there.
        T: poses X_BM at equidistant places, shape (2·m·every + 1, 4, 4), m >= 7.
        q_start: see there.
        every: see there.
        q: see there.
        picked: see there.
        derivatives: see there.
        coarse: see there.
        work: what is told, as there; shape (3 + m + ROOM_OF_ROWS,).
    """
    m = coarse.shape[1] - 1
    follow_wrist(arm, axes, close, slack, T, q_start, q, coarse[:1], work[3 + m :], work)
    _smooth(inner, sided, every, q, picked, derivatives, coarse, work)


@kernel(
    "void(f8[::1], f8[:,::1], f8, f8, f8[:,:,::1], f8[::1], f8[:,::1], f8[:,:,::1], f8[::1], f8[::1])",
)
def follow_wrist(
    arm: Array,
    axes: Array,
    close: float,
    slack: float,
    T: Array,
    q_start: Array,
    q: Array,
    rows: Array,
    room: Array,
    told: Array,
) -> None:
    """Write what `follow_row` does for an arm with spherical wrist, of which only one branch is solved.

    Args:
        arm: as `inverse_rows` takes it.
        axes: as for `follow_row`.
        close: as there.
        slack: as there.
        T: poses X_BM, shape (k, 4, 4).
        q_start: as there.
        q: where the coordinates go [rad | m], shape (k, 6).
        rows: room for branches, shape (1, 8 or more, 6).
        room: to work in, shape (ROOM_OF_ROWS,) or more.
        told: as there, shape (2,) or more.
    """
    for j in range(6):
        room[j] = 0.0
    inverse_rows(arm, room, T[:1], rows)
    nearest_branch(rows[0, :8], q_start, axes[2], told)
    inverse_branch(arm, room, T, int(told[0]), q)
    unwind(q, q_start, axes, close, slack, told)


@kernel(
    "void(f8[:,::1], f8[:,::1], f8[:,:,::1], f8, f8,"
    " f8[:,:,::1], f8[::1], i8, f8[:,::1], f8[:,::1], f8[:,:,::1], f8[:,:,::1], f8[::1])"
)
def lead_branch(
    axes: Array,
    inner: Array,
    sided: Array,
    close: float,
    slack: float,
    branches: Array,
    q_start: Array,
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
        every: of so many rows one is picked, of which all that follows is said.
        q: where the coordinates go [rad | m], shape (2·m·every + 1, n).
        picked: where those of picked rows go, shape (2·m + 1, n); `q` where all are picked.
        derivatives: where those by the number of the picked row go, shape (2, 2·m + 1, n).
        coarse: room to work in, shape (3, m + 1, n).
        work: its first two numbers become what `follow_row` tells, the third the greatest roughness
            [rad | m]; the others are room, shape (3 + m,) or more.
    """
    follow_row(branches, q_start, axes, close, slack, q, work)
    _smooth(inner, sided, every, q, picked, derivatives, coarse, work)


def _smooth(
    inner: Array,
    sided: Array,
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
    rows_with_roughness(picked, inner, sided, derivatives, coarse[0], coarse[1:], rough)
    work[2] = 0.0
    for k in range(rough.shape[0]):
        work[2] = max(work[2], rough[k])
