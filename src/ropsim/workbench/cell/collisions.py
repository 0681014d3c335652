"""Obstacles of an arm at a place of its cell with a part, and of a part next to an equal one."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from ropsim.collision import TOUCH, Collisions, Convex, Elsewhere, MeshPoints, Nearness, SolidBodies
from ropsim.model import Body, BodyKind, Cell, Part, Station, link_name, tool_body
from ropsim.spatial import Array, Pose
from ropsim.workbench.cell.part_places import first_parts, part_places

if TYPE_CHECKING:
    from ropsim.tasks import Point


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


UPSIDE_DOWN = Pose(orientation=np.array([0.0, 1.0, 0.0, 0.0]))
"""X_TO of a part that lies at no location: it hangs with its top against the tool."""


class CellCollisions:
    """Meetings of an arm, its tool and the part that it holds with all else, at one configuration.

    Pairs of bodies that overlap at the start are not checked (`met`), nor are other parts at locations: tasks
    may have moved them. All other parts stand where they stand at the start.

    Args:
        cell: its bodies.
        meshes: points of its meshes.
    """

    def __init__(self, cell: Cell, meshes: MeshPoints) -> None:
        self._cell = cell
        self._collisions = Collisions(cell, meshes)
        self._bodies = self._collisions.tree.by_name()
        self._parts = {part.name: part for part in cell.parts}
        self._places = part_places(cell)
        self._firsts = first_parts(cell)
        self.met = tuple(one.pair for one in self._collisions.meetings({}))

    @property
    def unchecked(self) -> Iterator[str]:
        """Yield the checks that are omitted, for a line behind `not checked`."""
        yield "collisions on the way between places"
        if self._places:
            yield "collisions with parts at other places"
        if unseen := list(self._unseen()):
            yield f"collisions of {_listed(unseen)} without a known shape"
        for one, other in self._collisions.at_rest:
            yield f"{self.words(one)} against {self.words(other)}, since they are in each other at rest"
        for one, other in self.met:
            yield f"{self.words(one)} in {self.words(other)}, as at the start"

    def first_meeting(
        self, station: Station, part: str, place: "Point", postures: Iterable[Array]
    ) -> Nearness | None:
        """Return None where an arm can stand in one of some postures without being in anything.

        Otherwise the deepest meeting in the posture in which that is the least deep. A part may be as deep in
        other things as the cell allows for parts that are set down, and at its start place as deep as drawn;
        other bodies may touch.

        Args:
            station: of the arm.
            part: name of the part that it holds; of one that is not in the cell nothing is known.
            place: where it holds it.
            postures: joint coordinates of the arm [rad | m], shape (n,) each.
        """
        held = self._held(station, part)
        absent = self._places.keys() - {part}
        is_drawn_so = place == self.place_of(part)
        best: Nearness | None = None
        for q in postures:
            found = self._collisions.meetings({station.name: q}, held, absent)
            counted = (one for one in found if self._counts(station, part, one))
            if is_drawn_so:
                counted = (one for one in counted if part not in one.pair or self._is_of_arm(station, one))
            worst = next(counted, None)
            if worst is None:
                return None
            if best is None or worst.distance > best.distance:
                best = worst
        return best

    def beside(self, part: str, shift: Array) -> tuple[float, float] | None:
        """Return how deep a part is in one like it that is held alike, and its length there [m].

        None where it is no deeper than the cell allows for parts, or nothing is known of it.

        Args:
            part: by its name.
            shift: how far from it the other one is, along the axes of the tool [m], shape (3,).
        """
        bodies = self._collisions.bodies
        if part not in self._parts or part not in bodies.rows:
            return None
        pair = SideBySide([bodies.convexes[k] for k in bodies.rows[part]])
        moved = self.hanging(part).rotation().T @ shift
        depth = pair.depth(moved)
        return (depth, pair.length(moved)) if depth > self._cell.supports.depth else None

    @property
    def parts(self) -> Mapping[str, Part]:
        """Return the parts of the cell by name."""
        return self._parts

    @property
    def places(self) -> Mapping[str, str]:
        """Return at which locations parts lie at the start, by part."""
        return self._places

    def words(self, name: str) -> str:
        """Return the name of a body for users."""
        body = self._bodies[name]
        match body.kind:
            case BodyKind.TOOL:
                return f"the tool `{name.rpartition(':')[2]}`"
            case BodyKind.FINGER:
                return f"a finger of {self.words(body.parent)}"
            case BodyKind.PART:
                return f"the part `{name}`"
            case BodyKind.CYLINDER:
                link, _, end = name.rpartition("/")
                return f"the {end} of the cylinder that turns `{link}`"
        return f"`{name}`"

    def is_moved(self, station: Station, name: str, part: str) -> bool:
        """Return whether a body belongs to an arm, or is the part that it holds."""
        return name == part or _station_of(self._bodies, name) == station.name

    def _unseen(self) -> Iterator[str]:
        """Yield the bodies without a known shape; an arm without any shape by one name."""
        unseen = dict.fromkeys(self._collisions.unseen)
        for station in self._cell.stations.values():
            names = [link_name(number, station.name) for number in range(len(station.robot.joints) + 1)]
            if unseen.keys() >= {*names}:
                unseen = {name: None for name in unseen if name not in names}
                yield f"the arm of `{station.name}`" if len(self._cell.stations) > 1 else "the arm"
        yield from map(self.words, unseen)

    def _counts(self, station: Station, part: str, one: Nearness) -> bool:
        if one.pair in self.met or not any(self.is_moved(station, name, part) for name in one.pair):
            return False
        return -one.distance > (self._cell.supports.depth if part in one.pair else TOUCH)

    def _is_of_arm(self, station: Station, one: Nearness) -> bool:
        return any(_station_of(self._bodies, name) == station.name for name in one.pair)

    def place_of(self, part: str) -> str | None:
        """Return where a part lies at the start, or the first one of its supply; None if unknown."""
        return self._places.get(self._firsts.get(part, part))

    def _held(self, station: Station, name: str) -> Elsewhere:
        """Return the body that a held part is attached to, and its pose there."""
        tool = station.tools.get(station.default_tool)
        if name not in self._parts:
            return {}
        X_TO = self.hanging(name)
        if tool is None:
            return {name: (link_name(station.robot.tip + 1, station.name), station.robot.X_nM @ X_TO)}
        return {name: (tool_body(tool.name, station.name), tool.X_MT @ X_TO)}

    def hanging(self, name: str) -> Pose:
        """Return X_TO of a part: as when it is taken from where it lies at the start.

        One that waits in a supply is taken from where the first one of it lies.
        """
        place = self.place_of(name)
        return (
            UPSIDE_DOWN if place is None else self._cell.locations[place].inverse() @ self._parts[name].X_WO
        )


def _station_of(bodies: Mapping[str, Body], name: str) -> str:
    """Return the mechanism that moves a body with its arm, empty for none."""
    while name:
        body = bodies[name]
        if body.mover is not None and body.kind in (BodyKind.LINK, BodyKind.CYLINDER):
            return body.mover.mechanism
        name = body.parent
    return ""


def _listed(names: list[str]) -> str:
    """Return up to three names, and how many more there are."""
    more = f" and {len(names) - 3} more" if len(names) > 3 else ""
    return f"{', '.join(names[:3])}{more}"
