"""The pose of a tool as position and unit quaternion, in plain numbers that numba compiles."""

from math import sqrt

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics.chain.chain_kernel import forward_rows
from ropsim.spatial import Array

_Quaternion = tuple[float, float, float, float]


@kernel
def write_tool_pose(
    chain: Array1, q: Array2, position: Array1, orientation: Array1, X_BM: Array3, room: Array1, out: Array1
) -> None:
    """Write X_BT = X_BM(q)·X_MT, bit by bit as poses are multiplied of which none is the identity.

    Args:
        chain: `ChainArrays.flat`.
        q: coordinates of the steps [rad | m], shape (1, m).
        position: of the tool in M [m], shape (3,).
        orientation: of the tool in M (w, x, y, z), shape (4,).
        X_BM: where the pose of M goes, shape (1, 4, 4).
        room: room to work in, shape (`POSES`,).
        out: where position [m] and orientation (w, x, y, z) go, shape (7,).
    """
    forward_rows(chain, q, X_BM, room)
    X = X_BM[0]
    out[0], out[1], out[2] = X[0, 3], X[1, 3], X[2, 3]
    out[3], out[4], out[5], out[6] = _unit(_unit(_of_rotation(X)))
    _write_product(out, position, orientation, out)


@kernel
def write_pose_product(X_AB: Array1, X_BC: Array1, X_AC: Array1) -> None:
    """Write the product of two poses, bit by bit as `Pose` does; the poses are not checked.

    Args:
        X_AB: position [m] and unit quaternion (w, x, y, z), shape (7,).
        X_BC: 4x4 pose as X_AB.
        X_AC: product, in the same form.
    """
    _write_product(X_AB, X_BC[:3], X_BC[3:], X_AC)


def _write_product(X_AB: Array, position: Array, orientation: Array, X_AC: Array) -> None:
    """Write a product, possibly over its first factor."""
    w, x, y, z = X_AB[3], X_AB[4], X_AB[5], X_AB[6]
    a, b, c = position[0], position[1], position[2]
    tx, ty, tz = 2.0 * (y * c - z * b), 2.0 * (z * a - x * c), 2.0 * (x * b - y * a)
    X_AC[0] = X_AB[0] + (a + w * tx + y * tz - z * ty)
    X_AC[1] = X_AB[1] + (b + w * ty + z * tx - x * tz)
    X_AC[2] = X_AB[2] + (c + w * tz + x * ty - y * tx)
    d, e, f, g = orientation[0], orientation[1], orientation[2], orientation[3]
    turned = (
        w * d - x * e - y * f - z * g,
        w * e + x * d + y * g - z * f,
        w * f - x * g + y * d + z * e,
        w * g + x * f - y * e + z * d,
    )
    X_AC[3], X_AC[4], X_AC[5], X_AC[6] = _unit(_unit(turned))


@kernel
def write_tool_places(chain: Array1, Q: Array2, points: Array2, X_BM: Array3, room: Array1) -> None:
    """Write where points of the interface are.

    Args:
        chain: `ChainArrays.flat`.
        Q: coordinates of the steps [rad | m], shape (k, m).
        points: in M [m], replaced by points in the base frame, shape (k, 3).
        X_BM: where the poses of M go, shape (k, 4, 4).
        room: room to work in, shape (`POSES`,).
    """
    forward_rows(chain, Q, X_BM, room)
    for k in range(Q.shape[0]):
        X, x, y, z = X_BM[k], points[k, 0], points[k, 1], points[k, 2]
        for i in range(3):
            points[k, i] = X[i, 0] * x + X[i, 1] * y + X[i, 2] * z + X[i, 3]


def _unit(q: _Quaternion) -> _Quaternion:
    """Return the unit quaternion along another one, with w >= 0; NaN where it has no direction."""
    w, x, y, z = q
    length = sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / length, x / length, y / length, z / length
    if w >= 0.0:
        return w, x, y, z
    return -w, -x, -y, -z


def _of_rotation(X: Array) -> _Quaternion:
    """Return a quaternion along that of a rotation; its largest component is found first (Shepperd 1978)."""
    trace = X[0, 0] + X[1, 1] + X[2, 2]
    most, largest = 1.0 + trace, 0
    for i in range(3):
        square = 1.0 + 2.0 * X[i, i] - trace
        if square > most:
            most, largest = square, i + 1
    x, y, z = X[2, 1] - X[1, 2], X[0, 2] - X[2, 0], X[1, 0] - X[0, 1]
    xy, zx, yz = X[1, 0] + X[0, 1], X[0, 2] + X[2, 0], X[2, 1] + X[1, 2]
    if largest == 0:
        return most, x, y, z
    if largest == 1:
        return x, most, xy, zx
    if largest == 2:
        return y, xy, most, yz
    return z, zx, yz, most
