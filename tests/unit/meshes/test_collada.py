"""COLLADA files: triangles at their places in the scene, colours of materials, refusals in words."""

import numpy as np
import pytest

from ropsim.meshes.testing import UNCOLOURED, MeshFileError, Soup, read_collada
from ropsim.spatial import Array
from support.meshes import NODE, POLYLIST, STRIP, TRIANGLES, collada

SIDE = np.array([[[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 0], [0, 1, 0]]], float)
"""The triangles of `TRIANGLES`."""
MATERIAL = (
    '<library_effects><effect id="e"><profile_COMMON><technique><phong><diffuse><color>1 0.5 0 1</color>'
    '</diffuse></phong></technique></profile_COMMON></effect></library_effects><library_materials>'
    '<material id="orange"><instance_effect url="#e"/></material></library_materials>'
)  # fmt: skip
BOUND = NODE.replace(
    'url="#g"/>',
    'url="#g"><bind_material><technique_common><instance_material symbol="m" target="#orange"/>'
    "</technique_common></bind_material></instance_geometry>",
)


def area(soup: Soup) -> Array:
    """Return the sum of the area vectors: size and side of a flat surface."""
    corners = soup.corners
    found = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]).sum(axis=0) / 2.0
    return np.asarray(found)


def test_triangles_of_every_kind_cover_the_same_side() -> None:
    np.testing.assert_array_equal(read_collada(collada()).corners, SIDE)
    for shapes in (TRIANGLES, POLYLIST, STRIP, POLYLIST.replace("polylist", "polygons")):
        soup = read_collada(collada(shapes))
        assert len(soup.corners) == 2
        np.testing.assert_allclose(area(soup), [0.0, 0.0, 1.0])


def test_corners_with_normals_and_textures_keep_the_points() -> None:
    more = '<input semantic="NORMAL" source="#none" offset="1"/>'
    shapes = TRIANGLES.replace("<p>", f"{more}<p>").replace("0 4 2 4 6 2", "0 9 4 9 2 9 4 9 6 9 2 9")
    np.testing.assert_array_equal(read_collada(collada(shapes)).corners, SIDE)


def test_frames_of_nodes_are_carried_out_in_their_order_and_the_unit_comes_last() -> None:
    """Place p = unit · T · R · S · p₀, for a node in a node that is used once more by another."""
    steps = "<translate>10 0 0</translate><rotate>0 0 1 90</rotate><scale>2 3 1</scale>"
    again = f'<node><matrix>{_MOVED}</matrix><instance_node url="#a"/></node>'
    nodes = f'<node id="a">{steps}<node>{NODE}</node></node>{again}'
    soup = read_collada(collada(nodes=nodes, unit="0.01"))
    turned = SIDE * [2.0, 3.0, 1.0] @ np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    expected = np.concatenate([np.add(turned, [10.0, 0.0, z]) for z in (0.0, 7.0)])
    np.testing.assert_allclose(soup.corners, 0.01 * expected, atol=1e-15)


_MOVED = "1 0 0 0 0 1 0 0 0 0 1 7 0 0 0 1"


def test_a_mirrored_node_keeps_its_outside() -> None:
    soup = read_collada(collada(nodes=NODE.replace("<node>", "<node><scale>-1 1 1</scale>")))
    np.testing.assert_allclose(area(soup), [0.0, 0.0, 1.0])


def test_colours_of_materials_are_kept_and_others_are_grey() -> None:
    soup = read_collada(collada(TRIANGLES + POLYLIST, BOUND, MATERIAL))
    assert soup.colours is not None
    assert [tuple(row) for row in soup.colours[:, 0].tolist()] == [(255, 128, 0, 255)] * 2 + [UNCOLOURED] * 2
    assert read_collada(collada()).colours is None


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is not XML"),
        (b"<a/>", "is no COLLADA file"),
        (b"<!DOCTYPE a [<!ENTITY b 'c'>]><COLLADA/>", "has a document type"),
        (b'<?xml version="1.0" encoding="ebcdic"?><COLLADA/>', "cannot be read as XML"),
        (collada(TRIANGLES.replace("0 4 2 4 6 2", "0 4 8")), "has a face at point 8, points are"),
        (collada(TRIANGLES.replace("0 4 2 4 6 2", "0 4 x")), "not whole numbers"),
        (collada(POLYLIST.replace("<vcount>4", "<vcount>5")), "more corners than it says"),
        (collada().replace(b'count="8" stride="3"', b'count="9" stride="3"'), "has 24 numbers for 9 points"),
        (collada().replace(b'"#points"', b'"#nowhere"'), "has faces without points"),
        (collada().replace(b"float_array", b"name_array"), "has points without numbers"),
        (collada(TRIANGLES.replace('offset="0"', 'offset="-1"')), "has offset='-1' in `input`"),
        (collada(unit="wide"), "has the unit `wide`"),
        (collada(nodes=""), "holds no triangles"),
        (collada(nodes=NODE.replace("<node>", "<node><matrix>1 2</matrix>")), "has a `matrix` of 2 numbers"),
        (collada(nodes=NODE.replace("<node>", '<node id="n"><instance_node url="#n"/>')), "20,000 nodes"),
    ],
)  # fmt: skip
def test_what_is_damaged_is_refused_in_words(content: bytes, words: str) -> None:
    with pytest.raises(MeshFileError) as found:
        read_collada(content)
    assert words in found.value.found


def test_nodes_that_multiply_themselves_are_refused_in_bounded_time() -> None:
    doubled = "".join(
        f'<node id="n{k}"><instance_node url="#n{k + 1}"/><instance_node url="#n{k + 1}"/></node>'
        for k in range(40)
    )
    with pytest.raises(MeshFileError):
        read_collada(collada(nodes=doubled))


def test_references_to_other_files_are_not_followed() -> None:
    with pytest.raises(MeshFileError, match="holds no triangles"):
        read_collada(collada(nodes=NODE.replace("#g", "file:///etc/passwd#g")))
