"""Where the parts of a running cell are: the parent of each one, and its carrier."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import field
from types import MappingProxyType

from ropsim.core import frozen_dataclass
from ropsim.flow import Placement
from ropsim.model import WORLD, BodyTree
from ropsim.spatial import Pose


@frozen_dataclass
class Seat:
    """Where one part or object is.

    The pose is kept in the frame of the body that moves it, so that no bit of it changes while it stays where
    it is, for any parent.

    Attributes:
        parent: name of the body that it hangs on, `WORLD` for none.
        rides: name of the body with which it moves: a tool that holds it or its parent, or a body that a
            device or an external axis moves; `WORLD` while it rests.
        pose: X_WO while it rests, else in the frame of that body; of a tool that is the mechanical interface.
    """

    parent: str
    rides: str
    pose: Pose


@frozen_dataclass
class Exit:
    """How a part has left the cell.

    Attributes:
        pose: X_WO at which it left.
        sink: name of the sink that took it; empty for none.
        device: name of the conveyor off whose end it ran; empty where a gripper brought it.
    """

    pose: Pose
    sink: str = ""
    device: str = ""


@frozen_dataclass
class Placements:
    """Where every part is.

    Attributes:
        seats: of each part that is there, by name.
        queued: names of parts still waiting in their supply.
        left: how each part has left the cell, by name, in order.
    """

    seats: Mapping[str, Seat] = field(default_factory=lambda: MappingProxyType({}))
    queued: frozenset[str] = frozenset()
    left: Mapping[str, Exit] = field(default_factory=lambda: MappingProxyType({}))

    def held(self, hands: Collection[str]) -> str:
        """Return the name of the part that one of some tools holds, empty for none."""
        return next((name for name, seat in self.seats.items() if seat.parent in hands), "")

    def carried(self, hands: Collection[str]) -> dict[str, Pose]:
        """Return the poses X_MO of the part that some tools hold and of all bodies on it, by name."""
        return {name: seat.pose for name, seat in self.seats.items() if seat.rides in hands}

    def family(self, *names: str) -> tuple[str, ...]:
        """Return the names of parts and of all parts that hang on them, directly or not, each one once.

        Each part is followed by the parts attached to it.
        """
        if {seat.parent for seat in self.seats.values()}.isdisjoint(names):
            return tuple(dict.fromkeys(names))
        children: dict[str, list[str]] = {}
        for name, seat in self.seats.items():
            children.setdefault(seat.parent, []).append(name)
        found: dict[str, None] = {}
        for name in names:
            own = [] if name in found else [name]
            for one in own:
                found[one] = None
                own += [child for child in children.get(one, ()) if child not in found]
        return tuple(found)

    def with_seats(self, seats: Mapping[str, Seat]) -> "Placements":
        """Return these placements with other seats for some parts."""
        return Placements(MappingProxyType({**self.seats, **seats}), self.queued, self.left)

    def without(self, gone: Mapping[str, Exit]) -> "Placements":
        """Return these placements after some parts have left the cell."""
        seats = {name: seat for name, seat in self.seats.items() if name not in gone}
        return Placements(MappingProxyType(seats), self.queued, MappingProxyType({**self.left, **gone}))


def at_start(tree: BodyTree, placements: Placements, objects: Mapping[str, Seat]) -> Iterator[Placement]:
    """Yield where every body of a cell is at time 0, in the order of its tree.

    Args:
        tree: the bodies.
        placements: of the parts.
        objects: parent of each object.
    """
    for body in tree.bodies:
        if body.name in placements.seats:
            yield _placement(0.0, body.name, placements, objects)
        else:
            yield Placement(0.0, body.name, body.parent, body.X_PB, body.visible)


def changes(
    time: float, before: Placements, after: Placements, objects: Mapping[str, Seat]
) -> Iterator[Placement]:
    """Yield the placement of each part that hangs on something else now, has come or has left.

    Args:
        time: when that came to be [s].
        before: where the parts were.
        after: where they are.
        objects: parent of each object.
    """
    for name, gone in after.left.items():
        if name not in before.left:
            yield Placement(time, name, WORLD, gone.pose, visible=False)
    for name, seat in after.seats.items():
        known = before.seats.get(name)
        if known is not seat and (known is None or known.parent != seat.parent):
            yield _placement(time, name, after, objects)


def _placement(time: float, name: str, placements: Placements, objects: Mapping[str, Seat]) -> Placement:
    seat = placements.seats[name]
    if seat.parent == seat.rides:
        return Placement(time, name, seat.parent, seat.pose)
    under = placements.seats[seat.parent] if seat.parent in placements.seats else objects[seat.parent]
    return Placement(time, name, seat.parent, under.pose.inverse() @ seat.pose)
