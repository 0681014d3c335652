"""Natural cubic spline: its slopes and bends at the knots, where only values are given."""

from itertools import pairwise

import numpy as np

from ropsim.spatial import Array


def natural_derivatives(chords: Array, steps: Array) -> tuple[Array, Array]:
    """Return first and second derivatives of the natural cubic spline at its knots, each (m, n).

    Its second derivatives solve a tridiagonal system, by elimination without pivoting (the diagonal is twice
    the sum of its neighbours).

    Args:
        chords: between the knots, shape (m - 1,).
        steps: of the values from knot to knot, shape (m - 1, n).

    References:
        Farin 2002, Curves and Surfaces for CAGD, chapter 9.
    """
    slopes = steps / chords[:, None]
    h = chords.tolist()
    second = np.zeros((len(h) + 1, steps.shape[1]))
    second[1:-1] = 6.0 * np.diff(slopes, axis=0)
    diagonal = [2.0 * (before + after) for before, after in pairwise(h)]
    for k in range(1, len(diagonal)):
        share = h[k] / diagonal[k - 1]
        diagonal[k] -= share * h[k]
        second[k + 1] -= share * second[k]
    for k in range(len(diagonal), 0, -1):
        second[k] = (second[k] - h[k] * second[k + 1]) / diagonal[k - 1]
    by_chord = chords[:, None] / 6.0
    first = np.empty(second.shape)
    first[:-1] = slopes - by_chord * (2.0 * second[:-1] + second[1:])
    first[-1] = slopes[-1] + by_chord[-1] * (second[-2] + 2.0 * second[-1])
    return first, second
