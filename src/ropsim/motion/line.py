"""Straight-line motion of the tool: position on a line, orientation by a turn, one profile for both."""

import math
from dataclasses import dataclass, replace

import numpy as np

from ropsim.core import Diagnostic
from ropsim.motion.profile import Profile, ProfileLimits, evaluate, lengthen, plan_profile
from ropsim.motion.ptp import ZERO_LENGTH
from ropsim.motion.turn import OrientationMode, Turn, plan_turn
from ropsim.spatial import Array, Pose, record


@dataclass(frozen=True, slots=True)
class LineLimits:
    """What the tool must respect on the line; all positive.

    Attributes:
        speed: of the TCP [m/s].
        acceleration: of the TCP along the line [m/s²].
        jerk: of the TCP along the line [m/s³].
        orientation_speed: angular speed of the tool [rad/s].
        orientation_acceleration: [rad/s²].
        orientation_jerk: [rad/s³].
    """

    speed: float
    acceleration: float
    jerk: float
    orientation_speed: float
    orientation_acceleration: float
    orientation_jerk: float


@record
class LineTrajectory:
    """A straight line of the TCP over time, in the base frame B.

    Position p(r) = (1 - r)·p_start + r·p_end; orientation R(r) = R_start·turn(r).

    Attributes:
        X_start: X_BT at time 0.
        X_end: X_BT at the end.
        turn: from one orientation to the other.
        profile: r over time, from 0 to 1.
        findings: what the planner has to say about it.
    """

    X_start: Pose
    X_end: Pose
    turn: Turn
    profile: Profile
    findings: tuple[Diagnostic, ...] = ()

    @property
    def duration(self) -> float:
        """Return the time from start to end [s]."""
        return self.profile.duration

    @property
    def length(self) -> float:
        """Return the way of the TCP [m]."""
        return float(np.linalg.norm(self.X_end.position - self.X_start.position))

    def matrices(self, t: Array) -> Array:
        """Return X_BT at the times `t` [s], shape (k,) to homogeneous matrices (k, 4, 4)."""
        r = evaluate(self.profile, t)[0]
        result = np.zeros((len(r), 4, 4))
        result[:, :3, :3] = self.X_start.rotation() @ self.turn.rotations(r)
        result[:, :3, 3] = (1.0 - r)[:, None] * self.X_start.position + r[:, None] * self.X_end.position
        result[:, 3, 3] = 1.0
        return result

    def speeds(self, t: Array) -> tuple[Array, Array]:
        """Return the speed of the TCP [m/s] and the angular speed of the tool [rad/s] at `t`, each (k,)."""
        rd = evaluate(self.profile, t)[1]
        return rd * self.length, rd * self.turn.size

    def stretched(self, duration: float) -> "LineTrajectory":
        """Return the same way in a longer time [s], at the same speed where possible.

        Raises:
            ProfileError: M540, where `duration` is shorter than now.
        """
        return replace(self, profile=lengthen(self.profile, duration))


def line_trajectory(
    X_start: Pose, X_end: Pose, limits: LineLimits, mode: OrientationMode = OrientationMode.FIXED_AXIS
) -> LineTrajectory:
    """Return the fastest motion on the straight line from `X_start` to `X_end`.

    Position and orientation share one normalised profile r(t), so that both start and end together; the
    limits of r are the smaller of limit / length and orientation limit / angle, for speed, acceleration and
    jerk.

    Args:
        X_start: X_BT at the start.
        X_end: X_BT at the end.
        limits: of position and orientation.
        mode: how the tool turns.

    Returns:
        the trajectory; of duration 0 where the tool neither moves by more than `ZERO_LENGTH` [m] nor turns by
        more than `ZERO_LENGTH` [rad].

    Raises:
        ProfileError: M540, where a limit is not positive or a coordinate is not finite.
    """
    turn = plan_turn(X_start, X_end, mode)
    length = math.dist(X_start.position.tolist(), X_end.position.tolist())
    if length <= ZERO_LENGTH and turn.size <= ZERO_LENGTH:
        return LineTrajectory(X_start, X_end, turn, Profile(0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    normalised = ProfileLimits(
        _share(limits.speed, length, limits.orientation_speed, turn.size),
        _share(limits.acceleration, length, limits.orientation_acceleration, turn.size),
        _share(limits.jerk, length, limits.orientation_jerk, turn.size),
    )
    return LineTrajectory(X_start, X_end, turn, plan_profile(1.0, normalised))


def _share(limit: float, length: float, orientation_limit: float, angle: float) -> float:
    """Return the limit of r; a part that stands still (but for rounding) limits nothing."""
    linear = limit / length if length > ZERO_LENGTH else math.inf
    angular = orientation_limit / angle if angle > ZERO_LENGTH else math.inf
    return min(linear, angular)
