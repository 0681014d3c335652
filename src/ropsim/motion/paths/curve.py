"""Curve: a path of the tool through polynomials of position and orientation, over its arc length."""

import math

import numpy as np

from ropsim.motion.curves.curve_kernel import curve_at, curve_points
from ropsim.motion.curves.nearest import distances
from ropsim.motion.curves.path import ToolPoints
from ropsim.motion.curves.rotation_vector import series
from ropsim.motion.paths.arc_length import ArcLength
from ropsim.spatial import Array, frozen, record

_EVERY = 4  # steps of the arc length from one path parameter of the grid to the next
_GRID = 16, 512  # least and most steps of each segment in the search for the nearest path parameter
_STEP = 1e-3  # [m] of that search between, so that sections that come near each other are distinguished
_MOST_POINTS = 200_000  # at most, of all segments together


@record
class Curve:
    """Segments one after the other: p(t) and R(t) = R_middle·exp(θ(t)), both of degree five, t from 0 to 1.

    The path parameter is the arc length of the TCP; derivatives by it follow from those by t by the chain
    rule, so that segments joined with one position, orientation, tangent, curvature, angular velocity and
    acceleration per arc length keep them in the curve, to rounding.

    Attributes:
        coefficients: of t⁰ to t⁵ in p [m] and θ [rad], shape (c, 6, 6).
        middles: R_middle in the reference frame, shape (c, 3, 3).
        arc_length: of the TCP.
    """

    coefficients: Array
    middles: Array
    arc_length: ArcLength

    def __post_init__(self) -> None:
        for name in ("coefficients", "middles"):
            array = getattr(self, name)
            if array.flags.writeable:  # immutable arrays need not be copied
                object.__setattr__(self, name, frozen(array))

    @property
    def moves(self) -> bool:
        """Return that the TCP moves: the path parameter is its arc length."""
        return True

    @property
    def length(self) -> float:
        """Return the arc length of the TCP path [m]."""
        return self.arc_length.length

    @property
    def knots(self) -> Array:
        """Return the path parameters at which segments begin and end [m], rising from 0, shape (c + 1,)."""
        return self.arc_length.ends[:: self.arc_length.steps]

    def own_grid(self) -> Array:
        """Return path parameters that are even in the parameter of the polynomials, shape (m,).

        So they are close where the curve nearly reverses, and four times as close on curves with segments of
        uneven speed.
        """
        return self.arc_length.ends[::_EVERY]

    @property
    def numbers(self) -> tuple[Array, Array, Array, int, Array, Array]:
        """Return the data of the curve for `curve_points`."""
        arc_length = self.arc_length
        return (
            series(),
            arc_length.ends,
            arc_length.inverse,
            arc_length.steps,
            self.coefficients,
            self.middles,
        )

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool and its derivatives at path parameters s, shape (k,)."""
        points = ToolPoints(np.empty((len(s), 4, 4)), np.empty((len(s), 6)), np.empty((len(s), 6)))
        parameters = np.ascontiguousarray(s)
        curve_points(*self.numbers, parameters, points.matrices, points.d1, points.d2)
        return points

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at path parameters s, shape (k,) to (k, 3) [m]."""
        return self.tool(s).matrices[:, :3, 3]

    def distance(self, points: Array) -> Array:
        """Return how far points, shape (k, 3) [m], are from the path of the TCP, shape (k,) [m]."""
        count = len(self.middles)
        wanted = min(math.ceil(self.length / count / _STEP), _MOST_POINTS // count)
        steps = min(max(wanted, _GRID[0]), _GRID[1])
        return distances(points, self._by_parameter, np.arange(count * steps + 1) / steps)

    def _by_parameter(self, u: Array) -> tuple[Array, Array, Array]:
        """Return p and its derivatives by u, the number of the segment and the parameter in it as one."""
        p, d1, d2 = (np.empty((len(u), 3)) for _ in range(3))
        curve_at(self.coefficients, np.ascontiguousarray(u), p, d1, d2)
        return p, d1, d2
