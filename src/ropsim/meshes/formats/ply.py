"""PLY files: points and faces of text and binary ones; textures in them are ignored."""

import numpy as np
import numpy.typing as npt

from ropsim.meshes.formats.ply_header import Encoding, Header, read_header
from ropsim.meshes.formats.ply_rows import Lists, Rows, read_rows
from ropsim.meshes.formats.ply_source import BinarySource, Column, Source, TextSource
from ropsim.meshes.formats.soup import (
    NO_TRIANGLES,
    Bytes,
    Floats,
    Indices,
    Soup,
    check_places,
    damaged,
    fans,
)

_FACES = ("vertex_indices", "vertex_index")
_AXES = ("x", "y", "z")
_COLOURS = ("red", "green", "blue")


def read_ply(content: bytes) -> Soup:
    """Return the triangles of a PLY file, polygons cut into fans.

    Raises:
        MeshFileError: it is cut short, has faces at points that are not there, or none.
    """
    header = read_header(content)
    source = _source(content, header)
    found: dict[str, Rows] = {}
    for element in header.elements:
        if element.properties:
            found.setdefault(element.name, read_rows(source, element))
    if isinstance(source, TextSource):
        source.check_end()
    vertices, faces = found.get("vertex"), found.get("face")
    lists = (
        None if faces is None else next((faces.lists[name] for name in _FACES if name in faces.lists), None)
    )
    if vertices is None or faces is None or lists is None or not set(_AXES) <= vertices.numbers.keys():
        raise damaged(NO_TRIANGLES)
    points = np.column_stack([vertices.numbers[axis].astype(np.float64) for axis in _AXES])
    triangles, polygon = _triangles(lists, len(points))
    colours = _rgba(vertices)
    if colours is not None:
        return Soup(points[triangles], colours[triangles])
    colours = _rgba(faces)
    if colours is not None:
        return Soup(points[triangles], np.repeat(colours[polygon][:, np.newaxis], 3, axis=1))
    return Soup(points[triangles])


def _source(content: bytes, header: Header) -> Source:
    if header.encoding is Encoding.TEXT:
        return TextSource(content[header.size :])
    return BinarySource(content, header.size, header.encoding.value)


def _triangles(lists: Lists, points: int) -> tuple[Indices, Indices]:
    entries = lists.entries.astype(np.float64)
    if not (np.isfinite(entries) & (np.abs(entries) < 2**40)).all():
        raise damaged("has a face whose corners are no numbers of points")
    corners = entries.astype(np.int64)
    triangles, polygon = fans(lists.starts, lists.lengths)
    check_places(corners, points)
    if not len(triangles):
        raise damaged(NO_TRIANGLES)
    return corners[triangles], polygon


def _rgba(rows: Rows) -> Bytes | None:
    """Return the colours of rows, shape (k, 4); None without any."""
    if not set(_COLOURS) <= rows.numbers.keys():
        return None
    columns = [_shade(rows.numbers[name]) for name in _COLOURS]
    alpha = rows.numbers.get("alpha")
    columns.append(np.full(rows.count, 255, np.uint8) if alpha is None else _shade(alpha))
    return np.column_stack(columns)


def _shade(column: Column) -> Bytes:
    """Return 0 to 255, of bytes or of fractions; numbers of a text are fractions if none is above 1."""
    values: Floats = np.nan_to_num(column.astype(np.float64), posinf=255.0, neginf=0.0)
    whole: npt.NDArray[np.bool_] = values > 1.0
    if column.dtype.kind == "f" and not whole.any():
        values = 255.0 * values
    return np.asarray(np.round(np.clip(values, 0.0, 255.0)), dtype=np.uint8)
