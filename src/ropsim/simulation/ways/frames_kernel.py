"""Frames of carriers as others see them, and distances from axes, over the rows of a run; compiled."""

from math import sqrt

from ropsim.codegen import Array2, Array3, kernel


@kernel
def write_seen(frames: Array3, centres: Array2, seen: Array2, first: int) -> None:
    """Write the frames of carriers in those of others behind a number of frames.

    Args:
        frames: R_W by rows and p_W of the centre of each carrier by rows [m], shape (c + s, k, 12).
        centres: in the frames of the carriers [m], shape (c, 3).
        seen: numbers of two carriers, of which the second one is expressed in the frame of the first, -1 for
            the world; shape (s, 2).
        first: number of the first frame that is written.
    """
    for s in range(seen.shape[0]):
        one, other = int(seen[s, 0]), int(seen[s, 1])
        for i in range(frames.shape[1]):
            X, found = frames[other, i], frames[first + s, i]
            if one < 0:
                for e in range(12):
                    found[e] = X[e]
                continue
            Y = frames[one, i]
            for r in range(3):
                for c in range(3):
                    found[3 * r + c] = Y[r] * X[c] + Y[3 + r] * X[3 + c] + Y[6 + r] * X[6 + c]
                away = Y[r] * (X[9] - Y[9]) + Y[3 + r] * (X[10] - Y[10]) + Y[6 + r] * (X[11] - Y[11])
                found[9 + r] = away + centres[one, r]


@kernel
def write_farthest(frames: Array3, origins: Array3, wanted: Array2) -> None:
    """Write the greatest distances of centres from points on axes.

    Args:
        frames: of carriers, shape (c, k, 12).
        origins: points by rows [m], shape (l, k, 3).
        wanted: number of a carrier, of a point, and the greatest distance, written here [m]; shape (w, 3).
    """
    for w in range(wanted.shape[0]):
        c, link, most = int(wanted[w, 0]), int(wanted[w, 1]), 0.0
        for i in range(frames.shape[1]):
            square = 0.0
            for r in range(3):
                square += (frames[c, i, 9 + r] - origins[link, i, r]) ** 2
            most = max(most, square)
        wanted[w, 2] = sqrt(most)
