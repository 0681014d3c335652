"""Durations of pose-to-pose moves: all joints start and end together and share one profile."""

import numpy as np

from ropsim.motion.motion_limits import JointMotionLimits
from ropsim.motion.time_law.profile import ProfileLimits, plan_profile
from ropsim.spatial import Array

ZERO_LENGTH = 1e-9  # [rad | m]; far below any encoder, far above the rounding of inverse kinematics


def durations(q_start: Array, q_ends: Array, limits: JointMotionLimits) -> Array:
    """Return the durations of the fastest motions from one position to others [s], shape (m,).

    All joints follow one normalised profile r(t) with q = (1 - r)·q_start + r·q_end, so the slowest joint
    leads and the others scale with it: the limits of r are min over the joints of limit / |q_end - q_start|,
    for speed, acceleration and jerk. Where no joint moves by more than `ZERO_LENGTH` the duration is 0.

    Args:
        q_start: [rad | m], shape (n,).
        q_ends: [rad | m], shape (m, n).
        limits: of every joint.

    Raises:
        ProfileError: M540, where a limit is not positive or a coordinate is not finite.
    """
    distances = np.abs(q_ends - q_start)  # (m, n)
    moves = ~(distances.max(axis=1) <= ZERO_LENGTH)  # so that NaN is planned, and refused
    inverse = np.maximum(distances, 1e-300)
    speed = (limits.speed / inverse).min(axis=1).tolist()
    acceleration = (limits.acceleration / inverse).min(axis=1).tolist()
    jerk = (limits.jerk / inverse).min(axis=1).tolist()
    return np.array(
        [
            plan_profile(1.0, ProfileLimits(v, a, j)).duration if moving else 0.0
            for v, a, j, moving in zip(speed, acceleration, jerk, moves.tolist(), strict=True)
        ]
    )
