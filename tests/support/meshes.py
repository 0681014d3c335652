"""Mesh files for tests, written by hand so that they do not depend on the reader under test."""

import json
import struct

import numpy as np

from ropsim.spatial import Array

CUBE_CORNERS = np.array([[x, y, z] for x in (0.0, 1.0) for y in (0.0, 1.0) for z in (0.0, 1.0)])
CUBE_FACES = (
    (0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
    (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3),
)  # fmt: skip
"""Twelve triangles of the unit cube, counter-clockwise from outside."""


def cube_soup(size: float = 1.0) -> Array:
    """Return the corners of the triangles of a cube with one corner at the origin, shape (12, 3, 3)."""
    return np.asarray(size * CUBE_CORNERS[np.array(CUBE_FACES)])


def stl(soup: Array) -> bytes:
    """Return a binary STL file of triangles, shape (m, 3, 3)."""
    rows = [struct.pack("<12fH", 0.0, 0.0, 0.0, *face.reshape(-1), 0) for face in soup]
    return b"\0" * 80 + struct.pack("<I", len(soup)) + b"".join(rows)


def stl_text(soup: Array) -> bytes:
    """Return an STL file in its text form."""
    lines = ["solid test"]
    for face in soup:
        corners = [f"vertex {x!r} {y!r} {z!r}" for x, y, z in face.tolist()]
        lines += ["facet normal 0 0 0", "outer loop", *corners, "endloop", "endfacet"]
    return "\n".join([*lines, "endsolid test", ""]).encode()


def obj(size: float = 1.0) -> bytes:
    """Return a cube as OBJ file."""
    points = [f"v {x} {y} {z}" for x, y, z in (size * CUBE_CORNERS).tolist()]
    faces = [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in CUBE_FACES]
    return "\n".join(["mtllib absent.mtl", *points, *faces, ""]).encode()


def ply(size: float = 1.0, colours: str = "") -> bytes:
    """Return a cube as PLY file; `colours` is appended to each of its eight corners."""
    head = ["ply", "format ascii 1.0", "element vertex 8", *(f"property float {axis}" for axis in "xyz")]
    if colours:
        head += [f"property uchar {name}" for name in ("red", "green", "blue")]
    head += ["element face 12", "property list uchar int vertex_indices", "end_header"]
    points = [f"{x} {y} {z} {colours}".strip() for x, y, z in (size * CUBE_CORNERS).tolist()]
    faces = [f"3 {a} {b} {c}" for a, b, c in CUBE_FACES]
    return "\n".join([*head, *points, *faces, ""]).encode()


def drum(sections: int = 32) -> Array:
    """Return the triangles of a closed cylinder of radius 1 and height 1, shape (4·sections, 3, 3)."""
    angles = 2.0 * np.pi * np.arange(sections) / sections
    low = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(sections)])
    high = low + np.array([0.0, 0.0, 1.0])
    faces = []
    for k in range(sections):
        a, b, c, d = low[k], low[(k + 1) % sections], high[(k + 1) % sections], high[k]
        faces += [[a, b, c], [a, c, d], [[0.0, 0.0, 0.0], b, a], [[0.0, 0.0, 1.0], d, c]]
    return np.array(faces)


def ply_binary(soup: Array, order: str) -> bytes:
    """Return a binary PLY file of triangles without shared points; `order` is `<` or `>`."""
    name = "little" if order == "<" else "big"
    head = [
        *("ply", f"format binary_{name}_endian 1.0", f"element vertex {3 * len(soup)}"),
        *(f"property float {axis}" for axis in "xyz"),
        *(f"element face {len(soup)}", "property list uchar int vertex_indices", "end_header", ""),
    ]
    points = [struct.pack(f"{order}3f", *point) for point in soup.reshape(-1, 3).tolist()]
    faces = [struct.pack(f"{order}B3i", 3, 3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(soup))]
    return "\n".join(head).encode() + b"".join(points + faces)


def glb_container(document: object, body: bytes) -> bytes:
    """Return a GLB file of a JSON part and a binary part."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    size = 12 + 8 + len(text) + 8 + len(body)
    parts = [struct.pack("<4sII", b"glTF", 2, size), struct.pack("<I4s", len(text), b"JSON"), text]
    return b"".join([*parts, struct.pack("<I4s", len(body), b"BIN\0"), body])
