"""Trajectories with their utilisation of the joint limits."""

from dataclasses import replace

from ropsim.motion import Reference, Slowed, Ticks, as_planned, loaded
from ropsim.planning.joint_limits.arm_limits import ArmBounds
from ropsim.planning.trajectory.timing import Timing
from ropsim.planning.trajectory.trajectory import Trajectory
from ropsim.spatial import record


@record
class EvaluatedTrajectory:
    """A trajectory, and its utilisation of the joint limits.

    Attributes:
        motion: of the sequence on the timing.
        reference: at ticks, and its utilisation of the limits.
        ticks: at which it was evaluated: control ticks, or a few of them.
        slowed: where it is slower than its bounds would have it.
    """

    motion: Trajectory
    reference: Reference
    ticks: Ticks
    slowed: tuple[Slowed, ...]

    @property
    def timing(self) -> Timing:
        """Return the timing of the sequence."""
        return self.motion.timing

    def loaded(self, arm: ArmBounds) -> "EvaluatedTrajectory":
        """Return the same with the torques that it takes, where they count."""
        if arm.effort is None or self.reference.torque is not None:
            return self
        return replace(self, reference=loaded(self.reference, arm.joints, arm.effort))

    def at_each(self, ticks: Ticks, arm: ArmBounds) -> "EvaluatedTrajectory":
        """Return the same evaluated at each tick, torques excepted if they were so far.

        Args:
            ticks: of control.
            arm: limits of the joints.
        """
        if self.ticks == ticks:
            return self
        effort = None if self.reference.torque is None else arm.effort
        return as_bounds_allow(self.motion, replace(arm, effort=effort), ticks)


def as_bounds_allow(motion: Trajectory, arm: ArmBounds, ticks: Ticks) -> EvaluatedTrajectory:
    """Return a motion with its utilisation of the joint limits, even beyond them.

    Args:
        motion: of the sequence.
        arm: limits of the joints.
        ticks: at which it is evaluated.
    """
    return EvaluatedTrajectory(motion, as_planned(motion, arm.joints, arm.effort, ticks), ticks, ())
