"""The mesh readers agree with an independent one, keep to the file, and refuse what they cannot draw."""

import io
import json
import struct
from collections.abc import Callable
from functools import cache, partial
from typing import Any

import numpy as np
import pytest

from ropsim.meshes import MESH_FORMATS
from ropsim.meshes.testing import (
    MeshFileError,
    Soup,
    glb_bytes,
    read_collada,
    read_glb,
    read_mesh,
    read_obj,
    read_ply,
    read_stl,
)
from ropsim.model import MESH_ENDINGS, Mesh
from ropsim.spatial import Array
from support.meshes import cube_soup, drum, glb_container, obj, ply, ply_binary, stl, stl_text

READERS = {"stl": read_stl, "obj": read_obj, "ply": read_ply, "glb": read_glb, "dae": read_collada}


TURNED = np.array([[0.0, -1.0, 0.0, 0.5], [0.0, 0.0, -1.0, 0.2], [1.0, 0.0, 0.0, 0.1], [0.0, 0.0, 0.0, 1.0]])


@cache
def scene_glb() -> bytes:
    """Two placed instances of a body, one of them turned, the other mirrored and stretched."""
    import trimesh

    body = trimesh.Trimesh(*_indexed(drum(12)), process=False)
    scene = trimesh.Scene()
    scene.add_geometry(body, "body", "one", transform=TURNED)
    mirrored = np.diag([-1.0, 1.0, 2.0, 1.0])
    mirrored[:3, 3] = [1.0, 2.0, 3.0]
    scene.add_geometry(body, "body again", "two", transform=mirrored)
    export: Any = scene.export
    return bytes(export(file_type="glb"))


def _indexed(soup: Array) -> tuple[Array, Any]:
    return soup.reshape(-1, 3), np.arange(3 * len(soup)).reshape(-1, 3)


@cache
def exported(ending: str, **options: Any) -> bytes:
    """A drum as an independent program writes it."""
    import trimesh

    content = trimesh.Trimesh(*_indexed(drum(20)), process=False).export(file_type=ending, **options)
    return content.encode() if isinstance(content, str) else bytes(content)


FILES: list[tuple[str, Callable[[], bytes]]] = [
    ("stl", partial(exported, "stl")),
    ("stl", partial(exported, "stl_ascii")),
    ("obj", partial(exported, "obj")),
    ("ply", partial(exported, "ply", encoding="ascii")),
    ("ply", partial(exported, "ply")),
    ("glb", partial(exported, "glb")),
    ("glb", scene_glb),
    ("obj", partial(obj, 3.0)),
    ("ply", partial(ply, 3.0)),
    ("ply", partial(ply_binary, cube_soup(), ">")),
    ("ply", partial(ply_binary, cube_soup(), "<")),
    ("stl", partial(stl, cube_soup())),
    ("stl", partial(stl_text, cube_soup())),
]


def other_reader(ending: str, content: bytes) -> Array:
    import trimesh

    scene = trimesh.load_scene(io.BytesIO(content), file_type=ending, process=False)
    whole = scene.to_mesh()
    return np.asarray(np.asarray(whole.vertices)[np.asarray(whole.faces)])


def in_order(soup: Array) -> Array:
    """Triangles from their first corner on, sorted, so that two readers may list them differently."""
    rounded = np.round(soup, 5) + 0.0
    turned = [np.roll(one, -min(range(3), key=lambda k: tuple(one[k])), axis=0) for one in rounded]
    return np.array(sorted(one.reshape(-1).tolist() for one in turned))


@pytest.mark.parametrize(("ending", "made"), FILES)
def test_the_triangles_are_those_of_an_independent_reader(ending: str, made: Callable[[], bytes]) -> None:
    content = made()
    ours = in_order(READERS[ending](content).corners)
    theirs = in_order(other_reader(ending, content))
    assert ours.shape == theirs.shape
    assert np.abs(ours - theirs).max() <= 2e-5  # both are rounded to 1e-5


def test_polygons_become_fans() -> None:
    soup = read_obj(b"v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1/7/8 2//3 3 -1\n")
    assert soup.corners.tolist() == [[[0, 0, 0], [2, 0, 0], [2, 2, 0]], [[0, 0, 0], [2, 2, 0], [0, 2, 0]]]


def test_rows_of_different_lengths_are_read() -> None:
    content = ply_binary(cube_soup(), "<")
    head, _, body = content.partition(b"end_header\n")
    five = struct.pack("<B5i", 5, 0, 1, 2, 3, 4)
    longer = head.replace(b"face 12", b"face 13") + b"end_header\n" + body + five
    assert len(read_ply(longer).corners) == 12 + 3
    assert read_ply(longer).corners[:12].tolist() == cube_soup().tolist()


def corner_colours(soup: Soup) -> list[int]:
    assert soup.colours is not None
    return [int(value) for value in soup.colours[0, 0]]


def test_colours_of_points_and_faces_and_materials_are_kept() -> None:
    assert corner_colours(read_ply(ply(colours="255 128 0"))) == [255, 128, 0, 255]
    assert corner_colours(read_obj(b"v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")) == [255, 128, 0, 255]
    document = glb_document()
    document["materials"] = [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}}]
    document["meshes"][0]["primitives"][0]["material"] = 0
    assert corner_colours(read_glb(glb_container(document, GLB_BODY))) == [255, 128, 0, 255]


def test_colours_are_made_linear_where_the_format_has_them_as_screens_show_them() -> None:
    on_screen = read_mesh(ply(colours="255 128 0"), Mesh("a.ply", 1.0)).colours
    assert on_screen is not None
    assert on_screen[0].tolist() == [255, round(255 * (128 / 255) ** 2.2), 0, 255]
    document = glb_document()
    document["materials"] = [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 1]}}]
    document["meshes"][0]["primitives"][0]["material"] = 0
    linear = read_mesh(glb_container(document, GLB_BODY), Mesh("a.glb")).colours
    assert linear is not None
    assert linear[0].tolist() == [255, 128, 0, 255]


def test_every_ending_of_meshes_has_its_reader() -> None:
    assert tuple(MESH_FORMATS) == MESH_ENDINGS


GLB_BODY = struct.pack("<9f3I", 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 2)


def glb_document() -> dict[str, Any]:
    """One triangle."""
    return {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"componentType": 5126, "count": 3, "type": "VEC3", "bufferView": 0},
            {"componentType": 5125, "count": 3, "type": "SCALAR", "bufferView": 1},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 12},
        ],
        "buffers": [{"byteLength": 48}],
    }


def glb_with(path: str, value: object) -> bytes:
    """The file of one triangle with one value in its description changed."""
    document = glb_document()
    *way, last = [int(step) if step.isdigit() else step for step in path.split("/")]
    place: Any = document
    for step in way:
        place = place[step]
    place[last] = value
    return glb_container(document, GLB_BODY)


PLY = ply()
REFUSED = [
    ("stl", stl(cube_soup())[:80] + b"\xff\xff\xff\xff" + stl(cube_soup())[84:], "promises 4,294,967,295"),
    (
        "stl",
        stl_text(cube_soup()).replace(b"endloop", b"vertex 1 2 3\nendloop", 1),
        "triangles have three each",
    ),
    ("stl", stl_text(cube_soup()).replace(b"1.0", b"one", 1), "a corner that is not three numbers"),
    ("ply", PLY.replace(b"3 0 1 3", b"3 0 1 99"), "a face at point 99, points are numbered from 0 to 7"),
    ("ply", PLY.replace(b"3 0 1 3", b"3 0 1 -2"), "a face at point -2"),
    ("ply", PLY.replace(b"3 0 1 3", b"3 0 1 nan"), "corners are no numbers of points"),
    ("ply", PLY.replace(b"3 0 1 3", b"2 0 1 3"), "more than its header promises"),
    ("ply", PLY.replace(b"3 0 1 3", b"9 0 1 3"), "is cut short"),
    ("ply", PLY.replace(b"3 0 1 3", b"three 0 1 3"), "something among its numbers that is none"),
    ("ply", PLY[:-30], "is cut short"),
    ("ply", PLY.replace(b"face 12", b"face 4000000000"), "has 4,000,000,000 triangles"),
    ("ply", PLY.replace(b"vertex 8", b"vertex 4000000000"), "is cut short"),
    ("ply", PLY.replace(b"vertex 8", b"vertex -8"), "a header with `-8` rows"),
    ("ply", PLY.replace(b"list uchar", b"list float"), "a header with the property"),
    ("obj", obj().replace(b"f 1 ", b"f 9 ", 1), "a face at point 8, points are numbered from 0 to 7"),
    ("obj", obj().replace(b"f 1 ", b"f 0 ", 1), "a face at point 0, points are numbered from 1"),
    ("obj", obj().replace(b"f 1 ", b"f one ", 1), "a line `f one"),
    ("obj", b"v 0 0\nf 1 1 1\n", "a point with 2 coordinates"),
    ("glb", glb_with("accessors/0/count", 2**31 - 1), "has 2,147,483,650 points, normals, colours"),
    ("glb", glb_with("accessors/1/componentType", 5126), "corners are no numbers of points"),
    ("glb", glb_with("accessors/0/bufferView", 7), "refers to bytes that it does not hold"),
    ("glb", glb_with("bufferViews/0/byteLength", 4096), "numbers lie outside of its bytes"),
    ("glb", glb_with("buffers/0/uri", "/etc/passwd"), "in another file, which is not opened"),
    ("glb", glb_with("buffers/0/uri", "https://localhost/a.bin"), "in another file, which is not opened"),
    ("glb", glb_with("nodes/0/children", [0]), "a node that hangs in two places"),
    ("glb", glb_with("nodes/0/mesh", 5), "refers to meshes that it does not hold"),
    ("glb", glb_with("extensionsRequired", ["KHR_draco_mesh_compression"]), "needs the extension"),
    ("glb", glb_with("scene", -1), "cannot be read as GLB"),
    ("glb", glb_container(glb_document(), GLB_BODY)[:-4], "is cut short"),
]


@pytest.mark.parametrize(("ending", "content", "words"), REFUSED)
def test_what_is_damaged_is_refused_in_words(ending: str, content: bytes, words: str) -> None:
    with pytest.raises(MeshFileError) as found:
        READERS[ending](content)
    assert words in found.value.found


def test_too_many_points_are_called_points(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("ropsim.meshes.formats.obj.MOST_TRIANGLES", 2)
    with pytest.raises(MeshFileError) as found:
        read_obj(7 * b"v 0 0 0\n" + b"f 1 2 3\n")
    assert found.value.found == "has 7 points, at most 6 are read"


@pytest.mark.parametrize(("ending", "made"), FILES)
def test_no_format_gives_more_triangles_than_can_be_drawn(
    ending: str, made: Callable[[], bytes], monkeypatch: pytest.MonkeyPatch
) -> None:
    content = made()
    count = len(READERS[ending](content).corners)
    monkeypatch.setattr("ropsim.meshes.formats.soup.MOST_TRIANGLES", count)
    assert len(READERS[ending](content).corners) == count
    monkeypatch.setattr("ropsim.meshes.formats.soup.MOST_TRIANGLES", count - 1)
    with pytest.raises(MeshFileError) as found:
        READERS[ending](content)
    assert found.value.kind.code == "X883"
    assert found.value.found == f"has {count:,} triangles, at most {count - 1:,} are drawn"


@pytest.mark.parametrize("value", ["nan", "inf", "-inf", "1e308", "1e400"])
def test_wild_coordinates_are_refused(value: str) -> None:
    with pytest.raises(MeshFileError) as found:
        read_mesh(PLY.replace(b"1.0 1.0 1.0", f"1.0 {value} 1.0".encode()), Mesh("a.ply"))
    assert found.value.kind.code in {"X881", "X885"}


def test_what_a_file_refers_to_is_not_looked_at() -> None:
    document = glb_document()
    document["images"] = [{"uri": "https://localhost/a.png"}, {"uri": "../../secret.png"}]
    document["textures"] = [{"source": 0}]
    document["materials"] = [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]
    document["meshes"][0]["primitives"][0]["material"] = 0
    textured = ply().replace(b"format ascii 1.0", b"format ascii 1.0\ncomment TextureFile /etc/passwd")
    linked = b"mtllib /etc/passwd\nmtllib https://localhost/a.mtl\nusemtl a\n" + obj()
    assert len(read_glb(glb_container(document, GLB_BODY)).corners) == 1
    assert len(read_ply(textured).corners) == 12
    assert len(read_obj(linked).corners) == 12


def test_strips_and_fans_are_triangles() -> None:
    body = struct.pack("<12f", 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0)
    document = glb_document()
    document["accessors"][0]["count"] = 4
    document["bufferViews"] = [{"buffer": 0, "byteLength": 48}]
    (primitive,) = document["meshes"][0]["primitives"]
    del primitive["indices"]
    primitive["mode"] = 5
    strip = read_glb(glb_container(document, body)).corners
    assert np.cross(strip[:, 1] - strip[:, 0], strip[:, 2] - strip[:, 0])[:, 2].tolist() == [1.0, 1.0]
    primitive["mode"] = 6
    assert read_glb(glb_container(document, body)).corners[:, 0].tolist() == [[0, 0, 0], [0, 0, 0]]


def test_what_ropsim_writes_it_reads_again() -> None:
    once = glb_bytes(read_mesh(stl(drum()), Mesh("a.stl", 1.0)))
    assert glb_bytes(read_mesh(once, Mesh("a.glb"))) == once
    assert json.loads(once[20 : 20 + struct.unpack_from("<I", once, 12)[0]])["asset"]["version"] == "2.0"
