"""What stands still around the parts of a cell, and which parts lie on nothing."""

from collections.abc import Mapping
from dataclasses import replace

from ropsim.kinematics.blocks import Blocks, part_blocks, shape_blocks, stacked
from ropsim.kinematics.body_poses import body_poses
from ropsim.kinematics.supports import standings
from ropsim.model import BodyKind, BodyTree, Cell, Mesh, Part, body_tree
from ropsim.spatial import Pose, record


@record
class Ground:
    """The fixed objects of a cell.

    Attributes:
        poses: X_WB by name.
        blocks: of their shapes.
        known: whether it is known what carries the parts: there are objects, and none is drawn by a mesh.
    """

    poses: Mapping[str, Pose]
    blocks: Blocks
    known: bool


def ground_of(cell: Cell, tree: BodyTree) -> Ground:
    """Return what stands still in a cell.

    Args:
        cell: with its objects.
        tree: its bodies.
    """
    matrices = body_poses(tree, {}, tree.names(BodyKind.OBJECT))
    poses = {name: Pose.from_matrix(rows[0]) for name, rows in matrices.items()}
    blocks = shape_blocks({thing.name: thing.shapes for thing in cell.objects}, poses)
    solids = [shape.solid for thing in cell.objects for shape in thing.shapes]
    return Ground(poses, blocks, bool(solids) and not any(isinstance(solid, Mesh) for solid in solids))


def parts_in_the_air(cell: Cell) -> tuple[Part, ...]:
    """Return the parts that lie on nothing at time 0, of a supply the first one.

    None where it is not known what stands around.
    """
    ground = ground_of(cell, body_tree(replace(cell, parts=())))
    there = [part for part in cell.parts if part.turn == 0]
    if not ground.known:
        return ()
    blocks = part_blocks((part, part.X_WO) for part in there)
    stand = standings(blocks, stacked([ground.blocks, blocks]), cell.supports.gap)
    return tuple(part for part, one in zip(there, stand, strict=True) if one.on is None)
