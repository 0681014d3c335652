"""Arc length along a curve of polynomials, and its inverse."""

from functools import cache

import numpy as np

from ropsim.motion.curves.curve_kernel import arc_length_of_steps, speed_range
from ropsim.spatial import Array, frozen, record

_POINTS = 5  # of Gauss and Legendre in each step
_SAMPLED_STEPS = 64  # steps in which the speed of a segment is sampled
_UNEVEN = 0.45  # least speed in a segment by its greatest; below, steps are four times as fine


@record
class ArcLength:
    """The parameter t of each segment, from 0 to 1, over the arc length s along all of them.

    Between steps of t the arc length is integrated; its inverse is interpolated by polynomials of degree five
    with the exact derivatives dt/ds = 1 / |p'| and d²t/ds² = -p'·p'' / |p'|⁴ at both ends of every step.

    Attributes:
        ends: arc length at the end of each step, after that at the start, shape (m + 1,) [m].
        inverse: coefficients of t over the share of the step, shape (m, 6).
        steps: of each segment.
    """

    ends: Array
    inverse: Array
    steps: int

    def __post_init__(self) -> None:
        self.ends.flags.writeable = self.inverse.flags.writeable = False

    @property
    def length(self) -> float:
        """Return the arc length along the whole curve [m]."""
        return float(self.ends[-1])


def arc_length(coefficients: Array, steps: int, least: Array) -> ArcLength | None:
    """Return the arc length of a curve, or None if its speed nearly vanishes somewhere.

    Args:
        coefficients: of the powers of t in p [m] and in the further columns in every segment, shape (c, 6,
            6).
        steps: of each segment, for curves of even speed.
        least: of every segment the |p'| that it needs, shape (c,) [m].

    References:
        Press, Teukolsky, Vetterling and Flannery 2007, Numerical Recipes, section 4.6, for the quadrature.
    """
    speeds = np.empty((len(coefficients), 2))
    speed_range(coefficients, _SAMPLED_STEPS, np.empty(2 * _SAMPLED_STEPS + 2), speeds)
    if not (speeds[:, 0] > least).all():
        return None
    if (speeds[:, 0] < _UNEVEN * speeds[:, 1]).any():
        steps *= 4
    return arc_length_in_steps(coefficients, steps)


def arc_length_in_steps(coefficients: Array, steps: int) -> ArcLength:
    """Return the arc length of a curve that nowhere stands, with as many steps of each segment."""
    count = len(coefficients) * steps
    ends, inverse = np.empty(count + 1), np.empty((count, 6))
    arc_length_of_steps(coefficients, steps, *quadrature(), np.empty(3 * steps + 3), ends, inverse)
    return ArcLength(ends, inverse, steps)


@cache
def quadrature() -> tuple[Array, Array]:
    """Return points in [0, 1] and weights of the quadrature of a step."""
    points, weights = np.polynomial.legendre.leggauss(_POINTS)
    return frozen((points + 1.0) / 2.0), frozen(weights / 2.0)
