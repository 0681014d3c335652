"""Axes of closed chains brought to their poses by Levenberg and Marquardt, in loops that numba compiles.

As `polish_kernel.py`, with the Jacobian of the closed chain; each step of the axes is followed by the chain
from where it is. An answer counts if the chain, followed from home to it, has the interface at the pose: so
forward kinematics of every answer gives its pose, in the assembly of the rest position.
"""

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics.chain.closed_jacobian_kernel import closed_columns
from ropsim.kinematics.chain.closure_kernel import evaluate, follow, follow_from_home, loop_tangents
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


@kernel
def closed_polish_rows(
    arm: LoopArm,
    turning: Array1,
    T: Array3,
    Q: Array3,
    bounds: Array2,
    settings: Array1,
    states: Array2,
    room: Array2,
    work: LoopWork,
) -> None:
    """Bring every row of Q (k, j, n) to its pose X_BM in T (k, 4, 4), or make it NaN.

    Args:
        arm: the mechanism, with n axes.
        turning: 1.0 for axes whose whole turns change nothing, shape (n,).
        T: poses.
        Q: starts, NaN rows are left alone; answers [rad | m].
        bounds: as of `polish_rows`, and likewise the settings.
        settings: number of steps, largest sum of the errors, how answers follow their starts.
        states: room to work in, shape (j + 2, n + p).
        room: room to work in, shape (n + 12, max(n, 6)).
        work: room to work in.
    """
    n, m = Q.shape[2], arm.steps.shape[0]
    steps, slack = int(settings[0]), settings[1]
    for k in range(Q.shape[0]):
        for j in range(Q.shape[1]):
            state, last = states[2 + j], states[1]
            continued = settings[2] == 1.0 and k > 0
            if continued:
                for i in range(n):
                    Q[k, j, i] = Q[k - 1, j, i]
            if Q[k, j, 0] != Q[k, j, 0]:
                continue
            if steps > 0:
                if not continued:
                    follow_from_home(arm, state, Q[k, j], work)
                descend_closed(arm, T[k], state, states[0], bounds, steps, room, work)
                for i in range(n):
                    Q[k, j, i] = state[i]
                    if turning[i] > 0.0 and settings[2] == 0.0:
                        Q[k, j, i] = principal(state[i])
            found = follow_from_home(arm, last, Q[k, j], work) == 1.0
            found = found and entry_errors(work.frames[m], T[k]) <= slack
            for i in range(n):
                if not found:
                    Q[k, j, i] = float("nan")


def descend_closed(
    arm: LoopArm,
    X: Array,
    state: Array,
    trial: Array,
    bounds: Array,
    steps: int,
    room: Array,
    work: LoopWork,
) -> None:
    """Improve a closed state (n + p,) in place, its axes within the bounds (2, n).

    Rows of `room` are those of `descend`.
    """
    n, m, still = bounds.shape[1], arm.steps.shape[0], work.spare[0]
    e, goal = room[6], room[8]
    for i in range(3):
        still[i] = 0.0
    evaluate(arm, state, work)
    error = pose_error(work.frames[m], X, e)
    mu, stalls = 1.0, 0
    for _ in range(steps):
        if error <= GOAL or stalls > STALLS:
            break
        loop_tangents(arm, work)
        closed_columns(arm, still, work, room)
        helped, tried = False, error
        for _ in range(12):
            longest = bounded_step(room, state, bounds, mu * error)
            scale = LONGEST_STEP / longest if longest > LONGEST_STEP else 1.0
            for i in range(n):
                goal[i] = min(max(state[i] + scale * room[7, i], bounds[0, i]), bounds[1, i])
            for i in range(state.shape[0]):
                trial[i] = state[i]
            follow(arm, trial, goal[:n], work)
            evaluate(arm, trial, work)
            tried = pose_error(work.frames[m], X, room[9])
            if tried < error:
                helped = True
                break
            mu = 1e-3 if mu < 1e-3 else mu * 8.0
        if not helped:
            break
        stalls = stalls + 1 if tried > 0.995 * error else 0
        mu *= 0.1
        for i in range(state.shape[0]):
            state[i] = trial[i]
        error = pose_error(work.frames[m], X, e)
