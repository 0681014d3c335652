"""Courses, looked at for what they take of the joints."""

from dataclasses import replace

from ropsim.controller.course import Course
from ropsim.controller.kept_limits import ArmBounds
from ropsim.controller.stretch_motion import StretchMotion
from ropsim.motion import Reference, Slowed, as_planned, loaded
from ropsim.spatial import record


@record
class Fit:
    """A course, and what it takes of the joints.

    Attributes:
        motion: of the stretch on the course.
        reference: at ticks, and what it uses of the limits.
        period: of the ticks [s]: that of control, or a few of it.
        slowed: where it is slower than its bounds would have it.
    """

    motion: StretchMotion
    reference: Reference
    period: float
    slowed: tuple[Slowed, ...]

    @property
    def course(self) -> Course:
        """Return the course of the stretch."""
        return self.motion.course

    def loaded(self, arm: ArmBounds) -> "Fit":
        """Return the same with the torques that it takes, where they count."""
        if arm.effort is None or self.reference.torque is not None:
            return self
        return replace(self, reference=loaded(self.reference, arm.joints, arm.effort))

    def at_each(self, period: float, arm: ArmBounds) -> "Fit":
        """Return the same looked at at each tick, torques aside where they were so far.

        Args:
            period: of the ticks [s].
            arm: limits of the joints.
        """
        if self.period == period:
            return self
        effort = None if self.reference.torque is None else arm.effort
        return as_bounds_allow(self.motion, replace(arm, effort=effort), period)


def as_bounds_allow(motion: StretchMotion, arm: ArmBounds, period: float) -> Fit:
    """Return a motion with what it takes of the joints, whatever they say to it.

    Args:
        motion: of the stretch.
        arm: limits of the joints.
        period: of the ticks [s].
    """
    return Fit(motion, as_planned(motion, arm.joints, arm.effort, period), period, ())
