"""Rows of a straight path in joint space, in a loop that numba compiles."""

from ropsim.codegen import Array1, Array2, Array3, columns, kernel
from ropsim.spatial import Array


@kernel
def line_points(q_start: Array1, q_end: Array1, s: Array1, out: Array3) -> None:
    """Write coordinates and their first two derivatives at path parameters from 0 to 1.

    Args:
        q_start: joint coordinates at path parameter 0 [rad | m], shape (n,).
        q_end: at path parameter 1 [rad | m], shape (n,).
        s: path parameters, shape (k,).
        out: where the rows go, shape (3, k, n).
    """
    for k in range(s.shape[0]):
        _line(q_start.shape[0], s[k], 1.0, 0.0, q_start, q_end, out[0, k], out[1, k], out[2, k])


@kernel
def line_in_time(
    q_start: Array1, q_end: Array1, law: Array2, first: int, until: int, at: int, total: Array3
) -> None:
    """Write coordinates and derivatives by time at times of a motion, see `traced_in_time`.

    Args:
        q_start: joint coordinates at path parameter 0 [rad | m], shape (n,).
        q_end: at path parameter 1 [rad | m], shape (n,).
        law: path parameters, speeds and accelerations in its rows 1 to 3, shape (4 or more, m).
        first: number of the first time.
        until: number behind that of the last one.
        at: row of the motion for the time 0 of the law.
        total: the motion, of which rows at + first to at + until are written, shape (3, m, n).
    """
    for k in range(first, until):
        s, v, a = law[1, k], law[2, k], law[3, k]
        _line(q_start.shape[0], s, v, a, q_start, q_end, total[0, at + k], total[1, at + k], total[2, at + k])


@columns
def _line(
    count: int, s: float, v: float, a: float, q_start: Array, q_end: Array, q: Array, qd: Array, qdd: Array
) -> None:
    """Write coordinates at a path parameter traversed with the speed v and the acceleration a."""
    for j in range(count):
        displacement = q_end[j] - q_start[j]
        q[j] = (1.0 - s) * q_start[j] + s * q_end[j]
        qd[j] = displacement * v
        qdd[j] = displacement * a
