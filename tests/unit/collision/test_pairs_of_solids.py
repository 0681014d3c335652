"""Distances of pairs of solids: proved by planes between them, by another engine, and by laws."""

from itertools import combinations

import mujoco
import numpy as np
import numpy.typing as npt
import pytest

from ropsim.collision import Nearness, SolidBodies, convexes
from ropsim.model import Box, Cylinder, Mesh, Prism, Revolve, Shape, Solid, Sphere
from ropsim.spatial import Array, Pose

EXACT = 1e-9
"""[m]: what the kernel leaves uncertain, and rounding."""
OTHER = 1e-6
"""[m]: to this MuJoCo iterates."""
RANDOM = np.random.default_rng(7)
CLOUD = Mesh("cloud.stl")
POINTS = RANDOM.normal(size=(40, 3)) * [0.1, 0.06, 0.08]
SHAPES: dict[str, Solid] = {
    "box": Box((0.2, 0.3, 0.1)),
    "cylinder": Cylinder(0.08, 0.3),
    "sphere": Sphere(0.1),
    "mesh": CLOUD,
    "cone": Cylinder(0.1, 0.2, 0.0),
    "bottle": Revolve(((0.0, -0.1), (0.06, -0.1), (0.08, 0.0), (0.05, 0.1), (0.0, 0.1))),
    "prism": Prism(((0.0, 0.0), (0.2, 0.0), (0.0, 0.1)), 0.15),
}
SOLIDS = SolidBodies({name: convexes(Shape(solid), {CLOUD: POINTS}) for name, solid in SHAPES.items()})
NAMES = list(SHAPES)
Rows = npt.NDArray[np.intp]
PAIRS: Rows = np.array(list(combinations(range(len(NAMES)), 2)))


def somewhere(spread: float) -> dict[str, Array]:
    """Return random poses within a cube [m]."""
    return {name: Pose(RANDOM.uniform(-spread, spread, 3), RANDOM.normal(size=4)).matrix() for name in NAMES}


def found(poses: dict[str, Array], pairs: Rows = PAIRS) -> list[Nearness]:
    placed = SOLIDS.placed(poses)
    rows = SOLIDS.distances(placed, pairs, np.zeros(len(pairs)), (np.inf, np.inf))
    return [SOLIDS.nearness(placed, pair, row) for pair, row in zip(pairs.tolist(), rows, strict=True)]


def reach(name: str, X: Array, direction: Array) -> float:
    """Return how far a solid reaches along a direction in the world [m]."""
    convex = SOLIDS.convexes[NAMES.index(name)]
    point = X[:3, :3] @ convex.farthest(direction @ X[:3, :3]) + X[:3, 3]
    return float(point @ direction) + convex.margin


@pytest.mark.parametrize("spread", [0.25, 1.0])
def test_a_plane_between_two_solids_proves_their_distance_and_one_for_depth_that_they_can_be_parted(
    spread: float,
) -> None:
    for _ in range(6):
        poses = somewhere(spread)
        for one in found(poses):
            assert np.linalg.norm(one.point_other - one.point_one) == pytest.approx(
                abs(one.distance), abs=EXACT
            )
            away = (one.point_other - one.point_one) / one.distance
            between = -reach(one.other, poses[one.other], -away) - reach(one.one, poses[one.one], away)
            assert between == pytest.approx(one.distance, abs=10 * EXACT)


def test_another_engine_finds_the_same_distances_and_depths() -> None:
    asset = f'<mesh name="m" vertex="{" ".join(map(str, POINTS.ravel()))}"/>'
    geoms = (
        'type="box" size=".1 .15 .05"',
        'type="cylinder" size=".08 .15"',
        'type="sphere" size=".1"',
        'type="mesh" mesh="m"',
    )
    bodies = "".join(
        f'<body name="{n}" mocap="true"><geom name="{n}" {g}/></body>'
        for n, g in zip(NAMES, geoms, strict=False)
    )
    text = f"<mujoco><asset>{asset}</asset><worldbody>{bodies}</worldbody></mujoco>"
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    pairs = np.array(list(combinations(range(4), 2)))
    for spread in (0.3, 0.12):
        for _ in range(8):
            poses = somewhere(spread)
            for k in range(4):
                data.mocap_pos[k], data.mocap_quat[k] = (
                    Pose.from_matrix(poses[NAMES[k]]).as_tuple()[:3],
                    Pose.from_matrix(poses[NAMES[k]]).as_tuple()[3:],
                )
            mujoco.mj_kinematics(model, data)
            for (i, j), one in zip(pairs.tolist(), found(poses, pairs), strict=True):
                theirs = mujoco.mj_geomDistance(model, data, i, j, 10.0, None)
                assert one.distance == pytest.approx(theirs, abs=OTHER), one.pair


def test_distances_are_the_same_both_ways_and_wherever_the_whole_is() -> None:
    poses = somewhere(0.4)
    X = Pose(RANDOM.normal(size=3), RANDOM.normal(size=4)).matrix()
    here, back = found(poses), found(poses, PAIRS[:, ::-1].copy())
    moved = found({name: X @ pose for name, pose in poses.items()})
    for one, other, there in zip(here, back, moved, strict=True):
        assert other.distance == pytest.approx(one.distance, abs=EXACT)
        assert there.distance == pytest.approx(one.distance, abs=EXACT)
        if one.distance > 0.0:
            assert X[:3, :3] @ one.point_one + X[:3, 3] == pytest.approx(there.point_one, abs=1e-4)


def test_a_solid_that_is_shifted_changes_a_distance_by_the_shift_at_most() -> None:
    poses = somewhere(0.3)
    shift = RANDOM.normal(size=3) * 0.05
    there = {name: pose.copy() for name, pose in poses.items()}
    there["box"][:3, 3] += shift
    length = float(np.linalg.norm(shift))
    for one, other in zip(found(poses), found(there), strict=True):
        assert abs(other.distance - one.distance) <= (length + EXACT if "box" in one.pair else EXACT)


@pytest.mark.parametrize(("height", "expected"), [(0.1, 0.0), (0.1 + 1e-4, 1e-4), (0.09, -0.01)])
def test_boxes_that_stand_on_each_other_are_as_far_apart_as_they_look(height: float, expected: float) -> None:
    (box,) = convexes(Shape(Box((0.2, 0.3, 0.1))))
    two = SolidBodies({"lower": (box,), "upper": (box,)})
    poses = {"lower": np.eye(4), "upper": Pose(np.array([0.02, 0.0, height])).matrix()}
    placed, pair = two.placed(poses), np.array([[0, 1]])
    row = two.distances(placed, pair, np.zeros(1), (np.inf, np.inf))[0]
    assert two.nearness(placed, [0, 1], row).distance == pytest.approx(expected, abs=EXACT)


def test_boxes_around_solids_never_say_more_than_the_distance() -> None:
    for _ in range(10):
        poses = somewhere(0.3)
        bounds = SOLIDS.bounds(SOLIDS.placed(poses), PAIRS)
        for bound, one in zip(bounds, found(poses), strict=True):
            assert bound <= max(one.distance, 0.0) + EXACT


def test_a_hollow_profile_is_cut_where_it_is_hollow_and_a_bulging_one_is_one_solid() -> None:
    spool = Revolve(((0.1, 0.0), (0.1, 0.1), (0.02, 0.1), (0.02, 0.4), (0.1, 0.4), (0.1, 0.5)))
    rod = Shape(Sphere(0.05), Pose(np.array([0.1, 0.0, 0.25])))
    cut = SolidBodies({"spool": convexes(Shape(spool)), "ball": convexes(rod)})
    assert len(cut.rows["spool"]) == 3
    assert len(convexes(Shape(SHAPES["bottle"]))) == 1
    rows = np.array([(k, 3) for k in range(3)])
    gaps = cut.distances(
        cut.placed({"spool": np.eye(4), "ball": np.eye(4)}), rows, np.zeros(3), (np.inf, np.inf)
    )
    assert gaps[:, 0].min() - 0.05 == pytest.approx(0.1 - 0.02 - 0.05, abs=EXACT)


def two(one: Solid, other: Solid, pose: Pose) -> Nearness:
    """Return how near a solid is to another one that stands at a pose of its frame."""
    bodies = SolidBodies({"one": convexes(Shape(one)), "other": convexes(Shape(other))})
    placed, pair = bodies.placed({"one": np.eye(4), "other": pose.matrix()}), np.array([[0, 1]])
    row = bodies.distances(placed, pair, np.zeros(1), (np.inf, np.inf))[0]
    return bodies.nearness(placed, [0, 1], row)


@pytest.mark.parametrize(
    ("lengths", "place"), [((0.01, 0.005), (0.025, -0.15000000000000002)), ((0.1, 0.02), (0.1, 0.05))]
)
@pytest.mark.parametrize("scale", [1.0, 1e3])
def test_cylinders_with_one_axis_direction_are_in_each_other_as_deep_as_their_heights_say(
    lengths: tuple[float, float], place: tuple[float, float], scale: float
) -> None:
    low, high = (Cylinder(0.5 * scale, length * scale) for length in lengths)
    found = two(low, high, Pose(np.array([*place, 0.0]) * scale))
    assert found.distance == pytest.approx(-sum(lengths) / 2.0 * scale, abs=EXACT * scale)


def test_bodies_of_a_hundred_metres_have_a_depth_too_and_it_parts_them() -> None:
    random = np.random.default_rng(4)
    for _ in range(32):
        one, other = (Cylinder(100 * random.uniform(0.2, 2.0), 100 * random.uniform(0.01, 2.0)) for _ in "ab")
        pose = Pose(100 * random.uniform(-0.5, 0.5, 3), random.normal(size=4))
        found = two(one, other, pose)
        away = (found.point_other - found.point_one) / found.distance
        (first,), (second,) = convexes(Shape(one)), convexes(Shape(other))
        R = pose.matrix()[:3, :3]
        low = (R @ second.farthest(-away @ R) + pose.position) @ away
        assert low - first.farthest(away) @ away == pytest.approx(found.distance, abs=1e-7)


def test_a_corner_of_a_profile_that_bends_once_makes_one_cut() -> None:
    runs = [
        one.points[:, :2].tolist() for one in convexes(Shape(Revolve(((0.1, 0.0), (0.05, 0.1), (0.1, 0.2)))))
    ]
    assert runs == [[[0.1, 0.0], [0.05, 0.1]], [[0.05, 0.1], [0.1, 0.2]]]


@pytest.mark.parametrize("distance", [0.7, 0.35, 0.29, 0.1])
def test_the_nearest_points_of_two_balls_lie_on_each_of_them(distance: float) -> None:
    """Along the line between their centres, at the radius of each, be they apart or in each other."""
    small, large = 0.05, 0.25
    way = distance * np.array([2.0, -1.0, 2.0]) / 3.0
    near = two(Sphere(small), Sphere(large), Pose(way))
    assert near.distance == pytest.approx(distance - small - large, abs=EXACT)
    assert near.point_one == pytest.approx(way * small / distance, abs=EXACT)
    assert near.point_other == pytest.approx(way * (1.0 - large / distance), abs=EXACT)


@pytest.mark.parametrize("depth", [0.0, 0.01, 0.04])
def test_a_bound_by_boxes_is_as_negative_as_the_boxes_are_deep(depth: float) -> None:
    """Deeper pairs come before those that touch, in the order of their bounds."""
    (box,) = convexes(Shape(Box((0.2, 0.3, 0.1))))
    placed = SolidBodies({"one": (box,), "other": (box,)})
    poses = {"one": np.eye(4), "other": Pose(np.array([0.05, 0.1, 0.1 - depth])).matrix()}
    assert placed.bounds(placed.placed(poses), np.array([[0, 1]]))[0] == pytest.approx(-depth, abs=EXACT)
