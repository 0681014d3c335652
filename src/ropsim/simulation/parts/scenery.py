"""Fixed data of a cell while parts are moved: made once per cell."""

from collections.abc import Mapping
from dataclasses import field
from functools import lru_cache

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.kinematics import NO_BLOCKS, Blocks, Ground, ground_of, shape_blocks
from ropsim.model import (
    WORLD,
    BodyKind,
    BodyTree,
    Cell,
    Part,
    Shape,
    bearers,
    body_tree,
    carrier,
    link_name,
)
from ropsim.simulation.parts.placements import Seat
from ropsim.spatial import Pose


@frozen_dataclass
class Scenery:
    """Data that a run needs repeatedly.

    Attributes:
        tree: the bodies at time 0.
        parts: of the cell, by name.
        ground: bodies at rest.
        objects: parent and carrier of each object and each base of a device.
        belts: the body with which parts on a belt move, by the name of the base that carries them.
        surfaces: shapes moved by devices and external axes, by the name of the body or object.
        tools: names of the bodies of all tools.
        largest: greatest extent of a part [m].
    """

    tree: BodyTree
    parts: Mapping[str, Part]
    ground: Ground
    objects: Mapping[str, Seat]
    belts: Mapping[str, str]
    surfaces: Mapping[str, tuple[Shape, ...]]
    tools: frozenset[str]
    largest: float

    def moving(self, carriers: Mapping[str, Pose]) -> Blocks:
        """Return the solids that devices and external axes move where they are now.

        Args:
            carriers: X_WC of the bodies that these move, by name.
        """
        if not self.surfaces:
            return NO_BLOCKS
        poses = {}
        for name in self.surfaces:
            seat = self.objects.get(name)
            poses[name] = carriers[name] if seat is None else carriers[seat.rides] @ seat.pose
        return shape_blocks(self.surfaces, poses)


@frozen_dataclass
class _Described:
    """A cell that counts as another one with the same fingerprint."""

    content: str
    cell: Cell = field(compare=False)


def scenery_of(cell: Cell, content: str) -> Scenery:
    """Return the fixed data of a cell, shared by cells of the same content.

    Args:
        cell: it.
        content: `Cell.content` of it.
    """
    return _scenery(_Described(content, cell))


@lru_cache(maxsize=4)
def _scenery(described: _Described) -> Scenery:
    cell = described.cell
    tree = body_tree(cell)
    bodies = tree.by_name()
    largest = max((float(np.linalg.norm(part.size)) for part in cell.parts), default=0.0)
    ground = ground_of(tree)
    objects = {name: Seat(bodies[name].parent, WORLD, pose) for name, pose in ground.poses.items()}
    surfaces = {name: bodies[name].shapes for name in bearers(tree) if bodies[name].mover}
    for name in tree.names(BodyKind.OBJECT):
        rides = carrier(bodies, {}, name)
        if rides != WORLD:
            surfaces[name] = bodies[name].shapes
            objects[name] = Seat(bodies[name].parent, rides, _within(tree, name, rides))
    tools = frozenset(tree.names(BodyKind.TOOL))
    return Scenery(
        tree,
        {part.name: part for part in cell.parts},
        ground,
        objects,
        _belts(cell),
        surfaces,
        tools,
        largest,
    )


def _belts(cell: Cell) -> dict[str, str]:
    """Return the carrier of the parts on each conveyor: its belt, which is drawn at rest."""
    devices = cell.devices.values()
    return {link_name(0, one.name): link_name(1, one.name) for one in devices if one.is_belt}


def _within(tree: BodyTree, name: str, rides: str) -> Pose:
    """Return the pose of an object in the frame of the body that moves it."""
    bodies, pose = tree.by_name(), Pose()
    while name != rides:
        pose = bodies[name].X_PB @ pose
        name = bodies[name].parent
    return pose
