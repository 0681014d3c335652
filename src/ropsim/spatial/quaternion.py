"""Unit quaternions (w, x, y, z) and vectors as plain tuples of floats, without numpy.

The interpreter and the compiler work on single poses; tuples are faster there than arrays.
Hamilton product; a quaternion `q_AB` turns coordinates in B into coordinates in A.
"""

import math
from collections.abc import Sequence

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
PoseTuple = tuple[float, float, float, float, float, float, float]

IDENTITY: Quaternion = (1.0, 0.0, 0.0, 0.0)

_ROUNDING = 1e-15
"""By how much the square of a normalized quaternion misses 1: its squares are rounded, and their sums."""


def normalize(q: Quaternion) -> Quaternion:
    """Return the unit quaternion along `q`, with w >= 0.

    Raises:
        ValueError: the length is zero or not finite.
    """
    w, x, y, z = q
    length = math.sqrt(w * w + x * x + y * y + z * z)
    if not math.isfinite(length) or length == 0.0:
        raise ValueError("quaternion has no direction")
    w, x, y, z = w / length, x / length, y / length, z / length
    return (w, x, y, z) if w >= 0.0 else (-w, -x, -y, -z)


def unit(q: Quaternion) -> Quaternion:
    """Return the unit quaternion along `q`, with w >= 0; one that is so within rounding keeps its bits.

    Raises:
        ValueError: the length is zero or not finite.
    """
    w, x, y, z = q
    is_unit = abs(w * w + x * x + y * y + z * z - 1.0) < _ROUNDING and w >= 0.0
    return q if is_unit else normalize(q)


def multiply(a: Quaternion, b: Quaternion) -> Quaternion:
    """Return the Hamilton product a*b."""
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )


def conjugate(q: Quaternion) -> Quaternion:
    """Return the inverse of a unit quaternion."""
    return (q[0], -q[1], -q[2], -q[3])


def rotate(q: Quaternion, v: Vector) -> Vector:
    """Return `v` turned by `q`."""
    w, x, y, z = q
    tx = 2.0 * (y * v[2] - z * v[1])
    ty = 2.0 * (z * v[0] - x * v[2])
    tz = 2.0 * (x * v[1] - y * v[0])
    return (
        v[0] + w * tx + y * tz - z * ty,
        v[1] + w * ty + z * tx - x * tz,
        v[2] + w * tz + x * ty - y * tx,
    )


def from_rotation(rows: Sequence[Sequence[float]]) -> Quaternion:
    """Return the unit quaternion, w >= 0, of the rows of a rotation matrix.

    The largest of the four components is found first and divides the others (Shepperd 1978), so that no
    rotation loses accuracy.
    """
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rows
    trace = xx + yy + zz
    squares = (1.0 + trace, 1.0 + 2.0 * xx - trace, 1.0 + 2.0 * yy - trace, 1.0 + 2.0 * zz - trace)
    largest = squares.index(max(squares))  # of 4·q·qᵀ the row with the largest square on its diagonal
    q = (
        (squares[0], zy - yz, xz - zx, yx - xy),
        (zy - yz, squares[1], yx + xy, xz + zx),
        (xz - zx, yx + xy, squares[2], zy + yz),
        (yx - xy, xz + zx, zy + yz, squares[3]),
    )[largest]
    return normalize(q)


def from_zyx(c: float, b: float, a: float) -> Quaternion:
    """Return the quaternion of Rz(c)·Ry(b)·Rx(a), angles in rad (ISO 9787 names A, B, C)."""
    cc, sc = math.cos(c / 2.0), math.sin(c / 2.0)
    cb, sb = math.cos(b / 2.0), math.sin(b / 2.0)
    ca, sa = math.cos(a / 2.0), math.sin(a / 2.0)
    return normalize(
        (
            cc * cb * ca + sc * sb * sa,
            cc * cb * sa - sc * sb * ca,
            cc * sb * ca + sc * cb * sa,
            sc * cb * ca - cc * sb * sa,
        )
    )


def to_zyx(q: Quaternion) -> Vector:
    """Return (c, b, a) [rad] with Rz(c)·Ry(b)·Rx(a) = q; a = 0 where b = ±90°."""
    w, x, y, z = q
    sin_b = max(-1.0, min(1.0, 2.0 * (w * y - x * z)))
    if abs(sin_b) > 1.0 - 1e-12:
        return (math.copysign(1.0, -sin_b) * 2.0 * math.atan2(x, w), math.copysign(math.pi / 2.0, sin_b), 0.0)
    return (
        math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z)),
        math.asin(sin_b),
        math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y)),
    )


def compose(a: PoseTuple, b: PoseTuple) -> PoseTuple:
    """Return X_AC from X_AB and X_BC, each (x, y, z, qw, qx, qy, qz)."""
    qa: Quaternion = a[3:]
    p = rotate(qa, b[:3])
    q = normalize(multiply(qa, b[3:]))
    return (a[0] + p[0], a[1] + p[1], a[2] + p[2], *q)


def invert(a: PoseTuple) -> PoseTuple:
    """Return X_BA from X_AB."""
    qi = conjugate(a[3:])
    p = rotate(qi, (-a[0], -a[1], -a[2]))
    return (*p, *normalize(qi))
