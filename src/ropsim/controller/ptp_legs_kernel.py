"""Moves from pose to pose one behind another: the joints of each target and their profiles, in one loop."""

from ropsim.codegen import kernel
from ropsim.controller.move_check import MAX_COORDINATE
from ropsim.controller.turns_kernel import rows_inside, turn_rows
from ropsim.kinematics import (
    NEAR_SINGULAR,
    NEIGHBOUR,
    POSES,
    ROOM_OF_ROWS,
    forward_rows,
    inverse_rows,
    wrist_posture,
    write_pose_product,
)
from ropsim.motion import ZERO_LENGTH, plan_together, write_duration
from ropsim.spatial import Array

SIDE = 1e-6
"""A step off a singularity that no drive notices [rad]."""
ROOM = POSES + ROOM_OF_ROWS + 31
"""So many numbers are room to work in."""
SHEETS = 2
"""So many tables of eight rows are room to work in."""


@kernel(
    "void(f8[::1], f8[::1], f8[:,::1], f8, i8, f8[::1], f8[::1],"
    " f8[:,::1], f8[:,:,::1], f8[:,::1], f8[:,:,::1], f8[::1], f8[:,:,::1], f8[:,:,::1], f8[::1])"
)
def choose_ends(
    chain: Array,
    arm: Array,
    axes: Array,
    slack: float,
    in_time: int,
    X_BK: Array,
    X_TM: Array,
    targets: Array,
    limits: Array,
    q: Array,
    shapes: Array,
    told: Array,
    sheets: Array,
    T: Array,
    work: Array,
) -> None:
    """Write where moves of an arm with spherical wrist end, each in the posture in which the one before ends.

    Of branches turned near to the start that of its posture is taken within the limits; where the start
    belongs to two postures, that which is sooner there. It ends at the first move that has no such branch, no
    way or no profile, begins near to a singular pose and to its target at once, or ends where no cell is.

    Args:
        chain: of the arm, as `forward_rows` takes it; its steps are the axes.
        arm: as `inverse_rows` takes it.
        axes: as for `follow_row`.
        slack: by which a coordinate may be beyond its limit [rad].
        in_time: 1 where joints have profiles of their own, else 0.
        X_BK: task frame, position [m] and unit quaternion (w, x, y, z), shape (7,); without numbers (0,)
            where targets are in the base frame.
        X_TM: inverse of the tool, likewise; without numbers where it is none.
        targets: X_KT, likewise, shape (m, 7).
        limits: speed, acceleration and jerk of the joints in each move, shape (m, 3, 6).
        q: the start in the first row; where the ends go, behind it [rad], shape (m + 1, 6).
        shapes: where profiles go, as `plan_together` writes them, shape (m, 3, 6).
        told: becomes the time of each move [s], 1 where joints have one profile together, and 0 for that
            which is not made, behind which nothing is written; shape (m,).
        sheets: room to work in, shape (SHEETS, 8, 6).
        T: room for poses, shape (2, 4, 4).
        work: room to work in, shape (ROOM,).
    """
    X, answer = work[:7], work[7:16]
    branches, turned = sheets[0], sheets[1]
    for i in range(targets.shape[0]):
        told[i] = 0.0
        here, there = q[i], q[i + 1]
        if not _write_target(X_BK, X_TM, targets[i], X, T[0]):
            return
        wrist_posture(arm, here, 0.0, answer)
        if answer[1] < NEAR_SINGULAR and _is_next_to(chain, q[i : i + 1], T, work[31:]):
            return
        room = work[31:]
        for j in range(6):
            room[j] = here[j]
        inverse_rows(arm, room, T[:1], sheets[:1])
        turn_rows(branches, here, axes[0], axes[1], axes[2], slack, turned)
        rows_inside(turned, axes[0], axes[1], slack, work[16:24])
        row = _sooner(arm, here, turned, limits[i], work[16:24], answer)
        if row < 0:
            return
        most = 0.0
        for j in range(6):
            there[j] = turned[row, j]
            work[24 + j] = there[j] - here[j]
            most = max(most, abs(work[24 + j]))
        if not most > ZERO_LENGTH:
            return
        time = 1.0
        if in_time == 1:
            plan_together(work[24:30], limits[i], shapes[i], answer)
            time = answer[0]
        if not time > 0.0:
            return
        told[i] = time


def _write_target(X_BK: Array, X_TM: Array, X_KT: Array, X: Array, T: Array) -> bool:
    """Write the matrix of X_BM; return whether a cell can be there."""
    for j in range(3):
        if not abs(X_KT[j]) <= MAX_COORDINATE:
            return False
    for j in range(7):
        X[j] = X_KT[j]
    if X_BK.shape[0] > 0:
        write_pose_product(X_BK, X_KT, X)
    if X_TM.shape[0] > 0:
        write_pose_product(X, X_TM, X)
    w, x, y, z = X[3], X[4], X[5], X[6]
    T[0, 0], T[0, 1], T[0, 2] = 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)
    T[1, 0], T[1, 1], T[1, 2] = 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)
    T[2, 0], T[2, 1], T[2, 2] = 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)
    T[0, 3], T[1, 3], T[2, 3] = X[0], X[1], X[2]
    T[3, 0] = T[3, 1] = T[3, 2] = 0.0
    T[3, 3] = 1.0
    return True


def _is_next_to(chain: Array, q: Array, T: Array, room: Array) -> bool:
    """Return whether an arm at q stands near to the first pose; its own becomes the second one."""
    forward_rows(chain, q, T[1:2], room)
    most = 0.0
    for i in range(4):
        for j in range(4):
            most = max(most, abs(T[1, i, j] - T[0, i, j]))
    return most <= NEIGHBOUR


def _sooner(arm: Array, q: Array, ends: Array, limits: Array, inside: Array, answer: Array) -> int:
    """Return the row of the posture of q to which it is sooner, -1 where none is inside or takes a time."""
    wrist_posture(arm, q, SIDE, answer)
    first = int(answer[0])
    wrist_posture(arm, q, -SIDE, answer)
    second = int(answer[0])
    first, second = min(first, second), max(first, second)
    if inside[first] == 0.0:
        first = second
    if inside[second] == 0.0:
        second = first
    if inside[first] == 0.0:
        return -1
    if first == second:
        return first
    write_duration(q, ends[first], limits, answer)
    write_duration(q, ends[second], limits, answer[1:])
    if answer[1] < answer[0]:
        return second
    return first if answer[0] >= 0.0 else -1
