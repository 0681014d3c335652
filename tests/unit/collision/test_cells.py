"""Distances in a cell: which bodies are looked at, which are not and why, what the nearest two are."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from ropsim import robots
from ropsim.collision import Collisions, LeftOut, distance, in_collision
from ropsim.kinematics import NotFiniteError, inverse
from ropsim.model import Box, Cell, FixedObject, Mesh, Part, Rates, Shape, Sphere, Station, Tool
from ropsim.robots.standard_controller import standard_controller
from ropsim.spatial import Array, Pose
from ropsim.workbench.testing import CellCollisions

UP = 1.0
"""Height of the robot's base [m]."""
JAWS = Tool(
    "jaws",
    Pose(np.array([0.0, 0.0, 0.15])),
    shapes=(Shape(Box((0.04, 0.06, 0.08)), Pose(np.array([0.0, 0.0, 0.11]))),),
)
CUBE = Part("cube", np.array([0.05, 0.05, 0.05]), 0.1, Pose(np.array([2.0, 0.0, 0.05])))


def block(name: str, size: tuple[float, float, float], *position: float) -> FixedObject:
    return FixedObject(name, Pose(np.array(position)), (Shape(Box(size)),))


@cache
def cell() -> Cell:
    robot = robots.load("puma560")
    station = Station(
        "robot",
        robot,
        standard_controller(robot, Rates()),
        Pose(np.array([0.0, 0.0, UP])),
        {"jaws": JAWS},
        "jaws",
    )
    pedestal = block("pedestal", (0.3, 0.3, UP), 0.0, 0.0, UP / 2.0)
    sign = FixedObject("sign", Pose(np.array([0.0, 3.0, 0.0])), (Shape(Mesh("sign.stl")),))
    return Cell("c", {"robot": station}, parts=(CUBE,), objects=(pedestal, sign))


@cache
def collisions() -> Collisions:
    return Collisions(cell())


PLACE = np.array([0.45, 0.1, 0.9])
"""Where the TCP stands [m]."""


@cache
def standing() -> Array:
    """Return joint coordinates at which the tool points down at its place [rad], shape (6,)."""
    station = cell().first
    down = Pose(PLACE, np.array([0.0, 1.0, 0.0, 0.0]))
    X_BM = station.X_WB.inverse() @ down @ JAWS.X_MT.inverse()
    return np.asarray(inverse(station.robot, X_BM).solutions[0])


def test_what_touches_by_its_build_is_left_out_with_its_reason() -> None:
    found = collisions().separation(cell().first.robot.home)
    why = {
        ("base", "pedestal"): LeftOut.FIXED,
        ("link6", "tool:jaws"): LeftOut.FIXED,
        ("base", "link1"): LeftOut.NEIGHBOURS,
        ("link2", "link3"): LeftOut.NEIGHBOURS,
    }
    assert {pair: found.left_out.get(pair) for pair in why} == why
    assert {("link1", "pedestal"), ("link1", "link3"), ("tool:jaws", "cube")} <= set(found.pairs)
    assert not set(found.pairs) & set(found.left_out)


def test_a_mesh_that_nobody_has_read_is_told_and_one_that_is_known_counts() -> None:
    home = cell().first.robot.home
    assert collisions().separation(home).unseen == ("sign",)
    points = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-2.5, 0.0) for z in (0.0, 2.0)])
    assert distance(cell(), home, {Mesh("sign.stl"): points}).unseen == ()
    assert in_collision(
        cell(), np.array([np.pi / 2.0, 0.0, np.pi / 2.0, 0.0, 0.0, 0.0]), {Mesh("sign.stl"): points}
    )


@pytest.mark.parametrize("gap", [0.004, -0.01])
def test_the_nearest_two_are_named_with_their_distance_and_their_points_in_the_world(gap: float) -> None:
    table = block("table", (0.1, 0.1, 0.02), *(PLACE - [0.0, 0.0, gap + 0.01]))
    found = distance(replace(cell(), objects=(table,)), standing())
    assert found.nearest is not None
    assert found.nearest.pair == ("tool:jaws", "table")
    assert found.distance == pytest.approx(gap, abs=1e-7)
    assert found.nearest.point_one[2] == pytest.approx(PLACE[2])
    assert found.nearest.point_other[2] == pytest.approx(PLACE[2] - gap)


def test_a_part_hangs_on_its_gripper_without_touching_it_and_meets_what_is_in_its_way() -> None:
    held = {"cube": ("tool:jaws", JAWS.X_MT @ Pose(orientation=np.array([0.0, 1.0, 0.0, 0.0])))}
    found = collisions().separation(standing(), held)
    assert found.left_out["tool:jaws", "cube"] is LeftOut.FIXED
    assert ("link5", "cube") in found.pairs
    assert collisions().meetings(standing(), held) == ()
    post = replace(cell(), objects=(block("post", (0.02, 0.02, 0.02), *(PLACE - [0.0, 0.0, 0.02])),))
    assert {one.pair for one in Collisions(post).meetings(standing(), held)} == {("post", "cube")}
    assert Collisions(post).meetings(standing(), held, absent=["post"]) == ()


def test_an_arm_that_folds_into_its_base_is_in_collision() -> None:
    assert not in_collision(cell(), cell().first.robot.home)
    assert in_collision(cell(), np.array([0.6, -0.8, -2.7, -0.1, 1.4, 4.3]))


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_coordinates_that_are_no_numbers_are_refused(value: float) -> None:
    q = np.array([0.0, 0.0, value, 0.0, 0.0, 0.0])
    for look in (collisions().separation, collisions().meetings):
        with pytest.raises(NotFiniteError):
            look(q)


@pytest.mark.parametrize(
    "points",
    [np.zeros((0, 3)), np.vstack([np.eye(3), [[np.nan, 0.0, 0.0]]])],
    ids=["no point", "not a number"],
)
def test_a_mesh_without_points_that_are_all_numbers_is_not_looked_at_and_told(points: Array) -> None:
    found = Collisions(cell(), {Mesh("sign.stl"): points}).separation(standing())
    assert found.unseen == ("sign",)
    assert found.distance == collisions().separation(standing()).distance


def test_what_is_absent_once_is_there_again_and_a_micrometre_tells_meeting_from_touching() -> None:
    for depth, pairs in ((5e-7, set()), (5e-5, {("tool:jaws", "table")})):
        table = block("table", (0.1, 0.1, 0.02), *(PLACE - [0.0, 0.0, 0.01 - depth]))
        looked = Collisions(replace(cell(), objects=(table,)))
        assert looked.meetings(standing(), absent=["table"]) == ()
        assert {one.pair for one in looked.meetings(standing())} == pairs


def test_a_tool_that_is_in_its_arm_at_rest_is_never_looked_at_against_it_and_tasks_say_so() -> None:
    beam = replace(JAWS, shapes=(Shape(Box((0.9, 0.9, 0.04)), Pose(np.array([0.0, 0.0, 0.06]))),))
    drawn = replace(cell(), stations={"robot": replace(cell().first, tools={"jaws": beam})})
    looked = Collisions(drawn)
    assert ("link2", "tool:jaws") in looked.at_rest
    assert looked.separation(standing()).left_out["link2", "tool:jaws"] is LeftOut.AT_REST
    told = "`link2` against the tool `jaws`, since they are in each other at rest"
    assert told in CellCollisions(drawn, {}).unchecked
    assert not any("at rest" in one for one in CellCollisions(cell(), {}).unchecked)


def ball(name: str, radius: float, *position: float) -> FixedObject:
    return FixedObject(name, Pose(np.array(position)), (Shape(Sphere(radius)),))


@pytest.mark.parametrize("depth", [1e-3, 5e-6, -5e-6])
def test_balls_meet_where_their_surfaces_do(depth: float) -> None:
    """They are points with a margin: the points are apart, the balls are not."""
    radius = 0.05
    looked = Collisions(replace(cell(), objects=(ball("ball", radius, *(PLACE - [0, 0, radius - depth])),)))
    pairs = {one.pair for one in looked.meetings(standing())}
    assert pairs == ({("tool:jaws", "ball")} if depth > 0.0 else set())
    nearest = looked.separation(standing()).nearest
    assert nearest is not None
    assert nearest.pair == ("tool:jaws", "ball")
    assert nearest.distance == pytest.approx(-depth, abs=1e-7)


def test_the_nearest_of_all_is_the_deepest_and_a_large_ball_is_nearer_than_its_centre() -> None:
    table = block("table", (0.1, 0.1, 0.02), *(PLACE - [0.0, 0.0, 0.01 - 0.004]))
    post = block("post", (0.02, 0.02, 0.02), *(PLACE - [0.0, 0.0, 0.01 - 0.007]))
    for objects in ((table, post), (post, table)):
        found = Collisions(replace(cell(), objects=objects)).separation(standing())
        assert found.nearest is not None
        assert found.nearest.other == "post"
        assert found.distance == pytest.approx(-0.007, abs=1e-7)
    near = block("near", (0.1, 0.1, 0.02), *(PLACE - [0.0, 0.0, 0.01 + 0.010]))
    large = ball("large", 0.5, *(PLACE - [0.0, 0.0, 0.5 + 0.008]))
    found = Collisions(replace(cell(), objects=(near, large))).separation(standing(), absent=["cube"])
    assert found.nearest is not None
    assert found.nearest.other == "large"


def test_of_two_that_are_in_the_tool_the_deeper_one_counts_though_boxes_say_the_other_one() -> None:
    """A block across cuts a corner of the jaws by 2 mm; the boxes along x, y, z overlap by 67 mm."""
    n = np.array([1.0, 1.0, 0.0]) / np.sqrt(2.0)
    reach = (0.02 + 0.03) / np.sqrt(2.0)
    place = PLACE + (reach + 0.1 - 0.002) * n + [0.0, 0.0, 0.04]
    turned = Pose(place, np.array([np.cos(np.pi / 8), 0.0, 0.0, np.sin(np.pi / 8)]))
    across = FixedObject("across", turned, (Shape(Box((0.2, 0.2, 0.06))),))
    post = block("post", (0.02, 0.02, 0.02), *(PLACE - [0.0, 0.0, 0.01 - 0.007]))
    alone = Collisions(replace(cell(), objects=(across,))).separation(standing())
    assert alone.distance == pytest.approx(-0.002, abs=1e-7)
    found = Collisions(replace(cell(), objects=(across, post))).separation(standing())
    assert found.distance == pytest.approx(-0.007, abs=1e-7)
