"""All convex bodies of a cell as arrays: where they are, which may be near, how near they are."""

from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt

from ropsim.collision.convex import Convex
from ropsim.collision.depth import FINE, Support, depth_of
from ropsim.collision.gjk_kernel import distances
from ropsim.collision.separation import Nearness
from ropsim.collision.ways_kernel import Certified, Convexes, Movement, Search, certify
from ropsim.spatial import Array

Rows = npt.NDArray[np.intp]
"""Numbers of two convex bodies each, shape (p, 2)."""
_APART = 1e-4
"""Bodies are parted by this distance more than their depth, so that their nearest points are known [m]."""


class SolidBodies:
    """The convex bodies of some bodies, by number.

    Args:
        solids: convex bodies of each body, by name.
    """

    def __init__(self, solids: Mapping[str, Sequence[Convex]]) -> None:
        self.owners = [name for name, some in solids.items() for _ in some]
        self.convexes = [one for some in solids.values() for one in some]
        self.rows = {name: [k for k, owner in enumerate(self.owners) if owner == name] for name in solids}
        counts = np.cumsum([0, *(len(one.points) for one in self.convexes)])
        self._points = np.concatenate([one.points for one in self.convexes] or [np.empty((0, 3))])
        self._bodies = np.array(
            [
                (first, last, float(one.is_round), one.margin)
                for first, last, one in zip(counts, counts[1:], self.convexes, strict=False)
            ],
            dtype=np.float64,
        ).reshape(-1, 4)
        self._X_BC = np.array([one.X_BC.matrix() for one in self.convexes]).reshape(-1, 4, 4)
        bounds = np.array([one.bounds for one in self.convexes]).reshape(-1, 2, 3)
        self._centres, self._halves = bounds.mean(axis=1), np.ptp(bounds, axis=1) / 2.0

    @property
    def hulls(self) -> tuple[Array, Array]:
        """Return the points of all hulls, shape (v, 3), and the bodies of them; see the kernel."""
        return self._points, self._bodies

    def placed(self, poses: Mapping[str, Array]) -> Array:
        """Return R_W by rows and p_W [m] of each convex body, shape (n, 12).

        Args:
            poses: X_WB of the bodies, shape (4, 4), by name.
        """
        X = np.array([poses[name] for name in self.owners]).reshape(-1, 4, 4) @ self._X_BC
        return np.ascontiguousarray(np.hstack([X[:, :3, :3].reshape(-1, 9), X[:, :3, 3]]))

    def bounds(self, placed: Array, pairs: Rows) -> Array:
        """Return lower bounds of distances, by boxes along x, y, z [m], shape (p,)."""
        R = placed[:, :9].reshape(-1, 3, 3)
        centres = np.einsum("kij,kj->ki", R, self._centres) + placed[:, 9:]
        halves = np.einsum("kij,kj->ki", np.abs(R), self._halves)
        i, j = pairs[:, 0], pairs[:, 1]
        gaps = np.abs(centres[i] - centres[j]) - halves[i] - halves[j]
        return np.asarray(np.linalg.norm(np.maximum(gaps, 0.0), axis=1) + np.minimum(gaps.max(axis=1), 0.0))

    def distances(
        self, placed: Array, pairs: Rows | Array, bounds: Array, limits: tuple[float, float]
    ) -> Array:
        """Return distances of the hulls without margins, and nearest points; see the kernel."""
        found = np.empty((len(pairs), 7))
        numbers, work = np.ascontiguousarray(pairs, dtype=np.float64), np.zeros((17, 4))
        distances(self._points, self._bodies, placed, numbers, bounds, np.array(limits), work, found)
        return found

    def gaps(self, pair: Sequence[int], first: Array, second: Array) -> Array:
        """Return the distances of two convex bodies at many poses, with their margins [m], shape (k,).

        Distances are 0 or less where the bodies touch; depths are not computed.

        Args:
            pair: two numbers.
            first: R_W by rows and p_W [m] of the first body, shape (k, 12).
            second: the same of the second body.
        """
        count = len(first)
        bodies = np.repeat(self._bodies[list(pair)], count, axis=0)
        rows = np.column_stack([np.arange(count), np.arange(count, 2 * count)]).astype(np.float64)
        found, work = np.empty((count, 7)), np.zeros((17, 4))
        placed = np.ascontiguousarray(np.concatenate([first, second]))
        limits = np.array([np.inf, np.inf])
        distances(self._points, bodies, placed, rows, np.zeros(count), limits, work, found)
        return found[:, 0] - float(self._bodies[list(pair), 3].sum())

    def box(self, number: int) -> tuple[Array, Array]:
        """Return middle and half edges of the box around a convex body, in its frame [m], shape (3,)."""
        return self._centres[number], self._halves[number]

    def on_ways(
        self, items: Array, pairs: Array, movement: Movement, search: Search, found: Certified
    ) -> None:
        """Find how near pairs come in a span of their ways; see the kernel."""
        certify(Convexes(self._points, self._bodies, items), pairs, movement, search, found)

    def nearness(self, placed: Array, pair: Sequence[int], row: Array, fine: float = FINE) -> Nearness:
        """Return the nearness of a pair, with its margins; if hulls overlap, with their depth.

        Args:
            placed: where all are.
            pair: two numbers.
            row: distance and nearest points of their hulls, shape (7,).
            fine: allowed excess of a depth [m].
        """
        i, j = pair
        margins = float(self._bodies[i, 3]), float(self._bodies[j, 3])
        distance, first, second = float(row[0]), row[1:4], row[4:7]
        if distance > 0.0:
            normal = (second - first) / np.linalg.norm(second - first)
        else:
            depth, away, _ = depth_of(self._support(placed, i), self._support(placed, j), fine)
            first = self._deepest(placed, (i, j), depth, away)
            distance, normal, second = -depth, -away, first + depth * away
        first, second = first + margins[0] * normal, second - margins[1] * normal
        return Nearness(self.owners[i], self.owners[j], distance - sum(margins), first, second)

    def _deepest(self, placed: Array, pair: tuple[int, int], depth: float, away: Array) -> Array:
        """Return the point of the first body that leaves the other one last when it is parted [m]."""
        apart = placed.copy()
        shift = (depth + _APART) * away
        apart[pair[0], 9:] += shift
        found = self.distances(apart, np.array([pair]), np.zeros(1), (np.inf, np.inf))[0]
        return np.asarray(found[1:4] - shift)

    def margins(self, pairs: Rows) -> Array:
        """Return the sum of the margins of each pair [m], shape (p,)."""
        return np.asarray(self._bodies[pairs[:, 0], 3] + self._bodies[pairs[:, 1], 3])

    def _support(self, placed: Array, number: int) -> Support:
        R, p = placed[number, :9].reshape(3, 3), placed[number, 9:]
        convex = self.convexes[number]
        return lambda direction: R @ convex.farthest(direction @ R) + p
