"""Forward kinematics of many configurations, in plain loops that numba compiles."""

from math import cos, sin

from ropsim.codegen import kernel
from ropsim.spatial import Array


@kernel("void(f8[:,:,::1], f8[:,::1], f8[::1], f8[::1], f8[:,::1], f8[:,::1], f8[:,:,::1])")
def forward_rows(R: Array, p: Array, slides: Array, offset: Array, X_nM: Array, Q: Array, out: Array) -> None:
    """Write X_BM of every row of Q (k, n) to out (k, 4, 4); arguments as in `ChainArrays`."""
    n = Q.shape[1]
    for k in range(Q.shape[0]):
        X = out[k]
        for r in range(3):
            for c in range(4):
                X[r, c] = 1.0 if r == c else 0.0
        for i in range(n + 1):
            if i < n:
                P, t = R[i], p[i]
                turn = Q[k, i] + offset[i]
                slide = turn * slides[i]
                turn -= slide
            else:
                P, t = X_nM[:, :3], X_nM[:, 3]
                turn = slide = 0.0
            co, si = cos(turn), sin(turn)
            for r in range(3):
                a, b, c = X[r, 0], X[r, 1], X[r, 2]
                x = a * P[0, 0] + b * P[1, 0] + c * P[2, 0]
                y = a * P[0, 1] + b * P[1, 1] + c * P[2, 1]
                z = a * P[0, 2] + b * P[1, 2] + c * P[2, 2]
                X[r, 3] += a * t[0] + b * t[1] + c * t[2] + z * slide
                X[r, 0] = x * co + y * si
                X[r, 1] = y * co - x * si
                X[r, 2] = z
        X[3, 0] = X[3, 1] = X[3, 2] = 0.0
        X[3, 3] = 1.0
