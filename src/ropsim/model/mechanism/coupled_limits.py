"""Limits of joints that are no axes: their coordinates follow from those of axes by couplings."""

from functools import lru_cache

import numpy as np

from ropsim.model.mechanism.coordinates import coordinates
from ropsim.model.mechanism.links import Joint
from ropsim.model.mechanism.mechanism import Mechanism, first_coordinates
from ropsim.spatial import Array, frozen, record

SLACK = 1e-9
"""Rounding of a coordinate that stands exactly on its limit [rad | m]."""


@record
class CoupledLimits:
    """Limits that some joints set to the axes together: lower ≤ T·q + c ≤ upper.

    Attributes:
        joints: the joints, m of them.
        T: factors of the n axes, shape (m, n).
        c: [rad | m], shape (m,).
        lower: [rad | m], shape (m,).
        upper: [rad | m], shape (m,).
    """

    joints: tuple[Joint, ...]
    T: Array
    c: Array
    lower: Array
    upper: Array

    def values(self, q: Array) -> Array:
        """Return the coordinates of these joints [rad | m], shape (..., m), for axes q, shape (..., n)."""
        return np.asarray(q @ self.T.T + self.c)

    def excess(self, q: Array) -> Array:
        """Return how far each is beyond its limit [rad | m], shape (..., m): 0 inside, NaN for NaN."""
        values = self.values(q)
        beyond: Array = np.maximum(np.maximum(self.lower - values, values - self.upper), 0.0)
        return np.where(beyond <= SLACK, 0.0, beyond)


@lru_cache(maxsize=256)
def coupled_limits(mechanism: Mechanism) -> CoupledLimits:
    """Return the limits of coupled joints that the limits of the axes alone do not keep; none for most arms.

    Joints with several freedoms, and coordinates that closed chains determine, are left out.

    Args:
        mechanism: n axes.
    """
    first, made = first_coordinates(mechanism.joints), coordinates(mechanism)
    dependent = {coupling.dependent for coupling in mechanism.couplings}
    rows = [
        (joint, first[k])
        for k, joint in enumerate(mechanism.joints)
        if joint.type.freedoms == 1 and first[k] in dependent and not made.P[first[k]].any()
    ]
    axes_lower, axes_upper = mechanism.lower_limits, mechanism.upper_limits
    kept = []
    for joint, row in rows:
        T = made.T[row]
        ends = [np.where(T == 0.0, 0.0, T * one) for one in (axes_lower, axes_upper)]
        least, most = (float(make(*ends).sum() + made.c[row]) for make in (np.minimum, np.maximum))
        if least < joint.lower - SLACK or most > joint.upper + SLACK:
            kept.append((joint, row))
    numbers = [row for _, row in kept]
    return CoupledLimits(
        tuple(joint for joint, _ in kept),
        frozen(made.T[numbers]),
        frozen(made.c[numbers]),
        frozen([joint.lower for joint, _ in kept]),
        frozen([joint.upper for joint, _ in kept]),
    )
