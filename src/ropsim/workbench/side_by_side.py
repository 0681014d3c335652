"""How deep a part is in one like it beside it, and how far apart they would touch."""

from collections.abc import Sequence

import numpy as np

from ropsim.collision import Convex, SolidBodies
from ropsim.spatial import Array

_FINE = 1e-6
"""Lengths are found so finely [m]."""


class SideBySide:
    """A body and its copy, which is moved and not turned.

    Args:
        solids: convex bodies of the body, one at least.
    """

    def __init__(self, solids: Sequence[Convex]) -> None:
        self._bodies = SolidBodies({"it": solids, "copy": solids})
        numbers = range(len(solids))
        self._pairs = np.array([(i, len(solids) + j) for i in numbers for j in numbers], np.intp)

    def depth(self, shift: Array) -> float:
        """Return how deep they are in each other [m], 0 where they touch at most.

        Args:
            shift: of the copy, in the frame of the body [m], shape (3,).
        """
        placed, found = self._found(shift)
        meeting = np.flatnonzero(found[:, 0] - self._bodies.margins(self._pairs) <= 0.0).tolist()
        depths = (-self._bodies.nearness(placed, self._pairs[k], found[k]).distance for k in meeting)
        return max(depths, default=0.0)

    def length(self, shift: Array) -> float:
        """Return the distance at which they touch, in the direction of a shift with which they meet [m].

        Args:
            shift: as with `depth`, not 0.
        """
        near = float(np.linalg.norm(shift))
        along, far = shift / near, 2.0 * near
        while self._meet(far * along):
            near, far = far, 2.0 * far
        while far - near > _FINE:
            middle = (near + far) / 2.0
            near, far = (middle, far) if self._meet(middle * along) else (near, middle)
        return far

    def _meet(self, shift: Array) -> bool:
        _, found = self._found(shift)
        return bool((found[:, 0] - self._bodies.margins(self._pairs) <= 0.0).any())

    def _found(self, shift: Array) -> tuple[Array, Array]:
        X = np.eye(4)
        X[:3, 3] = shift
        placed = self._bodies.placed({"it": np.eye(4), "copy": X})
        bounds = self._bodies.bounds(placed, self._pairs)
        return placed, self._bodies.distances(placed, self._pairs, bounds, (0.0, np.inf))
