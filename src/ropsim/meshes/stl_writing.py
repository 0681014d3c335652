"""Triangles as STL bytes."""

import struct

import numpy as np
import numpy.typing as npt

from ropsim.spatial import Array

_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def stl_bytes(points: Array, faces: npt.NDArray[np.int64]) -> bytes:
    """Return a binary STL file; printers and CAD take its numbers for millimetres.

    Args:
        points: vertices in the unit of the file, shape (k, 3).
        faces: their numbers, each triangle against the clock seen from outside, shape (t, 3).
    """
    corners = points[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    rows = np.zeros(len(faces), _TRIANGLE)
    rows["normal"] = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0.0)
    rows["corners"] = corners
    return b"ropsim".ljust(80) + struct.pack("<I", len(faces)) + rows.tobytes()
