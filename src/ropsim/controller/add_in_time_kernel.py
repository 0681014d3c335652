"""A path of any kind, added to a motion over time, in a loop that numba compiles."""

from ropsim.codegen import kernel
from ropsim.spatial import Array


@kernel("void(f8[:,::1], f8[:,::1], f8[:,::1], f8[::1], f8[::1], i8, i8, f8[::1], f8[:,:,::1])")
def add_in_time(
    q: Array,
    d1: Array,
    d2: Array,
    speeds: Array,
    accelerations: Array,
    first: int,
    shared: int,
    corner: Array,
    total: Array,
) -> None:
    """Write coordinates and derivatives by time: q' = dq/ds·v and q'' = d²q/ds²·v² + dq/ds·a.

    Args:
        q: joint coordinates at k places of a path [rad | m], shape (k, n).
        d1: their first derivatives by the place, shape (k, n).
        d2: second ones.
        speeds: along the path at the k times, v, shape (k,).
        accelerations: along it, a, shape (k,).
        first: row of the motion at which the first of them is.
        shared: row of the motion up to which another path still ends: there both are added, as far as they
            are from the corner between them.
        corner: joint coordinates there [rad | m], shape (n,).
        total: the motion; rows from `first` on are written, shape (3, m, n).
    """
    for k in range(q.shape[0]):
        row, v, a = first + k, speeds[k], accelerations[k]
        for j in range(q.shape[1]):
            place, slope, bend = q[k, j], d1[k, j] * v, d2[k, j] * (v * v) + d1[k, j] * a
            if row < shared:
                place += total[0, row, j] - corner[j]
                slope += total[1, row, j]
                bend += total[2, row, j]
            total[0, row, j], total[1, row, j], total[2, row, j] = place, slope, bend
