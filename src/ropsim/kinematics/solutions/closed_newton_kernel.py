"""Closed chains brought to a pose of the tool in all coordinates at once, in loops that numba compiles.

Newton's method on the rows of the cuts and the error of the tool together: with Cz·dz = -c - Cq·dq the
chains leave dz = z₀ + K·dq, and the error e of the tool asks for J·dq = e - Js·P·z₀ (J = Js·(T + P·K)). The
chains are open on the way and closed at its end, so that a step costs one solution of the rows where
`descend_closed` follows the chains from position to position. An answer may be in another assembly than
home, which a check that follows it from there finds out.
"""

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics.chain.closed_jacobian_kernel import closed_columns
from ropsim.kinematics.chain.closure_kernel import evaluate, follow_from_home, loop_tangents_and_shift
from ropsim.kinematics.chain.loop_rows_kernel import LoopArm, LoopWork
from ropsim.kinematics.solutions.polish_kernel import (
    GOAL,
    LONGEST_STEP,
    STALLS,
    bounded_step,
    entry_errors,
    pose_error,
    principal,
)
from ropsim.spatial import Array

LESS = 0.9
"""Share of the least error so far above which a step is no progress."""
DAMPED, MOST_DAMPED = 1e-3, 1e4
"""Damping of a step over the square of the error: at least, and where steps do not help."""
SAME = 1e-7
"""Answers nearer to each other than this need one check [rad | m]."""


@kernel
def newton_rows(
    arm: LoopArm,
    turning: Array1,
    T: Array3,
    Q: Array3,
    bounds: Array2,
    settings: Array1,
    starts: Array3,
    room: Array2,
    work: LoopWork,
) -> None:
    """Write answers for poses X_BM in T (k, 4, 4) from closed starts to Q (k, j, n), NaN where none is found.

    Args:
        arm: the mechanism, with n axes.
        turning: 1.0 for axes whose whole turns change nothing, shape (n,).
        T: poses.
        Q: where the axes go [rad | m].
        bounds: lower and upper bounds of the axes, shape (2, n).
        settings: number of steps, largest sum of the errors, 0.0 for angles in (-π, π].
        starts: coordinates of axes and loops (1 + k, j, n + p), from the second on; the first row of the
            first one is room to work in.
        room: room to work in, shape (n + 12, max(n, 6)).
        work: room to work in.
    """
    n, m, still, last = Q.shape[2], arm.steps.shape[0], work.spare[0], starts[0, 0]
    for k in range(Q.shape[0]):
        for j in range(Q.shape[1]):
            state = starts[1 + k, j]
            for i in range(3):
                still[i] = 0.0
            found = descend_in_all(arm, T[k], (still, 1.0), state, bounds, int(settings[0]), room, work)
            q, known = Q[k, j], False
            for i in range(n):
                q[i] = state[i]
                if turning[i] > 0.0 and settings[2] == 0.0:
                    q[i] = principal(state[i])
            there = found <= settings[1]
            for other in range(j):
                apart = 0.0
                for i in range(n):
                    apart = max(apart, abs(Q[k, other, i] - q[i]))
                known = known or apart < SAME
            there = there and not known and follow_from_home(arm, last, q, work) == 1.0
            there = there and entry_errors(work.frames[m], T[k]) <= settings[1]
            for i in range(n):
                if not there:
                    q[i] = float("nan")


def descend_in_all(
    arm: LoopArm,
    X: Array,
    tool: tuple[Array, float],
    state: Array,
    bounds: Array,
    steps: int,
    room: Array,
    work: LoopWork,
) -> float:
    """Bring a state (n + p,) to a pose of the tool in place; return what is left of rows and pose.

    Args:
        arm: the mechanism.
        X: the pose, shape (4, 4).
        tool: place of the TCP in the interface [m], and 1.0, or 0.0 where its orientation does not count.
        state: near to a closed one; axes within the bounds.
        bounds: shape (2, n).
        steps: most of them.
        room: as in `descend`.
        work: room to work in.
    """
    n, p, m, e = bounds.shape[1], work.solved.shape[0], arm.steps.shape[0], room[6]
    p_MT, counts = tool
    best, stalls, left, damping = 1e300, 0, 0.0, DAMPED
    for step in range(steps + 1):
        left = evaluate(arm, state, work) + tool_error(work, m, X, tool, e)
        if left <= GOAL or not left < 1e300 or step == steps:
            break
        stalls = stalls + 1 if left > LESS * best else 0
        damping = min(damping * 10.0, MOST_DAMPED) if left > best else max(damping * 0.1, DAMPED)
        best = min(best, left)
        if stalls > STALLS or (stalls > 0 and best < 1e-12):
            break
        loop_tangents_and_shift(arm, work)
        closed_columns(arm, p_MT, work, room)
        for i in range(m):  # how the chains move the tool while they close
            if arm.ways[i, 1] != 0.0:
                shift = 0.0
                for c in range(p):
                    shift += arm.spread[i, n + c] * work.solved[c, n]
                for r in range(6):
                    e[r] -= work.columns[r, i] * shift
        for r in range(3, 6):
            e[r] *= counts
            for i in range(n):
                room[r, i] *= counts
        longest = bounded_step(room, state, bounds, damping * min(left, 1.0) * left)
        for c in range(p):
            move = work.solved[c, n]
            for i in range(n):
                move += work.solved[c, i] * room[7, i]
            work.states[0, c] = move
            longest = max(longest, abs(move))
        scale = LONGEST_STEP / longest if longest > LONGEST_STEP else 1.0
        for i in range(n):
            state[i] = min(max(state[i] + scale * room[7, i], bounds[0, i]), bounds[1, i])
        for c in range(p):
            state[n + c] += scale * work.states[0, c]
    return left


def tool_error(work: LoopWork, m: int, X: Array, tool: tuple[Array, float], e: Array) -> float:
    """Write the error of the tool against a pose to e (6,); return the length of what counts [m, rad]."""
    p_MT, counts = tool
    M, at = work.frames[m], work.spare[1]
    for i in range(9):
        at[i] = M[i]
    for r in range(3):
        at[9 + r] = M[9 + r] + M[3 * r] * p_MT[0] + M[3 * r + 1] * p_MT[1] + M[3 * r + 2] * p_MT[2]
    length = pose_error(at, X, e)
    if counts > 0.0:
        return length
    return float((e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) ** 0.5)
