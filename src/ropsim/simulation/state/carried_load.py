"""The wrench that an arm exerts on its tool and part to carry and accelerate them."""

from collections.abc import Sequence

import numpy as np

from ropsim.model import Payload
from ropsim.spatial import Array, Pose, cross


def carried_load(payload: Payload, X_WM: Sequence[Pose], hz: float, free_fall: Array) -> Array:
    """Return force [N] and moment [N·m] about the origin of the mechanical interface, world axes, shape (6,).

    Newton and Euler for one rigid body: F = m·(a - g), and the moment about the centre of mass is the change
    of the angular momentum R·I·Rᵀ·ω. Acceleration and change are those over the last two control ticks, in
    which the body turns from one tick to the next about a fixed axis.

    Args:
        payload: the body, in the frame of the mechanical interface.
        X_WM: that frame in the world at the last three control ticks, the present one last.
        hz: control ticks per second.
        free_fall: acceleration g [m/s²], in the world frame, shape (3,).
    """
    turns = [pose.rotation() for pose in X_WM]
    centres = [pose.position + turn @ payload.com for pose, turn in zip(X_WM, turns, strict=True)]
    acceleration = (centres[2] - 2.0 * centres[1] + centres[0]) * hz * hz
    force = payload.mass * (acceleration - free_fall)
    momenta = [_momentum(payload, turns[k], turns[k + 1], hz) for k in (0, 1)]
    moment = (momenta[1] - momenta[0]) * hz + cross(centres[2] - X_WM[2].position, force)
    return np.concatenate((force, moment))


def _momentum(payload: Payload, before: Array, after: Array, hz: float) -> Array:
    """Return the angular momentum of a body that turns from one orientation to another in a tick."""
    turn = after @ before.T
    sine = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2.0
    size = float(np.linalg.norm(sine))
    angle = np.arctan2(size, (float(np.trace(turn)) - 1.0) / 2.0)
    speed = sine * (angle / size if size > 0.0 else 1.0) * hz
    # halfway the axes of the body are those before, turned by half: near enough to the mean of both
    inertia = (before @ payload.inertia @ before.T + after @ payload.inertia @ after.T) / 2.0
    return np.asarray(inertia @ speed)
