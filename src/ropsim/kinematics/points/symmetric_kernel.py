"""Eigenvectors of small symmetric matrices, in plain loops that numba compiles."""

from math import sqrt

from ropsim.spatial import Array

SWEEPS = 12
"""Turns of all pairs of rows at most; each sweep squares what is left beside the diagonal."""


def eigenvectors(d: int, S: Array, U: Array, w: Array) -> None:
    """Write the eigenvectors of S (d, d) as columns of U, and its eigenvalues, the greatest first, to w (d,).

    Jacobi's turns (1846) in the form of Golub and Van Loan, Matrix Computations, section 8.5; S becomes
    diagonal.
    """
    for a in range(d):
        for b in range(d):
            U[a, b] = 1.0 if a == b else 0.0
    for _ in range(SWEEPS):
        beside = 0.0
        for a in range(d):
            for b in range(a):
                beside += abs(S[a, b])
        if beside == 0.0:
            break
        for a in range(d - 1):
            for b in range(a + 1, d):
                if S[a, b] != 0.0:
                    _turn(d, S, U, a, b)
    _sort(d, S, U, w)


def _sort(d: int, S: Array, U: Array, w: Array) -> None:
    """Write the diagonal of S to w, the greatest number first, with the columns of U in that order."""
    for a in range(d):
        w[a] = S[a, a]
    for a in range(d - 1):
        for b in range(a + 1, d):
            if w[b] > w[a]:
                held = w[a]
                w[a], w[b] = w[b], held
                for r in range(d):
                    held = U[r, a]
                    U[r, a], U[r, b] = U[r, b], held


def _turn(d: int, S: Array, U: Array, a: int, b: int) -> None:
    """Bring entry (a, b) to zero."""
    tau = (S[b, b] - S[a, a]) / (2.0 * S[a, b])
    t = 1.0 / (abs(tau) + sqrt(1.0 + tau * tau))
    t = t if tau >= 0.0 else -t
    co = 1.0 / sqrt(1.0 + t * t)
    si = t * co
    for r in range(d):
        one, other = S[r, a], S[r, b]
        S[r, a], S[r, b] = co * one - si * other, si * one + co * other
    for r in range(d):
        one, other = S[a, r], S[b, r]
        S[a, r], S[b, r] = co * one - si * other, si * one + co * other
    S[a, b] = S[b, a] = 0.0
    for r in range(d):
        one, other = U[r, a], U[r, b]
        U[r, a], U[r, b] = co * one - si * other, si * one + co * other
