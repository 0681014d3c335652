"""Stages along a curve of the tool, found in one compiled loop."""

import numpy as np

from ropsim.controller.curve_stages_kernel import curve_stages
from ropsim.motion import Curve, Stages
from ropsim.spatial import Array

_ROOM = 8
"""Times as many places as in the grid of a curve for which there is room."""
_LONGEST = 600
"""Places in the grid of a curve for which that is; a corner has 129 at the most."""
_STRAIGHT = 1e-9
"""A path of the tool whose direction changes by less from end to end is straight."""


def stages_of_curve(curve: Curve, rates: Array, share: float) -> Stages | None:
    """Return the stages of a bent curve; None of one that is straight, too long or too uneven.

    They are those that `bends_of` leads to from the curve's own grid on.

    Args:
        curve: of the tool.
        rates: limits of speed, acceleration and jerk of position and orientation, shape (3, 2).
        share: of the highest speed that its bends allow, at which it is walked at the most.
    """
    grid = curve.own_grid()
    if len(grid) > _LONGEST:
        return None
    m = _ROOM * len(grid)
    out, told = np.empty((m, 7)), np.empty(5)
    rows = np.empty((4, m, 6))
    curve_stages(
        *curve.numbers,
        rates,
        share,
        np.ascontiguousarray(grid),
        np.empty((4, m)),
        rows,
        rows[:2].reshape(2 * m, 2, 3),
        np.empty((10, m, 2)),
        np.empty((m, 4, 4)),
        np.empty((2, m, 7)),
        out,
        told,
    )
    count, d1, d2, *_ = told.tolist()
    if not count or d2 * curve.length <= _STRAIGHT * d1:
        return None
    return Stages(out[: int(count), :4].copy())
