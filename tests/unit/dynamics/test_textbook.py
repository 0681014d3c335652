"""The recursions against slow formulas that share no code with them: Jacobians and energies."""

import numpy as np
import pytest

from ropsim.codegen import Engine
from ropsim.dynamics import compiled
from ropsim.model import RobotModel
from ropsim.spatial import Array
from support.arms import potential_energy, random_arm, random_states, textbook_mass_matrix

ROUNDING = 1e-10  # torques up to 1e3 in double arithmetic, chains of six
DIFFERENCE = 1e-5  # step of central differences; their error is below 1e-6 of torques up to 1e3
DIFFERENCE_TOLERANCE = 2e-5

CHAINS = ["R", "P", "RR", "RP", "PR", "PP", "RRR", "PRP", "RPRPRP", "RRRRRR"]


def _mass_matrix(robot: RobotModel, q: Array) -> Array:
    out = np.empty(robot.n**2)
    compiled(robot, engine=Engine.PYTHON).mass_matrix(q, out)
    return out.reshape(robot.n, robot.n)


def _inverse(robot: RobotModel, q: Array, qd: Array, qdd: Array) -> Array:
    out = np.empty(robot.n)
    compiled(robot, engine=Engine.PYTHON).rigid_inverse(q, qd, qdd, np.zeros(6), out)
    return out


@pytest.mark.parametrize("types", CHAINS)
def test_mass_matrix_is_the_sum_over_the_links(types: str) -> None:
    robot = random_arm(1, types)
    for q, _, _ in random_states(robot, 5):
        np.testing.assert_allclose(
            _mass_matrix(robot, q), textbook_mass_matrix(robot, q), rtol=0, atol=ROUNDING
        )


@pytest.mark.parametrize("types", CHAINS)
def test_gravity_is_the_slope_of_the_potential_energy(types: str) -> None:
    robot = random_arm(2, types)
    rest = np.zeros(robot.n)
    for q, _, _ in random_states(robot, 3):
        slope = [
            (potential_energy(robot, q + step) - potential_energy(robot, q - step)) / (2.0 * DIFFERENCE)
            for step in DIFFERENCE * np.eye(robot.n)
        ]
        np.testing.assert_allclose(_inverse(robot, q, rest, rest), slope, rtol=0, atol=DIFFERENCE_TOLERANCE)


@pytest.mark.parametrize("types", CHAINS)
def test_velocity_torques_are_those_of_lagrange(types: str) -> None:
    """H = Ṁ·q̇ - ½ ∂(q̇ᵀMq̇)/∂q, with the derivatives by central differences of the textbook matrix."""
    robot = random_arm(3, types)
    rest = np.zeros(robot.n)
    for q, qd, _ in random_states(robot, 3):
        slopes = [
            (textbook_mass_matrix(robot, q + step) - textbook_mass_matrix(robot, q - step))
            / (2.0 * DIFFERENCE)
            for step in DIFFERENCE * np.eye(robot.n)
        ]
        rate = sum((slope * speed for slope, speed in zip(slopes, qd, strict=True)), np.zeros_like(slopes[0]))
        lagrange = rate @ qd - 0.5 * np.array([qd @ slope @ qd for slope in slopes])
        attained = _inverse(robot, q, qd, rest) - _inverse(robot, q, rest, rest)
        np.testing.assert_allclose(attained, lagrange, rtol=0, atol=DIFFERENCE_TOLERANCE)
