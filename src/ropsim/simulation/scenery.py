"""What stays as it is in a cell while parts are moved: made once per run."""

from collections.abc import Mapping
from dataclasses import dataclass

from ropsim.kinematics import body_poses
from ropsim.model import BodyKind, BodyTree, Cell, Part, body_tree
from ropsim.spatial import Pose


@dataclass(frozen=True, slots=True)
class Scenery:
    """What a run looks up again and again.

    Attributes:
        tree: the bodies at time 0.
        parts: of the cell, by name.
        fixed: poses X_WB of the objects, by name.
    """

    tree: BodyTree
    parts: Mapping[str, Part]
    fixed: Mapping[str, Pose]


def scenery_of(cell: Cell) -> Scenery:
    """Return what stays as it is in a cell."""
    tree = body_tree(cell)
    poses = body_poses(tree, {}, tree.names(BodyKind.OBJECT))
    fixed = {name: Pose.from_matrix(matrices[0]) for name, matrices in poses.items()}
    return Scenery(tree, {part.name: part for part in cell.parts}, fixed)
