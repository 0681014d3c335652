"""How far points are from segments, in plain loops that numba compiles."""

from math import inf, sqrt

from ropsim.codegen import Array1, Array2, kernel


@kernel
def segment_distances(segments: Array2, spans: Array2, points: Array2, distances: Array1) -> None:
    """Write the distances of points from the segments to which they belong.

    Args:
        segments: start and displacement of each [m], shape (m, 6).
        spans: numbers of the first point that belongs to each of them, and behind the last, shape (m, 2).
        points: in the frame of the segments [m], shape (k, 3).
        distances: output [m], shape (k,); entries of other points stay unchanged.
    """
    for m in range(segments.shape[0]):
        x, y, z = segments[m, 0], segments[m, 1], segments[m, 2]
        a, b, c = segments[m, 3], segments[m, 4], segments[m, 5]
        square = a * a + b * b + c * c
        square = square if square > 0.0 else inf
        u, v, w = a / square, b / square, c / square
        for k in range(int(spans[m, 0]), int(spans[m, 1])):
            i, j, h = points[k, 0] - x, points[k, 1] - y, points[k, 2] - z
            r = i * u + j * v + h * w
            r = 0.0 if r < 0.0 else r
            r = 1.0 if r > 1.0 else r
            i, j, h = i - r * a, j - r * b, h - r * c
            distances[k] = sqrt(i * i + j * j + h * h)
