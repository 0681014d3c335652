"""Arms with closed chains on a track or beside a turntable: the arm keeps its chains."""

import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import IkOptions, Limits, forward, inverse, inverse_path, solver_of
from ropsim.model import RobotModel, beside, held_arm, on_track
from ropsim.spatial import Pose
from support.closed_arms import palletizer, six_axis_with_cylinders

PLACED = (
    on_track(six_axis_with_cylinders(), robots.linear_track(4.0)),
    on_track(palletizer(), robots.linear_track(4.0)),
    beside(six_axis_with_cylinders(), robots.turntable(0.3), Pose(np.array([1.5, 0.0, 0.0]))),
)


@pytest.mark.parametrize("robot", PLACED)
def test_the_arm_is_solved_in_its_moved_base(robot: RobotModel) -> None:
    arm = held_arm(robot).arm
    assert len(arm.cuts) == len(robot.cuts)
    assert len(arm.joints) == 10
    assert solver_of(robot).name in ("spherical wrist", "level wrist")
    q = robot.home + 0.01
    q[list(robot.external)] = 0.3
    found = inverse(robot, forward(robot, q), IkOptions(Limits.IGNORE, near=q))
    present = found.branches[~np.isnan(found.branches[:, 0])]
    assert np.abs(present - q).max(axis=1).min() < 1e-8
    rows = np.linspace(q, q + 0.01, 5)
    rows[:, list(robot.external)] = 0.3
    poses = np.array([forward(robot, one).matrix() for one in rows])
    np.testing.assert_allclose(inverse_path(robot, poses, q), rows, atol=1e-8)
