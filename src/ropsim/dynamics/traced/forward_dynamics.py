"""Forward dynamics: accelerations from torques, M(q)·q̈ = τ - h(q, q̇), by an LDLᵀ factorisation written out.

Bias by Newton–Euler, mass matrix by composite rigid bodies: for up to about a dozen joints cheaper than the
articulated-body algorithm (R. Featherstone: Rigid Body Dynamics Algorithms, 2008, section 10.3). The
factorisation runs from the last joint to the first and keeps the matrix well scaled: reflected motor inertia
dominates the wrist.
"""

from collections.abc import Sequence

from ropsim.codegen import Scalar


def trace_solve(lower: Sequence[Sequence[Scalar]], right: Sequence[Scalar]) -> list[Scalar]:
    """Return x of A·x = b for a symmetric positive definite A.

    Args:
        lower: lower triangle of A; row i has i + 1 entries.
        right: b, n of them.
    """
    n = len(right)
    L = [list(row) for row in lower]
    inverse: list[Scalar] = [right[0]] * n
    for k in range(n - 1, -1, -1):  # A = Lᵀ·D·L with unit lower triangular L
        inverse[k] = 1.0 / L[k][k]
        for i in range(k):
            factor = L[k][i] * inverse[k]
            for j in range(i + 1):
                L[i][j] = L[i][j] - factor * L[k][j]
        for i in range(k):
            L[k][i] = L[k][i] * inverse[k]
    x = list(right)
    for k in range(n - 1, -1, -1):
        for i in range(k):
            x[i] = x[i] - L[k][i] * x[k]
    for k in range(n):
        x[k] = x[k] * inverse[k]
        for i in range(k):
            x[k] = x[k] - L[k][i] * x[i]
    return x
