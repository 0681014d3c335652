import numpy as np
import pytest

from ropsim import robots
from ropsim.dynamics import axis_inertias, mass_matrix
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
