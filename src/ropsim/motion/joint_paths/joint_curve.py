"""Joint curve: joints along another path, evenly or smoothly from one slope to another."""

import numpy as np

from ropsim.motion.curves.path import JointPoints
from ropsim.motion.curves.polynomials import powers, quintics, with_derivatives
from ropsim.spatial import Array, frozen, record


@record
class JointCurve:
    """q(s), each coordinate a polynomial of degree five in s / length.

    Attributes:
        length: of the path, in its own unit; positive.
        coefficients: of (s / length)⁰ to (s / length)⁵ [rad | m], shape (6, n).
    """

    length: float
    coefficients: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "coefficients", frozen(self.coefficients))

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at path parameters s, shape (k,)."""
        per_unit = 1.0 / self.length
        rows = powers(s * per_unit) @ with_derivatives(self.coefficients)
        q, d1, d2 = np.split(rows, 3, axis=1)
        return JointPoints(q, d1 * per_unit, d2 * (per_unit * per_unit))


def evenly(length: float, q_start: Array, q_end: Array) -> JointCurve:
    """Return the path on which joints move by the same amount at every path parameter.

    Args:
        length: of the path, positive.
        q_start: at path parameter 0 [rad | m], shape (n,).
        q_end: at the end [rad | m], shape (n,).
    """
    coefficients = np.zeros((6, len(q_start)))
    coefficients[0], coefficients[1] = q_start, q_end - q_start
    return JointCurve(length, coefficients)


def smoothly(length: float, start: JointPoints, end: JointPoints) -> JointCurve:
    """Return the path between two others: it has their values, slopes and bends at its ends.

    Args:
        length: of the path, positive.
        start: joints and derivatives at the path parameter at which the path before is left, one row.
        end: the same at the path parameter at which the path behind is entered.
    """
    by_share = length ** np.arange(3.0)[:, np.newaxis]
    ends = (np.vstack((one.q, one.d1, one.d2)) * by_share for one in (start, end))
    return JointCurve(length, quintics(np.vstack(tuple(ends))))
