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


_VERTICES = '<input semantic="VERTEX" source="#corners" offset="0"/>'
TRIANGLES = f'<triangles count="1" material="m">{_VERTICES}<p>0 4 2 4 6 2</p></triangles>'
"""The side z = 0 of a unit cube, for `collada`."""
POLYLIST = f'<polylist count="1">{_VERTICES}<vcount>4</vcount><p>0 4 6 2</p></polylist>'
STRIP = f'<tristrips count="1">{_VERTICES}<p>0 4 2 6</p></tristrips>'
NODE = '<node><instance_geometry url="#g"/></node>'


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


def collada(shapes: str = TRIANGLES, nodes: str = NODE, more: str = "", unit: str = "1") -> bytes:
    """Return a COLLADA file whose geometry `g` has the corners of a unit cube, 0 to 1, as points.

    Args:
        shapes: elements that use the points.
        nodes: of the scene.
        more: further libraries.
        unit: metres per unit of the file.
    """
    points = " ".join(f"{x} {y} {z}" for x in (0, 1) for y in (0, 1) for z in (0, 1))
    return (
        '<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">'
        f'<asset><unit meter="{unit}"/><up_axis>Z_UP</up_axis></asset>'
        '<library_geometries><geometry id="g"><mesh><source id="points">'
        f'<float_array id="numbers" count="24">{points}</float_array><technique_common>'
        '<accessor source="#numbers" count="8" stride="3"/></technique_common></source>'
        '<vertices id="corners"><input semantic="POSITION" source="#points"/></vertices>'
        f"{shapes}</mesh></geometry></library_geometries>{more}"
        f'<library_visual_scenes><visual_scene id="s">{nodes}</visual_scene></library_visual_scenes>'
        '<scene><instance_visual_scene url="#s"/></scene></COLLADA>'
    ).encode()
