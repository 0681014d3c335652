"""Axis vectors that fill ranges evenly, always the same ones."""

import numpy as np

from ropsim.spatial import Array
from ropsim.workspace.ranges import AxisRanges


def even_rows(ranges: AxisRanges, count: int) -> Array:
    """Return axis vectors that fill ranges, by the rule of `kinematics.configurations`, shape (count, n).

    Other than there the ranges are those of the workspace, which are finite for axes without limits.
    """
    n = len(ranges.lower)
    phi = 2.0
    for _ in range(64):  # contracts to the root of φⁿ⁺¹ = φ + 1
        phi = (1.0 + phi) ** (1.0 / (n + 1))
    shares = np.modf(np.outer(np.arange(1, count + 1), phi ** -np.arange(1.0, n + 1.0)))[0]
    return np.asarray(ranges.lower + shares * ranges.extent)
