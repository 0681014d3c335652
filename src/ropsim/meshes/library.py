"""The meshes of a cell: files of the project read once, as GLB bytes under their own hash."""

import hashlib
import stat
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from ropsim.core import (
    OUTSIDE_PROJECT,
    Diagnostic,
    LeadsOutError,
    Span,
    did_you_mean,
    frozen_dataclass,
    read_bytes,
    stated_inside,
)
from ropsim.meshes.diagnostics import MANY_TRIANGLES, MESH_MISSING, MESH_TOO_LARGE
from ropsim.meshes.formats import MeshFileError
from ropsim.meshes.glb import glb_bytes
from ropsim.meshes.reading import read_mesh
from ropsim.model import LARGEST_MESH, Cell, Mesh, body_tree

if TYPE_CHECKING:
    from ropsim.views import MeshSource

TRIANGLE_BUDGET = 200_000
"""Triangles of all meshes of a cell beyond which a warning is due."""


@frozen_dataclass
class MeshLibrary:
    """The meshes of a cell as the page needs them.

    Attributes:
        addresses: where the page finds each mesh, or why it cannot be had; for `views.scene`.
        contents: GLB bytes by address.
        diagnostics: findings, at the place passed for the mesh.
        triangles: number of triangles by mesh.
        sources: hash of the file that each mesh was read from, by mesh.
    """

    addresses: Mapping[Mesh, "MeshSource"] = field(default_factory=dict)
    contents: Mapping[str, bytes] = field(default_factory=dict)
    diagnostics: tuple[Diagnostic, ...] = ()
    triangles: Mapping[Mesh, int] = field(default_factory=dict)
    sources: Mapping[Mesh, str] = field(default_factory=dict)


NOTHING_KNOWN = MeshLibrary()

PlaceOf: TypeAlias = Callable[[str], Span | None]
"""Where a cell file names a mesh file, None where that is not known."""


def _nowhere(_: str) -> None:
    return None


def load_meshes(
    folder: Path, cell: Cell, place_of: PlaceOf = _nowhere, known: MeshLibrary = NOTHING_KNOWN
) -> MeshLibrary:
    """Return the mesh files of a cell; an unreadable file is a finding, never an exception.

    The bytes are untrusted and large: call this in a process that may be lost.

    Args:
        folder: of the project; nothing outside it is read.
        cell: whose shapes are searched.
        place_of: returns where the cell file names a mesh file, for the places of findings.
        known: an earlier library; files that have not changed since are not converted again.
    """
    made = _Making(folder.resolve(), place_of, known)
    for mesh in dict.fromkeys(cell_meshes(cell)):
        made.add(mesh)
    total = sum(made.triangles.values())
    if total > TRIANGLE_BUDGET:
        largest = max(made.triangles, key=lambda mesh: made.triangles[mesh])
        message = (
            f"the meshes of the cell have {total:,} triangles, views stay smooth up to {TRIANGLE_BUDGET:,}"
        )
        hint = f"`{largest.file}` has {made.triangles[largest]:,}: export it with a coarser tolerance"
        made.diagnostics.append(MANY_TRIANGLES.at(made.place_of(largest.file), message, hint=hint))
    return MeshLibrary(made.addresses, made.contents, tuple(made.diagnostics), made.triangles, made.sources)


@dataclass(slots=True)
class _Making:
    """A library that is being filled."""

    folder: Path
    place_of: PlaceOf
    known: MeshLibrary
    addresses: dict[Mesh, "MeshSource"] = field(default_factory=dict)
    contents: dict[str, bytes] = field(default_factory=dict)
    diagnostics: list[Diagnostic] = field(default_factory=list)
    triangles: dict[Mesh, int] = field(default_factory=dict)
    sources: dict[Mesh, str] = field(default_factory=dict)

    def add(self, mesh: Mesh) -> None:
        """Read one mesh; note it, or its error."""
        from ropsim.views import MeshSource

        try:
            content = mesh_content(self.folder, mesh.file)
            source = hashlib.sha256(content).hexdigest()
            if self.known.sources.get(mesh) == source:
                self._keep(mesh, self.known.triangles[mesh], self.known.addresses[mesh])
            else:
                self._convert(mesh, content)
            self.sources[mesh] = source
        except MeshFileError as error:
            self.addresses[mesh] = MeshSource("", error.found)
            message = f"the mesh `{mesh.file}` {error.found}"
            self.diagnostics.append(error.kind.at(self.place_of(mesh.file), message, hint=error.hint))

    def _keep(self, mesh: Mesh, triangles: int, source: "MeshSource") -> None:
        self.triangles[mesh] = triangles
        self.addresses[mesh] = source
        self.contents[source.address] = self.known.contents[source.address]

    def _convert(self, mesh: Mesh, content: bytes) -> None:
        from ropsim.views import MeshSource

        triangles = read_mesh(content, mesh)
        glb = glb_bytes(triangles)
        address = hashlib.sha256(glb).hexdigest()
        low, high = (
            tuple(edge.tolist()) for edge in (triangles.points.min(axis=0), triangles.points.max(axis=0))
        )
        self.triangles[mesh] = len(triangles.faces)
        self.addresses[mesh] = MeshSource(address, "", tuple(low), tuple(high))
        self.contents[address] = glb


def cell_meshes(cell: Cell) -> Iterator[Mesh]:
    """Return the meshes of the shapes of a cell, with repetitions."""
    shapes = (shape for body in body_tree(cell).bodies for shape in body.shapes)
    return (shape.solid for shape in shapes if isinstance(shape.solid, Mesh))


def mesh_content(folder: Path, file: str) -> bytes:
    """Return the bytes of a file in the project folder.

    Raises:
        MeshFileError: it is not there, leads out of the folder, or is too large.
    """
    path = folder / file
    try:
        place = stated_inside(folder, file)
        facts = place.stat()
        if not stat.S_ISREG(facts.st_mode):
            raise MeshFileError(MESH_MISSING, "is no ordinary file", "give the path of a file")
        size = facts.st_size
        if size > LARGEST_MESH:
            found = f"has {size / 1e6:.0f} MB, at most {LARGEST_MESH / 1e6:.0f} MB are read"
            raise MeshFileError(MESH_TOO_LARGE, found, "export it with a coarser tolerance")
        return read_bytes(place, LARGEST_MESH)
    except LeadsOutError as error:
        raise MeshFileError(OUTSIDE_PROJECT, str(error.strerror), "copy the file into the project") from error
    except FileNotFoundError:
        raise MeshFileError(MESH_MISSING, "is not in the project folder", _near(path)) from None
    except (OSError, RuntimeError, ValueError) as error:  # permissions, links that go round, odd characters
        reason = error.strerror if isinstance(error, OSError) else None
        raise MeshFileError(MESH_MISSING, f"cannot be opened: {reason or error}") from error


def _near(path: Path) -> str:
    try:
        return did_you_mean(path.name, [entry.name for entry in path.parent.iterdir()])
    except OSError:
        return "paths count from the folder of `cell.toml`"
