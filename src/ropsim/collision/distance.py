"""Distance between the bodies of a cell at one configuration."""

from ropsim.collision.collisions import Collisions, Coordinates
from ropsim.collision.separation import Separation
from ropsim.collision.solids import NO_MESHES, MeshPoints
from ropsim.model import Cell


def distance(cell: Cell, q: Coordinates, meshes: MeshPoints = NO_MESHES) -> Separation:
    """Return the smallest distance between bodies of a cell, the two bodies and their nearest points in W.

    For many configurations make one `Collisions`.

    Args:
        cell: with its bodies as at the start.
        q: joint coordinates of the first station [rad | m], shape (n,), or of mechanisms by their names; all
            others stand as at the start.
        meshes: points of meshes [m], shape (k, 3) each; one without them is not checked.
    """
    return Collisions(cell, meshes).separation(q)


def in_collision(cell: Cell, q: Coordinates, meshes: MeshPoints = NO_MESHES) -> bool:
    """Return whether bodies of a cell are in each other by more than a micrometre; touching is none.

    Args:
        cell: as with `distance`.
        q: coordinates of the joints.
        meshes: points of meshes.
    """
    return bool(Collisions(cell, meshes).meetings(q))
