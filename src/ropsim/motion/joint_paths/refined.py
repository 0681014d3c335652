"""Refined path: a path of the joints, short parts of which are known more exactly than the rest."""

from dataclasses import field

import numpy as np
import numpy.typing as npt

from ropsim.motion.curves.path import JointPath, JointPoints
from ropsim.motion.curves.polynomials import powers, quintics, with_derivatives
from ropsim.spatial import Array, frozen, record

_SEAM = 1.0 / 16.0
"""Share of the length of a part within which it goes over into the path around it, at either end."""

_REACH = 8
"""Rows on either side of one that is replaced: every second one of them, six at an end, is used for
derivatives."""


@record
class Refined:
    """A path of the joints in which others replace some of its parts.

    Where a part begins and ends inside of the path, both have nearly the same values and derivatives; the
    maker guarantees that. Their difference is added to the part there, and fades out with a polynomial of
    fifth degree, so that values and two derivatives are continuous. A part at an end of the path is unchanged
    there: it is the more exact one.

    Attributes:
        whole: the path.
        begins: its path parameters at which the parts begin, rising, in its unit, shape (p,).
        parts: sections that replace the path there; each ends before the next one begins.
    """

    whole: JointPath
    begins: Array
    parts: tuple[JointPath, ...]
    _ends: Array = field(init=False, repr=False)
    _seams: tuple[Array, ...] = field(init=False, repr=False)

    def __post_init__(self) -> None:
        begins = frozen(self.begins)
        object.__setattr__(self, "begins", begins)
        lengths = np.array([part.length for part in self.parts])
        object.__setattr__(self, "_ends", frozen(begins + lengths))
        seams = map(self._seam, begins.tolist(), self.parts)
        object.__setattr__(self, "_seams", tuple(seams))

    @property
    def length(self) -> float:
        """Return the length in the unit of the path."""
        return self.whole.length

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at path parameters s, shape (k,)."""
        points = self.whole.joints(s)
        number = np.searchsorted(self.begins, s, "right") - 1
        inside = (number >= 0) & (s <= self._ends[np.maximum(number, 0)])
        if not inside.any():
            return points
        rows = np.stack((points.q, points.d1, points.d2))
        for part in np.unique(number[inside]).tolist():
            here = np.flatnonzero(inside & (number == part))
            own = s[here] - self.begins[part]
            exact = self.parts[part].joints(own)
            rows[:, here] = exact.q, exact.d1, exact.d2
            rows[:, here] += self._seams_at(part, own)
        return JointPoints(*rows)

    def _seam(self, begin: float, part: JointPath) -> Array:
        """Return the gaps of a part at its ends, as polynomials of the distance from there, (2, 6, 3·n).

        The distance counts in widths of the seam, towards the middle of the part; behind the rows of the
        values are the rows of the derivatives.
        """
        ends, inwards = np.array([0.0, part.length]), np.array([1.0, -1.0])[:, None]
        there, own = self.whole.joints(begin + ends), part.joints(ends)
        width = _SEAM * part.length
        lacks = there.q - own.q, (there.d1 - own.d1) * inwards * width, (there.d2 - own.d2) * width**2
        nothing = np.zeros_like(there.q)
        rows = np.stack((*lacks, nothing, nothing, nothing), axis=1)
        inside = _inside(self.whole, begin, part)[:, None, None]
        return frozen(with_derivatives(quintics(np.where(inside, rows, 0.0))))

    def _seams_at(self, number: int, s: Array) -> Array:
        """Return the added correction at path parameters of a part, with two derivatives, shape (3, k, n)."""
        length = self.parts[number].length
        width, n = _SEAM * length, self._seams[number].shape[2] // 3
        added = np.zeros((3, len(s), n))
        for seam, offset, inwards in zip(self._seams[number], (s, length - s), (1.0, -1.0), strict=True):
            near = np.flatnonzero(offset < width)
            rows = powers(offset[near] / width) @ seam
            scales = 1.0, inwards / width, 1.0 / width**2
            for order, scale in enumerate(scales):
                added[order, near] += scale * rows[:, order * n : (order + 1) * n]
        return added


def joins(whole: JointPath, begin: float, part: JointPath, step: float, within: float) -> bool:
    """Return whether a part goes over into the path around it, at its ends inside of the path.

    Values, first derivatives over a step and second ones over its square differ by no more than `within`.

    Args:
        whole: the path.
        begin: its path parameter at which the part begins, in its unit.
        part: that is to count there.
        step: from row to row of the path, in its unit.
        within: [rad | m].
    """
    ends = np.array([0.0, part.length])[_inside(whole, begin, part)]
    if not len(ends):
        return True
    there, own = whole.joints(begin + ends), part.joints(ends)
    off = (there.q - own.q, (there.d1 - own.d1) * step, (there.d2 - own.d2) * (step * step))
    return float(np.abs(np.stack(off)).max()) <= within


def _inside(whole: JointPath, begin: float, part: JointPath) -> npt.NDArray[np.bool_]:
    """Return which ends of a part, its begin and its end, are inside of the path, shape (2,)."""
    least = _SEAM * part.length
    return np.array([begin > least, begin + part.length < whole.length - least])


def parts_by_error(error: npt.NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Return the rows between which a path through 2·k + 1 rows is to be known more exactly, first and last.

    Around each row that the path through every second one misses lie as many rows as differences reach.

    Args:
        error: whether it misses the rows 1, 3, 5 …, shape (k,).
    """
    parts: list[tuple[int, int]] = []
    for row in (2 * np.flatnonzero(error) + 1).tolist():
        first, last = max(row - _REACH, 0), min(row + _REACH, 2 * len(error))
        if parts and first <= parts[-1][1]:
            first = parts.pop()[0]
        parts.append((first, last))
    return parts
