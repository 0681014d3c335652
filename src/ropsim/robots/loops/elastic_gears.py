"""Bandwidth limits of a controller with elastic gears: the lowest frequency of the arm on them.

A law receives coordinates of the joints and speeds of the motors. A loop of the motor speed damps the arm on
its springs, while it is slower than the oscillation of the arm with held motors (W. Leonhard, Control of
Electrical Drives, 3rd ed., Springer 2001, on drives with elastic couplings), and the loop of the joint
coordinate lets it swing where it is stiffer than the gear: the motor about a joint that swings is at

    θ/q = (k - kv·kp + i·ki·kp/ω) / (k + ki - J·ω² + i·ω·kv),

so that a slow loop takes energy out of the swing for kv·kp < k.
"""

import numpy as np

from ropsim.dynamics import elastic_axes, gear_stiffnesses, mass_matrices, rotor_inertias
from ropsim.model import Mechanism
from ropsim.spatial import Array

ELASTIC_SHARE = 0.7
"""Crossover of the speed loop over the frequency at which its axis swings."""
SOFTER = 1.0 / 3.0
"""Greatest stiffness kv·kp of a position loop, as a torque at the joint, over that of the gear."""


def elastic_frequencies(robot: Mechanism, Q: Array) -> Array:
    """Return how fast each axis swings on its gear while all motors are held [rad/s], shape (n,).

    For a single axis that is sqrt(k/M) with the stiffness k of its gear and the greatest inertia M of the
    links about it; together they swing slower, K·v = ω²·M·v, so all are brought down by as much as the lowest
    frequency of the arm is below the lowest one of its axes.

    Args:
        robot: the arm with its drives.
        Q: configurations at which it is evaluated [rad | m], shape (k, n).

    Returns:
        inf for rigid gears, and where a gear carries no mass.
    """
    found = np.full(robot.n, np.inf)
    axes = np.flatnonzero(elastic_axes(robot))
    if not len(axes):
        return found
    rotors = rotor_inertias(robot, Q)[:, :, np.newaxis] * np.eye(robot.n)
    links = (mass_matrices(robot, Q) - rotors)[:, axes[:, np.newaxis], axes]
    softness = gear_stiffnesses(robot)[axes] ** -0.5
    slowness = softness[:, np.newaxis] * links * softness  # its eigenvalues are 1/ω²
    alone = np.einsum("kii->ki", slowness).max(axis=0)
    together = float(np.linalg.eigvalsh(slowness).max())
    if together > 0.0:
        with np.errstate(divide="ignore"):
            found[axes] = np.sqrt(alone.max() / together / alone)
    return found


def elastic_words(swings: Array) -> str:
    """Return how elastic gears bound the speed loops of their axes; empty where all are rigid.

    Args:
        swings: how fast each axis swings [rad/s], inf for rigid gears, shape (n,).
    """
    if not np.isfinite(swings).any():
        return ""
    return (
        f"; axes with elastic gears swing at {span(swings[np.isfinite(swings)])} rad/s while motors are "
        f"held, their speeds are measured at the motors, in loops of at most {ELASTIC_SHARE:g} of that"
    )


def span(values: Array) -> str:
    """Return the least and the greatest of some numbers in words."""
    low, high = f"{values.min():.3g}", f"{values.max():.3g}"
    return low if low == high else f"{low} to {high}"
