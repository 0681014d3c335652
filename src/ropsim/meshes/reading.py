"""Bytes of a mesh file to triangles."""

from collections.abc import Callable, Mapping
from pathlib import PurePosixPath
from types import MappingProxyType
from typing import NamedTuple

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


class MeshFormat(NamedTuple):
    """A format of mesh files.

    Attributes:
        read: bytes of a file to corners of triangles.
        unit: metres per unit of the file if the cell file has no `scale`.
        colours: its colours to linear ones, as glTF has them.
    """

    read: Callable[[bytes], Soup]
    unit: float
    colours: Callable[[Colours], Colours]


def _read_glb(content: bytes) -> Soup:
    from ropsim.meshes.formats.glb import read_glb

    return read_glb(content)


def _read_collada(content: bytes) -> Soup:
    from ropsim.meshes.formats.collada import read_collada

    return read_collada(content)


def _as_they_are(colours: Colours) -> Colours:
    return colours


def _as_on_screens(colours: Colours) -> Colours:
    found = np.array(colours)
    found[..., :3] = np.round(255.0 * (found[..., :3] / 255.0) ** _GAMMA)
    return found


MESH_FORMATS: Mapping[str, MeshFormat] = MappingProxyType(
    {
        ".stl": MeshFormat(read_stl, 1e-3, _as_on_screens),
        ".obj": MeshFormat(read_obj, 1e-3, _as_on_screens),
        ".ply": MeshFormat(read_ply, 1e-3, _as_on_screens),
        ".glb": MeshFormat(_read_glb, 1.0, _as_they_are),
        ".dae": MeshFormat(_read_collada, 1.0, _as_on_screens),
    }
)
"""Readers by the ending of the file: each of `ropsim.model.MESH_ENDINGS`, in that order."""

_LARGEST, _SMALLEST = 1e3, 1e-5  # [m]
_GAMMA = 2.2


def mesh_ending(file: str) -> str:
    """Return the ending of a path in small letters, such as `.stl`."""
    return PurePosixPath(file).suffix.lower()


def read_mesh(content: bytes, mesh: Mesh) -> Triangles:
    """Return the triangles of a mesh file in metres.

    Args:
        content: of the file; any bytes are allowed.
        mesh: name, whose ending determines the format, and scale.

    Raises:
        MeshFileError: damaged, without triangles, with too many of them, or of an impossible size.
    """
    format_ = MESH_FORMATS[mesh_ending(mesh.file)]
    with np.errstate(all="ignore"):  # wild numbers in the file are found below
        soup = format_.read(content)
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
    colours = None if soup.colours is None else format_.colours(soup.colours)
    triangles = shaded(points.reshape(-1, 3, 3), colours)
    if not len(triangles.faces):
        raise MeshFileError(MESH_DAMAGED, NO_TRIANGLES)
    return triangles
