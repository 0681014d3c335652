"""Derivatives of the joints along a path of the tool, in plain loops that numba compiles.

With the Jacobian J at the TCP and its derivative J' along the path, tool derivatives v' and a' give J·q' = v'
and J·q'' = a' - J'·q'. An arm with one joint more than its pose needs takes the least q', at right angles to
the null vector n of J; with J·n' = -J'·n that also determines n·q''.
"""

from typing import NamedTuple

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.kinematics.chain.steps_kernel import axis_columns, place_steps, spread_over
from ropsim.spatial import Array

SINGULAR = 1e-5
"""Least pivot of a Jacobian by its greatest one; below, rounding of the joints would count in derivatives."""
ASIDE = 1e-6
"""Share of the derivatives of the tool that the joints may miss."""


class DerivativeWork(NamedTuple):
    """Room to work in, of an arm with m steps and n axes.

    Attributes:
        frames: of the steps, then the tool: R of the interface by rows, and the TCP, shape (m + 1, 12).
        lanes: columns of the Jacobian of the steps, and their coordinates, shape (7, m).
        changes: derivatives of these columns along the path, shape (6, m).
        columns: of the Jacobian of the axes, then of its derivative, shape (12, n).
        solved: the Jacobian and its inverse on the way to the unit matrix, shape (6, n + 6).
        vectors: null vector of the Jacobian, an answer or the velocity of the TCP, the pivot of each row,
            which axes have one, right side of an equation, shape (5, max(n, 6)).
    """

    frames: Array2
    lanes: Array2
    changes: Array2
    columns: Array2
    solved: Array2
    vectors: Array2


@kernel
def derivatives_along(
    chain: Array1,
    spread: Array2,
    active: Array1,
    p_MT: Array1,
    Q: Array2,
    tool: Array3,
    out: Array3,
    work: DerivativeWork,
    result: Array1,
) -> None:
    """Write first and second derivatives of the joints at rows of a path.

    Args:
        chain: `ChainArrays.flat` of the arm with m steps and n axes.
        spread: `ChainArrays.spread`.
        active: 1.0 for axes that move the tool along the path, at most seven; 0.0 for those that stand still,
            shape (n,).
        p_MT: TCP in the interface [m], shape (3,).
        Q: coordinates of the axes [rad | m], shape (k, n).
        tool: first and second derivatives of position and angular velocity, shape (2, k, 6).
        out: where the derivatives go, shape (2, k, n).
        work: room to work in.
        result: set to 1.0, or to 0.0 where a row is near a singularity, shape (1,).
    """
    result[0] = 1.0
    for k in range(Q.shape[0]):
        spread_over(spread, Q[k], work.lanes[6])
        place_steps(chain, work.lanes[6], work.frames)
        if not row_derivatives(
            chain, spread, active, p_MT, tool[0, k], tool[1, k], out[0, k], out[1, k], work
        ):
            result[0] = 0.0
            return


def row_derivatives(
    chain: Array,
    spread: Array,
    active: Array,
    p_MT: Array,
    d1: Array,
    d2: Array,
    first: Array,
    second: Array,
    work: DerivativeWork,
) -> bool:
    """Write the derivatives of the joints where the frames of the steps are placed; return whether there are.

    The frame of the interface is moved to the TCP. Arguments as in `derivatives_along`, of one row.
    """
    n, columns, vectors = first.shape[0], work.columns, work.vectors
    M = work.frames[work.frames.shape[0] - 1]
    for r in range(3):
        M[9 + r] += M[3 * r] * p_MT[0] + M[3 * r + 1] * p_MT[1] + M[3 * r + 2] * p_MT[2]
    axis_columns(chain, spread, work.frames, columns, work.lanes)
    free = invert(active, columns, work.solved, vectors)
    if free < -1:
        return False
    null, answer, right = vectors[0], vectors[1], vectors[4]
    square = _null_vector(work.solved, vectors, free, n)
    for r in range(6):
        right[r] = d1[r]
    solve_pivots(work.solved, vectors, n, first)
    along = _dot(n, null, first) / square
    for i in range(n):
        first[i] -= along * null[i]
    column_changes(chain, spread, work, first)
    for r in range(6):
        total = 0.0
        for i in range(n):
            total += columns[6 + r, i] * null[i]
        right[r] = total
    solve_pivots(work.solved, vectors, n, answer)
    turned = _dot(n, answer, first)
    for r in range(6):
        total = d2[r]
        for i in range(n):
            total -= columns[6 + r, i] * first[i]
        right[r] = total
    solve_pivots(work.solved, vectors, n, second)
    along = (_dot(n, null, second) - turned) / square
    for i in range(n):
        second[i] -= along * null[i]
    return holds(columns, first, second, d1, right)


def holds(columns: Array, first: Array, second: Array, d1: Array, right: Array) -> bool:
    """Return whether both derivatives of the joints lead the tool as they should.

    An arm with fewer than six joints follows paths only that are within its reach, and others within the
    accuracy of its inverse kinematics.
    """
    for r in range(6):
        gone, turned, size = -d1[r], -right[r], abs(d1[r]) + abs(right[r])
        for i in range(first.shape[0]):
            gone += columns[r, i] * first[i]
            turned += columns[r, i] * second[i]
            size = max(size, abs(columns[r, i] * first[i]), abs(columns[r, i] * second[i]))
        if not max(abs(gone), abs(turned)) <= ASIDE * max(size, 1.0):
            return False
    return True


def invert(active: Array, J: Array, solved: Array, vectors: Array) -> int:
    """Bring the active columns of a Jacobian to unit columns by elimination with full pivoting.

    Returns:
        the active axis without a pivot, -1 for none, -2 at a singularity.
    """
    n, pivots, taken = active.shape[0], vectors[2], vectors[3]
    count = 0
    for i in range(n):
        taken[i] = 1.0 - active[i]
        count += 1 if active[i] > 0.0 else 0
        for r in range(6):
            solved[r, i] = J[r, i]
    for r in range(6):
        pivots[r] = -1.0
        for c in range(6):
            solved[r, n + c] = 1.0 if c == r else 0.0
    greatest = 0.0
    for step in range(min(count, 6)):
        row, column = _largest(solved, taken, step)
        most = abs(solved[row, column])
        greatest = max(greatest, most)
        if not most > SINGULAR * greatest:
            return -2
        _eliminate(solved, step, row, column)
        taken[column], pivots[step] = 1.0, float(column)
    for i in range(n):
        if taken[i] == 0.0:
            return i
    return -1


def _largest(solved: Array, taken: Array, step: int) -> tuple[int, int]:
    """Return row and column of the largest number in columns without a pivot, from a row on."""
    row, column, most = step, 0, -1.0
    for r in range(step, 6):
        for c in range(solved.shape[1] - 6):
            if taken[c] == 0.0 and abs(solved[r, c]) > most:
                row, column, most = r, c, abs(solved[r, c])
    return row, column


def _eliminate(solved: Array, step: int, row: int, column: int) -> None:
    """Bring the pivot in a row to the row of its step, and make its column a unit column."""
    pivot = solved[row, column]
    for c in range(solved.shape[1]):
        held = solved[row, c]
        solved[row, c] = solved[step, c]
        solved[step, c] = held / pivot
    for r in range(6):
        factor = solved[r, column]
        if r != step and factor != 0.0:
            for c in range(solved.shape[1]):
                solved[r, c] -= factor * solved[step, c]


def _null_vector(solved: Array, vectors: Array, free: int, n: int) -> float:
    """Write the null vector of the Jacobian, zeros where there is none; return its square, or 1.0."""
    null, pivots = vectors[0], vectors[2]
    for i in range(n):
        null[i] = 0.0
    if free < 0:
        return 1.0
    null[free], square = 1.0, 1.0
    for r in range(6):
        if pivots[r] >= 0.0:
            value = -solved[r, free]
            null[int(pivots[r])] = value
            square += value * value
    return square


def solve_pivots(solved: Array, vectors: Array, n: int, out: Array) -> None:
    """Write joint rates (n,) that have the tool rates of the right side; of an axis without pivot 0."""
    pivots, right = vectors[2], vectors[4]
    for i in range(n):
        out[i] = 0.0
    for r in range(6):
        if pivots[r] >= 0.0:
            total = 0.0
            for c in range(6):
                total += solved[r, n + c] * right[c]
            out[int(pivots[r])] = total


def column_changes(chain: Array, spread: Array, work: DerivativeWork, rates: Array) -> None:
    """Write the derivative of the Jacobian along joint rates (n,) behind the Jacobian.

    Frame by frame its velocity v and angular velocity w add up; the axis z of a step changes by w × z.
    """
    frames, changes, columns, vectors = work.frames, work.changes, work.columns, work.vectors
    m, n = frames.shape[0] - 1, rates.shape[0]
    M, v_M = frames[m], vectors[1]
    for r in range(3):
        v_M[r] = 0.0
        for j in range(n):
            v_M[r] += columns[r, j] * rates[j]
    vx = vy = vz = wx = wy = wz = px = py = pz = 0.0
    for i in range(m):
        X, speed = frames[i], 0.0
        if spread.shape[0] == 0:
            speed = rates[i]
        else:
            for j in range(n):
                speed += spread[i, j] * rates[j]
        zx, zy, zz = X[2], X[5], X[8]
        dx, dy, dz = X[9] - px, X[10] - py, X[11] - pz
        vx, vy, vz = vx + wy * dz - wz * dy, vy + wz * dx - wx * dz, vz + wx * dy - wy * dx
        px, py, pz = X[9], X[10], X[11]
        ax, ay, az = wy * zz - wz * zy, wz * zx - wx * zz, wx * zy - wy * zx
        if chain[14 * i + 12] > 0.0:
            vx, vy, vz = vx + zx * speed, vy + zy * speed, vz + zz * speed
            changes[0, i], changes[1, i], changes[2, i] = ax, ay, az
            changes[3, i] = changes[4, i] = changes[5, i] = 0.0
        else:
            x, y, z = M[9] - px, M[10] - py, M[11] - pz
            dx, dy, dz = v_M[0] - vx, v_M[1] - vy, v_M[2] - vz
            changes[0, i] = ay * z - az * y + zy * dz - zz * dy
            changes[1, i] = az * x - ax * z + zz * dx - zx * dz
            changes[2, i] = ax * y - ay * x + zx * dy - zy * dx
            changes[3, i], changes[4, i], changes[5, i] = ax, ay, az
            wx, wy, wz = wx + zx * speed, wy + zy * speed, wz + zz * speed
    for i in range(n):
        for r in range(6):
            total = 0.0
            if spread.shape[0] == 0:
                total = changes[r, i]
            else:
                for k in range(m):
                    total += changes[r, k] * spread[k, i]
            columns[6 + r, i] = total


def _dot(n: int, one: Array, other: Array) -> float:
    total = 0.0
    for i in range(n):
        total += one[i] * other[i]
    return total
