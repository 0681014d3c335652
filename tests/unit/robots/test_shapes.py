"""Shapes of the built-in robots: neighbours touch in every posture, published lengths are kept."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from ropsim import robots
from ropsim.kinematics import joint_frames
from ropsim.model import Shape
from ropsim.spatial import Array
from support.arm_capsules import PUMA_CAPSULES, Capsule
from support.built_in import WRITTEN
from support.solids import STEP, surface_points

POSTURES = 4
SEED = 7


def points_of(shapes: tuple[Shape, ...]) -> Array:
    return np.concatenate([surface_points(shape) for shape in shapes])


def gap(a: Array, b: Array) -> float:
    """Return the least distance of two clouds of points [m]; infinite where it is `STEP` or more."""
    low = np.maximum(a.min(axis=0), b.min(axis=0)) - STEP
    high = np.minimum(a.max(axis=0), b.max(axis=0)) + STEP
    a, b = (cloud[((cloud > low) & (cloud < high)).all(axis=1)] for cloud in (a, b))
    return float(cKDTree(b).query(a, distance_upper_bound=STEP)[0].min()) if len(a) and len(b) else np.inf


@pytest.mark.slow
@pytest.mark.parametrize("name", [*WRITTEN, "irb120", "kr6_r900_2", "lr_mate_200id", "panda", "tx60", "ur3e"])
def test_neighbouring_links_touch_in_every_posture(name: str) -> None:
    robot = robots.load(name)
    seen = [link for link in robot.links if link.shapes]  # cranks that only count an axis come last
    clouds = [points_of(robot.base_shapes), *(points_of(link.shapes) for link in seen)]
    rng = np.random.default_rng(SEED)
    for q in (robot.home, *rng.uniform(robot.lower_limits, robot.upper_limits, (POSTURES, robot.n))):
        frames = (np.eye(4), *joint_frames(robot, q)[: len(seen)])
        placed = [cloud @ X[:3, :3].T + X[:3, 3] for cloud, X in zip(clouds, frames, strict=True)]
        pairs = [
            (joint.parent + 1, number) for number, joint in enumerate(robot.joints[: len(seen)], start=1)
        ]
        gaps = [gap(placed[one], placed[other]) for one, other in pairs]
        assert max(gaps) < STEP, [f"{value:.3f}" for value in gaps]


@pytest.mark.parametrize("name", robots.names())
def test_the_axis_of_every_joint_runs_through_its_link(name: str) -> None:
    for link in robots.load(name).links:
        if not link.shapes:
            continue
        cloud = points_of(link.shapes)
        assert (cloud[:, :2].min(axis=0) < -0.02).all()
        assert (cloud[:, :2].max(axis=0) > 0.02).all()


def test_the_flange_of_the_puma_ends_where_the_maker_says() -> None:
    # Flange face to wrist centre: 2.2 in or 56.25 mm in the maker's drawing.
    flange = points_of(robots.load("puma560").links[5].shapes)
    assert flange[:, 2].max() == pytest.approx(0.05625, abs=1e-12)


def test_the_puma_stands_on_the_floor() -> None:
    assert points_of(robots.load("puma560").base_shapes)[:, 2].min() == 0.0


def test_the_forearm_of_the_puma_hides_behind_its_upper_arm_without_cutting_it() -> None:
    robot = robots.load("puma560")
    upper, fore = points_of(robot.links[1].shapes), points_of(robot.links[2].shapes)
    beyond_hub = upper[upper[:, 0] > 0.15]  # the upper arm, without the hub at the shoulder
    assert fore[:, 2].max() <= beyond_hub[:, 2].min() + 1e-12


@pytest.mark.parametrize("name", robots.names())
def test_shapes_are_opaque_and_of_written_colours(name: str) -> None:
    robot = robots.load(name)
    shapes = [*robot.base_shapes, *(shape for link in robot.links for shape in link.shapes)]
    assert shapes
    for shape in shapes:
        assert shape.opacity == 1.0
        assert len(bytes.fromhex(shape.colour.removeprefix("#"))) == 3


def test_the_drawn_shapes_are_said_to_be_estimated() -> None:
    (origin,) = [origin for origin in robots.load("puma560").origins if origin.parameters == "drawn shapes"]
    assert origin.kind == "estimated"


def test_all_that_is_drawn_of_the_links_of_the_puma_lies_in_its_capsules() -> None:
    for number, (link, capsules) in enumerate(
        zip(robots.load("puma560").links, PUMA_CAPSULES, strict=True), start=1
    ):
        cloud = points_of(link.shapes)
        outside = np.min([from_capsule(cloud, one) for one in capsules], axis=0)
        assert outside.max() < 1e-9, f"link {number}"


def from_capsule(points: Array, capsule: Capsule) -> Array:
    start, end = np.array(capsule.start), np.array(capsule.end)
    share = np.clip((points - start) @ (end - start) / ((end - start) @ (end - start)), 0.0, 1.0)
    apart: Array = np.linalg.norm(points - start - share[:, np.newaxis] * (end - start), axis=1)
    return apart - capsule.radius
