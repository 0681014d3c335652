"""Mesh files of every format that is read."""

import struct
from functools import partial
from random import Random

import numpy as np

from ropsim.meshes.testing import MOST_TRIANGLES, MeshFileError, glb_bytes, read_mesh, shaded
from ropsim.model import Mesh
from support.fuzzing.mutation import BYTES, TEXT, changed_value, mutated
from support.fuzzing.target import Target
from support.fuzzing.values import DEPTHS
from support.meshes import (
    POLYLIST,
    STRIP,
    collada,
    cube_soup,
    drum,
    glb_container,
    obj,
    ply,
    ply_binary,
    stl,
    stl_text,
)

_POLYGONS = (
    b"o a\nusemtl b\nv 0 0 0 1 0.5 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1 4\n"
    b"f -4 -3 \\\n-2\nl 1 2\n"
)
_TEXTURED = ply().replace(b"format ascii 1.0", b"format ascii 1.0\ncomment TextureFile ../../a.png")


def _uneven(order: str) -> bytes:
    """Return a binary PLY whose last face has five corners."""
    head, _, body = ply_binary(cube_soup(), order).partition(b"end_header\n")
    return (
        head.replace(b"face 12", b"face 13")
        + b"end_header\n"
        + body
        + struct.pack(order + "B5i", 5, 0, 1, 2, 3, 4)
    )


_GLB_BODY = struct.pack("<12f12B6H", *(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1), *(7,) * 12, 0, 1, 2, 1, 2, 3)
_GLB: dict[str, object] = {
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": [0]}],
    "nodes": [
        {"children": [1, 2], "translation": [1, 2, 3], "rotation": [0, 0, 0, 1], "scale": [1, -1, 1]},
        {"mesh": 0},
        {"mesh": 1, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]},
    ],
    "meshes": [
        {"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 2}, "indices": 1, "material": 0}]},
        {
            "primitives": [
                {"attributes": {"POSITION": 0}, "mode": 5},
                {"attributes": {"POSITION": 0}, "mode": 6},
            ]
        },
    ],
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}}],
    "textures": [{"source": 0}],
    "images": [{"uri": "../../a.png"}],
    "accessors": [
        {
            "componentType": 5126,
            "count": 4,
            "type": "VEC3",
            "bufferView": 0,
            "min": [0, 0, 0],
            "max": [1, 1, 1],
        },
        {"componentType": 5123, "count": 6, "type": "SCALAR", "bufferView": 2, "byteOffset": 0},
        {"componentType": 5121, "count": 4, "type": "VEC3", "bufferView": 1, "normalized": True},
    ],
    "bufferViews": [
        {"buffer": 0, "byteOffset": 0, "byteLength": 48, "byteStride": 12},
        {"buffer": 0, "byteOffset": 48, "byteLength": 12},
        {"buffer": 0, "byteOffset": 60, "byteLength": 12},
    ],
    "buffers": [{"byteLength": 72}],
    "extensionsUsed": ["KHR_materials_unlit"],
}

_STLS = (stl(cube_soup()), stl(drum(5)))
_TEXT_STLS = (stl_text(cube_soup()), stl_text(drum(3)))
_OBJS = (obj(), _POLYGONS)
_TEXT_PLYS = (ply(), ply(colours="1 2 3"), _TEXTURED)
_PLYS = (ply_binary(cube_soup(), "<"), ply_binary(cube_soup(), ">"), _uneven("<"))
_COLLADAS = (
    collada(),
    collada(POLYLIST + STRIP),
    collada(
        nodes='<node id="n"><matrix>1 0 0 1 0 1 0 2 0 0 1 3 0 0 0 1</matrix><scale>1 -1 2</scale>'
        '<instance_geometry url="#g"/><instance_node url="#n"/></node>'
    ),
)
_GLBS = (glb_bytes(shaded(cube_soup())), glb_container(_GLB, _GLB_BODY))


def _take(name: str, content: bytes) -> str:
    try:
        found = read_mesh(content, Mesh(name))
    except MeshFileError as error:
        return error.kind.code if error.found else "said nothing"
    assert np.isfinite(found.points).all()
    assert np.isfinite(found.normals).all()
    assert 0 < len(found.faces) <= MOST_TRIANGLES
    assert int(found.faces.max()) < len(found.points)
    assert glb_bytes(found)[:4] == b"glTF"
    return "read"


def _stl(random: Random) -> bytes:
    if random.random() < 0.5:
        return mutated(random, random.choice(_STLS), BYTES)
    return mutated(random, random.choice(_TEXT_STLS), TEXT)


def _obj(random: Random) -> bytes:
    return mutated(random, random.choice(_OBJS), (*TEXT, *BYTES[:4]))


def _ply(random: Random) -> bytes:
    if random.random() < 0.5:
        return mutated(random, random.choice(_TEXT_PLYS), TEXT)
    content = random.choice(_PLYS)
    if random.random() < 0.4:
        head, mark, body = content.partition(b"end_header\n")
        return mutated(random, head, TEXT) + mark + body
    return mutated(random, content, BYTES)


def _glb(random: Random) -> bytes:
    choice = random.random()
    if choice < 0.25:
        return mutated(random, random.choice(_GLBS), BYTES)
    if choice < 0.3:
        return glb_container(
            _chain(random.choice((*DEPTHS[:3], *DEPTHS[:3], *DEPTHS[:3], DEPTHS[3]))), _GLB_BODY
        )
    document: object = _GLB
    for _ in range(random.choice((1, 1, 2, 3))):
        document = changed_value(random, document)
    body = mutated(random, _GLB_BODY, BYTES) if random.random() < 0.2 else _GLB_BODY
    content = glb_container(document, body)
    return mutated(random, content, TEXT) if random.random() < 0.1 else content


def _collada(random: Random) -> bytes:
    content = random.choice(_COLLADAS)
    if random.random() < 0.1:
        depth = random.choice((10, 100, 1000, 10_000))
        content = content.replace(b"<node>", depth * b"<node>").replace(b"</node>", depth * b"</node>")
    return mutated(random, content, (*TEXT, *BYTES[:4]))


def _chain(depth: int) -> object:
    """Return a document with nodes one below the other."""
    nodes = [{"mesh": 0, "children": [k + 1]} for k in range(depth)]
    return {**_GLB, "nodes": [*nodes, {"mesh": 0}]}


TARGETS = (
    Target("stl", _stl, partial(_take, "a.stl")),
    Target("obj", _obj, partial(_take, "a.obj")),
    Target("ply", _ply, partial(_take, "a.ply")),
    Target("glb", _glb, partial(_take, "a.glb")),
    Target("dae", _collada, partial(_take, "a.dae")),
)
