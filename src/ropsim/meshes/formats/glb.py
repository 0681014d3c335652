"""GLB files (glTF 2.0, binary): triangles of the scene with plain colours; textures are ignored."""

import struct
from dataclasses import dataclass, field

import numpy as np

from ropsim.meshes.formats.gltf_accessor import Accessors, at
from ropsim.meshes.formats.gltf_document import Document, Primitive, read_document
from ropsim.meshes.formats.gltf_nodes import placed_meshes
from ropsim.meshes.formats.soup import (
    NO_TRIANGLES,
    UNCOLOURED,
    Bytes,
    Floats,
    Indices,
    Soup,
    check_count,
    damaged,
)

_HEADER, _CHUNK = struct.Struct("<4sII"), struct.Struct("<I4s")
_TRIANGLES, _STRIP, _FAN = 4, 5, 6  # modes of a primitive


def read_glb(content: bytes) -> Soup:
    """Return the triangles of a GLB file in its scene.

    Raises:
        MeshFileError: it is damaged, or keeps triangles outside of itself.
    """
    text, body = _chunks(content)
    document = read_document(text)
    meshes = _Meshes(document, Accessors(document, body))
    total, placed = 0, []
    for number, X_WM in placed_meshes(document):
        for soup in meshes.chunks(number):
            total += len(soup.corners)
            check_count(total)
            placed.append(Soup(_moved(soup.corners, X_WM), _turned(soup.colours, X_WM)))
    if not total:
        raise damaged(NO_TRIANGLES)
    return Soup(np.concatenate([soup.corners for soup in placed]), _joined([soup for soup in placed]))


def _chunks(content: bytes) -> tuple[bytes, bytes]:
    """Return the JSON part and the binary part; parts of other sorts are passed over."""
    found: dict[bytes, bytes] = {}
    if len(content) < _HEADER.size:
        raise damaged("cannot be read as GLB")
    magic, version, length = _HEADER.unpack_from(content)
    if magic != b"glTF" or version != 2:
        raise damaged("cannot be read as GLB")
    if length > len(content):
        raise damaged(f"is cut short: {length:,} bytes are promised, {len(content):,} are there")
    place = _HEADER.size
    while place + _CHUNK.size <= length and len(found) < 2:
        size, sort = _CHUNK.unpack_from(content, place)
        place += _CHUNK.size
        if size > length - place:
            raise damaged(f"is cut short: {size:,} bytes are promised, {length - place:,} are there")
        if sort in {b"JSON", b"BIN\0"}:
            found.setdefault(sort, content[place : place + size])
        place += size + -size % 4
    if b"JSON" not in found:
        raise damaged("cannot be read as GLB")
    return found[b"JSON"], found.get(b"BIN\0", b"")


@dataclass(slots=True)
class _Meshes:
    """The meshes of a document, each read once."""

    document: Document
    accessors: Accessors
    read: dict[int, list[Soup]] = field(default_factory=dict)

    def chunks(self, number: int) -> list[Soup]:
        """Return the primitives of a mesh that have triangles, in its own frame."""
        if number not in self.read:
            mesh = at(self.document.meshes, number, "meshes")
            chunks = [self._chunk(one) for one in mesh.primitives if one.mode in {_TRIANGLES, _STRIP, _FAN}]
            self.read[number] = [soup for soup in chunks if len(soup.corners)]
        return self.read[number]

    def _chunk(self, primitive: Primitive) -> Soup:
        positions = primitive.attributes.get("POSITION")
        if positions is None:
            return Soup(np.empty((0, 3, 3)))
        places = self._places(primitive, positions)
        return Soup(self.accessors.vectors(positions, (3,), places), self._colours(primitive, places))

    def _places(self, primitive: Primitive, positions: int) -> Indices:
        """Return the places of the corners of all triangles, shape (m, 3)."""
        if primitive.indices is None:
            corners = np.arange(self.accessors.count(positions))
        else:
            corners = self.accessors.places(primitive.indices)
        check_count(len(corners) // 3 if primitive.mode == _TRIANGLES else len(corners))
        if primitive.mode == _TRIANGLES:
            return corners[: len(corners) // 3 * 3].reshape(-1, 3)
        first = np.arange(max(len(corners) - 2, 0))
        if primitive.mode == _FAN:
            return corners[np.column_stack([np.zeros_like(first), first + 1, first + 2])]
        odd = first % 2  # every second triangle of a strip is the other way round
        return corners[np.column_stack([first, first + 1 + odd, first + 2 - odd])]

    def _colours(self, primitive: Primitive, places: Indices) -> Bytes | None:
        """Return linear colours of corners: of the points times that of the material; None without both."""
        factor = self._factor(primitive)
        number = primitive.attributes.get("COLOR_0")
        if number is None:
            return None if factor is None else np.broadcast_to(_bytes(factor), (*places.shape, 4))
        rgba = self.accessors.vectors(number, (3, 4), places)
        if rgba.shape[-1] == 3:
            rgba = np.concatenate([rgba, np.ones((*places.shape, 1))], axis=-1)
        return _bytes(rgba if factor is None else rgba * factor)

    def _factor(self, primitive: Primitive) -> Floats | None:
        if primitive.material is None:
            return None
        paint = at(self.document.materials, primitive.material, "materials").pbr_metallic_roughness
        if paint.base_color_factor is None:
            return None if paint.base_color_texture is not None else np.ones(4)
        return np.array(paint.base_color_factor)


def _bytes(rgba: Floats) -> Bytes:
    return np.round(255.0 * np.clip(np.nan_to_num(rgba), 0.0, 1.0)).astype(np.uint8)


def _moved(corners: Floats, X_WM: Floats) -> Floats:
    moved: Floats = corners @ X_WM[:3, :3].T + X_WM[:3, 3]
    return moved[:, ::-1] if _mirrors(X_WM) else moved


def _turned(colours: Bytes | None, X_WM: Floats) -> Bytes | None:
    return colours[:, ::-1] if colours is not None and _mirrors(X_WM) else colours


def _mirrors(X_WM: Floats) -> bool:
    return float(np.linalg.det(X_WM[:3, :3])) < 0.0


def _joined(placed: list[Soup]) -> Bytes | None:
    if all(soup.colours is None for soup in placed):
        return None
    plain = np.array(UNCOLOURED, dtype=np.uint8)
    return np.concatenate(
        [
            np.broadcast_to(plain, (*soup.corners.shape[:2], 4)) if soup.colours is None else soup.colours
            for soup in placed
        ]
    )
