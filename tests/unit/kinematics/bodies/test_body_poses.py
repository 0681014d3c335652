"""Where bodies are: links follow the joints, all else the body that it hangs on."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim import robots
from ropsim.kinematics import body_poses, forward, frames_batch
from ropsim.model import (
    Body,
    BodyKind,
    FixedObject,
    Part,
    Tool,
    body_tree,
    carrier,
    link_name,
    tool_body,
)
from ropsim.spatial import Array, Pose
from support.cells import one_station
from support.examples import examples

ARM = robots.load("puma560")
ROUNDING = 1e-12
"""Of a few products of poses with coordinates of some metres."""


def at(x: float, y: float, z: float, turn: float = 0.0) -> Pose:
    return Pose(np.array([x, y, z]), np.array([np.cos(turn / 2), 0.0, 0.0, np.sin(turn / 2)]))


CELL = one_station(
    "c",
    ARM,
    robots.default_controller("puma560"),
    X_WB=at(0.3, -0.2, 0.5, 0.7),
    tools={"jaws": Tool("jaws", at(0.0, 0.0, 0.1))},
    objects=(
        FixedObject("cup", at(0.01, 0.02, 0.03, 0.2), (), parent="plate"),
        FixedObject("plate", at(0.1, 0.0, 0.05, 0.5), (), parent="table"),
        FixedObject("table", at(1.0, 2.0, 0.7, 0.3), ()),
    ),
    parts=(Part("box", np.full(3, 0.05), 0.1, at(0.4, 0.5, 0.6, 0.1)),),
)
TREE = body_tree(CELL)
SOME = np.random.default_rng(5).uniform(ARM.lower_limits, ARM.upper_limits, (4, ARM.n))


def test_links_are_where_forward_kinematics_has_them() -> None:
    poses = body_poses(TREE, {"robot": SOME})
    expected = CELL.first.X_WB.matrix() @ frames_batch(ARM, SOME)
    for number in range(1, ARM.n + 1):
        np.testing.assert_array_equal(poses[link_name(number)], expected[:, number - 1])


def test_the_body_of_a_tool_is_the_mechanical_interface() -> None:
    found = body_poses(TREE, {"robot": SOME}, [tool_body("jaws")])
    assert list(found) == ["tool:jaws"]
    for X_WM, q in zip(found["tool:jaws"], SOME, strict=True):
        np.testing.assert_allclose(X_WM, (CELL.first.X_WB @ forward(ARM, q)).matrix(), atol=ROUNDING)


def test_an_object_rides_on_its_parent_wherever_that_stands_in_the_file() -> None:
    table, plate, cup = (CELL.objects[k].X_PO for k in (2, 1, 0))
    poses = body_poses(TREE, {"robot": SOME})
    for name, expected in (("table", table), ("plate", table @ plate), ("cup", table @ plate @ cup)):
        np.testing.assert_allclose(poses[name][0], expected.matrix(), atol=ROUNDING)
        assert poses[name].shape == (4, 4, 4)


def test_what_stands_still_takes_no_memory_of_its_own_for_each_row() -> None:
    poses = body_poses(TREE, {"robot": np.repeat(SOME, 1000, axis=0)})
    assert {name for name, pose in poses.items() if pose.strides[0]} == {
        *TREE.names(BodyKind.LINK, BodyKind.TOOL)
    }


def test_without_coordinates_the_bodies_that_no_joint_moves_are_known() -> None:
    poses = body_poses(TREE, {}, ["cup", "base"])
    np.testing.assert_allclose(poses["base"], CELL.first.X_WB.matrix()[None], atol=0.0)


@settings(max_examples=examples(30), derandomize=True, deadline=None)
@given(st.sampled_from(["table", "cup", "link3", "tool:jaws", "base"]), st.integers(0, 3))
def test_hanging_a_part_on_another_body_leaves_it_where_it_is(parent: str, row: int) -> None:
    q = {"robot": SOME[row : row + 1]}
    before = body_poses(TREE, q)
    X_PO = np.linalg.inv(before[parent][0]) @ before["box"][0]
    after = body_poses(TREE, q, elsewhere={"box": (parent, Pose.from_matrix(X_PO))})
    np.testing.assert_allclose(after["box"], before["box"], atol=ROUNDING)


def test_a_part_on_a_link_keeps_its_place_on_it() -> None:
    X_PO = at(0.1, 0.2, 0.3, 0.4)
    poses = body_poses(TREE, {"robot": SOME}, elsewhere={"box": ("tool:jaws", X_PO)})
    np.testing.assert_allclose(poses["box"], poses["tool:jaws"] @ X_PO.matrix(), atol=ROUNDING)


def moving(tree_names: tuple[str, ...], poses: dict[str, Array]) -> Array:
    return np.stack([poses[name] for name in tree_names])


@pytest.mark.parametrize("name", ["first", "zz"])
def test_another_object_in_the_cell_changes_nothing_of_the_others(name: str) -> None:
    more = replace(CELL, objects=(FixedObject(name, at(3.0, 0.0, 0.0), ()), *CELL.objects))
    one, other = body_poses(TREE, {"robot": SOME}), body_poses(body_tree(more), {"robot": SOME})
    names = tuple(one)
    np.testing.assert_array_equal(moving(names, one), moving(names, other))


def test_bodies_ride_on_the_nearest_one_that_a_joint_moves() -> None:
    bodies = TREE.by_name()
    assert carrier(bodies, {}, "cup") == ""
    assert carrier(bodies, {}, "tool:jaws") == "link6"
    assert carrier(bodies, {"box": "tool:jaws"}, "box") == "link6"
    assert carrier(bodies, {"box": "cup", "cup": "link2"}, "box") == "link2"


def test_equal_cells_have_equal_trees() -> None:
    assert body_tree(replace(CELL)) == TREE
    assert replace(TREE, bodies=(*TREE.bodies, Body("x", BodyKind.OBJECT, "", Pose()))) != TREE
