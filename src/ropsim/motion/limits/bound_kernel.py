"""Bounds of the rows of the fastest course, in a loop that numba compiles."""

from ropsim.codegen import Array1, Array2, kernel


@kernel
def bound(
    most: Array2,
    share: Array1,
    caps: Array1,
    wider: float,
    before: Array2,
    lower: Array2,
    upper: Array2,
    same: Array1,
) -> None:
    """Write the bounds of the first rows of `fastest`, and where they are those of the call before.

    Args:
        most: greatest sizes of rows, shape (m, n), or (1, n) for the same at all places.
        share: what is used of them, shape (m,).
        caps: bounds of x, shape (m,).
        wider: factor of the bounds.
        before: share and caps of the call before; become those of this one, shape (2, m).
        lower: its first n columns become minus the bounds, shape (m, r).
        upper: its first n columns become the bounds, shape (m, r).
        same: becomes 1 where all is as in the call before, 0 elsewhere, shape (m,).
    """
    constant = most.shape[0] == 1
    for i in range(share.shape[0]):
        here, is_same = 0 if constant else i, share[i] == before[0, i]
        same[i] = 1.0 if is_same and caps[i] == before[1, i] else 0.0
        before[0, i], before[1, i] = share[i], caps[i]
        for r in range(0 if is_same else most.shape[1]):
            upper[i, r] = most[here, r] * share[i] * wider
            lower[i, r] = -upper[i, r]
