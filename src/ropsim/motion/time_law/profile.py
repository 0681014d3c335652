"""Jerk-limited rest-to-rest profile of one scalar: the seven-segment S-curve in closed form."""

import math

import numpy as np

from ropsim.core import RopsimError, frozen_dataclass
from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.spatial import Array

_WHOLE_SLACK = 1e-12  # relative; rounding of duration / period must not cost a whole period


class ProfileError(RopsimError):
    """A profile was requested with limits or a distance that no motion can have."""


@frozen_dataclass
class ProfileLimits:
    """Limits of a scalar that moves; all positive.

    Attributes:
        speed: largest first derivative [1/s].
        acceleration: largest second derivative [1/s²].
        jerk: largest third derivative [1/s³].
    """

    speed: float
    acceleration: float
    jerk: float


@frozen_dataclass
class Profile:
    """A motion from 0 to `distance`, at rest at both ends and symmetric in time.

    The first half: jerk for `jerk_time`, constant acceleration for `acceleration_time`, negative jerk for
    `jerk_time`, constant speed until the middle. The second half mirrors it.

    Attributes:
        distance: in the unit of the scalar.
        duration: time for it [s].
        jerk: third derivative in the first segment [1/s³].
        jerk_time: [s].
        acceleration_time: [s].
        speed_time: whole time at constant speed [s].
    """

    distance: float
    duration: float
    jerk: float
    jerk_time: float
    acceleration_time: float
    speed_time: float

    @property
    def peak_acceleration(self) -> float:
        """Return the largest acceleration that is reached [1/s²]."""
        return self.jerk * self.jerk_time

    @property
    def peak_speed(self) -> float:
        """Return the largest speed that is reached [1/s]."""
        return self.peak_acceleration * (self.jerk_time + self.acceleration_time)


def plan_profile(distance: float, limits: ProfileLimits) -> Profile:
    """Return the fastest rest-to-rest motion over `distance` within `limits`.

    With symmetric limits the S-curve that saturates jerk, then acceleration, then speed is optimal in time.
    Pinned by tests/unit/motion/test_profile.py (32^(1/3) s for unit limits) and, with ruckig as the oracle,
    by tests/property/test_profiles.py.

    Args:
        distance: >= 0.
        limits: speed, acceleration and jerk.

    Raises:
        ProfileError: M540, where the distance is negative or a limit is not positive, or one is not finite.

    References:
        Biagiotti and Melchiorri 2008, Trajectory Planning for Automatic Machines and Robots, section 3.4.
    """
    v, a, j = limits.speed, limits.acceleration, limits.jerk
    if not (math.isfinite(distance) and distance >= 0.0):
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, f"distance is {distance:g}, allowed is 0 or more"))
    if not all(math.isfinite(limit) and limit > 0.0 for limit in (v, a, j)):
        found = f"speed {v:g}, acceleration {a:g}, jerk {j:g}"
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, f"limits are {found}, allowed are numbers above 0"))
    if distance == 0.0:
        return Profile(0.0, 0.0, j, 0.0, 0.0, 0.0)
    jerk_time, acceleration_time = _rise(v, a, j)
    ramps = v * (2.0 * jerk_time + acceleration_time)  # distance of speeding up and slowing down together
    if ramps <= distance:
        speed_time = (distance - ramps) / v
    else:
        speed_time = 0.0
        jerk_time, acceleration_time = _short_rise(distance, a, j)
    duration = 4.0 * jerk_time + 2.0 * acceleration_time + speed_time
    return Profile(distance, duration, j, jerk_time, acceleration_time, speed_time)


def evaluate(profile: Profile, t: Array) -> tuple[Array, Array, Array]:
    """Return position, speed and acceleration at the times `t`.

    Start and end are exact: the second half is computed as the mirror of the first.

    Args:
        profile: the motion.
        t: times [s], shape (k,); before the start and after the end the scalar stands still.

    Returns:
        s, ds/dt [1/s], d²s/dt² [1/s²], each of shape (k,).
    """
    time = np.clip(t, 0.0, profile.duration)
    mirrored = time > profile.duration / 2.0
    u = np.where(mirrored, profile.duration - time, time)
    j, tj, ta = profile.jerk, profile.jerk_time, profile.acceleration_time
    a = profile.peak_acceleration
    v1, v2, v3 = j * tj**2 / 2.0, j * tj**2 / 2.0 + a * ta, profile.peak_speed
    s1 = j * tj**3 / 6.0
    s2 = s1 + v1 * ta + a * ta**2 / 2.0
    s3 = s2 + v2 * tj + a * tj**2 / 3.0
    starts = np.array([0.0, tj, tj + ta, 2.0 * tj + ta])
    segment = np.searchsorted(starts[1:], u, side="right")
    x = u - starts[segment]  # time since the segment began, (k,)
    s0 = np.array([0.0, s1, s2, s3])[segment]
    v0 = np.array([0.0, v1, v2, v3])[segment]
    a0 = np.array([0.0, a, a, 0.0])[segment]
    j0 = np.array([j, 0.0, -j, 0.0])[segment]
    s = s0 + x * (v0 + x * (a0 / 2.0 + x * j0 / 6.0))
    speed = v0 + x * (a0 + x * j0 / 2.0)
    acceleration = a0 + x * j0
    return (
        np.where(mirrored, profile.distance - s, s),
        speed,
        np.where(mirrored, -acceleration, acceleration),
    )


def _rise(v: float, a: float, j: float) -> tuple[float, float]:
    """Return jerk time and acceleration time of a rise to speed `v` [s]."""
    if v * j >= a * a:
        return a / j, v / a - a / j
    return math.sqrt(v / j), 0.0


def _short_rise(distance: float, a: float, j: float) -> tuple[float, float]:
    """Return jerk time and acceleration time of a motion that never reaches the speed limit [s].

    With the acceleration limit reached the peak speed v solves v²/a + v·a/j = distance; the root is taken in
    the form without cancellation. Otherwise 2·j·tj³ = distance.
    """
    lag = a * a / j
    peak = 2.0 * distance * a / (lag + math.sqrt(lag * lag + 4.0 * distance * a))
    if peak * j >= a * a:
        return a / j, peak / a - a / j
    return math.cbrt(distance / (2.0 * j)), 0.0


def whole_periods(duration: float, period: float) -> int:
    """Return how many periods [s] cover `duration` [s], rounded up."""
    return math.ceil(duration / period * (1.0 - _WHOLE_SLACK))
