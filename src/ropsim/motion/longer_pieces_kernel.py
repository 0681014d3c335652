"""Segments of a time law, told over longer pieces, in a loop that numba compiles."""

from ropsim.codegen import kernel
from ropsim.spatial import Array


@kernel("void(f8[:,::1], i8, f8[::1], f8[::1], f8[:,::1], f8[::1])")
def over_longer(
    segments: Array, count: int, ends: Array, counts: Array, longer: Array, longer_ends: Array
) -> None:
    """Write the segments of a time law over longer pieces, each of several pieces with the same unit.

    Args:
        segments: columns as in `TimeLaw`, of every piece one or more, shape (8, m or more).
        count: of them, m.
        ends: times [s] at which the pieces end, shape (p,).
        counts: how many pieces are one, in order, shape (c,); their sum is p.
        longer: where the segments go, shape (8, m).
        longer_ends: where the times [s] go at which the longer pieces end, shape (c,).
    """
    number = piece = int(segments[0, 0])  # 0; a number in the text would be a type of its own for numba
    left, gone, first = int(counts[0]), 0.0, 0.0
    for k in range(count):
        if int(segments[0, k]) != piece:
            gone += segments[7, k - 1]
            left -= 1
            if left == 0:
                longer_ends[number] = ends[piece]
                number += 1
                left, first = int(counts[number]), gone
            piece = int(segments[0, k])
        longer[0, k], longer[1, k] = number, segments[1, k]
        longer[2, k], longer[7, k] = segments[2, k] + (gone - first), segments[7, k] + (gone - first)
        for row in range(3, 7):
            longer[row, k] = segments[row, k]
    longer_ends[number] = ends[piece]
