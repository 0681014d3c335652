"""Result and refusal of every mesh reader."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from ropsim.core import Kind
from ropsim.meshes.diagnostics import MESH_DAMAGED, MESH_TOO_LARGE

MOST_TRIANGLES = 500_000
"""More are not drawn; making them ready takes about a kilobyte for each."""

COARSER = "export it with a coarser tolerance"

UNCOLOURED = (150, 156, 163, 255)
"""Red, green, blue and opaqueness of entities without a colour in a file with colours."""

NO_TRIANGLES = "holds no triangles"

Floats = npt.NDArray[np.float64]
Indices = npt.NDArray[np.int64]
Bytes = npt.NDArray[np.uint8]


class Soup(NamedTuple):
    """Corners of triangles.

    Attributes:
        corners: counter-clockwise from outside, in units of the file, shape (m, 3, 3); may hold NaN.
        colours: red, green, blue and opaqueness of every corner, shape (m, 3, 4); None without colours.
    """

    corners: Floats
    colours: Bytes | None = None


class MeshFileError(Exception):
    """A mesh file that cannot be drawn: its kind, the finding, the hint."""

    def __init__(self, kind: Kind, found: str, hint: str = "") -> None:
        super().__init__(found)
        self.kind = kind
        self.found = found
        self.hint = hint


def damaged(found: str, hint: str = "export it again") -> MeshFileError:
    """Return the error of a file whose content does not match its ending.

    Args:
        found: the finding, after the name of the file.
        hint: next action.
    """
    return MeshFileError(MESH_DAMAGED, found, hint)


def check_count(triangles: int) -> None:
    """Refuse more triangles than can be drawn.

    Raises:
        MeshFileError: X883.
    """
    if triangles > MOST_TRIANGLES:
        found = f"has {triangles:,} triangles, at most {MOST_TRIANGLES:,} are drawn"
        raise MeshFileError(MESH_TOO_LARGE, found, COARSER)


def check_points(count: int, most: int, noun: str) -> None:
    """Refuse more points than the triangles that can be drawn have use for.

    Args:
        count: how many there are.
        most: how many are read.
        noun: name of the counted entities, in the plural.

    Raises:
        MeshFileError: X883.
    """
    if count > most:
        raise MeshFileError(MESH_TOO_LARGE, f"has {count:,} {noun}, at most {most:,} are read", COARSER)


def fans(starts: Indices, lengths: Indices) -> tuple[Indices, Indices]:
    """Cut polygons into triangles that share the first corner of their polygon.

    Args:
        starts: place of the first corner of each polygon in a list of corners, shape (k,).
        lengths: number of corners of each polygon, shape (k,); a polygon with fewer than three corners has no
            triangle.

    Returns:
        Places of the corners, shape (m, 3), and the polygon of each triangle, shape (m,).

    Raises:
        MeshFileError: X883, they are too many.
    """
    counts = np.maximum(lengths - 2, 0)
    total = int(counts.sum())
    check_count(total)
    polygon = np.repeat(np.arange(len(counts)), counts)
    step = np.arange(total) - np.repeat(np.cumsum(counts) - counts, counts)
    first = starts[polygon]
    return np.column_stack([first, first + step + 1, first + step + 2]), polygon


def check_places(places: Indices, points: int) -> None:
    """Refuse faces whose corners are not there.

    Args:
        places: of corners among the points.
        points: how many there are.

    Raises:
        MeshFileError: X881.
    """
    wrong = (places < 0) | (places >= points)
    if wrong.any():
        raise damaged(
            f"has a face at point {int(places[wrong][0])}, points are numbered from 0 to {points - 1}"
        )
