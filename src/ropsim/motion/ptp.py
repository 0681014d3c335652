"""Pose-to-pose motion: all joints start together, end together and share one profile."""

from dataclasses import replace

import numpy as np

from ropsim.core import Diagnostic
from ropsim.motion.profile import Profile, ProfileLimits, evaluate, lengthen, plan_profile
from ropsim.spatial import Array, frozen, record

ZERO_LENGTH = 1e-9  # [rad | m]; far below any encoder, far above the rounding of inverse kinematics


@record
class JointMotionLimits:
    """What every joint must respect on the way, each of shape (n,).

    Attributes:
        speed: [rad/s | m/s].
        acceleration: [rad/s² | m/s²].
        jerk: [rad/s³ | m/s³].
    """

    speed: Array
    acceleration: Array
    jerk: Array

    def __post_init__(self) -> None:
        for name in ("speed", "acceleration", "jerk"):
            object.__setattr__(self, name, frozen(getattr(self, name)))


@record
class JointTrajectory:
    """A straight line in joint space over time: q(t) = q_start + r(t)·(q_end - q_start).

    Attributes:
        q_start: joint coordinates at time 0 [rad | m], shape (n,).
        q_end: joint coordinates at the end [rad | m], shape (n,).
        profile: r over time, from 0 to 1.
        findings: what the planner has to say about it.
    """

    q_start: Array
    q_end: Array
    profile: Profile
    findings: tuple[Diagnostic, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "q_start", frozen(self.q_start))
        object.__setattr__(self, "q_end", frozen(self.q_end))

    @property
    def duration(self) -> float:
        """Return the time from start to end [s]."""
        return self.profile.duration

    def joints(self, t: Array) -> Array:
        """Return the joint coordinates [rad | m] at the times `t` [s], (k,) to (k, n); ends are exact."""
        r = evaluate(self.profile, t)[0][:, None]
        return (1.0 - r) * self.q_start + r * self.q_end

    def derivatives(self, t: Array) -> tuple[Array, Array]:
        """Return joint speeds [rad/s | m/s] and accelerations [rad/s² | m/s²] at `t`, each (k, n)."""
        _, rd, rdd = evaluate(self.profile, t)
        way = self.q_end - self.q_start
        return rd[:, None] * way, rdd[:, None] * way

    def stretched(self, duration: float) -> "JointTrajectory":
        """Return the same way in a longer time [s], at the same speed where possible.

        Raises:
            ProfileError: M540, where `duration` is shorter than now.
        """
        return replace(self, profile=lengthen(self.profile, duration))


def joint_trajectory(q_start: Array, q_end: Array, limits: JointMotionLimits) -> JointTrajectory:
    """Return the fastest synchronous motion from `q_start` to `q_end`.

    All joints follow one normalised profile r(t), so the slowest joint leads and the others scale with it:
    the limits of r are min over the joints of limit / |q_end - q_start|, for speed, acceleration and jerk.

    Args:
        q_start: [rad | m], shape (n,).
        q_end: [rad | m], shape (n,).
        limits: of every joint.

    Returns:
        the trajectory; of duration 0 where no joint moves by more than `ZERO_LENGTH`.

    Raises:
        ProfileError: M540, where a limit is not positive or a coordinate is not finite.
    """
    return JointTrajectory(q_start, q_end, _profiles(q_start, np.asarray(q_end)[None, :], limits)[0])


def durations(q_start: Array, q_ends: Array, limits: JointMotionLimits) -> Array:
    """Return the durations [s] of the motions from `q_start` (n,) to each row of `q_ends` (m, n), shape (m,).

    Raises:
        ProfileError: M540, as for `joint_trajectory`.
    """
    return np.array([profile.duration for profile in _profiles(q_start, q_ends, limits)])


def _profiles(q_start: Array, q_ends: Array, limits: JointMotionLimits) -> list[Profile]:
    way = np.abs(q_ends - q_start)  # (m, n)
    moves = ~(way.max(axis=1) <= ZERO_LENGTH)  # so that NaN is planned, and refused
    inverse = np.maximum(way, 1e-300)
    speed = (limits.speed / inverse).min(axis=1).tolist()
    acceleration = (limits.acceleration / inverse).min(axis=1).tolist()
    jerk = (limits.jerk / inverse).min(axis=1).tolist()
    return [
        plan_profile(1.0, ProfileLimits(v, a, j)) if moving else Profile(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
        for v, a, j, moving in zip(speed, acceleration, jerk, moves.tolist(), strict=True)
    ]
