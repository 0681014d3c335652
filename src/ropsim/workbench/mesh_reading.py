"""Bytes of a mesh file to triangles."""

import io
from collections.abc import Mapping
from pathlib import PurePosixPath
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ropsim.core import Kind
from ropsim.model import Mesh
from ropsim.workbench.mesh_diagnostics import MESH_DAMAGED, MESH_EXTENT, MESH_TOO_LARGE
from ropsim.workbench.triangles import Colours, Triangles, shaded

if TYPE_CHECKING:
    import trimesh

MESH_ENDINGS = {".stl": 1e-3, ".obj": 1e-3, ".ply": 1e-3, ".glb": 1.0}
"""What is read, with the metres per unit that hold where the cell file gives no `scale`."""

MOST_TRIANGLES = 2_000_000
_LARGEST, _SMALLEST = 1e3, 1e-5  # [m]
_NO_TRIANGLES = "holds no triangles"
_OPTIONS: Mapping[str, Mapping[str, Any]] = {".obj": {"skip_materials": True}}
_UNCOLOURED = (150, 156, 163, 255)
_GAMMA = 2.2

Soup = tuple[npt.NDArray[np.float64], Colours | None]


class MeshFileError(Exception):
    """A mesh file that cannot be drawn: its kind, what was found, what to do next."""

    def __init__(self, kind: Kind, found: str, hint: str = "") -> None:
        super().__init__(found)
        self.kind = kind
        self.found = found
        self.hint = hint


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
    try:
        soup, colours = _soup(content, mesh_ending(mesh.file))
    except MeshFileError:
        raise
    except Exception as error:
        # The bytes are a stranger's and the readers behind `trimesh` do not promise what they raise on them
        # (IndexError, struct.error, RecursionError, MemoryError, ...): each means that the file is damaged.
        found = f"cannot be read as {mesh_ending(mesh.file)[1:].upper()}"
        raise MeshFileError(MESH_DAMAGED, found, "export it again") from error
    with np.errstate(over="ignore"):
        points = soup.reshape(-1, 3) * mesh.scale
        size, farthest = float(np.ptp(points, axis=0).max()), float(np.abs(points).max())
    if not (size >= _SMALLEST and farthest <= _LARGEST):
        found = f"is {size:.3g} m long with the scale {mesh.scale:g}"
        raise MeshFileError(MESH_EXTENT, found, "give `scale`, metres per unit of the file")
    triangles = shaded(points.reshape(-1, 3, 3), colours)
    if not len(triangles.faces):
        raise MeshFileError(MESH_DAMAGED, _NO_TRIANGLES)
    return triangles


def _soup(content: bytes, ending: str) -> Soup:
    """Return the corners of all triangles in units of the file, shape (m, 3, 3), and their colours."""
    import trimesh

    with np.errstate(all="ignore"):  # wild numbers in the file are found below
        scene = trimesh.load_scene(
            io.BytesIO(content), file_type=ending[1:], process=False, **_OPTIONS.get(ending, {})
        )
        pieces = _nodes(scene)
        count = sum(len(piece.faces) for _, piece in pieces)
        if not count:
            raise MeshFileError(MESH_DAMAGED, _NO_TRIANGLES)
        if count > MOST_TRIANGLES:
            found = f"has {count:,} triangles, at most {MOST_TRIANGLES:,} are drawn"
            raise MeshFileError(MESH_TOO_LARGE, found, "export it with a coarser tolerance")
        soup = np.concatenate([_corners(X_WG, piece) for X_WG, piece in pieces])
    if not np.isfinite(soup).all():
        raise MeshFileError(MESH_DAMAGED, "holds coordinates that are no numbers")
    return soup, _colours([piece for _, piece in pieces], ending)


def _nodes(scene: "trimesh.Scene") -> list[tuple[Any, "trimesh.Trimesh"]]:
    """Return every mesh of a scene with its pose, shape (4, 4); clouds of points and curves are left out."""
    import trimesh

    placed = [scene.graph[node] for node in scene.graph.nodes_geometry]
    found = [(X_WG, scene.geometry[name]) for X_WG, name in placed]
    return [(X_WG, piece) for X_WG, piece in found if isinstance(piece, trimesh.Trimesh)]


def _corners(X_WG: npt.NDArray[np.float64], piece: "trimesh.Trimesh") -> npt.NDArray[np.float64]:
    points: npt.NDArray[np.float64] = np.asarray(piece.vertices) @ X_WG[:3, :3].T + X_WG[:3, 3]
    corners: npt.NDArray[np.float64] = points[np.asarray(piece.faces)]
    mirrored = float(np.linalg.det(X_WG[:3, :3])) < 0.0
    return corners[:, ::-1] if mirrored else corners


def _colours(pieces: "list[trimesh.Trimesh]", ending: str) -> Colours | None:
    """Return the colour of every corner, shape (m, 3, 4); None where no piece has colours of its own."""
    found = [_own_colours(piece) for piece in pieces]
    if all(colours is None for colours in found):
        return None
    plain = np.array(_UNCOLOURED, dtype=np.uint8)
    whole = np.concatenate(
        [
            np.broadcast_to(plain, (len(piece.faces), 3, 4)) if colours is None else colours
            for piece, colours in zip(pieces, found, strict=True)
        ]
    )
    if ending != ".glb":  # all but glTF give colours as screens show them
        whole[..., :3] = np.round(255.0 * (whole[..., :3] / 255.0) ** _GAMMA)
    return whole


def _own_colours(piece: "trimesh.Trimesh") -> Colours | None:
    faces = np.asarray(piece.faces)
    visual: Any = piece.visual  # its sort tells which attributes it has
    colours: Colours | None = None
    if visual.kind == "vertex":
        colours = np.array(visual.vertex_colors, dtype=np.uint8)[faces]
    elif visual.kind == "face":
        colours = np.repeat(np.array(visual.face_colors, dtype=np.uint8)[:, np.newaxis], 3, axis=1)
    elif visual.kind == "texture":
        colours = np.tile(np.array(visual.material.main_color, dtype=np.uint8), (len(faces), 3, 1))
    return colours
