"""Numbers out of the binary part of a GLB file, with every size checked before memory is taken."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TypeVar

import numpy as np
import numpy.typing as npt

from ropsim.meshes.diagnostics import MESH_OUTSIDE
from ropsim.meshes.formats.gltf_document import Accessor, Document
from ropsim.meshes.formats.soup import (
    MOST_TRIANGLES,
    Floats,
    Indices,
    MeshFileError,
    check_places,
    check_points,
    damaged,
)

_COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}

Column = npt.NDArray[np.generic]
Row = TypeVar("Row")


@dataclass(slots=True)
class Accessors:
    """The accessors of a document; read ones are kept, since many primitives share them.

    Attributes:
        document: JSON part.
        body: binary part.
        read: arrays by the number of their accessor.
        rows: read so far, of all accessors; many of them may lie upon the same bytes.
    """

    document: Document
    body: bytes
    read: dict[int, Column] = field(default_factory=dict)
    rows: int = 0

    def count(self, number: int) -> int:
        """Return how many rows there are."""
        return len(self._array(number))

    def vectors(self, number: int, widths: tuple[int, ...], places: Indices) -> Floats:
        """Return vectors at places; whole numbers as fractions of the largest where they are marked so.

        Args:
            number: of the accessor.
            widths: numbers that a vector may have.
            places: of the vectors, any shape (…).

        Returns:
            Shape (…, width).

        Raises:
            MeshFileError: there are none of these widths, or none at some place.
        """
        found = self._array(number)
        if found.shape[1] not in widths:
            raise damaged(f"has vectors of {found.shape[1]} numbers where {widths[0]} are needed")
        check_places(places, len(found))
        values: Floats = found[places].astype(np.float64)
        if found.dtype.kind == "f" or not self.document.accessors[number].normalized:
            return values
        return values / float(np.iinfo(found.dtype.name).max)

    def places(self, number: int) -> Indices:
        """Return whole numbers, shape (k,).

        Raises:
            MeshFileError: there are none.
        """
        found = self._array(number)
        if found.shape[1] != 1 or found.dtype.kind != "u":
            raise damaged("has faces whose corners are no numbers of points")
        return found[:, 0].astype(np.int64)

    def _array(self, number: int) -> Column:
        if number not in self.read:
            self.read[number] = self._fresh(at(self.document.accessors, number, "numbers"))
        return self.read[number]

    def _fresh(self, accessor: Accessor) -> Column:
        self.rows += accessor.count
        check_points(self.rows, 8 * MOST_TRIANGLES, "points, normals, colours and corners")
        sort, width = _COMPONENTS.get(accessor.component_type), _WIDTHS.get(accessor.type)
        if sort is None or width is None or accessor.sparse is not None or accessor.buffer_view is None:
            raise damaged("has numbers of a form that is not read", "export it without compression of meshes")
        view = at(self.document.buffer_views, accessor.buffer_view, "bytes")
        self._check_buffer(view.buffer)
        kind = np.dtype((sort, (width,)))
        stride = view.byte_stride or kind.itemsize
        end = accessor.byte_offset + stride * (accessor.count - 1) + kind.itemsize if accessor.count else 0
        whole = view.byte_offset + view.byte_length <= len(self.body)
        if stride < kind.itemsize or not whole or end > view.byte_length:
            raise damaged("is cut short: its numbers lie outside of its bytes")
        if not accessor.count:
            return np.empty((0, width), sort)
        start = view.byte_offset + accessor.byte_offset
        part = np.dtype(sort).itemsize
        return np.ndarray((accessor.count, width), sort, self.body, start, (stride, part))

    def _check_buffer(self, number: int) -> None:
        buffer = at(self.document.buffers, number, "bytes")
        if buffer.uri is not None:
            found = "keeps its triangles in another file, which is not opened"
            raise MeshFileError(MESH_OUTSIDE, found, "export it as one file, with everything in the GLB")
        if number:
            raise damaged("has triangles in bytes that it does not hold")


def at(rows: Sequence[Row], number: int, noun: str) -> Row:
    """Return a row that another part of the document names by its number.

    Raises:
        MeshFileError: there is none.
    """
    if number >= len(rows):
        raise damaged(f"refers to {noun} that it does not hold")
    return rows[number]
