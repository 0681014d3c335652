"""Traced path: joint coordinates at path parameters of a path, made smooth between them."""

from dataclasses import field

import numpy as np

from ropsim.motion.curves.differences import derivatives_and_roughness, row_derivatives
from ropsim.motion.curves.path import JointPoints
from ropsim.motion.joint_paths.path_rows import TRACED, PathRows
from ropsim.motion.joint_paths.quintic_kernel import COEFFICIENTS, traced_middles, traced_points
from ropsim.spatial import Array, frozen, record

_UNKNOWN = frozen([])
"""Stands for derivatives that are to be found from the rows, and for equidistant path parameters."""


@record
class SampledPath:
    """Quintic Hermite polynomials between rows, twice continuously differentiable, through every row.

    Derivatives at the rows that are not given are differences of order 6 of equidistant rows (lower with
    fewer than seven: k rows are the polynomial through them, up to degree five exactly), so that values are
    exact to the sixth power of the distance between rows, and second derivatives to its fourth.

    Attributes:
        length: of the path, in its own unit; positive.
        q: joint coordinates [rad | m] at the path parameters, shape (k, n), k >= 2.
        derivatives: first and second ones at the rows by the path parameter, shape (2, k, n); found from
            these where they are not given.
        parameters: path parameters of the rows, rising from 0 to `length`, shape (k,); equidistant where
            they are not given.
    """

    length: float
    q: Array
    derivatives: Array = field(default_factory=lambda: _UNKNOWN, repr=False)
    parameters: Array = field(default_factory=lambda: _UNKNOWN, repr=False)

    def __post_init__(self) -> None:
        q, parameters = frozen(self.q), self.parameters
        last = len(q) - 1
        if parameters is _UNKNOWN:
            parameters = np.arange(last + 1, dtype=np.float64) * (self.length / last)
            parameters[last] = self.length
        derivatives = (
            row_derivatives(q, self.length / last) if self.derivatives is _UNKNOWN else self.derivatives
        )
        derivatives.flags.writeable = parameters.flags.writeable = False
        object.__setattr__(self, "q", q)
        object.__setattr__(self, "derivatives", derivatives)
        object.__setattr__(self, "parameters", parameters)

    @property
    def q_end(self) -> Array:
        """Return the joint coordinates at the end [rad | m], shape (n,)."""
        return self.q[-1, :]

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at path parameters s, shape (k,)."""
        n = self.q.shape[1]
        work, out = np.empty((COEFFICIENTS, n)), np.empty((3, len(s), n))
        d1, d2 = self.derivatives
        traced_points(self.q, d1, d2, self.parameters, np.ascontiguousarray(s), work, out)
        return JointPoints(out[0], out[1], out[2])

    def path_rows(self, begin: float) -> PathRows:
        """Return the data of the path for compiled loops, from a path parameter on."""
        rows, slopes = (self.q.reshape(-1),), self.derivatives
        return PathRows(TRACED, begin, self.length, len(self.q), rows, slopes, self.parameters)


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
    step = length / (len(rows) - 1)
    derivatives[0] *= 1.0 / step
    derivatives[1] *= 1.0 / step**2
    return SampledPath(length, rows, derivatives), error


def middle_errors(path: SampledPath) -> Array:
    """Return how far the path through every second row passes the others [rad | m].

    Args:
        path: of 2·m + 1 rows, each second one midway between its neighbours.

    Returns:
        the greatest distance of a joint at each row between, shape (m,).
    """
    d1, d2 = path.derivatives
    error = np.empty(len(path.q) // 2)
    traced_middles(path.q, d1, d2, path.parameters, error)
    return error
