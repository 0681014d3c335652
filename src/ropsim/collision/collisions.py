"""The bodies of a cell prepared for the check of many configurations."""

from collections.abc import Hashable, Iterable, Mapping
from dataclasses import replace
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from ropsim.collision.depth import COARSE
from ropsim.collision.pairs import Elsewhere, LeftOut, Pair, left_out, owners
from ropsim.collision.separation import Nearness, Separation
from ropsim.collision.solid_bodies import Rows, SolidBodies
from ropsim.collision.solids import NO_MESHES, MeshPoints, convexes, readable
from ropsim.core import frozen_dataclass
from ropsim.kinematics import NotFiniteError, body_poses
from ropsim.model import Body, BodyKind, Cell, Mechanism, Mesh, body_tree, is_bare, start_of
from ropsim.spatial import Array

TOUCH = 1e-6
"""Bodies that are no deeper in each other touch [m]; it is above the rounding of poses."""
AS_AT_START: Elsewhere = {}

Coordinates: TypeAlias = "npt.ArrayLike | Mapping[str, npt.ArrayLike]"
"""Joint coordinates of the first station [rad | m], shape (n,), or of mechanisms by their names."""


@frozen_dataclass
class CheckedPairs:
    """Bodies that are checked, for one state of attachments.

    Attributes:
        rows: pairs of convex bodies.
        pairs: of bodies.
        left_out: why others are not checked, by pair.
    """

    rows: Rows
    pairs: tuple[Pair, ...]
    left_out: Mapping[Pair, LeftOut]


class Collisions:
    """Distances between the bodies of a cell.

    Poses are in the world frame W. A body that is invisible at the start, such as an unmounted tool or a part
    in its supply, is present only if its attachment is passed. Pairs that touch by the way they are built are
    left out, see `left_out`, and so are bodies of one robot or device that are in each other while it rests:
    they are drawn so.

    Args:
        cell: its bodies.
        meshes: points of its meshes; one without them, or with one that is not finite, is not checked.
    """

    def __init__(self, cell: Cell, meshes: MeshPoints = NO_MESHES) -> None:
        self.tree, meshes = body_tree(cell), readable(meshes)
        self._first, self._start = cell.first.name, dict(start_of(cell))
        self._home = self._start | {name: one.robot.home for name, one in cell.stations.items()}
        solids = {
            body.name: [one for shape in body.shapes for one in convexes(shape, meshes)]
            for body in self.tree.bodies
        }
        self._hidden = frozenset(body.name for body in self.tree.bodies if not body.visible)
        self._known: dict[Hashable, CheckedPairs] = {}
        self.shapeless = tuple(
            body.name for body in self.tree.bodies if not _is_seen(body, self.tree.mechanisms, meshes)
        )
        self.unseen = tuple(name for name in self.shapeless if name not in self._hidden)
        self.bodies = SolidBodies({name: some for name, some in solids.items() if some})
        self._at_rest: frozenset[Pair] = frozenset()
        self._at_rest = frozenset(self._drawn_so())
        self._known.clear()

    @property
    def at_rest(self) -> tuple[Pair, ...]:
        """Return the pairs of one robot or device that are not checked: they overlap at rest."""
        return tuple(sorted(self._at_rest))

    def separation(
        self, q: Coordinates, elsewhere: Elsewhere = AS_AT_START, absent: Iterable[str] = ()
    ) -> Separation:
        """Return the smallest distance between bodies, with the checked pairs.

        Args:
            q: joint coordinates; mechanisms that are not named stand as at the start.
            elsewhere: attachments that differ from the start.
            absent: names of bodies that are not there.

        Raises:
            ArrayShapeError: M551, coordinates have another shape.
            NotFiniteError: M552, q holds NaN or infinity.
        """
        checked = self._checked(elsewhere, absent)
        nearest = self._nearest(q, checked, elsewhere)
        return Separation(nearest, checked.pairs, checked.left_out, self.unseen)

    def meetings(
        self, q: Coordinates, elsewhere: Elsewhere = AS_AT_START, absent: Iterable[str] = ()
    ) -> tuple[Nearness, ...]:
        """Return the pairs of bodies that are in each other, deepest first; depths mostly to 0.05 mm.

        Args:
            q: as with `separation`.
            elsewhere: attachments that differ from the start.
            absent: bodies that are not present.

        Raises:
            ArrayShapeError: M551, coordinates have another shape.
            NotFiniteError: M552, q holds NaN or infinity.
        """
        return self._meetings(q, self._checked(elsewhere, absent), elsewhere)

    def _checked(self, elsewhere: Elsewhere, absent: Iterable[str]) -> CheckedPairs:
        gone = frozenset(absent) | (self._hidden - elsewhere.keys())
        key = gone, tuple((name, parent) for name, (parent, _) in elsewhere.items())
        if key not in self._known:
            self._known[key] = self._pairs(elsewhere, gone)
        return self._known[key]

    def _pairs(self, elsewhere: Elsewhere, gone: frozenset[str]) -> CheckedPairs:
        names = [name for name in self.bodies.rows if name not in gone]
        out = left_out(self.tree, frozenset(names), elsewhere)
        out |= {pair: LeftOut.AT_REST for pair in self._at_rest if pair not in out and not gone & {*pair}}
        pairs, rows = [], []
        for k, one in enumerate(names):
            for other in names[k + 1 :]:
                if (one, other) not in out:
                    pairs.append((one, other))
                    rows += [(i, j) for i in self.bodies.rows[one] for j in self.bodies.rows[other]]
        return CheckedPairs(np.array(rows, np.intp).reshape(-1, 2), tuple(pairs), out)

    def _placed(self, q: Coordinates, elsewhere: Elsewhere) -> Array:
        given: Mapping[str, npt.ArrayLike] = q if isinstance(q, Mapping) else {self._first: q}
        rows = {name: np.asarray(values)[np.newaxis] for name, values in {**self._start, **given}.items()}
        for values in rows.values():
            if not np.isfinite(values).all():
                raise NotFiniteError("q")
        poses = body_poses(self.tree, rows, list(self.bodies.rows), elsewhere)
        return self.bodies.placed({name: found[0] for name, found in poses.items()})

    def _nearest(self, q: Coordinates, checked: CheckedPairs, elsewhere: Elsewhere) -> Nearness | None:
        if not len(checked.rows):
            return None
        placed = self._placed(q, elsewhere)
        bounds = self.bodies.bounds(placed, checked.rows)
        order = np.argsort(bounds, kind="stable")
        rows = checked.rows[order]
        found = self.bodies.distances(placed, rows, bounds[order], (np.inf, 0.0))
        gaps = found[:, 0] - self.bodies.margins(rows)
        touching = np.flatnonzero(found[:, 0] == 0.0)
        candidates = {int(np.argmin(gaps)), *touching.tolist()}
        every = [self.bodies.nearness(placed, rows[k], found[k]) for k in sorted(candidates)]
        return min(every, key=lambda one: one.distance)

    def _meetings(self, q: Coordinates, checked: CheckedPairs, elsewhere: Elsewhere) -> tuple[Nearness, ...]:
        if not len(checked.rows):
            return ()
        placed = self._placed(q, elsewhere)
        bounds = self.bodies.bounds(placed, checked.rows)
        near = bounds <= 0.0
        rows = checked.rows[near]
        found = self.bodies.distances(placed, rows, bounds[near], (0.0, np.inf))
        deepest: dict[Pair, Nearness] = {}
        for k in np.flatnonzero(found[:, 0] - self.bodies.margins(rows) <= 0.0).tolist():
            one = self.bodies.nearness(placed, rows[k], found[k], COARSE)
            if one.distance < min(-TOUCH, deepest[one.pair].distance if one.pair in deepest else 0.0):
                deepest[one.pair] = one
        return tuple(sorted(deepest.values(), key=lambda one: one.distance))

    def _drawn_so(self) -> list[Pair]:
        """Return the pairs of one robot or device that are in each other while it rests."""
        checked = self._checked(AS_AT_START, ())
        owner = owners(self.tree, frozenset(self.bodies.rows))
        own = [pair for pair in checked.pairs if owner.get(pair[0], "") == owner.get(pair[1], pair[1])]
        rows = [(i, j) for one, other in own for i in self.bodies.rows[one] for j in self.bodies.rows[other]]
        own_pairs = replace(checked, rows=np.array(rows, np.intp).reshape(-1, 2))
        return [one.pair for one in self._meetings(self._home, own_pairs, AS_AT_START)]


def _is_seen(body: Body, mechanisms: Mapping[str, Mechanism], meshes: MeshPoints) -> bool:
    """Return whether the points of all meshes of a body are known, and nothing else is drawn of it."""
    if body.shapes:
        return all(one.solid in meshes for one in body.shapes if isinstance(one.solid, Mesh))
    if body.kind is BodyKind.LINK and body.mover:
        return is_bare(mechanisms[body.mover.mechanism], body.mover.joint)
    return body.kind is not BodyKind.BASE  # views draw a stand-in for arms only
