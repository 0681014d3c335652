"""Bytes of a mesh file to triangles."""

from collections.abc import Callable, Mapping
from pathlib import PurePosixPath

import numpy as np

from ropsim.meshes.diagnostics import MESH_DAMAGED, MESH_EXTENT
from ropsim.meshes.formats import (
    NO_TRIANGLES,
    MeshFileError,
    Soup,
    read_obj,
    read_ply,
    read_stl,
)
from ropsim.meshes.triangles import Colours, Triangles, shaded
from ropsim.model import Mesh

MESH_ENDINGS = {".stl": 1e-3, ".obj": 1e-3, ".ply": 1e-3, ".glb": 1.0}
"""What is read, with the metres per unit that hold where the cell file gives no `scale`."""

_READERS: Mapping[str, Callable[[bytes], Soup]] = {".stl": read_stl, ".obj": read_obj, ".ply": read_ply}
_LARGEST, _SMALLEST = 1e3, 1e-5  # [m]
_GAMMA = 2.2


def mesh_ending(file: str) -> str:
    """Return the ending of a path in small letters, such as `.stl`."""
    return PurePosixPath(file).suffix.lower()


def read_mesh(content: bytes, mesh: Mesh) -> Triangles:
    """Return the triangles of a mesh file in metres.

    Args:
        content: of the file; any bytes are allowed.
        mesh: name, whose ending tells the format, and scale.

    Raises:
        MeshFileError: damaged, without triangles, too many of them, or of an impossible size.
    """
    ending = mesh_ending(mesh.file)
    with np.errstate(all="ignore"):  # wild numbers in the file are found below
        soup = _soup(content, ending)
        points = soup.corners.reshape(-1, 3) * mesh.scale
    if not len(soup.corners):
        raise MeshFileError(MESH_DAMAGED, NO_TRIANGLES)
    if not np.isfinite(soup.corners).all():
        raise MeshFileError(MESH_DAMAGED, "holds coordinates that are no numbers")
    with np.errstate(all="ignore"):
        size, farthest = float(np.ptp(points, axis=0).max()), float(np.abs(points).max())
    if not (size >= _SMALLEST and farthest <= _LARGEST):
        found = f"is {size:.3g} m long with the scale {mesh.scale:g}"
        raise MeshFileError(MESH_EXTENT, found, "give `scale`, metres per unit of the file")
    linear = ending == ".glb"  # all but glTF give colours as screens show them
    triangles = shaded(points.reshape(-1, 3, 3), soup.colours if linear else _linear(soup.colours))
    if not len(triangles.faces):
        raise MeshFileError(MESH_DAMAGED, NO_TRIANGLES)
    return triangles


def _soup(content: bytes, ending: str) -> Soup:
    if ending == ".glb":
        from ropsim.meshes.formats.glb import read_glb

        return read_glb(content)
    return _READERS[ending](content)


def _linear(colours: Colours | None) -> Colours | None:
    if colours is None:
        return None
    found = np.array(colours)
    found[..., :3] = np.round(255.0 * (found[..., :3] / 255.0) ** _GAMMA)
    return found
