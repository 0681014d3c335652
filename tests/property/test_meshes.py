"""Any bytes at all, under the name of a mesh, give triangles or a finding, never another exception."""

import struct
from math import isfinite

from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.meshes import MESH_FORMATS
from ropsim.meshes.testing import MeshFileError, glb_bytes, read_mesh, shaded
from ropsim.model import Mesh
from support.examples import examples
from support.meshes import cube_soup, obj, ply, stl, stl_text

ENDINGS = sorted(MESH_FORMATS)
SEEDS = (
    ("a.stl", stl(cube_soup())),
    ("a.stl", stl_text(cube_soup())),
    ("a.obj", obj()),
    ("a.ply", ply(colours="1 2 3")),
    ("a.glb", glb_bytes(shaded(cube_soup()))),
)


def read(name: str, content: bytes) -> None:
    try:
        found = read_mesh(content, Mesh(name))
    except MeshFileError:
        return
    assert all(isfinite(value) for value in found.points.reshape(-1).tolist())
    assert int(found.faces.max()) < len(found.points)
    assert struct.unpack_from("<4s", glb_bytes(found)) == (b"glTF",)


@given(st.sampled_from(ENDINGS), st.binary(max_size=400))
@settings(max_examples=examples(60))
def test_random_bytes_are_answered(ending: str, content: bytes) -> None:
    read(f"a{ending}", content)


@given(
    st.sampled_from(SEEDS),
    st.lists(st.tuples(st.floats(0.0, 1.0), st.binary(max_size=8)), min_size=1, max_size=6),
    st.floats(0.0, 1.0),
)
@settings(max_examples=examples(150))
def test_damaged_files_are_answered(
    seed: tuple[str, bytes], patches: list[tuple[float, bytes]], keep: float
) -> None:
    name, content = seed
    damaged = bytearray(content[: max(1, int(len(content) * max(keep, 0.3)))])
    for place, patch in patches:
        at = int(place * len(damaged))
        damaged[at : at + len(patch)] = patch
    read(name, bytes(damaged))
