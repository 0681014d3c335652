"""The points of the meshes of a cell, for who computes with them."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from ropsim.meshes.formats import MeshFileError
from ropsim.meshes.library import cell_meshes, mesh_content
from ropsim.meshes.reading import read_mesh
from ropsim.model import Cell, Mesh
from ropsim.spatial import Array


def mesh_points(folder: Path, cell: Cell) -> Mapping[Mesh, Array]:
    """Return the points of the mesh files of a cell [m], shape (k, 3); unreadable ones are missing.

    Args:
        folder: of the project; nothing outside it is read.
        cell: whose shapes are searched.
    """
    root = folder.resolve()
    found: dict[Mesh, Array] = {}
    for mesh in dict.fromkeys(cell_meshes(cell)):
        try:
            points = read_mesh(mesh_content(root, mesh.file), mesh).points
        except MeshFileError:
            continue
        found[mesh] = np.asarray(points, dtype=np.float64)
    return found
