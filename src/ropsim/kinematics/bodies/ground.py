"""Fixed bodies around the parts of a cell, and supports of the parts at the start of a run."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from ropsim.kinematics.bodies.blocks import Blocks, part_blocks, shape_blocks, stacked
from ropsim.kinematics.bodies.body_poses import body_poses
from ropsim.kinematics.bodies.supports import Standing, standings
from ropsim.model import WORLD, BodyTree, Cell, Mesh, Part, bearers, body_tree, carriages, carrier, start_of
from ropsim.spatial import Array, Pose, record


@record
class Ground:
    """Fixed bodies of a cell: fixed objects, and the bases of devices.

    Attributes:
        poses: X_WB by name.
        blocks: of their shapes.
        known: whether the supports of parts are known: there are bodies other than the carriages of arms,
            none of them drawn by a mesh.
    """

    poses: Mapping[str, Pose]
    blocks: Blocks
    known: bool


def ground_of(tree: BodyTree) -> Ground:
    """Return the fixed bodies of a cell.

    Args:
        tree: the bodies of the cell.
    """
    bodies = tree.by_name()
    solid = bearers(tree)
    still = [name for name in solid if carrier(bodies, {}, name) == WORLD]
    poses = _poses(tree, {}, still)
    blocks = shape_blocks({name: bodies[name].shapes for name in still}, poses)
    alone = carriages(tree)
    solids = [shape.solid for name in solid if name not in alone for shape in bodies[name].shapes]
    return Ground(poses, blocks, bool(solids) and not any(isinstance(one, Mesh) for one in solids))


def standings_at_start(cell: Cell) -> tuple[tuple[Part, Standing], ...]:
    """Return how each part stands at time 0, of a supply the first one.

    None if the surroundings are unknown.
    """
    there = [part for part in cell.parts if part.turn == 0]
    bearing = bearing_at_start(cell)
    if bearing is None:
        return ()
    blocks = part_blocks((part, part.X_WO) for part in there)
    stand = standings(blocks, stacked([bearing, blocks]), cell.supports.gap)
    return tuple(zip(there, stand, strict=True))


def bearing_at_start(cell: Cell) -> Blocks | None:
    """Return the supports of parts at time 0, except parts; None if the surroundings are unknown."""
    tree = body_tree(replace(cell, parts=()))
    ground = ground_of(tree)
    if not ground.known:
        return None
    bodies = tree.by_name()
    moved = [name for name in bearers(tree) if name not in ground.poses]
    surfaces = {name: bodies[name].shapes for name in moved}
    moving = shape_blocks(surfaces, _poses(tree, start_of(cell), moved))
    return stacked([ground.blocks, moving])


def _poses(tree: BodyTree, q: Mapping[str, Array], names: Iterable[str]) -> dict[str, Pose]:
    """Return X_WB of some bodies by name.

    Args:
        tree: the bodies.
        q: joint coordinates [rad | m], shape (n,), by mechanism.
        names: of which bodies.
    """
    matrices = body_poses(tree, {name: values[None] for name, values in q.items()}, names)
    return {name: Pose.from_matrix(rows[0]) for name, rows in matrices.items()}
