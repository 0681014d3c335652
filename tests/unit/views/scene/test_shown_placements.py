"""What a page is told of bodies that hang on others: their place on the link that carries them."""

from typing import Any

import numpy as np
import pytest

from ropsim.flow import Placement
from ropsim.kinematics import body_poses
from ropsim.model import FixedObject, Gripper, Part, Tool, body_tree
from ropsim.robots import default_controller, load
from ropsim.spatial import Pose, frozen
from ropsim.views import ShownPlacements
from support.cells import one_station

ARM = load("puma560")
ROUNDING = 1e-12
CELL = one_station(
    "c",
    ARM,
    default_controller("puma560"),
    X_WB=Pose(np.array([0.3, 0.0, 0.1])),
    tools={"jaws": Tool("jaws", gripper=Gripper(0.2, 0.2, 0.005))},
    default_tool="jaws",
    objects=(FixedObject("table", Pose(np.array([0.0, 0.5, 0.4]), np.array([0.8, 0.0, 0.0, 0.6])), ()),),
    parts=tuple(Part(name, np.full(3, 0.1), 1.0, Pose(np.array([0.1, 0.2, 0.5]))) for name in ("a", "b")),
)
TREE = body_tree(CELL)
X = Pose(np.array([0.01, 0.02, 0.03]), np.array([0.9, 0.1, 0.0, 0.1]))
Y = Pose(np.array([-0.2, 0.0, 0.1]), np.array([0.7, 0.0, 0.7, 0.1]))


def told(*placements: Placement) -> list[tuple[str, dict[str, Any]]]:
    shown = ShownPlacements(TREE)
    return [entry for one in placements for entry in shown.take(one)]


def test_a_part_on_the_tool_rides_on_the_last_link() -> None:
    ((name, entry),) = told(Placement(1.5, "a", "tool:jaws", X))
    assert (name, entry["time"], entry["parent"], entry["visible"]) == ("a", 1.5, 6, True)
    assert entry["pose"] == pytest.approx(list((ARM.X_nM @ X).as_tuple()), abs=ROUNDING)


def test_a_part_on_an_object_is_told_in_the_world() -> None:
    ((_, entry),) = told(Placement(0.0, "a", "table", X))
    assert entry["parent"] == -1
    assert entry["pose"] == pytest.approx(list((CELL.objects[0].X_PO @ X).as_tuple()), abs=ROUNDING)


def test_what_lies_on_a_part_is_told_again_when_that_is_taken() -> None:
    entries = told(Placement(0.0, "b", "a", Y), Placement(2.0, "a", "tool:jaws", X))
    assert [(name, one["time"], one["parent"]) for name, one in entries] == [
        ("b", 0.0, -1),
        ("a", 2.0, 6),
        ("b", 2.0, 6),
    ]
    pose = Pose(frozen(entries[-1][1]["pose"][:3]), frozen(entries[-1][1]["pose"][3:]))
    q = {"robot": ARM.home[None]}
    poses = body_poses(TREE, q, ["link6", "b"], {"b": ("a", Y), "a": ("tool:jaws", X)})
    np.testing.assert_allclose(poses["link6"][0] @ pose.matrix(), poses["b"][0], atol=ROUNDING)


def test_of_links_and_of_bodies_that_the_cell_lacks_nothing_is_told() -> None:
    assert (
        told(Placement(0.0, "link1", "base", X), Placement(0.0, "z", "", X), Placement(0.0, "a", "z", X))
        == []
    )


def test_a_part_that_is_gone_is_seen_no_more() -> None:
    ((_, entry),) = told(Placement(3.0, "a", "", X, visible=False))
    assert entry["visible"] is False
