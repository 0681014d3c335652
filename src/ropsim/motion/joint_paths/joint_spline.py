"""Joint spline: joints along another path, through given values at some of its path parameters."""

import numpy as np

from ropsim.motion.curves.natural import natural_derivatives
from ropsim.motion.curves.path import JointPoints
from ropsim.motion.curves.polynomials import powers, quintics, with_derivatives
from ropsim.spatial import Array, frozen, record


@record
class JointSpline:
    """q(s), between each two knots a polynomial of degree five in the share of the interval.

    Attributes:
        knots: rising, from 0 to the length of the path in its own unit, shape (k,), k >= 2.
        coefficients: of the powers 0 to 5 of the share [rad | m], shape (k - 1, 6, n).
    """

    knots: Array
    coefficients: Array

    def __post_init__(self) -> None:
        object.__setattr__(self, "knots", frozen(self.knots))
        object.__setattr__(self, "coefficients", frozen(self.coefficients))

    @property
    def length(self) -> float:
        """Return the length of the path."""
        return float(self.knots[-1])

    def joints(self, s: Array) -> JointPoints:
        """Return the joints and their derivatives at path parameters s, shape (k,)."""
        part = np.clip(np.searchsorted(self.knots, s, side="right") - 1, 0, len(self.coefficients) - 1)
        per_unit = (1.0 / np.diff(self.knots))[part, np.newaxis]
        shares = powers((s - self.knots[part]) * per_unit[:, 0])
        rows = (shares[:, np.newaxis] @ with_derivatives(self.coefficients)[part])[:, 0]
        q, d1, d2 = np.split(rows, 3, axis=1)
        return JointPoints(q, d1 * per_unit, d2 * per_unit**2)


def monotone(knots: Array, q: Array) -> JointSpline:
    """Return the path through values, twice continuously differentiable, that reverses only at them.

    Slopes m and bends c at the knots come from the natural cubic spline, made smaller where a part would
    otherwise leave the range between its two values. A part of the length h and the mean slope D > 0 never
    falls where the coefficients of its derivative in the form of Bernstein are not negative; they are not for
    c·h in [-4·m, 10·D - 8·m] at its start and in [8·m - 10·D, 4·m] at its end. Both parts next to a knot
    leave a bend where m is at most 5/2 of the smaller D and 5/4 of the slope of the parabola through the
    three values. Between two values alone it is straight.

    Args:
        knots: rising, the first one 0, shape (k,), k >= 2.
        q: joint coordinates there [rad | m], shape (k, n).

    References:
        Dougherty, Edelman and Hyman 1989, Nonnegativity-, Monotonicity-, or Convexity-Preserving Cubic and
        Quintic Hermite Interpolation, Mathematics of Computation 52(186), 471-494.
    """
    h, steps = np.diff(knots)[:, np.newaxis], np.diff(q, axis=0)
    first, second = natural_derivatives(h[:, 0], steps)
    first = _gentle(h, steps / h, first)
    second = np.clip(second, *_bends(h, steps / h, first))
    begin = np.stack((q[:-1], first[:-1] * h, second[:-1] * h * h), axis=1)
    end = np.stack((q[1:], first[1:] * h, second[1:] * h * h), axis=1)
    return JointSpline(knots, quintics(np.concatenate((begin, end), axis=1)))


def _gentle(h: Array, mean: Array, first: Array) -> Array:
    """Return slopes at the knots (k, n) as near to `first` as they may be, 0 where the values turn back.

    Args:
        h: lengths of the parts, shape (k - 1, 1).
        mean: slopes of the parts, shape (k - 1, n).
        first: requested slopes, shape (k, n).
    """
    before, behind = np.vstack((mean[:1], mean)), np.vstack((mean, mean[-1:]))  # of each knot
    h_before, h_behind = np.vstack((h[:1], h)), np.vstack((h, h[-1:]))
    parabola = np.abs(before * h_behind + behind * h_before) / (h_before + h_behind)
    most = np.minimum(2.5 * np.minimum(np.abs(before), np.abs(behind)), 1.25 * parabola)
    most = np.where(before * behind > 0.0, most, 0.0)
    sign = np.sign(behind)
    return np.asarray(sign * np.clip(sign * first, 0.0, most))


def _bends(h: Array, mean: Array, first: Array) -> tuple[Array, Array]:
    """Return the least and the greatest second derivative at each knot, shape (k, n) both."""
    starts = np.sort([-4.0 * first[:-1] / h, (10.0 * mean - 8.0 * first[:-1]) / h], axis=0)
    ends = np.sort([(8.0 * first[1:] - 10.0 * mean) / h, 4.0 * first[1:] / h], axis=0)
    least = np.maximum(np.vstack((starts[0], ends[0][-1:])), np.vstack((starts[0][:1], ends[0])))
    most = np.minimum(np.vstack((starts[1], ends[1][-1:])), np.vstack((starts[1][:1], ends[1])))
    return least, np.maximum(least, most)  # equal within rounding where the slope is the greatest
