"""The chain of an arm in plain loops that numba compiles: forward kinematics, and steps to poses.

The steps are for six turning joints whose model is off its class by rounding, and whose closed form thus
yields nearly an answer. The error e of `polish_kernel.py`, of which the small angles are the vector part, is
measured on the actual arm; J·Δq = e is solved as if it were exactly of its class, where J falls into a
number, two links in a plane and three turns. A step leaves an error of the snap of the arm times Δq, and of
half of the second derivative of the pose times the squares of Δq: after one that is small enough for both no
further check is needed.
"""

from math import ceil, pi

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.spatial import Array

PER_QUARTER = 0.6366197723675814
"""2/π: number of quarter turns in 1 rad."""
ROUNDING = 6755399441055744.0
"""1.5·2^52: a number added to it and taken away again is rounded to a whole one."""
HIGH, MIDDLE, LOW = 1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21
"""π/2 in three parts; the first two end in zeros: up to 2^20 times them is exact (Cody & Waite 1980)."""
S1, S2, S3 = -1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04
S4, S5, S6 = 2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10
C1, C2, C3 = 4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05
C4, C5, C6 = -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11
"""Sine and cosine up to π/4 to less than a unit of the last place (FDLIBM of Sun Microsystems, 1993)."""
MOST = 1e-3
"""A step that would move a joint farther [rad] is left to the search that can do with bad starts."""
STEPS = 4
LANES = 8
"""Branches that are refined side by side, so that machine code takes several numbers at once."""
FRAME, COS, SIN = 112, 96, 104
ERROR, STEP, SIZE, BEND, ANGLES, TURNS, ROOM = 896, 968, 1016, 1024, 1032, 1080, 1176
"""Where numbers lie in `room`, eight of each: eight frames, the first one the base, each as rows of R with p
behind each, and cosine and sine of the turn to the next one; the remaining displacement and rotation, and the
place of P; steps, their sizes; angles, and cosines and sines of them. At fixed distances a compiler sees that
loops over the eight may be taken side by side.
"""
WIDE = 16
"""Poses that are computed side by side: fewer do not keep the processor busy."""
POSE, POSES = 12 * WIDE, 15 * WIDE
"""Number of values per joint: R by rows, p, and the data of its motion."""
Three = tuple[float, float, float]
BENT = 1e-9
"""A matrix whose turn from the arm's frame is farther from a rotation [sum of entries] is no pose."""


@kernel
def forward_rows(chain: Array1, Q: Array2, out: Array3, room: Array1) -> None:
    """Write X_BM of every row of Q (k, n) to out (k, 4, 4), sixteen rows side by side.

    The pose on the way is twelve numbers: its axes a, b, c and its origin p.

    Args:
        chain: `ChainArrays.flat`, shape (14·n + 12,).
        Q: coordinates of the steps [rad | m].
        out: homogeneous matrices.
        room: room to work in, shape (`POSES`,).
    """
    rows, n = Q.shape[0], Q.shape[1]
    for first in range(0, rows, WIDE):
        here = min(WIDE, rows - first)
        for c in range(12):
            for lane in range(WIDE):
                room[WIDE * c + lane] = chain[c]
        for i in range(n):
            for lane in range(here):
                room[POSE + lane] = Q[first + lane, i]
            _go_on(chain, 14 * i, room)
        for lane in range(here):
            X = out[first + lane]
            for r in range(3):
                X[r, 0], X[r, 1] = room[WIDE * 3 * r + lane], room[WIDE * (3 * r + 1) + lane]
                X[r, 2], X[r, 3] = room[WIDE * (3 * r + 2) + lane], room[WIDE * (9 + r) + lane]
                X[3, r] = 0.0
            X[3, 3] = 1.0


def _go_on(chain: Array, at: int, room: Array) -> None:
    """Move sixteen poses by a joint and go on to the next step, or to the interface.

    Args:
        chain: `ChainArrays.flat`, shape (14·n + 12,).
        at: where the joint begins in it; the next one has the same places behind it.
        room: R by rows and p of each pose, and the coordinates [rad | m], shape (`POSES`,).
    """
    slides, offset = chain[at + 12], chain[at + 13]
    at += 14
    p0, p1, p2, p3, p4 = chain[at], chain[at + 1], chain[at + 2], chain[at + 3], chain[at + 4]
    p5, p6, p7, p8 = chain[at + 5], chain[at + 6], chain[at + 7], chain[at + 8]
    t0, t1, t2 = chain[at + 9], chain[at + 10], chain[at + 11]
    for lane in range(WIDE):
        turn = room[POSE + lane] + offset
        slide = turn * slides
        co, si = _cos_sin(turn - slide)
        room[POSE + lane] = slide
        room[POSE + WIDE + lane], room[POSE + 2 * WIDE + lane] = co, si
    for r in range(3):
        for lane in range(WIDE):
            slide, co, si = room[POSE + lane], room[POSE + WIDE + lane], room[POSE + 2 * WIDE + lane]
            a, b = room[WIDE * 3 * r + lane], room[WIDE * (3 * r + 1) + lane]
            c = room[WIDE * (3 * r + 2) + lane]
            p = room[WIDE * (9 + r) + lane] + c * slide
            a, b = a * co + b * si, b * co - a * si
            room[WIDE * (9 + r) + lane] = p + (a * t0 + b * t1 + c * t2)
            room[WIDE * 3 * r + lane] = a * p0 + b * p3 + c * p6
            room[WIDE * (3 * r + 1) + lane] = a * p1 + b * p4 + c * p7
            room[WIDE * (3 * r + 2) + lane] = a * p2 + b * p5 + c * p8


@kernel
def refine_rows(chain: Array1, shape: Array1, T: Array3, Q: Array3, room: Array1) -> None:
    """Bring every row of Q (k, 8, 6) to its pose X_BM in T (k, 4, 4), the rows of a pose side by side.

    Args:
        chain: `ChainArrays.flat` of an arm with six turning joints.
        shape: of the arm: the point in M where its last axes meet [m] (3 numbers), how many axes behind the
            first are parallel, 2 or 3, and the largest step that is sure [rad].
        T: poses.
        Q: starts, NaN rows are left alone; answers, angles in (-π, π] [rad].
        room: room to work in (`ROOM` numbers), the number of rows that are unsure, and of each row whether
            it is: 1.0 where no step was small enough to be sure, else 0.0; shape
            (ROOM + 1 + 8·k,).
    """
    for c in range(12):
        for lane in range(LANES):
            room[LANES * c + lane] = 1.0 if c % 5 == 0 else 0.0
    for lane in range(LANES):  # the interface is not turned
        room[6 * FRAME + COS + lane], room[6 * FRAME + SIN + lane] = 1.0, 0.0
    room[ROOM] = 0.0
    for k in range(Q.shape[0]):
        rows, unsure = Q[k], room[ROOM + 1 + LANES * k : ROOM + 1 + LANES * k + LANES]
        for lane in range(LANES):
            for j in range(6):
                room[ANGLES + LANES * j + lane] = rows[lane, j] + chain[14 * j + 13]
            unsure[lane] = 1.0 if rows[lane, 0] == rows[lane, 0] else 0.0
        going = True
        for _ in range(STEPS):
            if going:
                _turns(room)
                _frames(chain, room)
                _errors(T[k], shape, room)
                if shape[3] == 2.0:
                    _wrist_steps(room)
                else:
                    _level_steps(room)
                going = _moved(rows, unsure, shape[4], room)
        for lane in range(LANES):
            room[ROOM] += unsure[lane]


def _moved(rows: Array, unsure: Array, sure: float, room: Array) -> bool:
    """Move the rows that are unsure by their steps; return whether some of them are to go on."""
    going = False
    for lane in range(LANES):
        size = room[SIZE + lane]
        if unsure[lane] == 0.0 or not size < MOST or (size < sure and room[BEND + lane] > BENT):
            continue
        for j in range(6):
            step = room[STEP + LANES * j + lane]
            room[ANGLES + LANES * j + lane] += step
            rows[lane, j] = _principal(rows[lane, j] + step)
        if size < sure:
            unsure[lane] = 0.0
        else:
            going = True
    return going


def _turns(room: Array) -> None:
    """Write cosines and sines of all angles."""
    for at in range(6 * LANES):
        room[TURNS + at], room[TURNS + 48 + at] = _cos_sin(room[ANGLES + at])
    for i in range(6):
        for lane in range(LANES):
            room[FRAME * i + COS + lane] = room[TURNS + LANES * i + lane]
            room[FRAME * i + SIN + lane] = room[TURNS + LANES * i + 48 + lane]


def _frames(chain: Array, room: Array) -> None:
    """Write the frames of six turned joints and of the interface, each behind the last."""
    for i in range(7):
        p0, p1, p2, p3 = chain[14 * i], chain[14 * i + 1], chain[14 * i + 2], chain[14 * i + 3]
        p4, p5, p6, p7 = chain[14 * i + 4], chain[14 * i + 5], chain[14 * i + 6], chain[14 * i + 7]
        p8, t0, t1, t2 = chain[14 * i + 8], chain[14 * i + 9], chain[14 * i + 10], chain[14 * i + 11]
        for lane in range(LANES):
            at = FRAME * i + lane
            co, si = room[at + COS], room[at + SIN]
            for r in range(3):
                a, b, c = room[at + 32 * r], room[at + 32 * r + 8], room[at + 32 * r + 16]
                x, y = a * p0 + b * p3 + c * p6, a * p1 + b * p4 + c * p7
                room[at + 32 * r + FRAME] = x * co + y * si
                room[at + 32 * r + FRAME + 8] = y * co - x * si
                room[at + 32 * r + FRAME + 16] = a * p2 + b * p5 + c * p8
                room[at + 32 * r + FRAME + 24] = room[at + 32 * r + 24] + (a * t0 + b * t1 + c * t2)


def _errors(X: Array, shape: Array, room: Array) -> None:
    """Write how far the point P of the hand is to move [m], and the hand to turn [rad]; and P itself."""
    x0, x1, x2, x3, x4, x5 = X[0, 0], X[0, 1], X[0, 2], X[1, 0], X[1, 1], X[1, 2]
    x6, x7, x8 = X[2, 0], X[2, 1], X[2, 2]
    s0, s1, s2 = shape[0], shape[1], shape[2]
    gx = X[0, 3] + (x0 * s0 + x1 * s1 + x2 * s2)
    gy = X[1, 3] + (x3 * s0 + x4 * s1 + x5 * s2)
    gz = X[2, 3] + (x6 * s0 + x7 * s1 + x8 * s2)
    for lane in range(LANES):
        m = 7 * FRAME + lane
        m0, m1, m2, px = room[m], room[m + 8], room[m + 16], room[m + 24]
        m3, m4, m5, py = room[m + 32], room[m + 40], room[m + 48], room[m + 56]
        m6, m7, m8, pz = room[m + 64], room[m + 72], room[m + 80], room[m + 88]
        c21, c12 = x6 * m3 + x7 * m4 + x8 * m5, x3 * m6 + x4 * m7 + x5 * m8
        c02, c20 = x0 * m6 + x1 * m7 + x2 * m8, x6 * m0 + x7 * m1 + x8 * m2
        c10, c01 = x3 * m0 + x4 * m1 + x5 * m2, x0 * m3 + x1 * m4 + x2 * m5
        bent = abs(c21 + c12) + abs(c02 + c20) + abs(c10 + c01)
        bent += abs(x0 * m0 + x1 * m1 + x2 * m2 - 1.0)
        bent += abs(x3 * m3 + x4 * m4 + x5 * m5 - 1.0)
        room[BEND + lane] = bent + abs(x6 * m6 + x7 * m7 + x8 * m8 - 1.0)
        px, py = px + (m0 * s0 + m1 * s1 + m2 * s2), py + (m3 * s0 + m4 * s1 + m5 * s2)
        pz += m6 * s0 + m7 * s1 + m8 * s2
        e = ERROR + lane
        room[e], room[e + 8], room[e + 16] = gx - px, gy - py, gz - pz
        room[e + 24], room[e + 32], room[e + 40] = 0.5 * (c21 - c12), 0.5 * (c02 - c20), 0.5 * (c10 - c01)
        room[e + 48], room[e + 56], room[e + 64] = px, py, pz


def _wrist_steps(room: Array) -> None:
    """Write the steps of arms with spherical wrist: two links in a plane bring P, the last axes turn."""
    for lane in range(LANES):
        d1, ux, uy, uz, vx, vy, vz, wx, wy, wz = _first_step(room, lane)
        e = ERROR + lane
        s, d2, d3 = _in_plane(
            room, lane, (ux, uy, uz), (room[e + 48], room[e + 56], room[e + 64]), (vx, vy, vz)
        )
        turn = d2 + d3
        z = 4 * FRAME + 16 + lane
        w = (wx - turn * ux, wy - turn * uy, wz - turn * uz)
        d4, d5, d6 = _about((room[z], room[z + 32], room[z + 64]), room, lane, w)
        _write(room, lane, d1, d2, s * d3, d4, d5, d6)


def _level_steps(room: Array) -> None:
    """Write the steps of arms with three parallel axes: the hand is turned, two links bring axis 4."""
    for lane in range(LANES):
        d1, ux, uy, uz, vx, vy, vz, wx, wy, wz = _first_step(room, lane)
        turn, d5, d6 = _about((ux, uy, uz), room, lane, (wx, wy, wz))
        f, e = 4 * FRAME + lane, ERROR + lane
        p = (room[f + 24], room[f + 56], room[f + 88])
        ax, ay, az = _cross((ux, uy, uz), (room[e + 48] - p[0], room[e + 56] - p[1], room[e + 64] - p[2]))
        v = (vx - turn * ax, vy - turn * ay, vz - turn * az)
        s, d2, d3 = _in_plane(room, lane, (ux, uy, uz), p, v)
        way = ux * room[f + 16] + uy * room[f + 48] + uz * room[f + 80]
        _write(room, lane, d1, d2, s * d3, way * (turn - d2 - d3), d5, d6)


def _first_step(
    room: Array, lane: int
) -> tuple[float, float, float, float, float, float, float, float, float, float]:
    """Return the step of axis 1, the direction u of axis 2, and the remaining displacement and rotation.

    P moves along u by axis 1 only.
    """
    e, f, z = ERROR + lane, FRAME + lane, 2 * FRAME + lane
    ux, uy, uz = room[z + 16], room[z + 48], room[z + 80]
    zx, zy, zz = room[f + 16], room[f + 48], room[f + 80]
    r = (room[e + 48] - room[f + 24], room[e + 56] - room[f + 56], room[e + 64] - room[f + 88])
    ax, ay, az = _cross((zx, zy, zz), r)
    vx, vy, vz = room[e], room[e + 8], room[e + 16]
    d = (vx * ux + vy * uy + vz * uz) / (ax * ux + ay * uy + az * uz)
    wx, wy, wz = room[e + 24] - d * zx, room[e + 32] - d * zy, room[e + 40] - d * zz
    return d, ux, uy, uz, vx - d * ax, vy - d * ay, vz - d * az, wx, wy, wz


def _in_plane(room: Array, lane: int, u: Three, p: Three, v: Three) -> Three:
    """Return ±1, as axis 3 is along u or against it, and turns at axes 2 and 3 about u that move p by v."""
    f, g = 2 * FRAME + lane, 3 * FRAME + lane
    a = (p[0] - room[f + 24], p[1] - room[f + 56], p[2] - room[f + 88])
    b = (p[0] - room[g + 24], p[1] - room[g + 56], p[2] - room[g + 88])
    scale = 1.0 / _dot(u, _cross(a, b))
    return _dot(u, (room[g + 16], room[g + 48], room[g + 80])), _dot(v, b) * scale, -_dot(v, a) * scale


def _about(z: Three, room: Array, lane: int, w: Three) -> Three:
    """Return the turns about an axis z, axis 5 and axis 6 that turn by w together."""
    f, g = 5 * FRAME + lane, 6 * FRAME + lane
    a = (room[f + 16], room[f + 48], room[f + 80])
    b = (room[g + 16], room[g + 48], room[g + 80])
    c = _cross(a, b)
    scale = 1.0 / _dot(z, c)
    return _dot(w, c) * scale, _dot(w, _cross(b, z)) * scale, _dot(w, _cross(z, a)) * scale


def _write(room: Array, lane: int, d1: float, d2: float, d3: float, d4: float, d5: float, d6: float) -> None:
    """Write the steps of six joints [rad], and the sum of their sizes; NaN where one is."""
    s = STEP + lane
    room[s], room[s + 8], room[s + 16] = d1, d2, d3
    room[s + 24], room[s + 32], room[s + 40] = d4, d5, d6
    room[SIZE + lane] = abs(d1) + abs(d2) + abs(d3) + abs(d4) + abs(d5) + abs(d6)


def _dot(a: Three, b: Three) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: Three, b: Three) -> Three:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


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
    odd = quarters if square == 1.0 else 0.0
    even = 0.0 if square == 1.0 else 1.0 - 0.5 * square
    return even * c - odd * s, even * s + odd * c
