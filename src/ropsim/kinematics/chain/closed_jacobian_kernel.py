"""Jacobians of closed chains, and motions along them, in plain loops that numba compiles.

The steps are at s = T·q + P·z(q) + c, their speeds (T + P·dz/dq)·q'. With the Jacobian Js of the steps,
that of the axes is J = Js·(T + P·dz/dq). Accelerations add what the rows of the cuts change without any: z''
solves Cz·z'' = -(Cq·q'' + drift).
"""

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics.chain.closure_kernel import (
    evaluate,
    loop_accelerations,
    loop_tangents,
)
from ropsim.kinematics.chain.loop_rows_kernel import LoopArm, LoopWork, carried, loop_drift, step_motion
from ropsim.kinematics.chain.path_derivatives_kernel import DerivativeWork, holds, invert, solve_pivots
from ropsim.spatial import Array


@kernel
def closed_frames_and_jacobians(
    arm: LoopArm, states: Array2, p_MT: Array1, frames: Array2, J: Array3, work: LoopWork
) -> None:
    """Write frames of the interface, and Jacobians of a point of it, at closed states (k, n + p).

    Args:
        arm: the mechanism.
        states: coordinates of axes and loops [rad | m].
        p_MT: the point in the interface [m], shape (3,).
        frames: R by rows and p of the interface, shape (k, 12).
        J: shape (k, 6, n).
        work: room to work in.
    """
    m = arm.steps.shape[0]
    for k in range(states.shape[0]):
        evaluate(arm, states[k], work)
        loop_tangents(arm, work)
        M = work.frames[m]
        for i in range(12):
            frames[k, i] = M[i]
        closed_columns(arm, p_MT, work, J[k])


@kernel
def closed_coordinates(arm: LoopArm, states: Array2, rates: Array3, out: Array3, work: LoopWork) -> None:
    """Write first and second derivatives of the coordinates of the loops at closed states (k, n + p).

    Args:
        arm: the mechanism.
        states: coordinates of axes and loops [rad | m].
        rates: first and second derivatives of the axes, shape (2, k, n).
        out: where those of the loops go, shape (2, k, p).
        work: room to work in.
    """
    p = work.solved.shape[0]
    for k in range(states.shape[0]):
        evaluate(arm, states[k], work)
        loop_tangents(arm, work)
        for i in range(p):
            out[0, k, i] = 0.0
            for j in range(rates.shape[2]):
                out[0, k, i] += work.solved[i, j] * rates[0, k, j]
        _step_rates(arm, rates[0, k], out[0, k], work.steps[1])
        _step_rates(arm, rates[1, k], out[0, k, :0], work.steps[2])
        step_motion(arm, work.frames, work.steps, work.motion)
        loop_drift(arm, work, work.left[1])
        loop_accelerations(arm, work.left[1], work)
        for i in range(p):
            out[1, k, i] = work.solved[i, 0]


def _step_rates(arm: LoopArm, rates: Array, loops: Array, steps: Array) -> None:
    """Write derivatives of the steps (m,) from those of the axes (n,) and of the loops, (p,) or none."""
    n = rates.shape[0]
    for i in range(steps.shape[0]):
        total = 0.0
        for j in range(n):
            total += arm.spread[i, j] * rates[j]
        for j in range(loops.shape[0]):
            total += arm.spread[i, n + j] * loops[j]
        steps[i] = total


def closed_columns(arm: LoopArm, p_MT: Array, work: LoopWork, J: Array) -> None:
    """Write the Jacobian of a point of the interface to the first six rows of J.

    `work` has the frames of the position, and dz/dq in `solved`.
    """
    p = work.solved.shape[0]
    n, m = arm.spread.shape[1] - 1 - p, arm.steps.shape[0]
    M, columns = work.frames[m], work.columns
    px = M[9] + M[0] * p_MT[0] + M[1] * p_MT[1] + M[2] * p_MT[2]
    py = M[10] + M[3] * p_MT[0] + M[4] * p_MT[1] + M[5] * p_MT[2]
    pz = M[11] + M[6] * p_MT[0] + M[7] * p_MT[1] + M[8] * p_MT[2]
    for i in range(m):
        X, slides = work.frames[i], arm.steps[i, 12]
        on_way = arm.ways[i, 1]
        ax, ay, az = on_way * X[2], on_way * X[5], on_way * X[8]
        if slides != 0.0:
            columns[0, i], columns[1, i], columns[2, i] = ax, ay, az
            columns[3, i] = columns[4, i] = columns[5, i] = 0.0
        else:
            x, y, z = px - X[9], py - X[10], pz - X[11]
            columns[0, i], columns[1, i], columns[2, i] = ay * z - az * y, az * x - ax * z, ax * y - ay * x
            columns[3, i], columns[4, i], columns[5, i] = ax, ay, az
    for j in range(n):
        for r in range(6):
            J[r, j] = 0.0
        for i in range(m):
            if arm.ways[i, 1] != 0.0:
                speed = arm.spread[i, j]
                for c in range(p):
                    speed += arm.spread[i, n + c] * work.solved[c, j]
                for r in range(6):
                    J[r, j] += columns[r, i] * speed


@kernel
def closed_derivatives_along(
    arm: LoopArm,
    states: Array2,
    active: Array1,
    p_MT: Array1,
    tool: Array3,
    out: Array3,
    work: LoopWork,
    room: DerivativeWork,
    result: Array1,
) -> None:
    """Write first and second derivatives of the axes at closed states (k, n + p) on a path of the tool.

    Args:
        arm: the mechanism.
        states: coordinates of axes and loops [rad | m].
        active: 1.0 for axes that move the tool, at most six; 0.0 for those that stand still, shape (n,).
        p_MT: TCP in the interface [m], shape (3,).
        tool: first and second derivatives of position and angular velocity, shape (2, k, 6).
        out: where the derivatives of the axes go, shape (2, k, n).
        work: room to work in.
        room: of `derivatives_along`.
        result: set to 1.0, or to 0.0 where a row is near a singularity, shape (1,).
    """
    columns, right, n = room.columns, room.vectors[4], active.shape[0]
    result[0] = 1.0
    for k in range(states.shape[0]):
        evaluate(arm, states[k], work)
        rank = loop_tangents(arm, work)
        closed_columns(arm, p_MT, work, columns)
        if rank < int(arm.interface[13]) or invert(active, columns, room.solved, room.vectors) < -1:
            result[0] = 0.0
            return
        for r in range(6):
            right[r] = tool[0, k, r]
        solve_pivots(room.solved, room.vectors, n, out[0, k])
        bias(arm, p_MT, out[0, k], work, room.vectors[1])
        for r in range(6):
            right[r] = tool[1, k, r] - room.vectors[1, r]
        solve_pivots(room.solved, room.vectors, n, out[1, k])
        if not holds(columns, out[0, k], out[1, k], tool[0, k], right):
            result[0] = 0.0
            return


def bias(arm: LoopArm, p_MT: Array, rates: Array, work: LoopWork, out: Array) -> None:
    """Write J'·q' of a point of the interface, shape (6,); `work` has frames and dz/dq of the position."""
    p, n, m = work.solved.shape[0], rates.shape[0], arm.steps.shape[0]
    speeds = work.states[4]
    for i in range(p):
        speeds[i] = 0.0
        for j in range(n):
            speeds[i] += work.solved[i, j] * rates[j]
    _step_rates(arm, rates, speeds[:p], work.steps[1])
    for i in range(m):
        work.steps[2, i] = 0.0
    step_motion(arm, work.frames, work.steps, work.motion)
    loop_drift(arm, work, work.left[1])
    loop_accelerations(arm, work.left[1], work)
    for i in range(m):
        for j in range(p):
            work.steps[2, i] += arm.spread[i, n + j] * work.solved[j, 0]
    step_motion(arm, work.frames, work.steps, work.motion)
    carrier = int(arm.interface[0])
    for r in range(6):
        out[r] = 0.0
    if carrier < 0:
        return
    M, tcp, found = work.frames[m], work.spare[0], work.spare[1]
    for r in range(3):
        tcp[9 + r] = M[9 + r] + M[3 * r] * p_MT[0] + M[3 * r + 1] * p_MT[1] + M[3 * r + 2] * p_MT[2]
    carried(work.motion[carrier], work.frames[carrier], tcp, found)
    for r in range(3):
        out[r], out[3 + r] = found[9 + r], found[6 + r]
