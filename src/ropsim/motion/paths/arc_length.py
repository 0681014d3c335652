"""Arc length: the way along a curve of polynomials, and where on it a way ends."""

from functools import cache

import numpy as np

from ropsim.motion.paths.nearest import IntArray
from ropsim.motion.paths.polynomials import powers, quintics
from ropsim.spatial import Array, frozen, record

_POINTS = 5  # of Gauss and Legendre in each step
_UNEVEN = 0.45  # least speed in a segment by its greatest; below, steps are four times as fine
_AT_ONCE = 256  # segments


@record
class ArcLength:
    """The parameter t of each segment, from 0 to 1, over the way s along all of them.

    Between steps of t the way is integrated; its inverse is interpolated by polynomials of degree five with
    the exact derivatives dt/ds = 1 / |p'| and d²t/ds² = -p'·p'' / |p'|⁴ at both ends of every step.

    Attributes:
        ends: way at the end of each step, after that at the start, shape (m + 1,) [m].
        coefficients: of t over the share of the step, shape (m, 6).
        steps: of each segment.
    """

    ends: Array
    coefficients: Array
    steps: int

    @property
    def length(self) -> float:
        """Return the way along the whole curve [m]."""
        return float(self.ends[-1])

    def parameters(self, s: Array) -> tuple[IntArray, Array]:
        """Return segment and parameter t at ways s, each of shape (k,)."""
        step = self.ends[1:-1].searchsorted(s, side="right")
        begin = self.ends[step]
        share = (s - begin) / (self.ends[step + 1] - begin)
        t = np.einsum("ki,ki->k", powers(share), self.coefficients.take(step, axis=0))
        return step // self.steps, t


def arc_length(d1: Array, d2: Array, steps: int, least: Array) -> ArcLength | None:
    """Return the way along a curve, or None where somewhere it all but stands.

    Args:
        d1: coefficients of the powers of t in p' of every segment, shape (c, 6, 3) [m].
        d2: those of p'', shape (c, 6, 3) [m].
        steps: of each segment, for curves of even speed.
        least: of every segment the |p'| that it needs, shape (c,) [m].

    References:
        Press, Teukolsky, Vetterling and Flannery 2007, Numerical Recipes, section 4.6, for the quadrature.
    """
    nodes = _grid(steps)[0]
    speeds = _norm(nodes @ d1)
    if (speeds.min(axis=1) <= least).any():
        return None
    if (speeds.min(axis=1) < _UNEVEN * speeds.max(axis=1)).any():
        steps *= 4
    parts = [_steps(d1[k : k + _AT_ONCE], d2[k : k + _AT_ONCE], steps) for k in range(0, len(d1), _AT_ONCE)]
    ways = np.concatenate([way for way, _ in parts])
    ends = np.concatenate(([0.0], np.cumsum(ways)))
    return ArcLength(frozen(ends), frozen(np.concatenate([inverse for _, inverse in parts])), steps)


def _steps(d1: Array, d2: Array, steps: int) -> tuple[Array, Array]:
    """Return the way of each step, shape (c·steps,), and the coefficients of t in it, (c·steps, 6)."""
    nodes, points, weights = _grid(steps)
    ways = _norm(points @ d1).reshape(len(d1), steps, _POINTS) @ weights
    p1, p2 = nodes @ d1, nodes @ d2
    square = np.einsum("csi,csi->cs", p1, p1)
    first, second = 1.0 / np.sqrt(square), -np.einsum("csi,csi->cs", p1, p2) / (square * square)
    ends = np.empty((len(d1), steps, 6, 1))
    for row, part in ((0, slice(0, steps)), (3, slice(1, steps + 1))):
        ends[:, :, row, 0] = nodes[part, 1]
        ends[:, :, row + 1, 0] = first[:, part] * ways
        ends[:, :, row + 2, 0] = second[:, part] * ways * ways
    return ways.ravel(), quintics(ends)[..., 0].reshape(-1, 6)


@cache
def _grid(steps: int) -> tuple[Array, Array, Array]:
    """Return the powers of t at the ends of the steps, (steps + 1, 6), and between; their weights."""
    ends = np.arange(steps + 1) / steps
    points, weights = np.polynomial.legendre.leggauss(_POINTS)
    inner = ends[:-1, None] + (points + 1.0) / (2.0 * steps)
    return frozen(powers(ends)), frozen(powers(inner.ravel())), frozen(weights / (2.0 * steps))


def _norm(vectors: Array) -> Array:
    return np.asarray(np.sqrt(np.einsum("...i,...i->...", vectors, vectors)))
