"""Traced path: joint coordinates at equidistant places of a way, made smooth between them."""

from dataclasses import field

import numpy as np

from ropsim.motion.paths.differences import row_derivatives
from ropsim.motion.paths.path import JointPoints
from ropsim.motion.paths.polynomials import powers, quintics, with_derivatives
from ropsim.spatial import Array, frozen, record


@record
class Traced:
    """Quintic Hermite polynomials between rows, twice continuously differentiable, through every row.

    Derivatives at the rows are differences of order 6 (lower with fewer than seven rows: k rows are the
    polynomial through them, up to degree five exactly), so that values are exact to the sixth power of the
    distance between rows, and second derivatives to its fourth.

    Attributes:
        length: of the way, in its own unit; positive.
        q: joint coordinates [rad | m] at the places 0 to `length`, shape (k, n), k >= 2.
        coefficients: of the polynomials between the rows and of their derivatives, shape (k - 1, 6, 3·n).
    """

    length: float
    q: Array
    coefficients: Array = field(init=False, repr=False)

    def __post_init__(self) -> None:
        q = frozen(self.q)
        step = 1.0  # of a place counted in rows
        rows = np.stack((q, *row_derivatives(q, step)), axis=1)
        coefficients = with_derivatives(quintics(np.concatenate((rows[:-1], rows[1:]), axis=1)))
        coefficients.flags.writeable = False
        object.__setattr__(self, "q", q)
        object.__setattr__(self, "coefficients", coefficients)

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at places s, shape (k,)."""
        count, n = self.q.shape
        per_unit = (count - 1) / self.length
        t = s * per_unit
        row = np.minimum(np.maximum(t, 0.0).astype(np.int64), count - 2)
        values = (powers(t - row)[:, None, :] @ self.coefficients.take(row, axis=0))[:, 0, :]
        return JointPoints(
            values[:, :n], values[:, n : 2 * n] * per_unit, values[:, 2 * n :] * (per_unit * per_unit)
        )
