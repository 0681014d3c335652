"""How slowly a path is crept along, in a loop that numba compiles."""

from ropsim.codegen import Array1, Array2, kernel

_CREEP = 0.02
"""Share of the speed of joints at which dry friction is as in motion and nothing else counts."""
_TINY = 2.0**-1022


@kernel
def creeping(d1: Array2, speed: Array1, out: Array2) -> None:
    """Write the speeds of joints that creep, a small share of their limits and of their greatest speeds.

    Args:
        d1: derivatives of joint coordinates by motion time, shape (m, n).
        speed: limits of the joints, shape (n,).
        out: becomes the speeds, shape (m, n), m >= 1.
    """
    m, n = d1.shape
    for j in range(n):
        out[0, j] = 0.0
        for i in range(m):
            out[0, j] = max(out[0, j], abs(d1[i, j]))
        out[0, j] = min(speed[j], out[0, j] + _TINY)
    for i in range(m - 1, -1, -1):
        share = _CREEP
        for j in range(n):
            share = max(share, abs(d1[i, j]) / out[0, j])
        for j in range(n):
            out[i, j] = d1[i, j] * (_CREEP / share)
