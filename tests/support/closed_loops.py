"""The servo loop of an arm about a rest, linear and tick by tick: true plant, true law, output held."""

from dataclasses import dataclass

import numpy as np

from ropsim.dynamics import axis_inertias, effort_limits, gravity_loads
from ropsim.kinematics import configurations
from ropsim.model import Payload, RobotModel, cube_of_water, with_payload
from ropsim.simulation import LinearLoop
from ropsim.spatial import Array

_HELD = 0.95
"""Most of the torque limits that gravity takes where an arm is to be controlled."""
POSTURES = 256
"""Postures of which three are chosen."""


@dataclass(frozen=True, slots=True, eq=False)
class ClosedLoop:
    """z ← A·z + B·q_ref once per control tick; z holds the plant, the law, and outputs on their way.

    Attributes:
        A: shape (s, s).
        B: shape (s, n).
    """

    A: Array
    B: Array

    @property
    def radius(self) -> float:
        """Return the largest magnitude of an eigenvalue: below 1 the loop is stable."""
        return float(np.abs(np.linalg.eigvals(self.A)).max())

    def overshoots(self, ticks: int) -> Array:
        """Return by which share each axis goes beyond a step of its reference, shape (n,)."""
        Z, most = np.zeros(self.B.shape), np.zeros(self.B.shape[1])
        for _ in range(ticks):
            Z = self.A @ Z + self.B
            most = np.maximum(most, np.diag(Z))
        return np.asarray(np.maximum(most - 1.0, 0.0))


def closed_loop(loop: LinearLoop, late: int = 0) -> ClosedLoop:
    """Return the closed loop; the output of the law acts by some ticks later than it does."""
    return ClosedLoop(*loop.closed(late))


def rated_load(mass: float) -> Payload:
    """Return a cube of water on the interface, or nothing for a mass of 0 [kg]."""
    return cube_of_water(mass) if mass else Payload()


def postures(robot: RobotModel, mass: float) -> Array:
    """Return three postures that the drives can hold: axis 1 moves least, a middle inertia, and most.

    Args:
        robot: with drives.
        mass: of the load in the hand [kg].

    Returns:
        Shape (3, n) [rad | m].
    """
    loaded, Q = with_payload(robot, mass), configurations(robot, POSTURES)
    Q = Q[(np.abs(gravity_loads(loaded, Q)) < _HELD * effort_limits(robot)).all(axis=1)]
    inertia = axis_inertias(loaded, Q)[:, 0]
    middle = np.sqrt(inertia.min() * inertia.max())
    return np.asarray(Q[[inertia.argmin(), np.abs(np.log(inertia / middle)).argmin(), inertia.argmax()]])
