"""OBJ files: points and faces; materials, textures, normals and curves in them are ignored."""

from __future__ import annotations

import re
from array import array
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from ropsim.meshes.formats.soup import (
    MOST_TRIANGLES,
    NO_TRIANGLES,
    UNCOLOURED,
    Bytes,
    Floats,
    Soup,
    check_count,
    check_places,
    check_points,
    damaged,
    fans,
)

if TYPE_CHECKING:
    Numbers: TypeAlias = array[float]
    Places: TypeAlias = array[int]

_LINE = re.compile(rb"^[ \t]*+([vf])[ \t]++([^\r\n]++)", re.MULTILINE)
_CONTINUED = re.compile(rb"\\\r?\n")
_LONGEST = 100_000  # bytes of one face
_UNCOLOURED = tuple(value / 255.0 for value in UNCOLOURED[:3])


def read_obj(content: bytes) -> Soup:
    """Return the triangles of an OBJ file, polygons cut into fans.

    Colours after the coordinates of a point, as scanners write them, are kept.

    Raises:
        MeshFileError: a point or a face is damaged, or there is none.
    """
    points, colours = array("d"), array("d")
    corners, lengths = array("q"), array("q")
    coloured = False
    for match in _LINE.finditer(_CONTINUED.sub(b" ", content)):
        sort, rest = match.groups()
        try:
            if sort == b"v":
                values = [float(word) for word in rest.split(None, 7)[:7]]
                if len(values) < 3:
                    raise damaged(f"has a point with {len(values)} coordinates, needed are three")
                points.extend(values[:3])
                has_colour = len(values) >= 6
                coloured = coloured or has_colour
                colours.extend(values[-3:] if has_colour else _UNCOLOURED)
            else:
                places = _places(rest, len(points) // 3)
                corners.extend(places)
                lengths.append(len(places))
        except (ValueError, OverflowError) as error:
            words = rest[:40].decode("utf-8", "replace")
            raise damaged(f"has a line `{sort.decode()} {words}` that is not numbers") from error
        check_count(len(lengths))
        check_points(len(points) // 3, 3 * MOST_TRIANGLES, "points")
    if not lengths:
        raise damaged(NO_TRIANGLES)
    return _soup(points, colours if coloured else None, corners, lengths)


def _places(rest: bytes, points: int) -> list[int]:
    """Return the points of a face, counted from 0; in the file they count from 1, or backwards from -1."""
    if len(rest) > _LONGEST:
        raise damaged(f"has a face of {len(rest):,} characters")
    named = [int(word.partition(b"/")[0]) for word in rest.split()]
    if 0 in named:
        raise damaged("has a face at point 0, points are numbered from 1")
    return [place - 1 if place > 0 else points + place for place in named]


def _soup(points: Numbers, colours: Numbers | None, corners: Places, lengths: Places) -> Soup:
    xyz: Floats = np.frombuffer(points, np.float64).reshape(-1, 3)
    flat = np.frombuffer(corners, np.int64) if corners else np.empty(0, np.int64)
    counts = np.frombuffer(lengths, np.int64)
    check_places(flat, len(xyz))
    triangles, _ = fans(np.cumsum(counts) - counts, counts)
    places = flat[triangles]
    return Soup(xyz[places], None if colours is None else _colours(colours)[places])


def _colours(values: Numbers) -> Bytes:
    rgb: Floats = np.nan_to_num(np.frombuffer(values, np.float64).reshape(-1, 3))
    rows = np.round(255.0 * np.clip(rgb, 0.0, 1.0)).astype(np.uint8)
    return np.column_stack([rows, np.full(len(rows), 255, np.uint8)])
