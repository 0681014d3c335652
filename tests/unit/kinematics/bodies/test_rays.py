"""Rays against boxes and upright cylinders: distances that are known, and points that are found."""

import numpy as np
import pytest

from ropsim.kinematics import nearest_along, shape_blocks
from ropsim.model import Box, Cylinder, Shape
from ropsim.spatial import Pose

ROUNDING = 1e-12
DOWN = np.array([0.0, 0.0, -1.0])


def box(edge: float, pose: Pose) -> dict[str, list[Shape]]:
    return {"a": [Shape(Box((edge, edge, edge)), pose)]}


def at(x: float, y: float, z: float) -> Pose:
    return Pose(np.array([x, y, z]))


def test_a_ray_meets_the_face_that_it_comes_to_first() -> None:
    cube = [Shape(Box((1.0, 1.0, 1.0)))]
    blocks = shape_blocks({"low": cube, "high": cube}, {"low": Pose(), "high": at(0.0, 0.0, 2.0)})
    assert nearest_along(blocks, np.array([0.1, 0.2, 5.0]), DOWN) == pytest.approx(2.5, abs=ROUNDING)
    assert nearest_along(blocks, np.array([0.1, 0.2, -5.0]), -DOWN) == pytest.approx(4.5, abs=ROUNDING)


def test_a_ray_that_passes_by_or_leads_away_meets_nothing() -> None:
    blocks = shape_blocks(box(1.0, Pose()), {"a": Pose()})
    assert nearest_along(blocks, np.array([0.6, 0.0, 5.0]), DOWN) == np.inf
    assert nearest_along(blocks, np.array([0.0, 0.0, 5.0]), -DOWN) == np.inf
    assert nearest_along(shape_blocks({}, {}), np.zeros(3), DOWN) == np.inf


def test_a_ray_that_begins_in_a_block_is_at_its_surface() -> None:
    blocks = shape_blocks(box(1.0, Pose()), {"a": Pose()})
    assert nearest_along(blocks, np.array([0.1, 0.0, 0.2]), DOWN) == 0.0


def test_an_upright_cylinder_is_round() -> None:
    blocks = shape_blocks({"a": [Shape(Cylinder(0.5, 1.0))]}, {"a": Pose()})
    ahead = np.array([1.0, 0.0, 0.0])
    found = nearest_along(blocks, np.array([-2.0, 0.3, 0.0]), ahead)
    assert found == pytest.approx(2.0 - 0.4, abs=ROUNDING)  # 0.3² + 0.4² = 0.5²
    assert nearest_along(blocks, np.array([0.45, 0.45, 2.0]), DOWN) == np.inf
    assert nearest_along(blocks, np.array([0.3, 0.3, 2.0]), DOWN) == pytest.approx(1.5, abs=ROUNDING)


def test_points_found_lie_on_the_surface_of_a_turned_box() -> None:
    generator = np.random.default_rng(5)
    met = 0
    for _ in range(200):
        orientation = generator.normal(size=4)
        pose = Pose(generator.normal(size=3), orientation / np.linalg.norm(orientation))
        blocks = shape_blocks({"a": [Shape(Box((0.8, 0.6, 0.4)))]}, {"a": pose})
        origin = generator.normal(size=3) * 3.0
        direction = pose.position + 0.4 * generator.normal(size=3) - origin
        direction /= np.linalg.norm(direction)
        found = nearest_along(blocks, origin, direction)
        far = np.linspace(0.0, 12.0, 4001)
        ways = origin + far[:, None] * direction
        inside = np.all(np.abs((ways - pose.position) @ pose.rotation()) <= [0.4, 0.3, 0.2], axis=1)
        if found == np.inf:
            assert not inside.any()
            continue
        met += 1
        share = np.abs(pose.rotation().T @ (origin + found * direction - pose.position)) / [0.4, 0.3, 0.2]
        assert found == 0.0 or share.max() == pytest.approx(1.0, abs=1e-9)
        assert not inside[far < found - 1e-9].any()
    assert met > 10
