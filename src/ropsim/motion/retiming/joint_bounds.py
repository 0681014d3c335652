"""Limits of the joints on the way, and the control ticks at which they are checked."""

from collections.abc import Callable
from enum import Enum

import numpy as np

from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.time_law.profile import ProfileError, whole_periods
from ropsim.spatial import Array, frozen, record


@record
class Ticks:
    """Ticks of one period from the start of a motion on.

    Attributes:
        period: between two of them [s].
    """

    period: float

    def count(self, duration: float) -> int:
        """Return the number of the first tick at or behind the end of a motion, whole or not.

        Args:
            duration: of the motion [s].
        """
        return whole_periods(duration, self.period)

    def times(self, duration: float) -> Array:
        """Return the times of the ticks from 0 on until the motion rests [s], shape (k,).

        Args:
            duration: of the motion [s].
        """
        ticks = np.arange(self.count(duration) + 1, dtype=np.float64)
        ticks *= self.period
        return ticks


Effort = Callable[[Array, Array, Array], Array]
"""Torques at the joints [N m | N] for rows of coordinates, speeds and accelerations, all (k, n)."""


class Quantity(Enum):
    """Quantity that can exceed the limit of a joint; in the order of the rows of utilisation."""

    SPEED = "speed"
    ACCELERATION = "acceleration"
    JERK = "jerk"
    TORQUE = "torque"


@record
class JointBounds:
    """Capabilities of every joint, each of shape (n,) and above 0; infinity if unknown.

    Attributes:
        speed: [rad/s | m/s].
        acceleration: [rad/s² | m/s²].
        jerk: [rad/s³ | m/s³].
        effort: torque or force at the joint [N m | N], or None where it does not count.

    Raises:
        ProfileError: M540, where one is not above 0, or they are not of one shape.
    """

    speed: Array
    acceleration: Array
    jerk: Array
    effort: Array | None = None

    def __post_init__(self) -> None:
        for name in ("speed", "acceleration", "jerk", "effort"):
            values = getattr(self, name)
            if values is None:
                continue
            bound = frozen(values)
            if bound.ndim != 1 or bound.shape != np.shape(self.speed) or not bool((bound > 0.0).all()):
                found = f"bounds of {name} are {values}, allowed are numbers above 0, one for each joint"
                raise ProfileError(WRONG_PROFILE_REQUEST.at(None, found))
            object.__setattr__(self, name, bound)


def torques(effort: Effort, q: Array, qd: Array, qdd: Array) -> Array:
    """Return the torques of rows [N m | N], all of shape (k, n).

    Raises:
        ProfileError: M540, one is no number, or they are of another shape.
    """
    found = checked_torques(effort, q, qd, qdd)
    if not bool(np.isfinite(found).all()):
        raise no_torques(found, q)
    return found


def checked_torques(effort: Effort, q: Array, qd: Array, qdd: Array) -> Array:
    """Return the torques of rows [N m | N], all of shape (k, n), whether they are numbers or not.

    Raises:
        ProfileError: M540, they are of another shape.
    """
    found = np.asarray(effort(q, qd, qdd), dtype=np.float64)
    if found.shape != q.shape:
        message = f"torques have shape {found.shape}, allowed is that of the joints, {q.shape}"
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, message))
    return found


def no_torques(found: Array, q: Array) -> ProfileError:
    """Return the error for torques [N m | N] of which one is NaN, both of shape (k, n)."""
    row = int(np.flatnonzero(~np.isfinite(found).all(axis=1))[0])
    message = f"torques are {found[row]} at q = {q[row]}, allowed are finite numbers"
    return ProfileError(WRONG_PROFILE_REQUEST.at(None, message))
