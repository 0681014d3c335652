"""Traced path: joint coordinates at equidistant path parameters of a path, made smooth between them."""

from dataclasses import field

import numpy as np

from ropsim.motion.curves.differences import derivatives_and_roughness, row_derivatives
from ropsim.motion.curves.path import JointPoints
from ropsim.motion.joint_paths.path_rows import TRACED, PathRows
from ropsim.motion.joint_paths.quintic_kernel import COEFFICIENTS, traced_points
from ropsim.spatial import Array, frozen, record

_UNKNOWN = frozen([])
"""Stands for derivatives that are to be found from the rows."""


@record
class SampledPath:
    """Quintic Hermite polynomials between rows, twice continuously differentiable, through every row.

    Derivatives at the rows are differences of order 6 (lower with fewer than seven rows: k rows are the
    polynomial through them, up to degree five exactly), so that values are exact to the sixth power of the
    distance between rows, and second derivatives to its fourth.

    Attributes:
        length: of the path, in its own unit; positive.
        q: joint coordinates [rad | m] at the path parameters 0 to `length`, shape (k, n), k >= 2.
        derivatives: first and second ones at the rows by the number of the row, shape (2, k, n);
            found from these where they are not given.
    """

    length: float
    q: Array
    derivatives: Array = field(default_factory=lambda: _UNKNOWN, repr=False)

    def __post_init__(self) -> None:
        q = frozen(self.q)
        derivatives = row_derivatives(q, 1.0) if self.derivatives is _UNKNOWN else self.derivatives
        derivatives.flags.writeable = False
        object.__setattr__(self, "q", q)
        object.__setattr__(self, "derivatives", derivatives)

    @property
    def q_end(self) -> Array:
        """Return the joint coordinates at the end [rad | m], shape (n,)."""
        return self.q[-1, :]

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at path parameters s, shape (k,)."""
        count, n = self.q.shape
        work, out = np.empty((COEFFICIENTS, n)), np.empty((3, len(s), n))
        per_unit = (count - 1) / self.length
        d1, d2 = self.derivatives
        traced_points(self.q, d1, d2, per_unit, np.ascontiguousarray(s), work, out)
        return JointPoints(out[0], out[1], out[2])

    def path_rows(self, begin: float) -> PathRows:
        """Return the data of the path for compiled loops, from a path parameter on."""
        return PathRows(TRACED, begin, self.length, len(self.q), (self.q.reshape(-1),), self.derivatives)


def sampled_with_error(length: float, q: Array) -> tuple[SampledPath, Array | None]:
    """Return the path through rows, and how far that through every second one passes the others [rad | m].

    Args:
        length: of the path, above 0.
        q: joint coordinates at equidistant path parameters, shape (k, n), k >= 2.

    Returns:
        the path and the greatest distance of a joint at each row between, shape (m,) for k = 2·m + 1 rows;
        None for it where rows are fewer than 17 or of even number.
    """
    rows = frozen(q)
    derivatives, error = derivatives_and_roughness(rows)
    return SampledPath(length, rows, derivatives), error
