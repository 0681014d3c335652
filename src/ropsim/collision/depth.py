"""How deep two convex bodies are in each other: the polytope algorithm on their difference."""

from collections.abc import Callable
from itertools import product
from typing import NamedTuple

import numpy as np

from ropsim.collision.polytope import Face, Polytope
from ropsim.spatial import Array

MOST = 120
"""Maximum number of added points; bodies with corners take about twenty. Round bodies take more: for 2 m,
depths were up to 1 mm too large, never too small."""
FINE = 1e-9
"""A depth is found so finely [m]."""
COARSE = 5e-5
"""So finely where only people read it: round bodies take many steps for more [m]."""

Support = Callable[[Array], Array]
"""Returns the point of a body that lies farthest along a direction, in W [m]."""

_AROUND = np.array([one for one in product((-1.0, 0.0, 1.0), repeat=3) if any(one)])


class Depth(NamedTuple):
    """How deep two bodies are in each other.

    Attributes:
        depth: length of the shortest shift that parts them [m]; 0 where they touch at most.
        normal: direction in which the first one goes then, shape (3,).
        point: where the first one is the deepest in the other, in W [m], shape (3,).
    """

    depth: float
    normal: Array
    point: Array


def depth_of(one: Support, other: Support, fine: float = FINE) -> Depth:
    """Return how deep two bodies that meet are in each other (van den Bergen 2001).

    Of a polytope inside of the difference of the bodies the face nearest to the origin is pushed outward,
    until no point of the difference is farther out. The answer is the least extent of the difference that was
    seen, so never too small.

    Args:
        one: of the first body.
        other: of the second body.
        fine: allowed excess [m].
    """
    seeds = [(one(d), other(-d)) for d in _AROUND]
    polytope = Polytope.within(np.array([a - b for a, b in seeds]))
    least, direction = np.inf, np.array([0.0, 0.0, 1.0])
    deepest = seeds[0][0]
    for _ in range(MOST):
        number = min(polytope.faces, key=lambda n: (polytope.faces[n].offset, n))
        face: Face = polytope.faces[number]
        point = one(face.normal)
        corner = point - other(-face.normal)
        extent = float(corner @ face.normal)
        if extent < least:
            least, direction, deepest = extent, face.normal, point
        if extent - face.offset <= fine or not polytope.add(corner, number)[1]:
            break
    return Depth(max(least, 0.0), -direction, deepest)
