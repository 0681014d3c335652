"""Limits of joints that follow the axes: by couplings, or by closed chains, which also have to close."""

from functools import lru_cache
from math import inf

import numpy as np

from ropsim.kinematics.chain.closed_arrays import ClosedArrays, closed_arrays
from ropsim.kinematics.chain.closure import APART, closed_states, cut_gaps
from ropsim.kinematics.chain.linear_loops import without_linear_loops
from ropsim.model import (
    CoupledLimits,
    Joint,
    JointType,
    Mechanism,
    coupled_limits,
    first_coordinates,
    passive_coordinates,
)
from ropsim.spatial import Array, Pose, frozen, record

SLACK = 1e-9
"""Rounding of a coordinate that stands exactly on its limit [rad | m]."""


@record
class LoopLimits:
    """Limits of the joints in closed chains, and of the gaps of the chains, which may not open.

    Attributes:
        coupled: limits of joints that follow by couplings, the first of the joints.
        joints: the joints, m of them: then those in chains, at the end one for the gap of each chain.
        arrays: the closed chains.
        places: of the coordinates of the joints in chains, among those that the chains determine.
        lower: of the joints in chains and the gaps [rad | m].
        upper: the same.
    """

    coupled: CoupledLimits
    joints: tuple[Joint, ...]
    arrays: ClosedArrays
    places: tuple[int, ...]
    lower: Array
    upper: Array

    def values(self, q: Array) -> Array:
        """Return the coordinates of these joints [rad | m], shape (..., m), for axes q, shape (..., n)."""
        rows = np.reshape(q, (-1, self.arrays.n))
        states, results = closed_states(self.arrays, rows)
        gaps = np.zeros((len(rows), len(self.arrays.ends)))
        open_rows = np.flatnonzero((results[:, 0] < 1.0) & ~np.isnan(states).any(axis=1))
        gaps[open_rows] = cut_gaps(self.arrays, states[open_rows])
        own = states[:, [self.arrays.n + place for place in self.places]]
        found = np.concatenate((self.coupled.values(rows), own, gaps), axis=1)
        found[np.isnan(rows).any(axis=1)] = np.nan
        return np.asarray(found.reshape(*q.shape[:-1], -1))

    def excess(self, q: Array) -> Array:
        """Return how far each is beyond its limit [rad | m], shape (..., m): 0 inside, NaN for NaN."""
        values, first = self.values(q), len(self.coupled.joints)
        own = values[..., first:]
        beyond: Array = np.maximum(np.maximum(self.lower - own, own - self.upper), 0.0)
        beyond = np.where(beyond <= SLACK, 0.0, beyond)
        return np.concatenate((self.coupled.excess(q), beyond), axis=-1)


FollowerLimits = CoupledLimits | LoopLimits
"""Limits of the joints that follow the axes: `joints`, `values` and `excess`."""


@lru_cache(maxsize=64)
def follower_limits(robot: Mechanism) -> FollowerLimits:
    """Return the limits of joints that follow the axes of an arm.

    Those of joints with several freedoms are left out. A closed chain has a gap with the limit 0: it does not
    follow the axes farther than to where it locks.

    Args:
        robot: with n axes.
    """
    linear = without_linear_loops(robot)
    coupled = coupled_limits(linear)
    if not linear.cuts:
        return coupled
    first, arrays = first_coordinates(linear.joints), closed_arrays(linear)
    owners = {first[k]: joint for k, joint in enumerate(linear.joints) if joint.type.freedoms == 1}
    passive = passive_coordinates(linear)
    places = tuple(k for k, number in enumerate(passive) if number in owners)
    joints = tuple(owners[passive[place]] for place in places)
    gaps = tuple(_gap(number) for number in range(len(linear.cuts)))
    return LoopLimits(
        coupled,
        (*coupled.joints, *joints, *gaps),
        arrays,
        places,
        frozen([*(joint.lower for joint in joints), *(-APART for _ in gaps)]),
        frozen([*(joint.upper for joint in joints), *(APART for _ in gaps)]),
    )


def _gap(number: int) -> Joint:
    """Return the gap of a closed chain as a joint that may not move."""
    name = f"gap of closed chain {number + 1}"
    return Joint(name, JointType.PRISMATIC, Pose(), 0.0, 0.0, 0.0, inf, inf, inf)
