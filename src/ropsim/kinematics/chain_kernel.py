"""The chain of an arm in plain loops that numba compiles: forward kinematics, and Newton's steps to poses.

The steps are for six turning joints whose model is off its class by rounding, and whose closed form thus
gives nearly an answer: J·Δq = e with the geometric Jacobian and the error e of `polish_kernel.py`, of which
the small angles are the vector part. A step leaves an error of at most half of the second derivative of the
pose times the squares of Δq, so that after one below `SURE` nothing has to be looked at again.
"""

from math import ceil, inf, nan, pi

from ropsim.codegen import kernel
from ropsim.spatial import Array

PER_QUARTER = 0.6366197723675814
"""2/π: so many quarter turns has an angle of 1 rad."""
ROUNDING = 6755399441055744.0
"""1.5·2^52: a number added to it and taken away again is rounded to a whole one."""
HIGH, MIDDLE, LOW = 1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21
"""π/2 in three parts; the first two end in zeros: up to 2^20 times them is exact (Cody & Waite 1980)."""
S1, S2, S3 = -1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04
S4, S5, S6 = 2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10
C1, C2, C3 = 4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05
C4, C5, C6 = -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11
"""Sine and cosine up to π/4 to less than a unit of the last place (FDLIBM of Sun Microsystems, 1993)."""
SURE = 1e-7
"""A step whose joints move less [rad] leaves less than 1e-12 [m, rad] on arms of some metres."""
MOST = 1e-3
"""A step that would move a joint farther [rad] is left to the search that can do with bad starts."""
STEPS = 3
BENT = 1e-9
"""A matrix whose turn from the arm's frame is farther from a rotation [sum of entries] is no pose."""
SMALL = 1e-2
"""Pivots [m, 1] above this are taken as they come: of a step a few digits are enough."""


@kernel("void(f8[::1], f8[:,::1], f8[:,:,::1])")
def forward_rows(chain: Array, Q: Array, out: Array) -> None:
    """Write X_BM of every row of Q (k, n) to out (k, 4, 4).

    The pose on the way is twelve numbers that stay in registers: its axes a, b, c and its origin p.

    Args:
        chain: `ChainArrays.flat`, shape (14·n + 12,).
        Q: coordinates of the steps [rad | m].
        out: homogeneous matrices.
    """
    n = Q.shape[1]
    for k in range(Q.shape[0]):
        ax, ay, az = chain[0], chain[3], chain[6]
        bx, by, bz = chain[1], chain[4], chain[7]
        cx, cy, cz = chain[2], chain[5], chain[8]
        px, py, pz = chain[9], chain[10], chain[11]
        for i in range(n):
            at = 14 * i
            turn = Q[k, i] + chain[at + 13]
            slide = turn * chain[at + 12]
            turn -= slide
            px, py, pz = px + cx * slide, py + cy * slide, pz + cz * slide
            co, si = _cos_sin(turn)
            ax, bx = ax * co + bx * si, bx * co - ax * si
            ay, by = ay * co + by * si, by * co - ay * si
            az, bz = az * co + bz * si, bz * co - az * si
            at += 14  # the next step, or the interface, whose rows have the same places
            p0, p1, p2 = chain[at], chain[at + 1], chain[at + 2]
            p3, p4, p5 = chain[at + 3], chain[at + 4], chain[at + 5]
            p6, p7, p8 = chain[at + 6], chain[at + 7], chain[at + 8]
            t0, t1, t2 = chain[at + 9], chain[at + 10], chain[at + 11]
            px, py, pz = (
                px + (ax * t0 + bx * t1 + cx * t2),
                py + (ay * t0 + by * t1 + cy * t2),
                pz + (az * t0 + bz * t1 + cz * t2),
            )
            ax, bx, cx = (
                ax * p0 + bx * p3 + cx * p6,
                ax * p1 + bx * p4 + cx * p7,
                ax * p2 + bx * p5 + cx * p8,
            )
            ay, by, cy = (
                ay * p0 + by * p3 + cy * p6,
                ay * p1 + by * p4 + cy * p7,
                ay * p2 + by * p5 + cy * p8,
            )
            az, bz, cz = (
                az * p0 + bz * p3 + cz * p6,
                az * p1 + bz * p4 + cz * p7,
                az * p2 + bz * p5 + cz * p8,
            )
        X = out[k]
        X[0, 0], X[0, 1], X[0, 2], X[0, 3] = ax, bx, cx, px
        X[1, 0], X[1, 1], X[1, 2], X[1, 3] = ay, by, cy, py
        X[2, 0], X[2, 1], X[2, 2], X[2, 3] = az, bz, cz, pz
        X[3, 0] = X[3, 1] = X[3, 2] = 0.0
        X[3, 3] = 1.0


@kernel("void(f8[::1], f8[:,:,::1], f8[:,:,::1], f8[:,::1], f8[:,::1], f8[:,::1])")
def refine_rows(chain: Array, T: Array, Q: Array, unsure: Array, frames: Array, room: Array) -> None:
    """Bring every row of Q (k, m, 6) to its pose X_BM in T (k, 4, 4).

    Args:
        chain: `ChainArrays.flat` of an arm with six turning joints.
        T: poses.
        Q: starts, NaN rows are left alone; answers, angles in (-π, π] [rad].
        unsure: 1.0 for rows that are left at their start, as no step was small enough to be sure, else 0.0;
            the last row has one entry that counts them; shape (k + 1, m).
        frames: room to work in, shape (7, 12).
        room: room to work in, shape (7, 7).
    """
    last = Q.shape[0]
    room[6, 0], unsure[last, 0] = nan, 0.0
    for k in range(last):
        for j in range(Q.shape[1]):
            q = Q[k, j]
            unsure[k, j] = 0.0
            if q[0] != q[0]:
                continue
            first = 0  # frames that the row before has, too, stay
            while first < 6 and q[first] == room[6, first]:
                first += 1
            for i in range(6):
                room[6, i] = q[i]
            sure, steps = False, 0
            while not sure and steps < STEPS:
                steps += 1
                _place(chain, q, first, frames)
                step = _step(frames, T[k], room)
                if not step < MOST:
                    break
                first, sure = 0, step < SURE
                for i in range(6):
                    q[i] = q[i] + room[i, 6]
            if not sure:
                unsure[k, j] = 1.0
                unsure[last, 0] += 1.0
            for i in range(6):
                q[i] = _principal(q[i]) if sure else room[6, i]
            if steps > 1:  # the frames are no longer those of the start
                room[6, 0] = nan


def _place(chain: Array, q: Array, first: int, frames: Array) -> None:
    """Write the frames of joints from the first one that moved, and of the interface, to frames (7, 12)."""
    for i in range(first, 7):
        at = 14 * i
        p0, p1, p2, p3, p4 = chain[at], chain[at + 1], chain[at + 2], chain[at + 3], chain[at + 4]
        p5, p6, p7, p8 = chain[at + 5], chain[at + 6], chain[at + 7], chain[at + 8]
        t0, t1, t2 = chain[at + 9], chain[at + 10], chain[at + 11]
        X = frames[i]
        if i == 0:
            X[0], X[1], X[2], X[3], X[4], X[5], X[6], X[7], X[8] = p0, p1, p2, p3, p4, p5, p6, p7, p8
            X[9], X[10], X[11] = t0, t1, t2
        else:
            W = frames[i - 1]
            for r in range(3):
                a, b, c = W[3 * r], W[3 * r + 1], W[3 * r + 2]
                X[9 + r] = W[9 + r] + (a * t0 + b * t1 + c * t2)
                X[3 * r] = a * p0 + b * p3 + c * p6
                X[3 * r + 1] = a * p1 + b * p4 + c * p7
                X[3 * r + 2] = a * p2 + b * p5 + c * p8
        if i < 6:
            co, si = _cos_sin(q[i] + chain[at + 13])
            for r in range(3):
                x, y = X[3 * r], X[3 * r + 1]
                X[3 * r], X[3 * r + 1] = x * co + y * si, y * co - x * si


def _step(frames: Array, X: Array, room: Array) -> float:
    """Write Δq to the last column of six rows of `room`; return the largest |Δq| [rad], inf for no pose."""
    M = frames[6]
    for i in range(6):
        F = frames[i]
        ax, ay, az = F[2], F[5], F[8]
        x, y, z = M[9] - F[9], M[10] - F[10], M[11] - F[11]
        room[0, i], room[1, i], room[2, i] = ay * z - az * y, az * x - ax * z, ax * y - ay * x
        room[3, i], room[4, i], room[5, i] = ax, ay, az
    room[0, 6], room[1, 6], room[2, 6] = X[0, 3] - M[9], X[1, 3] - M[10], X[2, 3] - M[11]
    c21 = X[2, 0] * M[3] + X[2, 1] * M[4] + X[2, 2] * M[5]
    c12 = X[1, 0] * M[6] + X[1, 1] * M[7] + X[1, 2] * M[8]
    c02 = X[0, 0] * M[6] + X[0, 1] * M[7] + X[0, 2] * M[8]
    c20 = X[2, 0] * M[0] + X[2, 1] * M[1] + X[2, 2] * M[2]
    c10 = X[1, 0] * M[0] + X[1, 1] * M[1] + X[1, 2] * M[2]
    c01 = X[0, 0] * M[3] + X[0, 1] * M[4] + X[0, 2] * M[5]
    room[3, 6], room[4, 6], room[5, 6] = 0.5 * (c21 - c12), 0.5 * (c02 - c20), 0.5 * (c10 - c01)
    bent = abs(c21 + c12) + abs(c02 + c20) + abs(c10 + c01)
    bent += abs(X[0, 0] * M[0] + X[0, 1] * M[1] + X[0, 2] * M[2] - 1.0)
    bent += abs(X[1, 0] * M[3] + X[1, 1] * M[4] + X[1, 2] * M[5] - 1.0)
    bent += abs(X[2, 0] * M[6] + X[2, 1] * M[7] + X[2, 2] * M[8] - 1.0)
    for i in range(6):  # Gauß, with the greatest pivot of a column where the next one is small
        if abs(room[i, i]) < SMALL:
            best = i
            for r in range(i + 1, 6):
                if abs(room[r, i]) > abs(room[best, i]):
                    best = r
            for c in range(i, 7):
                room[i, c], room[best, c] = room[best, c], room[i, c]
        scale = 1.0 / room[i, i]
        for r in range(i + 1, 6):
            share = room[r, i] * scale
            for c in range(i + 1, 7):
                room[r, c] -= share * room[i, c]
    largest = 0.0
    for i in range(5, -1, -1):
        value = room[i, 6]
        for c in range(i + 1, 6):
            value -= room[i, c] * room[c, 6]
        value /= room[i, i]
        room[i, 6] = value
        largest = max(largest, abs(value))
    return largest if bent <= BENT or largest >= SURE else inf


def _principal(q: float) -> float:
    """Return an angle in (-π, π] [rad]."""
    q -= 2.0 * pi * ceil((q - pi) * (0.5 / pi))
    return q if -pi < q < pi else pi  # rounding may leave ±π a bit outside


def _cos_sin(angle: float) -> tuple[float, float]:
    """Return cosine and sine of an angle [rad]; NaN for NaN."""
    quarters = (angle * PER_QUARTER + ROUNDING) - ROUNDING
    r = ((angle - quarters * HIGH) - quarters * MIDDLE) - quarters * LOW
    z = r * r
    s = r + r * z * (S1 + z * (S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)))))
    c = 1.0 - (0.5 * z - z * z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6))))))
    quarters -= 4.0 * ((0.25 * quarters + ROUNDING) - ROUNDING)  # 0, ±1 or ±2 are left
    square = quarters * quarters
    if square == 1.0:
        return -quarters * s, quarters * c
    return (1.0 - 0.5 * square) * c, (1.0 - 0.5 * square) * s
