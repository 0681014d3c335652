"""The trajectory of a motion sequence within the limits of joints and program."""

import math
from dataclasses import replace

from ropsim.motion import ROUNDING, Infeasible, Quantity, RetimedTrajectory, Slowed, Ticks, retimed_from
from ropsim.planning.joint_limits.arm_limits import ArmBounds
from ropsim.planning.joint_limits.evaluated import EvaluatedTrajectory, as_bounds_allow
from ropsim.planning.joint_limits.fitting import fitted
from ropsim.planning.trajectory.sections import TimingRules
from ropsim.planning.trajectory.timing import Timing
from ropsim.planning.trajectory.trajectory import Trajectory
from ropsim.spatial import record

_SPACING = 8e-3
"""Real time between two grid points of a motion that is slowed, about [s]."""
_NARROW_SPACING = 4e-3
"""The same where the tool is led, for how joints follow it is less even, and where torque is too much."""
_FIRST_SPACING = 4e-3
"""Time between two ticks at which a motion is evaluated first, at most [s]; with twice as much single motions
last up to 6 % longer."""
_FEWEST_TICKS = 64
"""A motion of fewer of them is evaluated at all control ticks at once."""
_TORQUE = list(Quantity).index(Quantity.TORQUE)
_LONGER = 1.03
"""A motion that is fitted to the joints may take this multiple of its time before another way is tried."""


@record
class Retiming:
    """A motion, and how it goes within all limits.

    Attributes:
        motion: of the sequence by its timing, before nominal time goes slower.
        retimed: how it goes; Infeasible where no speed helps.
        slowed: where it is slower than it was planned.
    """

    motion: Trajectory
    retimed: RetimedTrajectory | Infeasible
    slowed: tuple[Slowed, ...]

    @property
    def timing(self) -> Timing:
        """Return the timing of the sequence."""
        return self.motion.timing

    @property
    def duration(self) -> float:
        """Return how long the motion lasts [s]; infinity where there is none."""
        return self.retimed.clock.duration if isinstance(self.retimed, RetimedTrajectory) else float("inf")

    @property
    def ends(self) -> tuple[float, ...]:
        """Return the times at which the moves end [s]; infinity where there is no motion."""
        ends = self.timing.ends
        if isinstance(self.retimed, RetimedTrajectory):
            return tuple(self.retimed.clock.times_of(ends).tolist())
        return (float("inf"),) * len(ends)


def retimed(timing: Timing, arm: ArmBounds, ticks: Ticks, rules: TimingRules) -> Retiming:
    """Return the motion on the timing of a sequence.

    Time laws with lower bounds lose least where joints lack little. Where they lack much, nominal time that
    goes slower there may do it in less; the quicker one counts.

    Args:
        timing: as the bounds of its parts alone would have it.
        arm: limits of the joints.
        ticks: of control.
        rules: time law and look-ahead.
    """
    first = _coarse_ticks(timing, ticks)
    planned = as_bounds_allow(Trajectory.on(timing), replace(arm, effort=None), first)
    fit = fitted(planned, arm, ticks, rules)
    quick = _by_nominal_time(fit, arm, ticks)
    if fit.motion is planned.motion or quick.duration <= _LONGER * planned.timing.duration:
        return quick
    return min(quick, _by_nominal_time(planned.loaded(arm), arm, ticks), key=lambda one: one.duration)


def _by_nominal_time(fit: EvaluatedTrajectory, arm: ArmBounds, ticks: Ticks) -> Retiming:
    is_led = any(section.part.leads_tool for section in fit.timing.sections)
    is_heavy = fit.reference.utilisation.used[_TORQUE].max() > 1.0
    spacing = _NARROW_SPACING if is_led or is_heavy else _SPACING
    found = retimed_from(fit.reference, fit.motion, arm.joints, arm.effort, ticks, spacing)
    return Retiming(
        fit.motion, found, fit.slowed + (found.slowed if isinstance(found, RetimedTrajectory) else ())
    )


def _coarse_ticks(timing: Timing, ticks: Ticks) -> Ticks:
    """Return the ticks at which a motion is evaluated first, a few control ticks apart."""
    many = math.floor(_FIRST_SPACING / ticks.period * (1.0 + ROUNDING))
    is_long = timing.duration >= _FEWEST_TICKS * many * ticks.period
    return Ticks(many * ticks.period) if many > 1 and is_long else ticks
