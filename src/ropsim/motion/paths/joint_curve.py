"""Joint curve: joints along the way of something else, evenly or smoothly from one slope to another."""

import numpy as np

from ropsim.motion.paths.path import JointPoints
from ropsim.motion.paths.polynomials import powers, quintics, with_derivatives
from ropsim.spatial import Array, frozen, record


@record
class JointCurve:
    """q(s), each coordinate a polynomial of degree five in s / length.

    Attributes:
        length: of the way, in its own unit; positive.
        coefficients: of (s / length)⁰ to (s / length)⁵ [rad | m], shape (6, n).
    """

    length: float
    coefficients: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "coefficients", frozen(self.coefficients))

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at places s, shape (k,)."""
        per_unit = 1.0 / self.length
        rows = powers(s * per_unit) @ with_derivatives(self.coefficients)
        q, d1, d2 = np.split(rows, 3, axis=1)
        return JointPoints(q, d1 * per_unit, d2 * (per_unit * per_unit))


def evenly(length: float, q_start: Array, q_end: Array) -> JointCurve:
    """Return the way on which joints move by the same amount at every place.

    Args:
        length: of the way, positive.
        q_start: at place 0 [rad | m], shape (n,).
        q_end: at the end [rad | m], shape (n,).
    """
    coefficients = np.zeros((6, len(q_start)))
    coefficients[0], coefficients[1] = q_start, q_end - q_start
    return JointCurve(length, coefficients)


def smoothly(length: float, start: tuple[Array, Array], end: tuple[Array, Array]) -> JointCurve:
    """Return the way between two even ones: it has their values and slopes, and no bend, at its ends.

    Args:
        length: of the way, positive.
        start: coordinates [rad | m] and their slopes by the place at place 0, shape (n,) each.
        end: the same at the end.
    """
    ends = np.zeros((6, len(start[0])))
    ends[0], ends[1], ends[3], ends[4] = start[0], start[1] * length, end[0], end[1] * length
    return JointCurve(length, quintics(ends))
