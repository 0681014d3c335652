"""Joint coordinates from the eigenvalue problem of an elimination: starts that are nearly answers already."""

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.solvers.general.elimination import (
    OFFSETS,
    Elimination,
    about_z,
    equations,
    inverse_pose,
    pencils,
)
from ropsim.spatial import Array

NEARLY_REAL = 1e-3
"""A root whose angle is this near to a real one [rad] is tried: rounding parts double roots by its square
root."""
TOGETHER = 5e-4
"""Roots this near to each other [rad] may share a space of vectors."""
ONE = 1e-5
"""Roots this near to each other [rad] are the same: the space is used once."""
SINGULAR = 1e-13
"""A matrix A whose least singular value is this part of its greatest one has no inverse."""
ROOTS = 24
"""Order of the eigenvalue problem; at most 16 roots are angles, 8 are ±i (Raghavan & Roth 1993)."""
HIGHER, LOWER = np.array([0, 1, 3, 4, 6, 7, 9, 10]), np.array([1, 2, 4, 5, 7, 8, 10, 11])
"""Entries of v = (x_d³, x_d², x_d, 1) ⊗ (x_e², x_e, 1) whose ratios are x_e; entries and those three
further on have the ratio x_d."""


def starts(way: Elimination, T: Array, almost: float = NEARLY_REAL) -> tuple[Array, Array]:
    """Return the results of the roots of k poses.

    Args:
        way: the elimination.
        T: poses X_BM, finite, shape (k, 4, 4).
        almost: roots whose angle is this near to a real one are given [rad].

    Returns:
        Joint coordinates [rad], NaN where there is no root, shape (k, 24 + s, 6) with up to s further ones
        from roots that share a space of vectors, and how regular the eigenvalue problem of each pose is, the
        ratio of the least to the greatest singular value of A, shape (k,).
    """
    C = way.loop(T)
    (A, B, D), right = pencils(way, C)
    out = np.full((len(T), ROOTS, 6), np.nan)
    values = np.linalg.svd(A, compute_uv=False)
    regular = np.divide(values[:, -1], values[:, 0], out=np.zeros(len(T)), where=values[:, 0] > 0.0)
    x = np.full((len(T), ROOTS), np.nan, dtype=complex)
    solvable = regular > SINGULAR
    x[solvable] = _roots(A[solvable], B[solvable], D[solvable])
    with np.errstate(divide="ignore", invalid="ignore"):  # of ±i, which are no angles
        angles = 2.0 * np.arctan(x)
    real = np.abs(angles.imag) < almost
    place, root = np.nonzero(real)
    c = angles.real[place, root]
    s_half, c_half = (part[:, np.newaxis, np.newaxis] for part in (np.sin(0.5 * c), np.cos(0.5 * c)))
    M = A[place] * s_half**2 + B[place] * (s_half * c_half) + D[place] * c_half**2
    vectors = np.linalg.svd(M)[2]  # rows, that of the least singular value last
    out[place, root] = _coordinates(way, C[place], right[place], c, vectors[:, -1])
    close = real[place] & (np.abs(np.sin(0.5 * (angles.real[place] - c[:, np.newaxis]))) < TOGETHER)
    shared = _sharing(close, angles.real[place], root)
    if not len(shared):
        return out, regular
    parted = [_parted(vectors[i], int(close[i].sum())) for i in shared]
    asked = np.repeat(shared, [len(rows) for rows in parted])
    at = place[asked]  # in order, to find the first one of a pose
    number = np.arange(len(at)) - np.searchsorted(at, at)
    more = np.full((len(T), int(number.max()) + 1, 6), np.nan)
    more[at, number] = _coordinates(way, C[at], right[at], c[asked], np.concatenate(parted))
    return np.concatenate((out, more), axis=1), regular


def _sharing(close: npt.NDArray[np.bool_], angles: Array, root: npt.NDArray[np.intp]) -> npt.NDArray[np.intp]:
    """Return which roots have others `close` by (s, 24), one of equal ones; angles (s, 24)."""
    own = angles[np.arange(len(root)), root][:, np.newaxis]
    same = close & (np.abs(np.sin(0.5 * (angles - own))) < ONE)
    before = np.arange(ROOTS) < root[:, np.newaxis]
    return np.flatnonzero((close.sum(axis=1) > 1) & ~(same & before).any(axis=1))


def _roots(A: Array, B: Array, C: Array) -> npt.NDArray[np.complex128]:
    """Return the eigenvalues of A·x² + B·x + C, shape (k, 24)."""
    F = np.zeros((len(A), ROOTS, ROOTS))
    F[:, :12, 12:] = np.eye(12)
    F[:, 12:, :12] = -np.linalg.solve(A, C)
    F[:, 12:, 12:] = -np.linalg.solve(A, B)
    return np.linalg.eigvals(F).astype(np.complex128)


def _parted(vectors: Array, count: int) -> Array:
    """Return the vectors (count, 12) of roots that share the space of the last ones of `vectors`, in rows.

    In that space multiplication by x_d and by x_e are matrices, whose common eigenvectors are computed. All
    of them are given: which one belongs to which root is not known where some roots are one and others only
    near.
    """
    V = vectors[-count:].T
    by_d = np.linalg.lstsq(V[3:], V[:-3], rcond=None)[0]
    by_e = np.linalg.lstsq(V[LOWER], V[HIGHER], rcond=None)[0]
    return np.asarray((V @ np.linalg.eig(by_d + 0.618 * by_e)[1].real).T)


def _coordinates(way: Elimination, C: Array, right: Array, c: Array, v: Array) -> Array:
    """Return joint coordinates for roots c (s,) [rad] and vectors v (s, 12), shape (s, 6)."""
    d = 2.0 * np.arctan2((v[:, :-3] * v[:, 3:]).sum(axis=1), (v[:, 3:] ** 2).sum(axis=1))
    e = 2.0 * np.arctan2((v[:, HIGHER] * v[:, LOWER]).sum(axis=1), (v[:, LOWER] ** 2).sum(axis=1))
    c, d, e = (angle - off for angle, off in zip((c, d, e), OFFSETS, strict=True))
    L = about_z(c) @ way.steps[3] @ about_z(d) @ way.steps[4] @ about_z(e) @ way.steps[5]
    apart = equations(L) - right[:, :, 8]
    terms = (np.linalg.pinv(right[:, :, :8]) @ apart[:, :, np.newaxis])[:, :, 0]
    a, b = np.arctan2(terms[:, 4], terms[:, 5]), np.arctan2(terms[:, 6], terms[:, 7])
    back = inverse_pose(C)
    X = inverse_pose(L) @ back[:, 2] @ about_z(-b) @ back[:, 1] @ about_z(-a) @ back[:, 0]
    f = np.arctan2(X[:, 1, 0] - X[:, 0, 1], X[:, 0, 0] + X[:, 1, 1])
    q = np.empty((len(c), 6))
    q[:, way.order] = np.stack((a, b, c, d, e, f), axis=1)
    return q
