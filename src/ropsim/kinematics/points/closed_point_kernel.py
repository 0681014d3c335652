"""The TCP of closed chains brought to points, whatever the orientation, in plain loops that numba compiles.

As `point_rows_kernel.py` and `point_path_kernel.py`, for arms with as many axes as they choose coordinates of
a position. All coordinates of axes and chains are brought there at once, see `closed_newton_kernel.py`; a row
counts where the chains, followed from home, have the TCP at its point.
"""

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics.chain.closed_jacobian_kernel import bias, closed_columns
from ropsim.kinematics.chain.closure_kernel import follow_from_home, least_squares, loop_tangents
from ropsim.kinematics.chain.loop_rows_kernel import LoopArm, LoopWork
from ropsim.kinematics.solutions.closed_newton_kernel import descend_in_all, tool_error
from ropsim.spatial import Array

STEPS = 40
"""Most steps of Newton's method to a point."""
CLOSE = 0.1
"""A row this far from its prediction [rad | m] may be on another branch."""
ROOM = 14
"""Number of rows of the room behind those of `descend`: two states, the right side of derivatives, a table
and its solution, bounds."""


@kernel
def closed_point_rows(
    arm: LoopArm,
    tcp: Array1,
    space: Array2,
    T: Array3,
    Q: Array2,
    bounds: Array2,
    settings: Array1,
    room: Array2,
    work: LoopWork,
    misses: Array2,
) -> None:
    """Bring each row of Q (k, n) to its point, or as near as it comes.

    Args:
        arm: the mechanism.
        tcp: in the interface [m], shape (3,).
        space: basis of the directions in which the TCP moves, shape (d, 3).
        T: the points, in the last column, shape (k, 4, 4).
        Q: starts, then the answers [rad | m].
        bounds: of the axes, shape (2, n).
        settings: 1.0 where each row starts from the one before it, else 0.0, shape (1,).
        room: room to work in, shape (n + 12 + ROOM, w), w at least max(n, 6) + 2 and n + p.
        work: room to work in.
        misses: what is left along the basis and in all [m], and the side of a singular pose, shape (k, 3).
    """
    n, total = Q.shape[1], arm.home.shape[0]
    first = room.shape[0] - ROOM
    state, last = room[first, :total], room[first + 1, :total]
    for k in range(Q.shape[0]):
        if k == 0 or settings[0] == 0.0:
            follow_from_home(arm, state, Q[k], work)
        descend_in_all(arm, T[k], (tcp, 0.0), state, bounds, STEPS, room[:first, : max(n, 6)], work)
        for i in range(n):
            Q[k, i] = state[i]
        misses[k, 0] = misses[k, 1] = 1e300
        misses[k, 2] = 0.0
        if follow_from_home(arm, last, Q[k], work) == 1.0:
            point_misses(space, T[k], tcp, room, work, misses[k])
            loop_tangents(arm, work)
            closed_columns(arm, tcp, work, room)
            misses[k, 2] = side_of(space, room, n)


@kernel
def follow_closed_points(
    arm: LoopArm,
    place: Array2,
    s: Array1,
    T: Array3,
    tool: Array3,
    Q: Array2,
    out: Array3,
    room: Array2,
    work: LoopWork,
    result: Array1,
) -> None:
    """Write coordinates of the axes and their derivatives along a path of the TCP.

    From row to row they are integrated as in `follow_points`, and brought to their points.

    Args:
        arm: the mechanism.
        place: the TCP in the interface [m], below it the basis of its directions, shape (1 + d, 3).
        s: path parameters, rising, shape (k,).
        T: the points, in the last column, shape (k, 4, 4).
        tool: first and second derivatives of the TCP, shape (2, k, 3).
        Q: coordinates at the first row [rad | m]; afterwards at all, shape (k, n).
        out: where their derivatives go, shape (2, k, n).
        room: as in `closed_point_rows`.
        work: room to work in.
        result: largest allowed errors along the basis and in all [m]; the first one is set to -1.0 where a
            row is not reached, singular or maybe on another branch; room to work in, shape (5,).
    """
    n, total, side, tcp, space = Q.shape[1], arm.home.shape[0], 0.0, place[0], place[1:]
    first = room.shape[0] - ROOM
    state, last, ends = room[first, :total], room[first + 1, :total], result[2:]
    within = room[room.shape[0] - 2 :, :n]
    for i in range(n):
        within[0, i], within[1, i] = -1e300, 1e300
    if follow_from_home(arm, state, Q[0], work) != 1.0:
        result[0] = -1.0
        return
    for k in range(Q.shape[0]):
        away, h = 0.0, s[k] - s[k - 1] if k > 0 else 0.0
        for i in range(n):
            if k > 0:
                Q[k, i] = Q[k - 1, i] + h * (out[0, k - 1, i] + 0.5 * h * out[1, k - 1, i])
            state[i] = Q[k, i]
        descend_in_all(arm, T[k], (tcp, 0.0), state, within, STEPS, room[:first, : max(n, 6)], work)
        for i in range(n):
            away = max(away, abs(state[i] - Q[k, i]))
            Q[k, i] = state[i]
        there = away <= CLOSE and follow_from_home(arm, last, Q[k], work) == 1.0
        if there:
            point_misses(space, T[k], tcp, room, work, ends)
            there = ends[0] <= result[0] and ends[1] <= result[1]
        if not there or not _derive(arm, tcp, tool[:, k], out[:, k], room, work):
            result[0] = -1.0
            return
        here = side_of(space, room, n)
        if side * here < 0.0:
            result[0] = -1.0
            return
        side = here if here != 0.0 else side


def point_misses(space: Array, X: Array, tcp: Array, room: Array, work: LoopWork, misses: Array) -> None:
    """Write what is left to a point along the basis and in all [m], where the frames in `work` are placed."""
    m, e, along = work.frames.shape[0] - 1, room[6], 0.0
    misses[1] = tool_error(work, m, X, (tcp, 0.0), e)
    for a in range(space.shape[0]):
        part = space[a, 0] * e[0] + space[a, 1] * e[1] + space[a, 2] * e[2]
        along += part * part
    misses[0] = along**0.5


def side_of(space: Array, J: Array, n: int) -> float:
    """Return the determinant of the Jacobian along the basis, 0.0 where it is not square."""
    d = space.shape[0]
    if n != d:
        return 0.0
    total = 0.0
    if d == 1:
        for r in range(3):
            total += space[0, r] * J[r, 0]
        return total
    if d == 2:  # the determinants of all pairs of rows, weighed as the plane lies (Cauchy, Binet)
        for r in range(3):
            for t in range(r + 1, 3):
                plane = space[0, r] * space[1, t] - space[0, t] * space[1, r]
                total += plane * (J[r, 0] * J[t, 1] - J[r, 1] * J[t, 0])
        return total
    for r in range(3):
        t, u = (r + 1) % 3, (r + 2) % 3
        total += J[0, r] * (J[1, t] * J[2, u] - J[1, u] * J[2, t])
    return total


def _derive(arm: LoopArm, tcp: Array, tool: Array, out: Array, room: Array, work: LoopWork) -> bool:
    """Write both derivatives of the axes (2, n) for those of the TCP (2, 3); return whether there are.

    The frames in `work` are placed; the Jacobian is in the first rows of `room` then.
    """
    n, first = out.shape[1], room.shape[0] - ROOM
    table, solved = room[first + 3 : first + 6, : n + 1], room[first + 6 : first + 6 + n, :2]
    rank, right = loop_tangents(arm, work), room[first + 2, :6]
    if rank < int(arm.interface[13]):
        return False
    closed_columns(arm, tcp, work, room)
    for order in range(2):
        for r in range(3):
            for i in range(n):
                table[r, i] = room[r, i]
            table[r, n] = tool[order, r] - (right[r] if order == 1 else 0.0)
        if least_squares(table, solved, 1) < n:
            return False
        for i in range(n):
            out[order, i] = solved[i, 0]
        if order == 0:
            bias(arm, tcp, out[0], work, right)
    return True
