"""Rows of a straight way in joint space, in a loop that numba compiles."""

from ropsim.codegen import kernel
from ropsim.spatial import Array


@kernel("void(f8[::1], f8[::1], f8[::1], f8[:,:,::1])")
def line_points(q_start: Array, q_end: Array, s: Array, out: Array) -> None:
    """Write coordinates and their first two derivatives at places from 0 to 1.

    Args:
        q_start: joint coordinates at place 0 [rad | m], shape (n,).
        q_end: at place 1 [rad | m], shape (n,).
        s: places, shape (k,).
        out: where the rows go, shape (3, k, n).
    """
    for k in range(s.shape[0]):
        for j in range(q_start.shape[0]):
            out[0, k, j] = (1.0 - s[k]) * q_start[j] + s[k] * q_end[j]
            out[1, k, j], out[2, k, j] = q_end[j] - q_start[j], 0.0
