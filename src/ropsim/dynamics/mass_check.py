"""Whether an arm has the masses that its equations of motion need."""

from functools import lru_cache

import numpy as np

from ropsim.dynamics.arm_functions import compiled
from ropsim.dynamics.diagnostics import AXIS_WITHOUT_INERTIA, WITHOUT_MASSES, MissingMassError
from ropsim.dynamics.model_check import check_model
from ropsim.model import Mechanism, Payload
from ropsim.spatial import Array

_NOTHING = 1e-12
"""Pivot of a mass matrix, relative to its diagonal, that is rounding."""
_STEP = 0.6180339887498949
"""Distance between the coordinates of a posture in which no axes are parallel by chance [rad | m]."""


@lru_cache(maxsize=256)
def check_masses(robot: Mechanism) -> None:
    """Make sure that an arm has masses at all; without any, its torques are not zero but unknown.

    A single link without mass is allowed: frames and crossed axes are massless.

    Raises:
        MissingMassError: M590, no link has a mass or an inertia.
        JointCountError, MechanismError, ModelNumberError: as `check_model`.
    """
    check_model(robot)
    if not any(link.mass > 0.0 or link.inertia.any() for link in robot.links):
        raise MissingMassError(
            WITHOUT_MASSES.at(
                None,
                f"no link of arm `{robot.name}` has a mass",
                hint="give `links` with masses, centres of mass and inertias; kinematics needs none",
            )
        )


@lru_cache(maxsize=256)
def check_inertias(robot: Mechanism, payload: Payload | None) -> None:
    """Make sure that every axis of an arm moves some inertia, so that torques accelerate it.

    Raises:
        MissingMassError: M590, no link has a mass; M591, an axis moves nothing that has an inertia.
        JointCountError, MechanismError, ModelNumberError: as `check_model`.
    """
    check_masses(robot)
    n = robot.n
    entries = np.empty(n * n)
    compiled(robot, payload).mass_matrix(uneven_posture(robot), entries)
    idle = idle_axes(entries.reshape(n, n))
    if idle:
        raise missing_inertia(robot, idle)


def uneven_posture(robot: Mechanism) -> Array:
    """Return a posture in which no axes are parallel by chance [rad | m], shape (n,).

    It is the home position in an arm with closed chains, which others may not reach.
    """
    return robot.home if robot.cuts else robot.home + _STEP * np.arange(1, robot.n + 1)


def missing_inertia(robot: Mechanism, idle: tuple[int, ...]) -> MissingMassError:
    """Return the error that axes move no inertia.

    Args:
        robot: the arm.
        idle: numbers of the axes, from 0; none where they are not known, as in a posture of its own.
    """
    names = ", ".join(f"`{robot.axis_joints[axis].name}`" for axis in idle)
    what = (
        f"axis {names} of arm `{robot.name}` moves" if idle else f"an axis of arm `{robot.name}` moves here"
    )
    hint = "give the links behind it masses and inertias, or its drive a rotor inertia"
    return MissingMassError(AXIS_WITHOUT_INERTIA.at(None, f"{what} nothing that has an inertia", hint=hint))


def idle_axes(M: Array, nothing: float = _NOTHING) -> tuple[int, ...]:
    """Return the axes, from 0, that move no mass while earlier axes are held and later ones are free.

    Args:
        M: mass matrix [kg·m² | kg·m | kg], shape (n, n).
        nothing: pivot, relative to the diagonal, that counts as none.
    """
    left, idle = M.copy(), []
    for k in range(len(M) - 1, -1, -1):
        pivot = left[k, k]
        if not pivot > nothing * M[k, k]:
            idle.append(k)
            continue
        left[:k, :k] -= np.outer(left[:k, k], left[k, :k]) / pivot
    return tuple(reversed(idle))
