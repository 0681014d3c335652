"""A time law over path limits, expressed over longer path segments, in loops that numba compiles."""

from ropsim.codegen import Array1, Array2, Array3, kernel
from ropsim.motion.time_law.time_law_kernel import plan_segments
from ropsim.spatial import Array


@kernel
def plan_longer(
    bounds: Array2,
    counts: Array1,
    tables: Array3,
    rises: Array3,
    rows: Array2,
    ends: Array1,
    longer_ends: Array1,
    result: Array1,
) -> None:
    """Write the result of `plan_segments`, expressed over path segments of several intervals.

    Args:
        bounds: of the path limits, see `plan_segments`, and so are tables, rises, rows and ends, shape (s,
            6).
        counts: how many path limits are one path segment, in order, shape (c,); their sum is s.
        tables: see there.
        rises: see there.
        rows: see there; they count path segments.
        ends: see there, of the path limits, shape (s,).
        longer_ends: where the times [s] go at which the path segments end, shape (c,).
        result: see there.
    """
    plan_segments(bounds, tables, rises, rows, ends, result)
    if result[0] >= 0.0:
        _over_longer(rows, int(result[0]), ends, counts, longer_ends)


def _over_longer(segments: Array, count: int, ends: Array, counts: Array, longer_ends: Array) -> None:
    """Change the numbers of path segments to those of longer ones, each of several with the same unit.

    Args:
        segments: columns as in `TimeLaw`, of every path segment one or more; they change; shape (8, m or
            more).
        count: of them, m.
        ends: times [s] at which the path segments end, shape (p,).
        counts: how many path segments are one, in order, shape (c,); their sum is p.
        longer_ends: where the times [s] go at which the longer path segments end, shape (c,).
    """
    # 0; a number in the text would be a type of its own for numba
    number = path_segment = int(segments[0, 0])
    left, gone, first, length = int(counts[0]), 0.0, 0.0, 0.0
    for k in range(count):
        if int(segments[0, k]) != path_segment:
            gone += length
            left -= 1
            if left == 0:
                longer_ends[number] = ends[path_segment]
                number += 1
                left, first = int(counts[number]), gone
            path_segment = int(segments[0, k])
        length = segments[7, k]
        segments[0, k] = number
        segments[2, k] += gone - first
        segments[7, k] += gone - first
    longer_ends[number] = ends[path_segment]
