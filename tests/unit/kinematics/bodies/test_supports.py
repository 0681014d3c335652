"""What parts stand on: boxes, round and tilted supports, other parts, the floor."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.kinematics import Blocks, Standing, height_above, part_blocks, shape_blocks, stacked, standings
from ropsim.model import WORLD, Box, Cylinder, Mesh, Part, Polyline, Prism, Revolve, Shape, Solid, Sphere
from ropsim.spatial import Pose
from support.examples import examples

GAP = 0.005
ROUNDING = 1e-9


def at(x: float, y: float, z: float, pitch: float = 0.0, yaw: float = 0.0) -> Pose:
    turned = Pose(np.zeros(3), np.array([np.cos(yaw / 2), 0.0, 0.0, np.sin(yaw / 2)]))
    leaned = Pose(np.zeros(3), np.array([np.cos(pitch / 2), 0.0, np.sin(pitch / 2), 0.0]))
    return Pose(np.array([x, y, z])) @ turned @ leaned


def part(pose: Pose, name: str = "p", size: tuple[float, float, float] = (0.06, 0.06, 0.04)) -> Blocks:
    return part_blocks([(Part(name, np.array(size), 0.1, pose), pose)])


def thing(solid: Solid, pose: Pose, name: str = "table") -> Blocks:
    return shape_blocks({name: (Shape(solid),)}, {name: pose})


TABLE = thing(Box((1.0, 0.6, 0.1)), at(0.0, 0.0, 0.65))
"""Its top is at 0.7 m."""


def one(block: Blocks, others: Blocks, gap: float = GAP) -> Standing:
    (found,) = standings(block, others, gap)
    return found


@pytest.mark.parametrize(
    ("height", "on"), [(0.0, "table"), (0.0049, "table"), (0.0051, None), (-0.001, "table")]
)
def test_a_part_within_the_gap_stands_on_the_table(height: float, on: str | None) -> None:
    assert one(part(at(0.1, 0.1, 0.74 + height)), TABLE).on == on


def test_a_part_beside_the_table_does_not_stand_on_it() -> None:
    assert one(part(at(0.0, 0.331, 0.74)), TABLE).on is None
    assert one(part(at(0.0, 0.3289, 0.74)), TABLE).on is None  # 1.1 mm of it over the edge of the table
    assert one(part(at(0.0, 0.32, 0.74)), TABLE).on == "table"


@pytest.mark.parametrize("height", [0.0, 0.004])
def test_a_part_stands_on_the_floor(height: float) -> None:
    assert one(part(at(3.0, 0.0, 0.04 + height)), TABLE).on == WORLD


def test_a_part_on_a_slope_stands_on_it() -> None:
    X_WS = at(0.3, 0.2, 0.5, pitch=0.14, yaw=0.7)
    slope = thing(Box((1.0, 0.2, 0.02)), X_WS @ Pose(np.array([0.0, 0.0, -0.01])))
    assert one(part(X_WS @ Pose(np.array([0.2, 0.0, 0.04]))), slope) == Standing("table")
    assert one(part(X_WS @ Pose(np.array([0.2, 0.0, 0.05]))), slope).on is None


def test_a_round_table_carries_only_where_it_is() -> None:
    round_ = thing(Cylinder(0.5, 0.1), at(0.0, 0.0, 0.65))
    assert one(part(at(0.3, 0.3, 0.74)), round_).on == "table"
    assert one(part(at(0.45, 0.45, 0.74)), round_).on is None


@pytest.mark.parametrize(
    ("solid", "top"),
    [
        (Sphere(0.2), 0.2),
        (Cylinder(0.2, 0.3, 0.1), 0.15),
        (Revolve(((0.0, 0.0), (0.2, 0.0), (0.2, 0.1))), 0.1),
        (Prism(((-0.2, -0.2), (0.2, -0.2), (0.0, 0.2)), 0.3), 0.3),
    ],
)
def test_other_shapes_carry_at_the_top_of_the_box_around_them(solid: Solid, top: float) -> None:
    assert one(part(at(0.1, 0.1, 0.5 + top + 0.04)), thing(solid, at(0.0, 0.0, 0.5))).on == "table"


@pytest.mark.parametrize("solid", [Mesh("a.stl"), Polyline(((0.0, 0.0, 0.0), (1.0, 0.0, 0.0)))])
def test_meshes_and_lines_carry_nothing(solid: Solid) -> None:
    assert thing(solid, Pose()).owners == ()


def test_the_depth_is_how_much_higher_a_part_would_be_free() -> None:
    found = one(part(at(0.0, 0.0, 0.728)), TABLE)
    assert (found.on, found.inside) == ("table", "table")
    assert found.depth == pytest.approx(0.012, abs=ROUNDING)


@pytest.mark.parametrize("order", [1, -1])
def test_a_part_is_inside_what_it_is_the_deepest_in(order: int) -> None:
    deep = thing(Box((0.1, 0.1, 0.1)), at(-0.05, 0.0, 0.65), "deep")
    shallow = thing(Box((0.1, 0.1, 0.096)), at(0.05, 0.0, 0.648), "shallow")  # 4 mm lower
    found = one(part(at(0.0, 0.0, 0.735)), stacked([deep, shallow][::order]))
    assert found.inside == "deep"
    assert found.depth == pytest.approx(0.005, abs=ROUNDING)


def test_parts_that_touch_at_their_sides_are_not_in_each_other() -> None:
    rows = [part(at(0.06 * k, 0.0, 0.74), f"p{k}") for k in range(4)]
    assert {found.inside for found in standings(stacked(rows), stacked([TABLE, *rows]), GAP)} == {""}


def test_a_part_on_a_part_stands_on_that_one() -> None:
    low, high = part(at(0.0, 0.0, 0.74), "low"), part(at(0.02, 0.01, 0.78, yaw=0.4), "high")
    both = stacked([low, high])
    assert [found.on for found in standings(both, stacked([TABLE, both]), GAP)] == ["table", "low"]


def test_the_height_above_what_is_next_below() -> None:
    shelf = thing(Box((0.4, 0.4, 0.02)), at(0.0, 0.0, 0.3), "shelf")
    others = stacked([TABLE, shelf])
    for x, z, expected, name in (
        (0.0, 0.84, 0.1, "table"),
        (0.0, 0.44, 0.09, "shelf"),
        (2.0, 0.44, 0.4, WORLD),
    ):
        height, below = height_above(part(at(x, 0.0, z)), 0, others)
        assert height == pytest.approx(expected, abs=ROUNDING)
        assert below == name


PLACES = st.tuples(st.floats(-0.4, 0.4), st.floats(-0.25, 0.25), st.floats(0.7, 0.9), st.floats(-3.0, 3.0))


@settings(max_examples=examples(40), derandomize=True, deadline=None)
@given(st.lists(PLACES, min_size=1, max_size=30))
def test_many_parts_stand_as_each_one_alone_would(places: list[tuple[float, float, float, float]]) -> None:
    parts = stacked(part(at(x, y, z, yaw=yaw), f"p{k}") for k, (x, y, z, yaw) in enumerate(places))
    everything = stacked([TABLE, parts])
    together = standings(parts, everything, GAP)
    for k, (x, y, z, yaw) in enumerate(places):
        assert one(part(at(x, y, z, yaw=yaw), f"p{k}"), everything) == together[k]


@settings(max_examples=examples(40), derandomize=True, deadline=None)
@given(st.lists(PLACES, min_size=2, max_size=30))
def test_nothing_stands_on_itself_in_the_end(places: list[tuple[float, float, float, float]]) -> None:
    parts = stacked(part(at(x, y, z, yaw=yaw), f"p{k}") for k, (x, y, z, yaw) in enumerate(places))
    on = {f"p{k}": found.on for k, found in enumerate(standings(parts, stacked([TABLE, parts]), 0.1))}
    for name in on:
        way = [name]
        while (below := on.get(way[-1])) is not None:
            assert below not in way
            way.append(below)


@settings(max_examples=examples(20), derandomize=True, deadline=None)
@given(st.lists(PLACES, min_size=1, max_size=20))
def test_an_object_elsewhere_changes_nothing(places: list[tuple[float, float, float, float]]) -> None:
    parts = stacked(part(at(x, y, z, yaw=yaw), f"p{k}") for k, (x, y, z, yaw) in enumerate(places))
    far = thing(Box((1.0, 1.0, 1.0)), at(5.0, 5.0, 0.5), "far")
    here = stacked([TABLE, parts])
    assert standings(parts, stacked([far, here]), GAP) == standings(parts, here, GAP)


def test_two_parts_that_cross_do_not_stand_on_each_other() -> None:
    size = (0.2, 0.06, 0.01)
    crossed = stacked(
        [part(at(0.0, 0.0, 1.0, pitch), name, size) for name, pitch in (("a", 0.3), ("b", -0.3))]
    )
    one_, other = standings(crossed, crossed, 0.1)
    assert not (one_.on == "b" and other.on == "a")


def test_the_floor_is_not_below_a_part_under_it_where_something_else_is() -> None:
    cellar = thing(Box((0.4, 0.4, 0.02)), at(0.0, 0.0, -0.5), "cellar")
    height, below = height_above(part(at(0.0, 0.0, -0.3)), 0, cellar)
    assert (below, height > 0.0) == ("cellar", True)
    height, below = height_above(part(at(2.0, 0.0, -0.3)), 0, cellar)
    assert (below, height < 0.0) == (WORLD, True)
