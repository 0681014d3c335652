"""Geometries of a COLLADA file: triangles and polygons of its meshes, by material."""

from collections.abc import Iterator

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.meshes.formats.collada_document import Document, Element
from ropsim.meshes.formats.soup import (
    MOST_TRIANGLES,
    Floats,
    Indices,
    check_count,
    check_places,
    check_points,
    damaged,
    fans,
)


@frozen_dataclass
class Part:
    """Triangles of a geometry with one material.

    Attributes:
        corners: in units of the file, shape (m, 3, 3).
        material: its symbol, which a scene binds; empty for none.
    """

    corners: Floats
    material: str


def parts_of(geometry: Element, document: Document) -> tuple[Part, ...]:
    """Return the triangles of a geometry; lines, points and splines are passed over.

    Raises:
        MeshFileError: its numbers do not fit together, or there are too many.
    """
    mesh = geometry.first("mesh")
    if mesh is None:
        return ()
    found = []
    for one in mesh.children:
        if one.name not in _COUNTED:
            continue
        made = _part(one, document)
        if made is not None:
            found.append(made)
    return tuple(found)


_COUNTED = {"triangles", "polylist", "polygons", "tristrips", "trifans"}


def _part(primitive: Element, document: Document) -> Part | None:
    points, offset = _points(primitive, document)
    stride = _stride(primitive)
    chunks, lengths = [], []
    for place, length in _polygons(primitive, stride):
        chunks.append(place[offset::stride])
        lengths.append(length)
    if not chunks:
        return None
    corners, counts = np.concatenate(chunks), np.concatenate(lengths)
    check_points(len(corners), 3 * MOST_TRIANGLES, "corners of faces")
    if counts.sum() > len(corners) or (counts < 0).any():
        raise damaged("has polygons with more corners than it says")
    check_places(corners, len(points))
    starts = np.cumsum(counts) - counts
    triangles = _fans_or_strips(primitive.name, starts, counts)
    return Part(points[corners[triangles]], primitive.attributes.get("material", ""))


def _polygons(primitive: Element, stride: int) -> Iterator[tuple[Indices, Indices]]:
    """Yield the numbers of each `p`, and how many corners each of its polygons has."""
    for p in primitive.all("p"):
        places = p.places()
        count = len(places) // stride
        if primitive.name == "triangles":
            yield places, np.full(count // 3, 3)
        elif primitive.name == "polylist":
            lengths = primitive.first("vcount")
            yield places, lengths.places() if lengths else np.empty(0, np.int64)
        else:
            yield places, np.array([count])


def _fans_or_strips(name: str, starts: Indices, counts: Indices) -> Indices:
    """Return places of corners of triangles, shape (m, 3)."""
    if name != "tristrips":
        return fans(starts, counts)[0]
    numbers = np.maximum(counts - 2, 0)
    check_count(int(numbers.sum()))
    step = np.arange(int(numbers.sum())) - np.repeat(np.cumsum(numbers) - numbers, numbers)
    first = np.repeat(starts, numbers) + step
    odd = step % 2  # every second triangle turns the other way
    return np.column_stack([first, first + 1 + odd, first + 2 - odd])


def _stride(primitive: Element) -> int:
    """Return how many numbers of `p` stand for one corner."""
    offsets = [_whole(one, "offset") for one in primitive.all("input")]
    return max(offsets, default=0) + 1


def _points(primitive: Element, document: Document) -> tuple[Floats, int]:
    """Return the points that a primitive uses, shape (k, 3), and where in a corner their number stands."""
    for one in primitive.all("input"):
        if one.attributes.get("semantic") == "VERTEX":
            vertices = document.target(one.attributes.get("source", ""), "vertices")
            for inner in vertices.all("input") if vertices else ():
                if inner.attributes.get("semantic") == "POSITION":
                    source = document.target(inner.attributes.get("source", ""), "source")
                    if source is not None:
                        return _rows(source, document), _whole(one, "offset")
    raise damaged("has faces without points")


def _rows(source: Element, document: Document) -> Floats:
    """Return the rows of a source of points, shape (k, 3)."""
    accessor = source.first("technique_common", "accessor")
    array = document.target(accessor.attributes.get("source", ""), "float_array") if accessor else None
    if accessor is None or array is None:
        raise damaged("has points without numbers")
    values = array.numbers()
    count, stride, offset = (
        _whole(accessor, key, default) for key, default in (("count", 0), ("stride", 1), ("offset", 0))
    )
    if stride < 3 or offset + count * stride > len(values):
        raise damaged(f"has {len(values)} numbers for {count} points")
    check_points(count, 3 * MOST_TRIANGLES, "points")
    return values[offset : offset + count * stride].reshape(count, stride)[:, :3]


def _whole(element: Element, key: str, default: int = 0) -> int:
    """Return a whole number of an element, 0 or greater."""
    text = element.attributes.get(key)
    if text is None:
        return default
    if not (text.strip().isdecimal() and len(text) < 10):
        raise damaged(f"has {key}={text[:20]!r} in `{element.name[:40]}`")
    return int(text)
