"""Places of a motion, as dense as it must be slow there."""

import numpy as np

from ropsim.motion.curves.path import JointPoints
from ropsim.motion.retiming.grid_kernel import divide, parts_by_joints, parts_by_rate
from ropsim.motion.retiming.joint_bounds import JointBounds
from ropsim.motion.retiming.retimed import Motion
from ropsim.spatial import Array

_FEWEST = 8
_ROUNDS = 12


def places_of(
    motion: Motion, bounds: JointBounds, spacing: float, phi: Array, rates: Array
) -> tuple[Array, JointPoints]:
    """Return motion times [s] from 0 to the end, about one real time apart, (m,), and the motion there.

    Where joints must go a long way, or the speed that they allow changes steeply, ways are divided.

    Args:
        motion: the plan.
        bounds: of the joints.
        spacing: real time between two places [s].
        phi: motion times at which rates are known, rising, shape (k,).
        rates: estimates of dφ/dt there, in ]0, 1], shape (k,).
    """
    count = max(int(np.ceil(motion.duration / spacing)), _FEWEST)
    places, parts = np.linspace(0.0, motion.duration, count + 1), np.empty(count)
    parts_by_rate(places, np.ascontiguousarray(phi), np.ascontiguousarray(rates), parts)
    for _ in range(_ROUNDS):
        places = _divided(places, parts)
        points, parts = motion.at(places), np.empty(len(places) - 1)
        q, d1 = np.ascontiguousarray(points.q), np.ascontiguousarray(points.d1)
        parts_by_joints(places, q, d1, bounds.speed, spacing, parts)
        if not parts.max() > 1.0:
            return places, points
    places = _divided(places, parts)
    return places, motion.at(places)


def _divided(places: Array, parts: Array) -> Array:
    """Return the places with the ways between them in equal parts, (m,) and (m - 1,)."""
    divided = np.empty(int(parts.sum()) + 1)
    divide(places, parts, divided)
    return divided
