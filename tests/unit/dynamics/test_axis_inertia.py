import numpy as np
import pytest

from ropsim import robots
from ropsim.dynamics import axis_inertias, forward_dynamics, free_inertias, mass_matrices, mass_matrix
from ropsim.model import RobotModel
from support.arms import drive, random_arm


@pytest.mark.parametrize(
    "robot",
    [robots.load("puma560"), random_arm(5, "RPRRP"), random_arm(6, "PR", (drive(),) * 2)],
    ids=lambda robot: robot.name,
)
def test_inertias_of_the_axes_are_the_diagonal_of_the_mass_matrix(robot: RobotModel) -> None:
    """Bodies turned about each axis (numpy) against composite bodies in generated code."""
    Q = np.random.default_rng(2).uniform(-2.0, 2.0, (20, robot.n))
    expected = [np.diag(mass_matrix(robot, q)) for q in Q]
    np.testing.assert_allclose(axis_inertias(robot, Q), expected, rtol=1e-12)


@pytest.mark.parametrize("types", ["R", "RPR", "RRRRRR"])
def test_mass_matrices_in_bulk_are_those_of_generated_code(types: str) -> None:
    robot = random_arm(8, types, (drive(),) * len(types))
    Q = np.random.default_rng(3).uniform(-2.0, 2.0, (10, robot.n))
    expected = [mass_matrix(robot, q) for q in Q]
    np.testing.assert_allclose(mass_matrices(robot, Q), expected, rtol=0, atol=1e-12)


def test_with_the_others_free_an_axis_gives_way_as_forward_dynamics_say() -> None:
    """A torque on one joint alone, less what the arm does without it: acceleration over torque."""
    robot = random_arm(9, "RRP")
    for q in np.random.default_rng(4).uniform(-2.0, 2.0, (5, 3)):
        rest = forward_dynamics(robot, q, np.zeros(3), np.zeros(3))
        for axis, inertia in enumerate(free_inertias(robot, q[np.newaxis])[0]):
            pushed = forward_dynamics(robot, q, np.zeros(3), np.eye(3)[axis])
            assert pushed[axis] - rest[axis] == pytest.approx(1.0 / inertia, rel=1e-9)
