"""The fastest motion along a path under speed, acceleration and torque, without regard to jerk."""

import numpy as np

from ropsim.motion.diagnostics import WRONG_PROFILE_REQUEST
from ropsim.motion.limits.demand import demand
from ropsim.motion.limits.joint_bounds import Effort, JointBounds
from ropsim.motion.limits.kept import Beyond
from ropsim.motion.limits.refusal import too_heavy
from ropsim.motion.limits.speeds import Speeds
from ropsim.motion.paths.path import JointPoints
from ropsim.motion.profile import ProfileError
from ropsim.spatial import Array

_FASTEST = 1e6
_TINY = 1e-12


def time_optimal(
    points: JointPoints, step: float, bounds: JointBounds, effort: Effort | None
) -> Array | Beyond:
    """Return the speeds ds/dt of the fastest motion along a path, from rest to rest, shape (m,).

    Args:
        points: the path on a grid of its parameter s, m >= 2 places, and its derivatives by s.
        step: of the grid.
        bounds: of the joints; jerk is not looked at.
        effort: torques at the joints, affine in accelerations; None where they do not count.

    Returns:
        the speeds, or the first place at which the arm cannot even creep (its `phi` is the s of the place).

    Raises:
        ProfileError: M540, the grid is none, or the path or its torques are no numbers.
    """
    m = len(points.q)
    finite = all(bool(np.isfinite(each).all()) for each in (points.q, points.d1, points.d2))
    if m < 2 or not 0.0 < step < np.inf or not finite:
        found = f"a path of {m} places with steps of {step:g}"
        message = f"{found}, allowed are finite numbers at 2 places or more"
        raise ProfileError(WRONG_PROFILE_REQUEST.at(None, message))
    asked = demand(points, bounds, effort)
    refusal = too_heavy(asked, np.asarray(np.arange(m) * step, dtype=np.float64))
    if refusal is not None:
        return refusal
    caps = 1.0 / np.maximum(np.max(np.abs(points.d1) / bounds.speed, axis=1), 1.0 / _FASTEST) ** 2
    caps[0] = caps[-1] = 0.0
    x = np.minimum(caps, 1.0 / np.maximum(np.max(np.abs(points.d2) / bounds.acceleration, axis=1), _TINY))
    everything = np.ones(m)
    return np.asarray(np.sqrt(Speeds(asked, np.full(m - 1, step)).under(caps, x, everything, everything)))
