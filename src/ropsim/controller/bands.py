"""Bounds along a part of a stretch in bands, which joints that cannot follow bring down."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt

from ropsim.controller.bands_kernel import bring_down
from ropsim.controller.joint_caps import Caps
from ropsim.controller.parts import Part, planned_part
from ropsim.motion import Quantity, Stages
from ropsim.spatial import Array, record

_STEPS = np.array([0.01, 0.04, 0.08])
"""Logarithms of the steps in which bounds are brought down, so that neighbours are often the same."""
_BESIDE = 2
"""Bands beside one that are brought down with it: what is slower comes later to what lies behind."""
_SAME_PLACE = 1e-7
"""Share of a part below which two borders are one."""


@record
class Bands:
    """What counts between c + 1 places of a part.

    Attributes:
        part: as it was planned.
        borders: from its start on, stages and pieces end at some of them, shape (c + 1,).
        planned: bounds of speed, acceleration and jerk along it, shape (3, c).
        bounds: the same with regard to joints, shape (3, c).
        causes: joint that brought one of them down last, and the number of the quantity, or -1, (2, c).
    """

    part: Part
    borders: Array
    planned: Array
    bounds: Array
    causes: npt.NDArray[np.intp]

    @property
    def begins(self) -> Array:
        """Return the places at which pieces begin, and the end of the last one, shape (p + 1,)."""
        return self.part.borders

    @property
    def share(self) -> float:
        """Return the least share of its planned rate that a band is left, in ]0, 1]."""
        left = (self.bounds / self.planned).min(axis=1)
        return float((left ** np.array([1.0, 0.5, 1.0 / 3.0])).min())

    def lowered(self, caps: Caps) -> "Bands":
        """Return the same with bounds no higher than caps, and by as many steps lower than planned.

        Args:
            caps: what joints allow, and where.
        """
        bounds, causes = np.array(self.bounds, order="C"), self.causes.astype(np.float64)
        held = np.array((caps.kinds, caps.values, *caps.places, caps.joints, caps.quantities))
        bring_down(held, self.borders, _BESIDE, np.ascontiguousarray(self.bounds), bounds, causes)
        lower = bounds < self.bounds
        step = np.broadcast_to(_STEPS[:, None], bounds.shape)[lower]
        steps = np.floor(np.log(bounds[lower] / self.planned[lower]) / step) * step
        bounds[lower] = self.planned[lower] * np.exp(steps)
        return replace(self, bounds=bounds, causes=causes.astype(np.intp))

    def slower(self, share: float) -> "Bands":
        """Return the same where everything goes at a share, in ]0, 1], of its rate."""
        return replace(self, bounds=self.bounds * np.array([[share], [share**2], [share**3]]))

    def replanned(self, look_ahead: int) -> Part:
        """Return the part with these bounds.

        Args:
            look_ahead: how many moves beyond the present one are known.
        """
        middles = 0.5 * (self.borders[1:] + self.borders[:-1])
        owner = np.searchsorted(self.begins[1:-1], middles, "right")
        changes = (np.diff(self.bounds, axis=1) != 0.0).any(axis=0) | (np.diff(owner) != 0)
        firsts = np.append(0, np.flatnonzero(changes) + 1)
        lengths = np.diff(self.borders[np.append(firsts, len(middles))])
        stages = Stages(np.column_stack((lengths, self.bounds[:, firsts].T)))
        pieces = self.part.pieces
        counts = np.bincount(owner[firsts], minlength=len(pieces))
        return planned_part(pieces, stages, counts, self.part.over, look_ahead)

    def cause(self, band: int) -> tuple[int, Quantity]:
        """Return the joint that has brought a band down, and what it had too little of."""
        joint, quantity = self.causes[:, band].tolist()
        return joint, tuple(Quantity)[quantity]


def bands_of(part: Part, times: Array) -> Bands:
    """Return the bands of a part.

    Args:
        part: of the stretch, with stages.
        times: between which bands lie, from the start of the part on [s], rising, shape (m,).
    """
    inside = times[(times > 0.0) & (times < part.law.duration)]
    rows, ends = part.law.at(inside), part.stages.ends
    places = part.borders[rows.pieces] + rows.places
    fixed, near = np.append(0.0, ends), _SAME_PLACE * float(ends[-1])
    beside = np.searchsorted(fixed, places).clip(1, len(fixed) - 1)
    free = np.minimum(places - fixed[beside - 1], fixed[beside] - places) > near
    borders = np.sort(np.append(fixed, places[free]))
    borders = borders[np.append(np.diff(borders) > 0.0, True)]
    here = np.searchsorted(ends[:-1], 0.5 * (borders[1:] + borders[:-1]), "right")
    bounds = np.ascontiguousarray(part.stages.bounds[here].T)
    return Bands(part, borders, bounds, bounds, np.full((2, len(here)), -1))
