"""A contour in its plane, and the attained path with its error enlarged."""

import numpy as np

from ropsim.spatial import Array, frozen, record
from ropsim.views.accuracy.contours import ContourFigures, ContourRows

SHARE = 0.08
"""An error is drawn at most this share of the size of its contour long."""
_STEPS = (1, 2, 5)


@record
class ContourDrawing:
    """A contour seen along an axis of the base frame.

    Attributes:
        axes: names of the horizontal and the vertical axis.
        factor: by which the distance of the attained path from the contour is enlarged.
        wanted: corners of the contour [m], shape (c, 2).
        attained: the attained path, so enlarged [m], shape (k, 2).
    """

    axes: tuple[str, str]
    factor: int
    wanted: Array
    attained: Array

    @property
    def words(self) -> str:
        """Return the factor in words."""
        return f"error × {self.factor}" if self.factor > 1 else "true to scale"


def contour_drawing(one: ContourFigures, rows: ContourRows) -> ContourDrawing:
    """Return the drawing of a contour."""
    extents = np.ptp(rows.corners, axis=0)
    factor = _factor(SHARE * float(extents.max()) / one.path_max if one.path_max > 0.0 else 1.0)
    drawn = rows.nearest + factor * (rows.attained - rows.nearest)
    first, second = sorted(np.argsort(-extents, kind="stable")[:2].tolist())  # all but the least extent
    plane = [first, second]
    axes = "xyz"[first], "xyz"[second]
    return ContourDrawing(axes, factor, frozen(rows.corners[:, plane]), frozen(drawn[:, plane]))


def _factor(most: float) -> int:
    """Return the largest of 1, 2, 5, 10, 20 … that is not above a number; 1 at least."""
    power = 10 ** int(np.floor(np.log10(max(most, 1.0))))
    return int(max(step * power for step in _STEPS if step * power <= max(most, 1.0)))
