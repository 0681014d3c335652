"""Accelerations, speeds and displacements under rows that must hold: a small dense solver.

To be made least is (x - M⁻¹f)ᵀ·M·(x - M⁻¹f) under A·x = b (C. F. Gauß's principle of least constraint; F. E.
Udwadia, R. E. Kalaba: Analytical Dynamics, Cambridge 1996, chapter 3). With M = L·Lᵀ and w = Lᵀ·x the rows
become those of A·L⁻ᵀ, which are made orthogonal, the longest remaining one first, each twice (G. H. Golub,
C. F. Van Loan: Matrix Computations, 4th ed., 2013, sections 5.2 and 5.5). Rows of which nothing is left
depend on earlier ones and are left out: redundant ones do no harm. To M is added Aᵀ·A times a number, which
changes no answer, so that coordinates without inertia may be determined by the rows alone; one that neither
inertia nor a row determines does not move.

The functions are compiled from their text, in the order of this file.
"""

import math

from ropsim.spatial import Array

DEPENDENT = 1e-9
"""Part of a row that is left, relative to the longest one, that is rounding."""

NOTHING = 1e-13
"""Pivot of a mass matrix, relative to its diagonal, that is rounding."""


def row_weight(M: Array, A: Array) -> float:
    """Return the number times which Aᵀ·A is about as large as M (n, n); A has the shape (r, n)."""
    n, r = M.shape[0], A.shape[0]
    most = largest = squares = 0.0
    for k in range(r):
        size = own = 0.0
        for i in range(n):
            square = A[k, i] * A[k, i]
            own += square
            if M[i, i] > 0.0:
                size += square / M[i, i]
        most = max(most, size)
        squares = max(squares, own)
    for i in range(n):
        largest = max(largest, M[i, i])
    if most > 0.0:
        return 1.0 / most
    return largest / squares if squares > 0.0 and largest > 0.0 else 1.0


def factor_mass(M: Array, A: Array, nothing: float, L: Array) -> None:
    """Enter the Cholesky factor of the mass matrix with the rows.

    Args:
        M: mass matrix, of which the lower triangle is read, shape (n, n).
        A: rows, shape (r, n).
        nothing: pivot, relative to the diagonal, that is rounding.
        L: gets the factor, with an infinite pivot for a coordinate without inertia, shape (n, n).
    """
    n, r = M.shape[0], A.shape[0]
    weight = row_weight(M, A)
    for j in range(n):
        for i in range(j, n):
            total = M[i, j]
            for k in range(r):
                total += weight * A[k, i] * A[k, j]
            L[i, j] = total
    for j in range(n):
        pivot = L[j, j]
        least = nothing * pivot
        for k in range(j):
            pivot -= L[j, k] * L[j, k]
        root = math.sqrt(pivot) if pivot > least else math.inf
        L[j, j] = root
        for i in range(j + 1, n):
            total = L[i, j]
            for k in range(j):
                total -= L[i, k] * L[j, k]
            L[i, j] = total / root


def longest_row(Q: Array, order: Array, first: int) -> float:
    """Exchange the longest of the rows from `first` on with that one; return the square of its length."""
    best, found = -1.0, first
    for place in range(first, Q.shape[0]):
        k = int(order[place])
        size = 0.0
        for i in range(Q.shape[1]):
            size += Q[k, i] * Q[k, i]
        if size > best:
            best, found = size, place
    order[first], order[found] = order[found], order[first]
    return best


def take_out(Q: Array, one: int, other: int) -> float:
    """Take out of a row the part along another one of length 1; return this part."""
    part = 0.0
    for i in range(Q.shape[1]):
        part += Q[one, i] * Q[other, i]
    for i in range(Q.shape[1]):
        Q[other, i] -= part * Q[one, i]
    return part


def factor_rows(A: Array, L: Array, dependent: float, Q: Array, R: Array, order: Array) -> None:
    """Enter the orthogonal factors of rows.

    Args:
        A: rows, shape (r, n).
        L: as `factor_mass` has entered it.
        dependent: part of a row that is left, relative to the longest one, that is rounding.
        Q: gets the rows that count, orthogonal, shape (r, n).
        R: gets the part of each row along each of those, shape (r, r).
        order: gets the numbers of these rows, and in the end how many there are; shape (r + 1,).
    """
    n, r = L.shape[0], A.shape[0]
    for k in range(r):
        for i in range(n):
            total = A[k, i]
            for j in range(i):
                total -= L[i, j] * Q[k, j]
            Q[k, i] = total / L[i, i]
        order[k] = k
    longest, rank = 0.0, 0
    for step in range(min(r, n)):
        size = longest_row(Q, order, step)
        longest = max(longest, size)
        if not size > dependent * dependent * longest:
            break
        own = int(order[step])
        for before in range(step):
            R[before, own] += take_out(Q, int(order[before]), own)
        size = 0.0
        for i in range(n):
            size += Q[own, i] * Q[own, i]
        root = math.sqrt(size)
        R[step, own] = root
        for i in range(n):
            Q[own, i] /= root
        for place in range(step + 1, r):
            k = int(order[place])
            R[step, k] = take_out(Q, own, k)
        rank = step + 1
    order[r] = rank


def solve_rows(
    L: Array, Q: Array, R: Array, order: Array, f: Array, b: Array, parts: Array, x: Array
) -> None:
    """Enter the x under which A·x = b that differs least from M⁻¹·f.

    Args:
        L: as `factor_mass` has entered it.
        Q: as `factor_rows` has entered it.
        R: as `factor_rows` has entered it.
        order: as `factor_rows` has entered it.
        f: shape (n,).
        b: shape (r,).
        parts: room to work in, shape (r,).
        x: gets the answer, shape (n,).
    """
    n, r = L.shape[0], Q.shape[0]
    for i in range(n):
        total = f[i]
        for j in range(i):
            total -= L[i, j] * x[j]
        x[i] = total / L[i, i]
    for step in range(int(order[r])):
        own = int(order[step])
        part = b[own]
        for before in range(step):
            part -= R[before, own] * parts[before]
        part /= R[step, own]
        parts[step] = part
        for i in range(n):
            part -= Q[own, i] * x[i]
        for i in range(n):
            x[i] += part * Q[own, i]
    for i in range(n - 1, -1, -1):
        total = x[i]
        for j in range(i + 1, n):
            total -= L[j, i] * x[j]
        x[i] = total / L[i, i]


def signed_volume(D: Array) -> float:
    """Return the determinant of a square matrix, by elimination with exchange of rows; D is not kept."""
    p, volume = D.shape[0], 1.0
    for step in range(p):
        best = step
        for i in range(step + 1, p):
            if abs(D[i, step]) > abs(D[best, step]):
                best = i
        if best != step:
            volume = -volume
            for j in range(step, p):
                D[step, j], D[best, j] = D[best, j], D[step, j]
        volume *= D[step, step]
        if volume == 0.0:
            return 0.0
        for i in range(step + 1, p):
            factor = D[i, step] / D[step, step]
            for j in range(step + 1, p):
                D[i, j] -= factor * D[step, j]
    return volume
