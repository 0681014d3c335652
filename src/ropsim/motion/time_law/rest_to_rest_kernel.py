"""Ways of one piece, each walked from rest to rest, in a loop that numba compiles."""

from math import nan

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.motion.time_law.time_law_kernel import plan_segments

MOST_SEGMENTS = 16
"""Of one piece, up and down."""


@kernel
def plan_alone(
    bounds: Array2,
    ways: Array3,
    courses: Array3,
    rows: Array2,
    told: Array1,
    times: Array1,
    counts: Array1,
    laws: Array2,
) -> None:
    """Write the times [s] that pieces take, each from rest to rest, and their segments.

    Args:
        bounds: of k pieces, see `plan_segments`, shape (k, 6).
        ways: room for one of them, as there, and so are courses, rows and told.
        courses: see there.
        rows: see there.
        told: see there.
        times: where they go, NaN for a piece whose bounds no motion can have, shape (k,).
        counts: become the numbers of segments m of each, shape (k,).
        laws: row by row the segments of each, which take the first 8·m numbers of a row, shape
            (k, 8·MOST_SEGMENTS).
    """
    for k in range(bounds.shape[0]):
        plan_segments(bounds[k : k + 1], ways, courses, rows, times[k : k + 1], told)
        if told[0] < 0.0:
            times[k], counts[k] = nan, 0.0
            continue
        counts[k] = told[0]
        count = int(told[0])
        for row in range(rows.shape[0]):
            for i in range(count):
                laws[k, row * count + i] = rows[row, i]
