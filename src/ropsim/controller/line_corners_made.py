"""What a compiled loop makes of corners between lines, and the records that see it."""

from collections.abc import Mapping, Sequence

import numpy as np

from ropsim.controller.corners import Rounding
from ropsim.controller.line_corners_kernel import AHEAD, CELLS, LOOKS, TOLD
from ropsim.core import maker
from ropsim.motion import CORNER_STEPS, ArcLength, Curve, Stages, Traced
from ropsim.spatial import Array, record

_way, _curve, _traced = maker(ArcLength), maker(Curve), maker(Traced)
_stages, _rounding = maker(Stages), maker(Rounding)
_DENSITIES = (1, 2, AHEAD)
"""At which joints are taken from samples."""
_MANY = 16
"""Stages of a corner for which there is room beside those of one that has the most; few are usual."""


@record
class LineCornersMade:
    """Arrays of c corners.

    Attributes:
        coefficients: of their curves, shape (c, 6, 6).
        middles: of these, shape (c, 3, 3).
        ends: of their arc lengths, shape (c, `CORNER_STEPS` + 1).
        inverse: likewise, shape (c, `CORNER_STEPS`, 6).
        q: joint coordinates [rad] for each density, shapes (c, k, 6).
        slopes: derivatives of these by the number of the row, shapes (2·c, k, 6).
        stages: of all corners, shape (s, 4).
        told: what is told of each, shape (c, `TOLD`).
    """

    coefficients: Array
    middles: Array
    ends: Array
    inverse: Array
    q: tuple[Array, ...]
    slopes: tuple[Array, ...]
    stages: Array
    told: Array

    @classmethod
    def room_for(cls, count: int) -> "LineCornersMade":
        """Return arrays for a number of corners, in which nothing is written yet."""
        rows = [(LOOKS - 1) * density // AHEAD + 1 for density in _DENSITIES]
        return cls(
            np.empty((count, 6, 6)),
            np.empty((count, 3, 3)),
            np.empty((count, CORNER_STEPS + 1)),
            np.empty((count, CORNER_STEPS, 6)),
            tuple(np.empty((count, k, 6)) for k in rows),
            tuple(np.empty((2 * count, k, 6)) for k in rows),
            np.empty((CELLS + _MANY * count, 4)),
            np.empty((count, TOLD)),
        )

    @property
    def arrays(self) -> tuple[Array, ...]:
        """Return all of them in the order in which the kernel takes them."""
        curves = self.coefficients, self.middles, self.ends, self.inverse
        return *curves, *self.q, *self.slopes, self.stages, self.told

    def roundings(
        self, zones: Mapping[int, float], asked: Sequence[tuple[float, ...]]
    ) -> dict[int, Rounding]:
        """Return the corners that were made; the arrays are read-only from then on.

        Args:
            zones: distance of the TCP from the corners at which paths leave and enter [m], by their numbers.
            asked: where they leave the path before and enter that behind, first, in the same order.
        """
        for array in self.arrays:
            array.flags.writeable = False
        found: dict[int, Rounding] = {}
        rows = zip(self.told.tolist(), self.ends[:, -1].tolist(), zones.items(), asked, strict=True)
        for c, ((density, first, count), length, (number, zone), (leave, enter, *_)) in enumerate(rows):
            if density:
                kind, begin = int(density) // 2, int(first)
                way = _way(self.ends[c], self.inverse[c], CORNER_STEPS)
                curve = _curve(self.coefficients[c : c + 1], self.middles[c : c + 1], way)
                joints = _traced(length, self.q[kind][c], self.slopes[kind][2 * c : 2 * c + 2])
                stages = _stages(self.stages[begin : begin + int(count)]) if count else None
                found[number] = _rounding(zone, leave, enter, curve, joints, None, stages)
        return found
