"""Mesh files become GLB bytes under their own hash; what cannot be read is told, with its place."""

import hashlib
import json
import os
import struct
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.cellfile import mesh_in_files, read_cell
from ropsim.core import SourceText
from ropsim.meshes import MeshLibrary, glb, load_meshes
from ropsim.meshes import library as meshes
from ropsim.meshes.testing import shaded
from ropsim.model import Cell, FixedObject, Mesh, Shape
from ropsim.spatial import Pose
from ropsim.views import scene
from support.cells import one_station
from support.meshes import cube_soup, drum, obj, ply, stl, stl_text

EMPTY = one_station("c", robots.load("puma560"), robots.default_controller("puma560"))
SINGLE = 1e-6  # relative, of single precision


def cell_with(*found: Mesh) -> Cell:
    return replace(EMPTY, objects=(FixedObject("o", Pose(), tuple(Shape(mesh) for mesh in found)),))


def load(folder: Path, *found: Mesh) -> MeshLibrary:
    return load_meshes(folder, cell_with(*found))


def header_of(content: bytes) -> Any:
    magic, version, length = struct.unpack_from("<4sII", content)
    size, sort = struct.unpack_from("<I4s", content, 12)
    assert (magic, version, length, sort) == (b"glTF", 2, len(content), b"JSON")
    return json.loads(content[20 : 20 + size])


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.stl", stl(cube_soup(200.0))),
        ("b.STL", stl_text(cube_soup(200.0))),
        ("a.obj", obj(200.0)),
        ("a.ply", ply(200.0)),
        ("a.glb", glb.glb_bytes(shaded(cube_soup(200.0)))),
    ],
)
def test_every_format_gives_the_same_cube(tmp_path: Path, name: str, content: bytes) -> None:
    (tmp_path / name).write_bytes(content)
    mesh = Mesh(name, 0.001)
    library = load(tmp_path, mesh)
    assert library.diagnostics == ()
    source = library.addresses[mesh]
    assert source.low == pytest.approx((0.0, 0.0, 0.0), abs=SINGLE)
    assert source.high == pytest.approx((0.2, 0.2, 0.2), rel=SINGLE)
    assert library.triangles[mesh] == 12
    expected = glb.glb_bytes(shaded(cube_soup(200.0) * 0.001))
    assert header_of(library.contents[source.address]) == header_of(expected)


def test_the_address_is_the_hash_of_the_bytes_and_the_same_each_time(tmp_path: Path) -> None:
    (tmp_path / "a.stl").write_bytes(stl(drum()))
    mesh = Mesh("a.stl")
    first, second = load(tmp_path, mesh), load(tmp_path, mesh)
    assert first == second
    (content,) = first.contents.values()
    assert hashlib.sha256(content).hexdigest() == first.addresses[mesh].address


def test_the_same_content_is_kept_once(tmp_path: Path) -> None:
    for name in ("a.stl", "b.stl"):
        (tmp_path / name).write_bytes(stl(cube_soup()))
    library = load(tmp_path, Mesh("a.stl"), Mesh("b.stl"))
    assert len(library.addresses) == 2
    assert len(library.contents) == 1


def test_another_scale_is_another_mesh(tmp_path: Path) -> None:
    (tmp_path / "a.stl").write_bytes(stl(cube_soup()))
    small, large = Mesh("a.stl", 0.5), Mesh("a.stl", 2.0)
    library = load(tmp_path, small, large)
    assert library.addresses[small].high == pytest.approx((0.5, 0.5, 0.5))
    assert library.addresses[large].high == pytest.approx((2.0, 2.0, 2.0))
    assert len(library.contents) == 2


def test_unchanged_files_are_taken_from_an_earlier_library(tmp_path: Path) -> None:
    (tmp_path / "a.stl").write_bytes(stl(cube_soup()))
    mesh = Mesh("a.stl")
    known = load(tmp_path, mesh)
    address = known.addresses[mesh].address
    marked = replace(known, contents={address: b"taken over"})
    assert load_meshes(tmp_path, cell_with(mesh), known=marked).contents == {address: b"taken over"}
    (tmp_path / "a.stl").write_bytes(stl(cube_soup(3.0)))
    assert load_meshes(tmp_path, cell_with(mesh), known=marked).addresses[mesh].high == pytest.approx(
        (3, 3, 3)
    )


def test_colours_of_a_file_are_kept_in_linear_light(tmp_path: Path) -> None:
    (tmp_path / "a.ply").write_bytes(ply(colours="255 128 0"))
    (content,) = load(tmp_path, Mesh("a.ply")).contents.values()
    header = header_of(content)
    accessor = header["accessors"][header["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"]]
    view = header["bufferViews"][accessor["bufferView"]]
    start = len(content) - header["buffers"][0]["byteLength"] + view["byteOffset"]
    assert tuple(content[start : start + 4]) == (255, 56, 0, 255)  # (128/255)^2.2 = 0.2195


FINDINGS = [
    ("gone.stl", "X880", "is not in the project folder"),
    ("folder", "X880", "is no ordinary file"),
    ("bad\0name.stl", "X880", "cannot be opened"),
    ("cut.stl", "X881", "promises 12 triangles and holds 10"),
    ("empty.stl", "X881", ""),
    ("empty.obj", "X881", ""),
    ("points.ply", "X881", "holds no triangles"),
    ("flat.stl", "X881", "holds no triangles"),
    ("nan.stl", "X881", "holds coordinates that are no numbers"),
    ("noise.glb", "X881", "cannot be read as GLB"),
    ("../outside.stl", "U962", "leads out of the project folder"),
    ("/etc/hostname", "U962", "leads out of the project folder"),
    ("C:\\geometry\\a.stl", "U962", "leads out of the project folder"),
    ("a\\..\\..\\outside.stl", "U962", "leads out of the project folder"),
    ("link.stl", "U962", "is a link that leads out of the project folder"),
    ("round.stl", "X880", "cannot be opened"),
    ("large.stl", "X883", "has 60 MB, at most 50 MB are read"),
    ("long.stl", "X885", "is 5e+03 m long with the scale 1"),
]


@pytest.fixture(scope="module")
def bad_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    outer = tmp_path_factory.mktemp("bad")
    folder = outer / "project"
    (folder / "folder").mkdir(parents=True)
    cube = stl(cube_soup())
    (outer / "outside.stl").write_bytes(cube)
    (folder / "link.stl").symlink_to(outer / "outside.stl")
    (folder / "round.stl").symlink_to(folder / "round.stl")
    broken = cube_soup()
    broken[3, 1, 2] = np.nan
    flat = cube_soup()
    flat[:, 2] = flat[:, 1]
    points = (
        b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
    )
    files = {
        "cut.stl": cube[:-60],
        "empty.stl": b"",
        "empty.obj": b"",
        "points.ply": points + b"end_header\n0 0 0\n",
        "flat.stl": stl(flat),
        "nan.stl": stl(broken),
        "noise.glb": bytes(range(256)) * 4,
        "long.stl": stl(cube_soup(5000.0)),
    }
    for name, content in files.items():
        (folder / name).write_bytes(content)
    with (folder / "large.stl").open("wb") as stream:
        os.truncate(stream.fileno(), 60_000_000)
    return folder


@pytest.mark.parametrize(("name", "code", "words"), FINDINGS, ids=[repr(name) for name, *_ in FINDINGS])
def test_what_cannot_be_drawn_is_told(bad_folder: Path, name: str, code: str, words: str) -> None:
    mesh = Mesh(name)
    library = load(bad_folder, mesh)
    (found,) = library.diagnostics
    assert (found.code, found.is_error) == (code, code == "U962")
    assert words in found.message
    assert (library.addresses[mesh].address, dict(library.contents)) == ("", {})
    assert library.addresses[mesh].missing in found.message


def test_one_bad_mesh_does_not_hide_the_others(bad_folder: Path) -> None:
    (bad_folder / "good.stl").write_bytes(stl(cube_soup()))
    library = load(bad_folder, Mesh("gone.stl"), Mesh("good.stl"))
    assert len(library.contents) == 1
    document: Any = scene(cell_with(Mesh("gone.stl"), Mesh("good.stl")), library.addresses)
    (thing,) = [body for body in document["bodies"] if body["kind"] == "object"]
    gone, good = thing["shapes"]
    assert (gone["mesh"], gone["missing"]) == ("", "is not in the project folder")
    assert (good["mesh"] in library.contents, good["missing"]) == (True, "")


def test_a_near_name_is_offered(bad_folder: Path) -> None:
    assert "did you mean `cut.stl`?" in load(bad_folder, Mesh("cat.stl")).diagnostics[0].hint


def test_a_finding_points_at_the_path_in_the_cell_file(tmp_path: Path) -> None:
    lines = [
        '[robot]\nmodel = "puma560"\n[[objects]]\nname = "o"\nposition = [0, 0, 0]',
        'shapes = [{ box = [1, 1, 1] }, { mesh = "gone.stl" }]\n',
    ]
    text = SourceText("cell.toml", "\n".join(lines))
    cell, _ = read_cell(text, "folder")
    assert cell is not None
    (found,) = load_meshes(tmp_path, cell, partial(mesh_in_files, (text,))).diagnostics
    assert found.span is not None
    assert (found.span.line, lines[1][found.span.column - 1 : found.span.end_column - 1]) == (6, '"gone.stl"')


def test_more_triangles_than_views_can_turn_are_drawn_with_a_warning(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a.stl").write_bytes(stl(drum()))
    (tmp_path / "b.stl").write_bytes(stl(cube_soup()))
    monkeypatch.setattr(meshes, "TRIANGLE_BUDGET", 130)
    library = load(tmp_path, Mesh("a.stl"), Mesh("b.stl"))
    (found,) = library.diagnostics
    assert (found.code, found.is_error) == ("X884", False)
    assert "140 triangles" in found.message
    assert "`a.stl` has 128" in found.hint
    assert len(library.contents) == 2


def test_opening_a_project_reads_no_mesh(tmp_path: Path) -> None:
    text = '[robot]\nmodel = "puma560"\n[tools.t]\nshapes = [{ mesh = "gone.stl" }]\n'
    cell, findings = read_cell(SourceText("cell.toml", text), "folder")
    assert findings == ()
    assert cell is not None
    assert [found.code for found in load_meshes(tmp_path, cell).diagnostics] == ["X880"]
