"""What stays as it is in a cell while parts are moved: made once per run."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ropsim.kinematics import Ground, ground_of
from ropsim.model import BodyTree, Cell, Part, body_tree


@dataclass(frozen=True, slots=True)
class Scenery:
    """What a run looks up again and again.

    Attributes:
        tree: the bodies at time 0.
        parts: of the cell, by name.
        ground: the fixed objects.
        largest: greatest extent of a part [m].
    """

    tree: BodyTree
    parts: Mapping[str, Part]
    ground: Ground
    largest: float


def scenery_of(cell: Cell) -> Scenery:
    """Return what stays as it is in a cell."""
    tree = body_tree(cell)
    largest = max((float(np.linalg.norm(part.size)) for part in cell.parts), default=0.0)
    return Scenery(tree, {part.name: part for part in cell.parts}, ground_of(cell, tree), largest)
