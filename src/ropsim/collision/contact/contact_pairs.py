"""Bodies that may be pressed on each other: how far apart they are, and the wrench between them."""

from collections.abc import Mapping, Sequence
from dataclasses import field
from typing import NamedTuple

import numpy as np

from ropsim.collision.contact.contact_kernel import Moved, Room, Surfaces, contact_wrenches
from ropsim.collision.contact.surface import FLOOR, FLOOR_SURFACE, Surface, surface_of
from ropsim.collision.convex import Convex
from ropsim.collision.solid_bodies import SolidBodies
from ropsim.core import frozen_dataclass
from ropsim.spatial import Array, frozen

NEAR = 1e-3
"""Convex bodies farther from each other have no point in each other [m]."""
IMMOVABLE = frozen(np.zeros((6, 6)))
"""Mobility of a body of infinite mass."""
_AT_ORIGIN = np.eye(4)


@frozen_dataclass
class ContactLaw:
    """How hard two bodies resist.

    Attributes:
        stiffness: force over the depth of a flat face, or of a ball [N/m].
        damping: force over the speed of approach [N·s/m].
        friction: Coulomb coefficient.
    """

    stiffness: float
    damping: float
    friction: float


class Pressed(NamedTuple):
    """What acts on the bodies that move.

    Attributes:
        wrench: force [N] and moment [N·m] about the reference point, in W, shape (6,).
        depth: of the deepest point of them, or in them [m].
    """

    wrench: Array
    depth: float


@frozen_dataclass
class TouchingPair:
    """Two bodies that may touch.

    Attributes:
        moving: name of the body that moves.
        standing: name of the one that stands.
        law: how hard they resist.
    """

    moving: str
    standing: str
    law: ContactLaw


class ContactPairs:
    """The pairs of bodies that may touch, prepared for many poses.

    Args:
        solids: convex bodies of each, by name.
        pairs: of them.
        floor: name of the one that is the floor; empty for none.
    """

    def __init__(
        self, solids: Mapping[str, Sequence[Convex]], pairs: Sequence[TouchingPair], floor: str = ""
    ) -> None:
        self._floor = floor
        with_floor = {**solids, floor: (FLOOR,)} if floor else solids
        self._bodies = SolidBodies(with_floor)
        made = [
            FLOOR_SURFACE if owner == floor else surface_of(convex)
            for owner, convex in zip(self._bodies.owners, self._bodies.convexes, strict=True)
        ]
        self._surfaces, most = _packed(made, self._bodies)
        self._room = Room(np.zeros((most, 10)), np.zeros((17, 4)), np.zeros((1, 7)))
        rows = [
            (i, j, n)
            for n, one in enumerate(pairs)
            for i in self._bodies.rows[one.moving]
            for j in self._bodies.rows[one.standing]
        ]
        self._rows = np.array(rows, np.intp).reshape(-1, 3)
        laws = [(one.law.stiffness, one.law.damping, one.law.friction) for one in pairs]
        self._pairs, self._every = self._rows[:, :2].astype(np.float64), np.zeros(len(rows))
        self._margins = self._bodies.margins(self._rows)
        self._laws = np.array(laws).reshape(-1, 3)[self._rows[:, 2]]

    def placed(self, poses: Mapping[str, Array]) -> "PlacedPairs":
        """Return the pairs at poses X_WB of the bodies, shape (4, 4), by name; others are not there."""
        missing = [name for name in self._bodies.rows if name not in poses]
        placed = self._bodies.placed({**poses, **dict.fromkeys(missing, _AT_ORIGIN)})
        found = self._bodies.distances(placed, self._pairs, self._every, (np.inf, np.inf))
        gaps = found[:, 0] - self._margins
        if missing:
            away = {row for name in missing if name != self._floor for row in self._bodies.rows[name]}
            gaps[[bool(away & {int(i), int(j)}) for i, j, _ in self._rows]] = np.inf
        return PlacedPairs(self, placed, gaps)

    def pressed(self, placed: "PlacedPairs", motion: Array, mobility: Array = IMMOVABLE) -> Pressed:
        """Return what acts on the bodies that move.

        Args:
            placed: the pairs at their poses.
            motion: reference point in W [m], its velocity [m/s], and the angular velocity of what moves
                [rad/s], shape (3, 3).
            mobility: change of both velocities over a control tick by a wrench at the reference point, in W
                [m/s, rad/s over N, N·m], shape (6, 6): friction is bounded by it. Zeros for infinite masses.
        """
        near = placed.gaps <= NEAR
        if not near.any():
            return Pressed(np.zeros(6), 0.0)
        pairs = np.ascontiguousarray(self._pairs[near])
        found = np.empty((len(pairs), 7))
        laws = np.ascontiguousarray(self._laws[near])
        moved = Moved(np.ascontiguousarray(motion), np.ascontiguousarray(mobility))
        contact_wrenches(self._surfaces, placed.poses, pairs, laws, moved, self._room, found)
        return Pressed(found[:, :6].sum(axis=0), float(found[:, 6].max()))


@frozen_dataclass
class PlacedPairs:
    """Pairs of bodies at their poses.

    Attributes:
        pairs: they.
        poses: R_W by rows and p_W [m] of each convex body, shape (n, 12).
        gaps: distance of each pair of convex bodies, 0 or less where they touch [m], shape (p,).
    """

    pairs: ContactPairs = field(repr=False)
    poses: Array
    gaps: Array

    @property
    def gap(self) -> float:
        """Return the least distance [m]; infinite without a pair."""
        return float(self.gaps.min(initial=np.inf))


def _packed(surfaces: Sequence[Surface], bodies: SolidBodies) -> tuple[Surfaces, int]:
    """Return surfaces as arrays, and how many rows the points of two need at most."""
    rows = []
    ends = [0, 0, 0]
    counts = [0, 0]
    for number, one in enumerate(surfaces):
        starts = ends.copy()
        ends = [ends[0] + len(one.points), ends[1] + len(one.edges), ends[2] + len(one.planes)]
        kind = 1.0 if one.is_round else 0.0
        if not len(one.points) and not len(one.planes):
            kind = 2.0
        middle, halves = bodies.box(number)
        places = [value for pair in zip(starts, ends, strict=True) for value in pair]
        outer = starts[0] + one.outer
        rows.append((*places, kind, *middle.tolist(), float(np.linalg.norm(halves)), outer))
        counts.append(len(one.points) + int(one.edges[:, 6].sum()))
    corners, hulls = bodies.hulls
    return Surfaces(
        np.concatenate([one.points for one in surfaces] or [np.empty((0, 4))]),
        np.concatenate([one.edges for one in surfaces] or [np.empty((0, 8))]),
        np.concatenate([one.planes for one in surfaces] or [np.empty((0, 4))]),
        np.array(rows).reshape(-1, 12),
        corners,
        hulls,
    ), 2 + sum(sorted(counts)[-2:])
