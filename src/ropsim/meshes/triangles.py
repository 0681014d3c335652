"""Triangles with normals: smooth over rounded faces, sharp at edges."""

from math import cos, radians

import numpy as np
import numpy.typing as npt

from ropsim.spatial import record

_CREASE = cos(radians(40.0))
"""Faces that meet at a greater angle keep their edge; chords of rounded faces are nearly always below."""

_MOST_NEIGHBOURS = 64  # maximum number of faces checked about one point; cones of more chords look the same

Floats = npt.NDArray[np.float32]
Indices = npt.NDArray[np.uint32]
Colours = npt.NDArray[np.uint8]


@record
class Triangles:
    """Mesh data sent to the page.

    Attributes:
        points: [m], shape (k, 3).
        normals: unit vectors, shape (k, 3).
        faces: places of the corners in `points`, counter-clockwise from outside, shape (m, 3).
        colours: linear red, green, blue and opaqueness, shape (k, 4); None without colours.
    """

    points: Floats
    normals: Floats
    faces: Indices
    colours: Colours | None = None


def shaded(soup: npt.NDArray[np.float64], colours: Colours | None = None) -> Triangles:
    """Return triangles with normals, corners that agree in everything merged.

    Args:
        soup: the three corners of every triangle [m], shape (m, 3, 3); degenerate ones are left out.
        colours: of every corner, shape (m, 3, 4).
    """
    areas = np.cross(soup[:, 1] - soup[:, 0], soup[:, 2] - soup[:, 0])
    lengths = np.linalg.norm(areas, axis=1)
    solid = lengths > 0.0
    soup, faces = soup[solid], areas[solid] / lengths[solid, np.newaxis]
    corners = soup.reshape(-1, 3).astype(np.float32)
    _, point_of = np.unique(corners, axis=0, return_inverse=True)
    normals = _corner_normals(point_of.reshape(-1), faces, _angles(soup))
    columns = [corners, normals.astype(np.float32)]
    if colours is not None:
        columns.append(colours[solid].reshape(-1, 4).astype(np.float32))
    rows, places = np.unique(np.hstack(columns), axis=0, return_inverse=True)
    return Triangles(
        np.ascontiguousarray(rows[:, :3]),
        np.ascontiguousarray(rows[:, 3:6]),
        places.reshape(-1, 3).astype(np.uint32),
        None if colours is None else rows[:, 6:].astype(np.uint8),
    )


def _angles(soup: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Return the angle at every corner of every triangle [rad], shape (3·m,)."""
    ahead = np.roll(soup, -1, axis=1) - soup
    behind = np.roll(soup, 1, axis=1) - soup
    double_area = np.linalg.norm(np.cross(ahead, behind), axis=2)
    return np.asarray(np.arctan2(double_area, np.einsum("ijk,ijk->ij", ahead, behind)).reshape(-1))


def _corner_normals(
    point_of: npt.NDArray[np.intp], faces: npt.NDArray[np.float64], angles: npt.NDArray[np.float64]
) -> npt.NDArray[np.float64]:
    """Return for each corner the mean normal of the faces about its point that lie nearly flat to its own.

    Faces count by their angle at the point, so that it does not matter how a flat side is cut into triangles
    (Thürmer & Wüthrich 1998). Rounded to 1/8192, so that corners which agree can be merged.

    Args:
        point_of: number of the point of each corner, shape (3·m,).
        faces: unit normal of each face, shape (m, 3).
        angles: of each corner [rad], shape (3·m,).
    """
    own = np.repeat(faces, 3, axis=0)
    order = np.argsort(point_of, kind="stable")  # corners, grouped by point
    counts = np.bincount(point_of)
    starts = np.concatenate([[0], np.cumsum(counts)])[point_of]
    total = np.zeros_like(own)
    for k in range(min(int(counts.max(initial=0)), _MOST_NEIGHBOURS)):
        here = np.flatnonzero(counts[point_of] > k)
        other = order[starts[here] + k]
        near = np.einsum("ij,ij->i", own[other], own[here]) >= _CREASE
        total[here[near]] += angles[other[near], np.newaxis] * own[other[near]]
    sizes = np.linalg.norm(total, axis=1, keepdims=True)
    mean = np.where(sizes > 0.0, total / np.where(sizes > 0.0, sizes, 1.0), own)
    return np.asarray(np.round(mean * 8192.0) / 8192.0)
