"""Loads of the axes by gravity and inertia, over many postures of an arm that carries its rated payload."""

from dataclasses import replace

import numpy as np

from ropsim.dynamics import axis_inertias, greatest_gravity_loads
from ropsim.kinematics import configurations, frames_batch
from ropsim.model import RobotModel, with_payload
from ropsim.spatial import Array, record

POSTURES = 512
_STEP = 1e-4  # [rad | m], of the differences of the potential energy; their error is its square


@record
class AxisLoads:
    """Loads of the n axes in k postures within the limits.

    Attributes:
        gravity: torques or forces that hold the axes, without sign [N·m | N], shape (k, n).
        inertia: of the axes without their rotors [kg·m² | kg], shape (k, n).
        worst_gravity: the greatest torques or forces in any posture within the limits [N·m | N], shape (n,);
            the maxima of the k postures, which the rules multiply, are lower by some per cent.
    """

    gravity: Array
    inertia: Array
    worst_gravity: Array

    @property
    def greatest_gravity(self) -> Array:
        """Return the greatest gravity torque or force of each axis [N·m | N], shape (n,)."""
        return np.asarray(self.gravity.max(axis=0))

    @property
    def greatest_inertia(self) -> Array:
        """Return the greatest inertia of each axis [kg·m² | kg], shape (n,)."""
        return np.asarray(self.inertia.max(axis=0))


def axis_loads(robot: RobotModel, payload: float) -> AxisLoads:
    """Return the loads of the axes of an arm with masses.

    Args:
        robot: with its own links; drives do not count.
        payload: mass of a cube of water on the mechanical interface [kg].
    """
    loaded, Q = with_payload(replace(robot, drives=()), payload), configurations(robot, POSTURES)
    return AxisLoads(gravity_torques(loaded, Q), axis_inertias(loaded, Q), greatest_gravity_loads(loaded))


def gravity_torques(robot: RobotModel, Q: Array) -> Array:
    """Return the torques and forces that hold the axes against gravity, without sign [N·m | N].

    They are the derivatives of the potential energy by the coordinates of the axes, couplings included.

    Args:
        robot: n axes, couplings allowed.
        Q: coordinates of the axes [rad | m], shape (k, n).

    Returns:
        Shape (k, n).
    """
    found = np.empty(Q.shape)
    for axis in range(robot.n):
        step = np.zeros(robot.n)
        step[axis] = _STEP
        found[:, axis] = (_energy(robot, Q + step) - _energy(robot, Q - step)) / (2.0 * _STEP)
    return np.abs(found)


def _energy(robot: RobotModel, Q: Array) -> Array:
    """Return the potential energies of an arm [J], shape (k,)."""
    frames, found = frames_batch(robot, Q), np.zeros(len(Q))
    for number, link in enumerate(robot.links):
        if link.mass:
            centres = frames[:, number, :3, :3] @ link.com + frames[:, number, :3, 3]
            found -= link.mass * (centres @ robot.gravity)
    return found
