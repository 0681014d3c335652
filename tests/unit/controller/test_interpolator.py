"""The interpolator: setpoints at equal periods, the last one exactly at the end."""

import numpy as np

from ropsim.controller import StandardInterpolator
from ropsim.flow import JointSamples, PoseSetpoints
from ropsim.motion import JointMotionLimits, LineLimits, joint_trajectory, line_trajectory
from ropsim.spatial import Pose

PERIOD = 0.004
LIMITS = JointMotionLimits(np.ones(2), np.full(2, 5.0), np.full(2, 50.0))
LINE = line_trajectory(Pose(), Pose(np.array([0.1, 0.0, 0.0])), LineLimits(0.25, 2.0, 20.0, 1.0, 6.0, 60.0))


def test_joint_samples_end_exactly_at_the_goal() -> None:
    goal = np.array([0.3, -0.7])
    trajectory = joint_trajectory(np.zeros(2), goal, LIMITS)
    samples = StandardInterpolator().sample(trajectory, PERIOD)
    assert isinstance(samples, JointSamples)
    assert samples.q[-1].tolist() == goal.tolist()
    assert len(samples.q) == int(np.ceil(trajectory.duration / PERIOD))


def test_the_first_sample_is_one_period_after_the_start() -> None:
    trajectory = joint_trajectory(np.zeros(2), np.array([0.3, -0.7]), LIMITS).stretched(2.0)
    samples = StandardInterpolator().sample(trajectory, PERIOD)
    assert isinstance(samples, JointSamples)
    assert samples.q[0].tolist() == trajectory.joints(np.array([PERIOD]))[0].tolist()


def test_pose_setpoints_end_exactly_at_the_goal() -> None:
    setpoints = StandardInterpolator().sample(LINE, PERIOD)
    assert isinstance(setpoints, PoseSetpoints)
    assert setpoints.period == PERIOD
    assert setpoints.matrices[-1].tolist() == LINE.X_end.matrix().tolist()


def test_a_trajectory_without_duration_gives_no_setpoints() -> None:
    samples = StandardInterpolator().sample(joint_trajectory(np.ones(2), np.ones(2), LIMITS), PERIOD)
    assert isinstance(samples, JointSamples)
    assert samples.q.shape == (0, 2)
