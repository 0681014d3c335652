"""Closed chains as rows: what parts the frames of each cut, and how, in plain loops that numba compiles.

A cut has a row for each direction that it holds. Along an axis a_i of the first frame it is a_i·d with the
way d between the two origins; about axes it is made of products a_i·b_j of axes of both frames, which vanish
where the turn is closed, whatever turn is left free: all three for a frame that is held altogether, two for
an axis that stays parallel, one for two axes at right angles (`Turning`). The slopes are exact: a step that
turns about z moves b_j against a_i by z·(b_j × a_i).
"""

from math import cos, sin
from typing import NamedTuple

from ropsim.codegen import Array1, Array2
from ropsim.spatial import Array

FAR = 1e9
"""Rows beyond this are no numbers [m, rad]."""


class LoopArm(NamedTuple):
    """A mechanism of m steps, n axes and c cuts with r rows, which determine p coordinates.

    Attributes:
        steps: R by rows, p, whether it slides, offset; of each step against its parent, shape (m, 14).
        ways: parent, -1.0 for the base; 1.0 for steps on the way to the interface; and for each cut 1.0 for
            steps that move its second frame alone, -1.0 its first one alone, shape (m, 2 + c).
        spread: coordinates of the steps by those of axes, those of loops, and 1, shape (m, n + p + 1).
        ends: step that carries the first frame of a cut, -1.0 for the base, and the second one; the two
            frames on them, R by rows and p, shape (c, 26).
        rows: cut; 0.0 along an axis, then the number of the axis; or 1.0 about axes, then i, j and factor of
            one product a_i·b_j and the same of another, shape (r, 8).
        interface: step that carries the interface, -1.0 for the base; its frame there, R by rows and p; the
            number of the p coordinates that the rows determine; the effort of following chains at
            most, in steps, shape (15,).
        home: coordinates of axes and loops in the rest position, shape (n + p,).
    """

    steps: Array2
    ways: Array2
    spread: Array2
    ends: Array2
    rows: Array2
    interface: Array1
    home: Array1


class LoopWork(NamedTuple):
    """Room to work in.

    Attributes:
        frames: of the steps in the base frame, then the interface: R by rows and p, shape (m + 1, 12).
        ends: both frames of each cut in the base frame, shape (2·c, 12).
        steps: coordinates of the steps, their first and second derivatives, shape (3, m).
        slopes: of the rows by the steps, shape (r, m).
        left: values of the rows; their second derivatives where no coordinate accelerates, shape (2, r).
        table: equations that are solved, shape (r, p + n + 1).
        solved: answers, and in the last column the order of the unknowns, shape (p, n + 2).
        states: coordinates of axes and loops on the way, shape (6, n + p).
        motion: of the steps: angular velocity, velocity, angular acceleration, acceleration, shape (m, 12).
        columns: Jacobian of the steps, shape (6, m).
        spare: a frame, and how it moves, shape (2, 12).
    """

    frames: Array2
    ends: Array2
    steps: Array2
    slopes: Array2
    left: Array2
    table: Array2
    solved: Array2
    states: Array2
    motion: Array2
    columns: Array2
    spare: Array2


def spread_state(arm: LoopArm, state: Array, steps: Array) -> None:
    """Write coordinates of the steps (m,) from those of axes and loops (n + p,)."""
    width = arm.spread.shape[1] - 1
    for i in range(steps.shape[0]):
        total = arm.spread[i, width]
        for j in range(width):
            total += arm.spread[i, j] * state[j]
        steps[i] = total


def place_tree(arm: LoopArm, steps: Array, frames: Array) -> None:
    """Write the frames of all steps and of the interface to frames (m + 1, 12)."""
    m = arm.steps.shape[0]
    for i in range(m):
        own, parent = arm.steps[i], int(arm.ways[i, 0])
        turn = steps[i] + own[13]
        slide = turn * own[12]
        turn -= slide
        if parent < 0:
            for k in range(12):
                frames[i, k] = own[k]
        else:
            _compose(frames[parent], own, frames[i])
        _move(frames[i], slide, cos(turn), sin(turn))
    carrier = int(arm.interface[0])
    if carrier < 0:
        for k in range(12):
            frames[m, k] = arm.interface[1 + k]
    else:
        _compose(frames[carrier], arm.interface[1:13], frames[m])


def _compose(X: Array, Y: Array, out: Array) -> None:
    """Write X·Y of poses, R by rows and p."""
    for r in range(3):
        a, b, c = X[3 * r], X[3 * r + 1], X[3 * r + 2]
        for k in range(3):
            out[3 * r + k] = a * Y[k] + b * Y[3 + k] + c * Y[6 + k]
        out[9 + r] = X[9 + r] + a * Y[9] + b * Y[10] + c * Y[11]


def _move(X: Array, slide: float, co: float, si: float) -> None:
    """Slide a frame along its z axis and turn it about that."""
    for r in range(3):
        x, y = X[3 * r], X[3 * r + 1]
        X[9 + r] += X[3 * r + 2] * slide
        X[3 * r], X[3 * r + 1] = x * co + y * si, y * co - x * si


def place_ends(arm: LoopArm, frames: Array, ends: Array) -> None:
    """Write both frames of each cut to ends (2·c, 12)."""
    for c in range(arm.ends.shape[0]):
        for side in range(2):
            carrier, own = int(arm.ends[c, side]), arm.ends[c, 2 + 12 * side : 14 + 12 * side]
            if carrier < 0:
                for k in range(12):
                    ends[2 * c + side, k] = own[k]
            else:
                _compose(frames[carrier], own, ends[2 * c + side])


def loop_residuals(arm: LoopArm, ends: Array, left: Array) -> float:
    """Write the values of all rows [m, rad] to left (r,); return the largest."""
    most = 0.0
    for r in range(arm.rows.shape[0]):
        row = arm.rows[r]
        one, other = ends[2 * int(row[0])], ends[2 * int(row[0]) + 1]
        i, total = int(row[2]), 0.0
        if row[1] == 0.0:
            for k in range(3):
                total += one[3 * k + i] * (other[9 + k] - one[9 + k])
        else:
            j, i2, j2 = int(row[3]), int(row[5]), int(row[6])
            for k in range(3):
                total += row[4] * one[3 * k + i] * other[3 * k + j]
                total += row[7] * one[3 * k + i2] * other[3 * k + j2]
        left[r] = total
        most = max(most, abs(total)) if abs(total) < FAR else FAR
    return most


def loop_slopes(arm: LoopArm, frames: Array, ends: Array, slopes: Array) -> None:
    """Write the slopes of all rows by the coordinates of the steps, shape (r, m)."""
    for r in range(arm.rows.shape[0]):
        row = arm.rows[r]
        cut = int(row[0])
        one, other = ends[2 * cut], ends[2 * cut + 1]
        i, j = int(row[2]), int(row[3])
        fx, fy, fz = one[i], one[3 + i], one[6 + i]
        wx = wy = wz = 0.0
        if row[1] != 0.0:
            bx, by, bz = row[4] * other[j], row[4] * other[3 + j], row[4] * other[6 + j]
            wx, wy, wz = by * fz - bz * fy, bz * fx - bx * fz, bx * fy - by * fx
            i, j = int(row[5]), int(row[6])
            ax, ay, az = one[i], one[3 + i], one[6 + i]
            bx, by, bz = row[7] * other[j], row[7] * other[3 + j], row[7] * other[6 + j]
            wx, wy, wz = wx + by * az - bz * ay, wy + bz * ax - bx * az, wz + bx * ay - by * ax
        for k in range(slopes.shape[1]):
            side, X = arm.ways[k, 2 + cut], frames[k]
            if side == 0.0:
                slopes[r, k] = 0.0
            elif row[1] != 0.0:
                turns = 1.0 - arm.steps[k, 12]
                slopes[r, k] = side * turns * (X[2] * wx + X[5] * wy + X[8] * wz)
            elif arm.steps[k, 12] != 0.0:
                slopes[r, k] = side * (X[2] * fx + X[5] * fy + X[8] * fz)
            else:
                dx, dy, dz = other[9] - X[9], other[10] - X[10], other[11] - X[11]
                vx, vy, vz = X[5] * dz - X[8] * dy, X[8] * dx - X[2] * dz, X[2] * dy - X[5] * dx
                slopes[r, k] = side * (vx * fx + vy * fy + vz * fz)


def step_motion(arm: LoopArm, frames: Array, steps: Array, motion: Array) -> None:
    """Write how all steps move, shape (m, 12), see `LoopWork`.

    Args:
        arm: the mechanism.
        frames: of the steps, shape (m + 1, 12).
        steps: in rows 1 and 2 first and second derivatives of their coordinates, shape (3, m).
        motion: angular velocity, velocity of the origin, angular acceleration, acceleration.
    """
    for i in range(arm.steps.shape[0]):
        parent, own, X = int(arm.ways[i, 0]), motion[i], frames[i]
        if parent < 0:
            for k in range(12):
                own[k] = 0.0
        else:
            carried(motion[parent], frames[parent], X, own)
        speed, change = steps[1, i], steps[2, i]
        wx, wy, wz = own[0], own[1], own[2]
        zx, zy, zz = X[2], X[5], X[8]
        cx, cy, cz = wy * zz - wz * zy, wz * zx - wx * zz, wx * zy - wy * zx
        at, twice = (3, 2.0) if arm.steps[i, 12] != 0.0 else (0, 1.0)
        own[at], own[at + 1], own[at + 2] = (
            own[at] + zx * speed,
            own[at + 1] + zy * speed,
            own[at + 2] + zz * speed,
        )
        own[at + 6] += twice * cx * speed + zx * change
        own[at + 7] += twice * cy * speed + zy * change
        own[at + 8] += twice * cz * speed + zz * change


def carried(motion: Array, X: Array, Y: Array, out: Array) -> None:
    """Write how the origin of a frame Y moves that a body carries, of which frame X moves by `motion`."""
    wx, wy, wz, ax, ay, az = motion[0], motion[1], motion[2], motion[6], motion[7], motion[8]
    dx, dy, dz = Y[9] - X[9], Y[10] - X[10], Y[11] - X[11]
    vx, vy, vz = wy * dz - wz * dy, wz * dx - wx * dz, wx * dy - wy * dx
    out[0], out[1], out[2], out[6], out[7], out[8] = wx, wy, wz, ax, ay, az
    out[3], out[4], out[5] = motion[3] + vx, motion[4] + vy, motion[5] + vz
    out[9] = motion[9] + ay * dz - az * dy + wy * vz - wz * vy
    out[10] = motion[10] + az * dx - ax * dz + wz * vx - wx * vz
    out[11] = motion[11] + ax * dy - ay * dx + wx * vy - wy * vx


def loop_drift(arm: LoopArm, work: LoopWork, drift: Array) -> None:
    """Write the second derivatives of all rows for `work.motion`, shape (r,)."""
    for r in range(arm.rows.shape[0]):
        drift[r] = _row_drift(arm, work, arm.rows[r])


def _row_drift(arm: LoopArm, work: LoopWork, row: Array) -> float:
    cut = int(row[0])
    one, other = work.ends[2 * cut], work.ends[2 * cut + 1]
    w1, v1, e1, a1 = _end_motion(arm, work, cut, 0)
    w2, v2, e2, a2 = _end_motion(arm, work, cut, 1)
    total = 0.0
    if row[1] == 0.0:
        i = int(row[2])
        a = one[i], one[3 + i], one[6 + i]
        d = other[9] - one[9], other[10] - one[10], other[11] - one[11]
        dv = v2[0] - v1[0], v2[1] - v1[1], v2[2] - v1[2]
        da = a2[0] - a1[0], a2[1] - a1[1], a2[2] - a1[2]
        da1, dda1 = _turned(w1, e1, a)
        return _dot(a, da) + 2.0 * _dot(da1, dv) + _dot(dda1, d)
    for k in range(2):
        i, j, factor = int(row[2 + 3 * k]), int(row[3 + 3 * k]), row[4 + 3 * k]
        a = one[i], one[3 + i], one[6 + i]
        b = other[j], other[3 + j], other[6 + j]
        da1, dda1 = _turned(w1, e1, a)
        db2, ddb2 = _turned(w2, e2, b)
        total += factor * (_dot(dda1, b) + 2.0 * _dot(da1, db2) + _dot(a, ddb2))
    return total


_Three = tuple[float, float, float]


def _end_motion(arm: LoopArm, work: LoopWork, cut: int, side: int) -> tuple[_Three, _Three, _Three, _Three]:
    """Return angular velocity, velocity, angular acceleration and acceleration of a frame of a cut."""
    carrier = int(arm.ends[cut, side])
    none = (0.0, 0.0, 0.0)
    if carrier < 0:
        return none, none, none, none
    M, X, Y = work.motion[carrier], work.frames[carrier], work.ends[2 * cut + side]
    w, e = (M[0], M[1], M[2]), (M[6], M[7], M[8])
    v, a = _turned(w, e, (Y[9] - X[9], Y[10] - X[10], Y[11] - X[11]))
    return w, (M[3] + v[0], M[4] + v[1], M[5] + v[2]), e, (M[9] + a[0], M[10] + a[1], M[11] + a[2])


def _turned(w: _Three, e: _Three, a: _Three) -> tuple[_Three, _Three]:
    """Return first and second derivatives of a vector that turns along."""
    d = _cross(w, a)
    one, other = _cross(e, a), _cross(w, d)
    return d, (one[0] + other[0], one[1] + other[1], one[2] + other[2])


def _cross(a: _Three, b: _Three) -> _Three:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _dot(a: _Three, b: _Three) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
