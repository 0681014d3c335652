"""The interpolator: samples a trajectory at the interpolation tick."""

from dataclasses import dataclass

import numpy as np

from ropsim.flow import JointSamples, PoseSetpoints
from ropsim.motion import JointTrajectory, LineTrajectory, whole_periods


@dataclass(frozen=True, slots=True)
class StandardInterpolator:
    """Samples joint and line trajectories at equal periods, from one period after the start to the end."""

    def sample(
        self, trajectory: JointTrajectory | LineTrajectory, period: float
    ) -> JointSamples | PoseSetpoints:
        """Return the setpoints of a trajectory.

        A trajectory that does not last a whole number of periods is stretched to the next one, so that its
        end falls on a tick.

        Args:
            trajectory: in joint space or on a line.
            period: interpolation period [s].

        Returns:
            joint samples or pose setpoints; none for a trajectory of duration 0; the last row is the end.
        """
        count = whole_periods(trajectory.duration, period)
        step = trajectory.duration / count if count else period
        times = np.arange(1.0, count + 1.0) * step
        if isinstance(trajectory, LineTrajectory):
            return PoseSetpoints(period, trajectory.matrices(times))
        return JointSamples(period, trajectory.joints(times))
