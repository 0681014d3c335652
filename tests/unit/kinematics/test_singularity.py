"""Distances to singularities: their product is the determinant of the Jacobian."""

from math import sin

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim import robots
from ropsim.kinematics import SingularDistances, jacobian, near_singularity, singular_distances, solver_of
from ropsim.kinematics.testing import SphericalWristSolver

PUMA = robots.load("puma560")
ANGLES = st.lists(st.floats(-3.1, 3.1), min_size=6, max_size=6)
LOST = 5e-3
"""Least singular value of the Jacobian at which a motion of the tool takes joints too fast [m, rad]."""
ROUNDING = 1e-12  # of a determinant of numbers of the order of 1


def distances(q: list[float]) -> SingularDistances:
    left = singular_distances(PUMA, q)
    assert left is not None
    return left


@given(q=ANGLES)
def test_the_determinant_of_the_jacobian_is_their_product(q: list[float]) -> None:
    left = distances(q)
    solver = solver_of(PUMA)
    assert isinstance(solver, SphericalWristSolver)
    upper, fore = solver.arm.lengths[3:]
    product = upper * fore * sin(left.elbow) * left.shoulder * sin(left.wrist)
    assert abs(np.linalg.det(jacobian(PUMA, q))) == pytest.approx(product, abs=ROUNDING)


def test_a_straight_wrist_is_0_and_a_bent_one_its_angle() -> None:
    for angle in (0.0, 0.3, -0.3):
        left = distances([0, -1, 1, 0.4, angle, 0])
        assert left.wrist == pytest.approx(abs(angle), abs=1e-12)


def test_an_arm_without_a_spherical_wrist_has_none() -> None:
    assert singular_distances(robots.load("two_link"), [0.1, 0.2]) is None


@pytest.mark.parametrize("name", ["puma560", "irb120", "ur5e"])
def test_wherever_joints_lose_a_direction_of_the_tool_a_near_singularity_is_named(name: str) -> None:
    robot, rng = robots.load(name), np.random.default_rng(3)
    seen = set()
    for q in rng.uniform(-2.0, 2.0, (3000, 6)):
        near = near_singularity(robot, q)
        seen.add(near)
        least = float(np.linalg.svd(jacobian(robot, q), compute_uv=False)[-1])
        assert near != "" or least > LOST
    assert seen == {"", "wrist", "elbow", "shoulder"}


def test_an_arm_of_another_class_names_no_singularity() -> None:
    assert near_singularity(robots.load("two_link"), [0.1, 0.0]) == ""
    assert near_singularity(robots.load("scara"), robots.load("scara").home) == ""
