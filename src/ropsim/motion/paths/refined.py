"""Refined path: a way of the joints, short parts of which are known more exactly than the rest."""

from dataclasses import field

import numpy as np
import numpy.typing as npt

from ropsim.motion.paths.path import JointPath, JointPoints
from ropsim.spatial import Array, frozen, record

_REACH = 8
"""Rows on either side of one that is missed: every second one of them, six at an end, tells derivatives."""


@record
class Refined:
    """A path of the joints in which others take the place of some of its parts.

    Where a part begins and ends, both paths have the same values and the same derivatives but for rounding:
    whoever makes one sees to that.

    Attributes:
        whole: the path.
        begins: its places at which the parts begin, rising, in its unit, shape (p,).
        parts: what counts there; each ends before the next one begins.
    """

    whole: JointPath
    begins: Array
    parts: tuple[JointPath, ...]
    _ends: Array = field(init=False, repr=False)

    def __post_init__(self) -> None:
        begins = frozen(self.begins)
        object.__setattr__(self, "begins", begins)
        lengths = np.array([part.length for part in self.parts])
        object.__setattr__(self, "_ends", frozen(begins + lengths))

    @property
    def length(self) -> float:
        """Return the length in the unit of the path."""
        return self.whole.length

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at places s, shape (k,)."""
        points = self.whole.joints(s)
        number = np.searchsorted(self.begins, s, "right") - 1
        inside = (number >= 0) & (s <= self._ends[np.maximum(number, 0)])
        if not inside.any():
            return points
        rows = np.stack((points.q, points.d1, points.d2))
        for part in np.unique(number[inside]).tolist():
            here = np.flatnonzero(inside & (number == part))
            exact = self.parts[part].joints(s[here] - self.begins[part])
            rows[:, here] = exact.q, exact.d1, exact.d2
        return JointPoints(*rows)


def joins(whole: JointPath, begin: float, part: JointPath, step: float, within: float) -> bool:
    """Return whether a part goes over into the path around it, at both of its ends.

    Values, first derivatives over a step and second ones over its square differ by no more than `within`.

    Args:
        whole: the path.
        begin: its place at which the part begins, in its unit.
        part: that is to count there.
        step: from row to row of the path, in its unit.
        within: [rad | m].
    """
    ends = np.array([0.0, part.length])
    there, own = whole.joints(begin + ends), part.joints(ends)
    off = (there.q - own.q, (there.d1 - own.d1) * step, (there.d2 - own.d2) * (step * step))
    return float(np.abs(np.stack(off)).max()) <= within


def rough_parts(rough: npt.NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the rows between which a path through 2·k + 1 rows is to be known more exactly, first and last.

    Around each row that the path through every second one misses lie as many rows as differences reach.

    Args:
        rough: whether it misses the rows 1, 3, 5 …, shape (k,).
    """
    parts: list[tuple[int, int]] = []
    for row in (2 * np.flatnonzero(rough) + 1).tolist():
        first, last = max(row - _REACH, 0), min(row + _REACH, 2 * len(rough))
        if parts and first <= parts[-1][1]:
            first = parts.pop()[0]
        parts.append((first, last))
    return parts
