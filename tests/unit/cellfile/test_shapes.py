"""Shapes of the cell file: every element in SI units, and what a wrong one is answered."""

import numpy as np
import pytest

from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.model import Box, Cell, Cylinder, Material, Mesh, Polyline, Prism, Revolve, Shape, Sphere
from ropsim.tomltext import UNKNOWN_CHOICE

ROBOT = '[robot]\nmodel = "puma560"\n'
OBJECT = ROBOT + '[[objects]]\nname = "o"\nposition = [100, 200, 300]\n'
PARTS = '[[parts]]\nname = "p"\nsize = [60, 60, 40]\nmass = 0.5\nposition = [0, 0, 0]\n'


def cell_of(text: str) -> Cell:
    cell, findings = read_cell(SourceText("cell.toml", text), "folder")
    assert findings == ()
    assert cell is not None
    return cell


def shape_of(text: str) -> Shape:
    (thing,) = cell_of(OBJECT + f"shapes = [{{ {text} }}]\n").objects
    (shape,) = thing.shapes
    return shape


def one(text: str) -> Diagnostic:
    _, (found,) = read_cell(SourceText("cell.toml", text), "folder")
    return found


SOLIDS = [
    ("box = [10, 20, 30]", Box((0.01, 0.02, 0.03))),
    ("cylinder = { radius = 10, length = 500 }", Cylinder(0.01, 0.5, 0.01)),
    ("cylinder = { radius = 10, length = 500, top = 0 }", Cylinder(0.01, 0.5, 0.0)),
    ("sphere = { radius = 10 }", Sphere(0.01)),
    ("revolve = [[0, 0], [10, 0], [10, 50]]", Revolve(((0.0, 0.0), (0.01, 0.0), (0.01, 0.05)))),
    ("revolve = [[10, 50], [10, 0], [0, 0]]", Revolve(((0.0, 0.0), (0.01, 0.0), (0.01, 0.05)))),
    (
        "prism = { outline = [[0, 0], [1000, 0], [0, 1000]], length = 100 }",
        Prism(((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)), 0.1),
    ),
    (
        "prism = { outline = [[0, 1000], [1000, 0], [0, 0]], length = 100 }",  # clockwise, turned round
        Prism(((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)), 0.1),
    ),
    ("line = [[0, 0, 0], [0, 0, 1000]]", Polyline(((0.0, 0.0, 0.0), (0.0, 0.0, 1.0)))),
    (
        "polygon = [[0, 0, 0], [1000, 0, 0], [0, 0, 1000]]",
        Polyline(((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0))),
    ),
    ('mesh = "geometry/a.stl"', Mesh("geometry/a.stl", 0.001)),
    ('mesh = "geometry/a.GLB"', Mesh("geometry/a.GLB", 1.0)),
    ('mesh = "geometry/a.ply", scale = 0.0254', Mesh("geometry/a.ply", 0.0254)),
]


@pytest.mark.parametrize(("text", "solid"), SOLIDS, ids=[text for text, _ in SOLIDS])
def test_every_element_is_read_in_metres(text: str, solid: object) -> None:
    found = shape_of(text).solid
    assert type(found) is type(solid)
    assert found == solid or np.allclose(_numbers(found), _numbers(solid), atol=1e-15)


def _numbers(solid: object) -> list[float]:
    values: list[float] = []
    for name in getattr(solid, "__slots__", ()):
        values.extend(np.ravel(np.array(getattr(solid, name), dtype=np.float64)).tolist())
    return values


def test_an_arc_is_drawn_between_its_angles_in_degrees() -> None:
    solid = shape_of("arc = { radius = 100, from = 0, to = 90 }").solid
    assert isinstance(solid, Polyline)
    assert solid.points[0] == pytest.approx((0.1, 0.0, 0.0))
    assert solid.points[-1] == pytest.approx((0.0, 0.1, 0.0), abs=1e-12)


def test_a_circle_is_a_closed_line() -> None:
    solid = shape_of("circle = { radius = 100 }").solid
    assert isinstance(solid, Polyline)
    assert solid.points[0] == pytest.approx(solid.points[-1], abs=1e-12)


def test_a_shape_has_its_own_place_and_look() -> None:
    shape = shape_of(
        'box = [1, 1, 1], position = [0, 0, 500], rpy = [0, 90, 0], colour = "#AABBCC", opacity = 0.5'
    )
    assert shape.pose.position == pytest.approx([0.0, 0.0, 0.5])
    assert shape.pose.rotation()[:, 2] == pytest.approx([1.0, 0.0, 0.0])
    assert (shape.colour, shape.opacity) == ("#aabbcc", 0.5)


def test_the_look_of_an_object_holds_for_shapes_without_one() -> None:
    shapes = "shapes = [{ box = [1, 1, 1] }, { sphere = { radius = 1 }, opacity = 1 }]"
    (thing,) = cell_of(OBJECT + 'colour = "#010203"\nopacity = 0.25\n' + shapes).objects
    assert [(shape.colour, shape.opacity) for shape in thing.shapes] == [("#010203", 0.25), ("#010203", 1.0)]


def test_a_material_holds_for_an_object_or_for_one_shape() -> None:
    shapes = 'shapes = [{ box = [1, 1, 1] }, { sphere = { radius = 1 }, material = "rubber" }]'
    (thing,) = cell_of(OBJECT + 'material = "wood"\n' + shapes).objects
    assert [shape.material for shape in thing.shapes] == [Material.WOOD, Material.RUBBER]
    (part,) = cell_of(ROBOT + PARTS + 'material = "cardboard"\n').parts
    assert part.material is Material.CARDBOARD


def test_an_unknown_material_is_answered_with_the_known_ones() -> None:
    found = one(OBJECT + 'shapes = [{ box = [1, 1, 1], material = "gold" }]\n')
    assert found.code == UNKNOWN_CHOICE.code
    for material in Material:
        assert f"`{material.value}`" in found.message


def test_the_short_form_is_a_box_below_its_position() -> None:
    (thing,) = cell_of(OBJECT + "size = [100, 200, 50]\n").objects
    (shape,) = thing.shapes
    assert shape.solid == Box((0.1, 0.2, 0.05))
    assert shape.pose.position == pytest.approx([0.0, 0.0, -0.025])
    assert thing.X_PO.position == pytest.approx([0.1, 0.2, 0.3])


def test_objects_stay_in_the_world_wherever_the_base_stands() -> None:
    text = OBJECT.replace(ROBOT, ROBOT + "base = { position = [100, 0, 0], rpy = [0, 0, 90] }\n")
    (thing,) = cell_of(text + "size = [1, 1, 1]\n").objects
    assert thing.X_PO.position == pytest.approx([0.1, 0.2, 0.3])


def test_tools_have_shapes_and_parts_have_colours() -> None:
    tool = '[tools.t]\nposition = [0, 0, 100]\ncolour = "#123456"\nshapes = [{ box = [10, 10, 100] }]\n'
    supply = '[[supplies]]\nname = "s"\nsize = [1, 1, 1]\nmass = 0\nposition = [0, 0, 0]\ncount = 2\n'
    cell = cell_of(ROBOT + tool + PARTS + 'colour = "#abcdef"\n' + supply + 'colour = "#654321"\n')
    assert cell.first.tools["t"].shapes[0].colour == "#123456"
    assert [part.colour for part in cell.parts] == ["#abcdef", "#654321", "#654321"]


MISTAKES = [
    ('colour = "orange", box = [1, 1, 1]', "X886", '"orange"', "#c9ced3"),
    ('colour = "#12345", box = [1, 1, 1]', "X886", '"#12345"', ""),
    ("opacity = 1.5, box = [1, 1, 1]", "X806", "1.5", ""),
    ("position = [0, 0, 0]", "X887", "{ position = [0, 0, 0] }", "`box`, `cylinder`"),
    ("bx = [1, 1, 1]", "X802", "bx", "did you mean `box`?"),
    ("box = [1, 1, 1], sphere = { radius = 1 }", "X812", "sphere", "its own"),
    ("box = [1, 1]", "X805", "[1, 1]", ""),
    ("box = [1, 1, 0]", "X806", "0", ""),
    ("cylinder = { radius = 1 }", "X803", "cylinder", "add `length`"),
    ("cylinder = { radius = 1, length = 1, tip = 0 }", "X802", "tip", "`top`"),
    ("cylinder = 3", "X804", "3", ""),
    ("sphere = { radius = -1 }", "X806", "-1", ""),
    ("line = [[0, 0, 0]]", "X805", "[[0, 0, 0]]", ""),
    ("line = [[0, 0, 0], [0, 0]]", "X805", "[0, 0]", ""),
    ("line = [[0, 0, 0], 'a']", "X804", "'a'", ""),
    ("line = 3", "X804", "3", ""),
    ("revolve = [[0, 0], [-1, 5]]", "X806", "-1", ""),
    ("revolve = [[0, 0], [0, 5]]", "X887", "[[0, 0], [0, 5]]", "[radius, height]"),
    (
        "prism = { outline = [[0, 0], [1, 1], [2, 2]], length = 1 }",
        "X887",
        "[[0, 0], [1, 1], [2, 2]]",
        "once",
    ),
    (
        "prism = { outline = [[0, 0], [9, 9], [9, 0], [0, 9]], length = 1 }",
        "X887",
        "[[0, 0], [9, 9], [9, 0], [0, 9]]",
        "once",
    ),
    ('mesh = "a.step"', "X808", '"a.step"', ""),
    ("mesh = 3", "X804", "3", ""),
    ('mesh = "a.stl", scale = 0', "X806", "0", ""),
    ("scale = 2, box = [1, 1, 1]", "X802", "scale", ""),
]


@pytest.mark.parametrize(("text", "code", "marked", "hint"), MISTAKES, ids=[text for text, *_ in MISTAKES])
def test_a_wrong_shape_is_answered_with_its_place(text: str, code: str, marked: str, hint: str) -> None:
    whole = OBJECT + f"shapes = [{{ {text} }}]\n"
    found = one(whole)
    assert found.code == code
    assert found.span is not None
    line = whole.split("\n")[found.span.line - 1]
    assert line[found.span.column - 1 : found.span.end_column - 1] == marked
    assert hint in found.hint


def test_crossing_edges_are_named() -> None:
    found = one(
        OBJECT + "shapes = [{ prism = { outline = [[0, 0], [9, 9], [9, 0], [0, 9]], length = 1 } }]\n"
    )
    assert "edges 1 and 3" in found.message


def test_an_object_needs_shapes_or_a_size() -> None:
    assert one(OBJECT).code == "X803"
    assert one(OBJECT + "size = [1, 1, 1]\nshapes = []\n").code == "X812"


def test_two_objects_of_one_name_are_noticed() -> None:
    twice = (
        OBJECT + "size = [1, 1, 1]\n" + '[[objects]]\nname = "o"\nposition = [0, 0, 0]\nsize = [1, 1, 1]\n'
    )
    found = one(twice)
    assert "`o` is taken" in found.message
    assert found.span is not None
    assert found.span.line == 8


def test_a_wrong_colour_of_a_part_is_noticed() -> None:
    assert one(ROBOT + PARTS + 'colour = "red"\n').code == "X886"
