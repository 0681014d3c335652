"""The steps of an arm at coordinates: their frames and the Jacobian, in plain loops that numba compiles."""

from math import cos, sin

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.spatial import Array


@kernel
def frames_and_jacobians(
    chain: Array1,
    spread: Array2,
    Q: Array2,
    X_MT: Array2,
    frames: Array2,
    lanes: Array2,
    T: Array3,
    J: Array3,
) -> None:
    """Write the frames of a tool and the Jacobians of its origin at configurations Q (k, n).

    Args:
        chain: `ChainArrays.flat` of the arm with m steps and n axes.
        spread: `ChainArrays.spread`.
        Q: coordinates of the axes [rad | m].
        X_MT: tool frame in the interface, (3, 4) at least.
        frames: room to work in, shape (m + 1, 12).
        lanes: room to work in, shape (7, m).
        T: where the frames X_BT go, homogeneous, shape (k, 4, 4).
        J: zeros, where the Jacobians go; columns of axes that do not move the tool stay, shape (k, 6, n).
    """
    last = frames.shape[0] - 1
    M = frames[last]
    for k in range(Q.shape[0]):
        spread_over(spread, Q[k], lanes[6])
        place_steps(chain, lanes[6], frames)
        for r in range(3):
            a, b, c = M[3 * r], M[3 * r + 1], M[3 * r + 2]
            for i in range(4):
                T[k, r, i] = a * X_MT[0, i] + b * X_MT[1, i] + c * X_MT[2, i]
            T[k, r, 3] += M[9 + r]
            T[k, 3, r] = 0.0
        T[k, 3, 3] = 1.0
        for r in range(3):
            M[9 + r] = T[k, r, 3]
        axis_columns(chain, spread, frames, J[k], lanes)


@kernel
def spread_over(spread: Array2, q: Array1, steps: Array1) -> None:
    """Write the coordinates of the steps (m,) from coordinates of the axes, the first n numbers of q."""
    n = spread.shape[1] - 1
    for i in range(steps.shape[0]):
        if spread.shape[0] == 0:
            steps[i] = q[i]
        else:
            total = spread[i, n]
            for j in range(n):
                total += spread[i, j] * q[j]
            steps[i] = total


@kernel
def place_steps(chain: Array1, q: Array1, frames: Array2) -> None:
    """Write the frames of all steps and of the interface, R by rows and p, to frames (m + 1, 12)."""
    n = frames.shape[0] - 1
    for i in range(n + 1):
        X, at = frames[i], 14 * i
        turn = slide = 0.0
        if i < n:
            turn = q[i] + chain[at + 13]
            slide = turn * chain[at + 12]
            turn -= slide
        co, si = cos(turn), sin(turn)
        for r in range(3):
            a, b, c, d = 1.0, 0.0, 0.0, 0.0
            if r == 1:
                a, b = 0.0, 1.0
            elif r == 2:
                a, c = 0.0, 1.0
            if i > 0:
                W = frames[i - 1]
                a, b, c, d = W[3 * r], W[3 * r + 1], W[3 * r + 2], W[9 + r]
            x = a * chain[at] + b * chain[at + 3] + c * chain[at + 6]
            y = a * chain[at + 1] + b * chain[at + 4] + c * chain[at + 7]
            z = a * chain[at + 2] + b * chain[at + 5] + c * chain[at + 8]
            X[9 + r] = d + a * chain[at + 9] + b * chain[at + 10] + c * chain[at + 11] + z * slide
            X[3 * r] = x * co + y * si
            X[3 * r + 1] = y * co - x * si
            X[3 * r + 2] = z


@kernel
def axis_columns(chain: Array1, spread: Array2, frames: Array2, J: Array2, lanes: Array2) -> None:
    """Write the Jacobian of the last of frames (m + 1, 12) to the first six rows of J, as in `jacobian.py`.

    Rows of `lanes`: room for that of the steps (6 rows at least).
    """
    if spread.shape[0] == 0:
        _columns(chain, frames, J)
        return
    _columns(chain, frames, lanes)
    for i in range(spread.shape[1] - 1):
        for r in range(6):
            total = 0.0
            for k in range(spread.shape[0]):
                total += lanes[r, k] * spread[k, i]
            J[r, i] = total


def _columns(chain: Array, frames: Array, J: Array) -> None:
    """Write the Jacobian of the last frame for the steps to the first six rows of J."""
    m = frames.shape[0] - 1
    M = frames[m]
    for i in range(m):
        X = frames[i]
        ax, ay, az = X[2], X[5], X[8]
        if chain[14 * i + 12] > 0.0:
            J[0, i], J[1, i], J[2, i] = ax, ay, az
            J[3, i] = J[4, i] = J[5, i] = 0.0
        else:
            x, y, z = M[9] - X[9], M[10] - X[10], M[11] - X[11]
            J[0, i], J[1, i], J[2, i] = ay * z - az * y, az * x - ax * z, ax * y - ay * x
            J[3, i], J[4, i], J[5, i] = ax, ay, az
