"""Curve: a way of the tool through polynomials of position and orientation, over its arc length."""

from dataclasses import field

import numpy as np

from ropsim.motion.paths.arc_length import ArcLength
from ropsim.motion.paths.nearest import distances
from ropsim.motion.paths.path import ToolPoints
from ropsim.motion.paths.polynomials import powers
from ropsim.motion.paths.rotation_vector import turning
from ropsim.spatial import Array, frozen, record

_GRID = 16  # steps of each segment in the search for the nearest place


@record
class Curve:
    """Segments one after the other: p(t) and R(t) = R_middle·exp(θ(t)), both of degree five, t from 0 to 1.

    The place is the way of the TCP; derivatives by it follow from those by t by the chain rule, so that
    whoever joins segments with one position, orientation, tangent, curvature, angular velocity and
    acceleration per way has them in the curve, to rounding.

    Attributes:
        coefficients: of t⁰ to t⁵ in p [m] and θ [rad], beside those of both derivatives, (c, 6, 18).
        middles: R_middle in the reference frame, shape (c, 3, 3).
        way: of the TCP.
        turns: whether the tool turns at all.
    """

    coefficients: Array
    middles: Array
    way: ArcLength
    turns: bool = field(init=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "coefficients", frozen(self.coefficients))
        object.__setattr__(self, "middles", frozen(self.middles))
        object.__setattr__(self, "turns", bool(self.coefficients[:, 1:, 3:6].any()))

    @property
    def length(self) -> float:
        """Return the way of the TCP [m]."""
        return self.way.length

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool and its derivatives at places s, shape (k,)."""
        segment, t = self.way.parameters(s)
        values = (powers(t)[:, None, :] @ self.coefficients.take(segment, axis=0))[:, 0, :]
        middles = self.middles.take(segment, axis=0)
        p1, p2 = values[:, 6:9], values[:, 12:15]
        square = np.einsum("ki,ki->k", p1, p1)
        rate = (1.0 / np.sqrt(square))[:, None]  # dt/ds
        change = (-np.einsum("ki,ki->k", p1, p2) / (square * square))[:, None]  # d²t/ds²
        matrices = np.zeros((len(s), 4, 4))
        matrices[:, :3, 3] = values[:, :3]
        matrices[:, 3, 3] = 1.0
        d1, d2 = np.zeros((len(s), 6)), np.zeros((len(s), 6))
        d1[:, :3] = p1 * rate
        d2[:, :3] = p2 * (rate * rate) + p1 * change
        if not self.turns:
            matrices[:, :3, :3] = middles
            return ToolPoints(matrices, d1, d2)
        rotations, speed, grown = turning(values[:, 3:6], values[:, 9:12], values[:, 15:18])
        matrices[:, :3, :3] = middles @ rotations
        by_s = np.stack((speed * rate, grown * (rate * rate) + speed * change), axis=2)
        turned = middles @ by_s
        d1[:, 3:], d2[:, 3:] = turned[:, :, 0], turned[:, :, 1]
        return ToolPoints(matrices, d1, d2)

    def positions(self, s: Array) -> Array:
        """Return where the TCP is at places s, shape (k,) to (k, 3) [m]."""
        segment, t = self.way.parameters(s)
        return np.asarray((powers(t)[:, None, :] @ self.coefficients[..., :3].take(segment, axis=0))[:, 0, :])

    def distance(self, points: Array) -> Array:
        """Return how far points, shape (k, 3) [m], are from the way of the TCP, shape (k,) [m]."""
        count = len(self.middles)
        return distances(points, self._by_parameter, np.arange(count * _GRID + 1) / _GRID)

    def _by_parameter(self, u: Array) -> tuple[Array, Array, Array]:
        """Return p and its derivatives by u, the number of the segment and the parameter in it as one."""
        segment = np.clip(u.astype(np.int64), 0, len(self.middles) - 1)
        values = (powers(u - segment)[:, None, :] @ self.coefficients.take(segment, axis=0))[:, 0, :]
        return values[:, :3], values[:, 6:9], values[:, 12:15]
