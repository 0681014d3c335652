"""Closed chains followed from one position of the axes to another, in plain loops that numba compiles.

The coordinates z of the chains are a smooth function of those q of the axes where the slopes of the rows by
z have full rank: z' = -Cz⁺·Cq·q'. On the straight way from q to q + d steps are made along the tangent, each
closed by Newton's method. A step is kept where its ends agree with their tangents, z1 - z0 = (z0' + z1')/2 to
a share, so that the chain does not change to another assembly; else it is halved. Where steps become tiny
the chain locks, as at a dead centre. Equations are solved by Householder's reflections with exchange of
columns (Golub & Van Loan 2013, section 5.4.2): redundant rows do no harm, and coordinates that the rows leave
free stay.
"""

from math import sqrt

from ropsim.codegen import Array1, Array2, kernel
from ropsim.kinematics.chain.loop_rows_kernel import (
    LoopArm,
    LoopWork,
    loop_residuals,
    loop_slopes,
    place_ends,
    place_tree,
    spread_state,
)
from ropsim.spatial import Array

CLOSED = 1e-10
"""Rows below this [m, rad] are closed, and on their way to rounding."""
ROUNDED = 1e-15
ROUNDS = 40
"""Most steps of Newton's method in one position; more do not help where the chain does not reach."""
SURE_ROUNDS = 7
"""The same from a good prediction."""
LONGEST = 0.5
"""Longest step of a coordinate in Newton's method, and of one that the chains determine [rad | m]."""
STRIDE = 0.3
"""Longest step of an axis from one closed position to the next at first [rad | m]."""
FAR = 1e9
"""Coordinates and distances beyond this are none [rad | m]."""
LEAST = 1e-7
"""A chain that cannot follow an axis this far is locked [rad | m]."""
AGREED = 0.05
"""Share of a step by which its ends may miss their tangents."""
REFUSED = 3.0
"""Effort of a step that is halved, beyond that of one that is kept."""
DEPENDENT = 1e-11
"""Share of the largest slope below which a column depends on those before it."""


@kernel
def close_rows(arm: LoopArm, Q: Array2, states: Array2, results: Array2, work: LoopWork) -> None:
    """Write the coordinates of axes and loops for axes at rows Q (k, n), each followed from home.

    Args:
        arm: the mechanism.
        Q: coordinates of the axes [rad | m]; a row with NaN gives NaN.
        states: where the coordinates go, shape (k, n + p).
        results: share of the way from home on which the chains follow, 1.0 for all of it; what is left
            between the frames [m, rad], shape (k, 2).
        work: room to work in.
    """
    for k in range(Q.shape[0]):
        results[k, 0] = follow_from_home(arm, states[k], Q[k], work)
        if results[k, 0] < 1.0:
            for i in range(Q.shape[1]):
                states[k, i] = Q[k, i]
            results[k, 1] = closed(arm, states[k], ROUNDS, work)
        else:
            results[k, 1] = loop_residuals(arm, work.ends, work.left[0])


@kernel
def close_along(arm: LoopArm, Q: Array2, states: Array2, results: Array2, work: LoopWork) -> None:
    """Write the coordinates of axes and loops as `close_rows` does, each row followed from the one before.

    The first row of `states` is a closed position from which the first of Q is followed. From the first row
    on that the chains do not reach there is NaN.
    """
    for k in range(Q.shape[0]):
        if k > 0:
            for i in range(states.shape[1]):
                states[k, i] = states[k - 1, i]
        results[k, 0] = follow(arm, states[k], Q[k], work)
        if results[k, 0] != 1.0:
            for i in range(states.shape[1]):
                states[k, i] = float("nan")
        results[k, 1] = loop_residuals(arm, work.ends, work.left[0])


@kernel
def assemble(arm: LoopArm, state: Array1, result: Array1, work: LoopWork) -> None:
    """Close the chains by Newton's method alone, axes held.

    Args:
        arm: the mechanism.
        state: coordinates of axes and loops [rad | m], improved in place, shape (n + p,).
        result: rank of the slopes of the rows by the coordinates of the loops; what is left [m, rad],
            shape (2,).
        work: room to work in.
    """
    result[1] = closed(arm, state, ROUNDS, work)
    result[0] = float(loop_tangents(arm, work))


@kernel
def write_rows(arm: LoopArm, state: Array1, work: LoopWork) -> None:
    """Write values and slopes of all rows at a state (n + p,) to `work.left` and `work.slopes`."""
    evaluate(arm, state, work)
    loop_slopes(arm, work.frames, work.ends, work.slopes)


def follow(arm: LoopArm, state: Array, q: Array, work: LoopWork) -> float:
    """Move a closed state (n + p,) to axes at q (n,) in place; return the share of the way that it follows.

    Where that is less than 1.0 the chain locks, and the state is the last closed one. Else frames and ends in
    `work` belong to the state.
    """
    n, total = q.shape[0], state.shape[0]
    begin, slope, next_slope = work.states[0], work.states[2], work.states[3]
    longest = 0.0
    for i in range(n):
        begin[i], slope[i] = state[i], q[i] - state[i]
        next_slope[i] = slope[i]
        longest = max(longest, abs(slope[i])) if abs(slope[i]) < FAR else float("inf")
    left = evaluate(arm, state, work)
    if not (longest < FAR and left < FAR):
        for i in range(total):
            state[i] = float("nan")
        return 0.0
    rank, share, h = _tangent(arm, slope, n, work), 0.0, 1.0 if longest <= STRIDE else STRIDE / longest
    effort = arm.interface[14]
    while share < 1.0 and effort > 0.0:
        effort -= 1.0
        fastest = 0.0
        for i in range(n, total):
            fastest = max(fastest, abs(slope[i]))
        h = min(h, LONGEST / max(fastest, LONGEST))
        end = 1.0 if share + h >= 1.0 else share + h
        h = end - share
        new, defect = _step(arm, state, q, (end, h, float(rank)), work)
        if new >= 0:
            if new >= rank:
                rank = new
                for i in range(n, total):
                    slope[i] = next_slope[i]
            share = end
            h = h * 1.5 if defect <= 0.2 * AGREED else h
        else:
            h *= 0.5
            effort -= REFUSED
            if h * longest < LEAST:
                return share
    return share


def follow_from_home(arm: LoopArm, state: Array, q: Array, work: LoopWork) -> float:
    """Write the state (n + p,) for axes at q (n,), followed from home; return the share that is followed.

    Where the chain locks on the straight way, one axis is moved after the other, from the first one on, then
    from the last one on. If it locks on all ways, the state is the last closed one on the straight way.
    """
    n, total = q.shape[0], state.shape[0]
    goal, last = work.states[4], work.states[5]
    for i in range(total):
        state[i] = arm.home[i]
    share = follow(arm, state, q, work)
    if share == 1.0 or n == 1 or not abs(state[0]) < FAR or arm.interface[14] < FAR:
        return share
    for i in range(total):
        last[i] = state[i]
    for back in range(2):
        for i in range(total):
            goal[i] = state[i] = arm.home[i]
        for place in range(n):
            axis = n - 1 - place if back == 1 else place
            goal[axis] = q[axis]
            if follow(arm, state, goal[:n], work) < 1.0:
                break
            if place == n - 1:
                return 1.0
    for i in range(total):
        state[i] = last[i]
    return share


def _step(
    arm: LoopArm, state: Array, q: Array, along: tuple[float, float, float], work: LoopWork
) -> tuple[int, float]:
    """Make a step of `follow` where it is sure; return the rank of the rows and the share missed, or -1.

    Args:
        arm: the mechanism.
        state: closed, moved in place, shape (n + p,).
        q: where the way of the axes ends, shape (n,).
        along: share of that way at the end of the step, length of the step, rank at its start.
        work: room to work in, with the tangents of `follow`.
    """
    n, (end, h, before) = q.shape[0], along
    begin, trial, slope, next_slope = work.states[0], work.states[1], work.states[2], work.states[3]
    way = 1e-9
    for i in range(n):
        trial[i] = q[i] if end == 1.0 else begin[i] + end * slope[i]
        way = max(way, h * abs(slope[i]))
    for i in range(n, state.shape[0]):
        trial[i] = state[i] + h * slope[i]
    if not closed(arm, trial, SURE_ROUNDS, work) <= CLOSED:
        return -1, 1.0
    rank, defect = _tangent(arm, next_slope, n, work), 0.0
    for i in range(n, state.shape[0]):
        gone = trial[i] - state[i]
        mean = 0.5 * (slope[i] + next_slope[i]) if float(rank) == before else slope[i]
        way, defect = max(way, abs(gone)), max(defect, abs(gone - h * mean))
    full = before >= arm.interface[13]
    agreed = AGREED if float(rank) == before else 0.5
    if way > 2.0 * LONGEST or (full and defect > agreed * way):
        return -1, 1.0
    for i in range(state.shape[0]):
        state[i] = trial[i]
    return rank, defect / way


def evaluate(arm: LoopArm, state: Array, work: LoopWork) -> float:
    """Place everything at a state (n + p,); return the largest of the rows [m, rad]."""
    spread_state(arm, state, work.steps[0])
    place_tree(arm, work.steps[0], work.frames)
    place_ends(arm, work.frames, work.ends)
    return loop_residuals(arm, work.ends, work.left[0])


def closed(arm: LoopArm, state: Array, rounds: int, work: LoopWork) -> float:
    """Close the chains at a state (n + p,) by steps of Newton's method; return what is left [m, rad]."""
    n = arm.spread.shape[1] - 1 - work.solved.shape[0]
    size = evaluate(arm, state, work)
    for _ in range(rounds):
        if size <= ROUNDED or not size < FAR:
            break
        loop_slopes(arm, work.frames, work.ends, work.slopes)
        _columns_of_loops(arm, n, work)
        for r in range(work.table.shape[0]):
            work.table[r, work.solved.shape[0]] = -work.left[0, r]
        least_squares(work.table, work.solved, 1)
        longest = 0.0
        for i in range(work.solved.shape[0]):
            longest = max(longest, abs(work.solved[i, 0]))
        scale = LONGEST / longest if longest > LONGEST else 1.0
        for i in range(work.solved.shape[0]):
            state[n + i] += scale * work.solved[i, 0]
        before, size = size, evaluate(arm, state, work)
        if size < 1e-12 and size > 0.5 * before:
            break
    return size


def _tangent(arm: LoopArm, slope: Array, n: int, work: LoopWork) -> int:
    """Write z' for the axes' q' at the begin of slope (n + p,) behind them; return the rank of the rows.

    The frames in `work` are those of the position.
    """
    p = work.solved.shape[0]
    loop_slopes(arm, work.frames, work.ends, work.slopes)
    _columns_of_loops(arm, n, work)
    for r in range(work.table.shape[0]):
        total = 0.0
        for k in range(arm.spread.shape[0]):
            if work.slopes[r, k] != 0.0:
                speed = 0.0
                for j in range(n):
                    speed += arm.spread[k, j] * slope[j]
                total += work.slopes[r, k] * speed
        work.table[r, p] = -total
    rank = least_squares(work.table, work.solved, 1)
    for i in range(p):
        slope[n + i] = work.solved[i, 0]
    return rank


def _columns_of_loops(arm: LoopArm, n: int, work: LoopWork) -> None:
    """Write the slopes of the rows by the coordinates of the loops to the first columns of the table."""
    for r in range(work.table.shape[0]):
        for i in range(work.solved.shape[0]):
            work.table[r, i] = 0.0
        for k in range(arm.spread.shape[0]):
            own = work.slopes[r, k]
            if own != 0.0:
                for i in range(work.solved.shape[0]):
                    work.table[r, i] += own * arm.spread[k, n + i]


def loop_tangents(arm: LoopArm, work: LoopWork) -> int:
    """Write dz/dq to the first columns of `work.solved`, shape (p, n); return the rank of the rows.

    The frames in `work` are those of the position; `work.slopes` are written, too.
    """
    p = work.solved.shape[0]
    n = arm.spread.shape[1] - 1 - p
    loop_slopes(arm, work.frames, work.ends, work.slopes)
    _columns_of_loops(arm, n, work)
    _columns_of_axes(arm, n, work)
    return least_squares(work.table, work.solved, n)


def loop_tangents_and_shift(arm: LoopArm, work: LoopWork) -> int:
    """Write dz/dq and, in the column behind, the step of z that closes the chains; return the rank.

    As `loop_tangents`, at a state whose residuals stand in `work.left[0]`.
    """
    p = work.solved.shape[0]
    n = arm.spread.shape[1] - 1 - p
    loop_slopes(arm, work.frames, work.ends, work.slopes)
    _columns_of_loops(arm, n, work)
    _columns_of_axes(arm, n, work)
    for r in range(work.table.shape[0]):
        work.table[r, p + n] = -work.left[0, r]
    return least_squares(work.table, work.solved, n + 1)


def _columns_of_axes(arm: LoopArm, n: int, work: LoopWork) -> None:
    """Write minus the slopes of the rows by the axes behind those by the loops."""
    p = work.solved.shape[0]
    for r in range(work.table.shape[0]):
        for j in range(n):
            work.table[r, p + j] = 0.0
        for k in range(arm.spread.shape[0]):
            own = work.slopes[r, k]
            if own != 0.0:
                for j in range(n):
                    work.table[r, p + j] -= own * arm.spread[k, j]


def loop_accelerations(arm: LoopArm, drift: Array, work: LoopWork) -> None:
    """Write z'' to the first column of `work.solved` where the rows change by `drift` (r,) without it."""
    p = work.solved.shape[0]
    _columns_of_loops(arm, arm.spread.shape[1] - 1 - p, work)
    for r in range(work.table.shape[0]):
        work.table[r, p] = -drift[r]
    least_squares(work.table, work.solved, 1)


def least_squares(table: Array, solved: Array, count: int) -> int:
    """Solve A·x = b for several b, A in the first columns of a table and b behind it; return the rank of A.

    Args:
        table: shape (r, p + count) at least; not kept.
        solved: where the answers go, shape (p, count + 1) at least; the last column takes the order.
        count: of the right sides.
    """
    rows, p, last = table.shape[0], solved.shape[0], solved.shape[1] - 1
    rank, first = 0, 0.0
    for j in range(p):
        solved[j, last] = float(j)
    for step in range(min(rows, p)):
        best, column = -1.0, step
        for j in range(step, p):
            total = 0.0
            for i in range(step, rows):
                total += table[i, j] * table[i, j]
            if total > best:
                best, column = total, j
        norm = sqrt(best)
        first = max(first, norm)
        if not norm > DEPENDENT * first:
            break
        if column != step:
            for i in range(rows):
                table[i, step], table[i, column] = table[i, column], table[i, step]
            solved[step, last], solved[column, last] = solved[column, last], solved[step, last]
        _reflect(table, step, norm, p + count)
        rank += 1
    for c in range(count):
        for i in range(p - 1, -1, -1):
            total = 0.0
            if i < rank:
                total = table[i, p + c]
                for j in range(i + 1, rank):
                    total -= table[i, j] * table[j, p + c]
                total /= table[i, i]
            if i < rows:
                table[i, p + c] = total
            solved[int(solved[i, last]), c] = total
    return rank


def _reflect(table: Array, step: int, norm: float, width: int) -> None:
    """Reflect the rows from a step on so that its column has one number only."""
    rows = table.shape[0]
    alpha = -norm if table[step, step] > 0.0 else norm
    head = table[step, step] - alpha
    factor = -1.0 / (alpha * head)
    for j in range(step + 1, width):
        total = head * table[step, j]
        for i in range(step + 1, rows):
            total += table[i, step] * table[i, j]
        total *= factor
        table[step, j] -= total * head
        for i in range(step + 1, rows):
            table[i, j] -= total * table[i, step]
    table[step, step] = alpha
