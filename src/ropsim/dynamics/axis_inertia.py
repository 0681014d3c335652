"""The inertia that each joint axis moves, for many configurations at once and without compiling anything."""

import numpy as np
import numpy.typing as npt

from ropsim.dynamics.drives import reflected_inertia
from ropsim.kinematics import frames_batch
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array


def mass_matrices(robot: RobotModel, Q: npt.ArrayLike) -> Array:
    """Return the mass matrices, motor inertia included: the sum of m·JᵥᵀJᵥ + JᵤᵀI·Jᵤ over the links.

    Jᵥ and Jᵤ are the Jacobians of the centre of mass and of the rotation of a link.

    Args:
        robot: the arm, without payload.
        Q: joint coordinates [rad | m], shape (k, n).

    Returns:
        Shape (k, n, n) [kg·m² | kg·m | kg].

    Raises:
        ArrayShapeError: M551, Q has another shape.
    """
    frames = frames_batch(robot, Q)  # (k, n + 1, 4, 4)
    k, n = len(frames), robot.n
    found = np.zeros((k, n, n))
    for i, link in enumerate(robot.links):
        R, p = frames[:, i, :3, :3], frames[:, i, :3, 3]
        centre = p + R @ link.com
        linear, angular = np.zeros((k, 3, n)), np.zeros((k, 3, n))
        for j, joint in enumerate(robot.joints[: i + 1]):
            z = frames[:, j, :3, 2]
            if joint.type is JointType.PRISMATIC:
                linear[:, :, j] = z
            else:
                linear[:, :, j] = np.cross(z, centre - frames[:, j, :3, 3])
                angular[:, :, j] = z
        about_centre = R @ link.inertia @ R.transpose(0, 2, 1)
        found += (
            link.mass * linear.transpose(0, 2, 1) @ linear
            + angular.transpose(0, 2, 1) @ about_centre @ angular
        )
    return np.asarray(found + np.diag([reflected_inertia(drive) for drive in robot.drives] or [0.0] * n))


def axis_inertias(robot: RobotModel, Q: npt.ArrayLike) -> Array:
    """Return the inertia that each axis moves while the others stand still, shape (k, n) [kg·m² | kg].

    Arguments and errors are those of `mass_matrices`, whose diagonals these are.
    """
    return np.asarray(np.einsum("kii->ki", mass_matrices(robot, Q)))


def free_inertias(robot: RobotModel, Q: npt.ArrayLike) -> Array:
    """Return the inertia that each axis moves while the others are free, shape (k, n) [kg·m² | kg].

    It is 1 / (M⁻¹)ᵢᵢ, what a torque meets at once; arguments and errors are those of `mass_matrices`.

    Raises:
        LinAlgError: a mass matrix is singular, as of an arm with a link that has no mass.
    """
    return np.asarray(1.0 / np.einsum("kii->ki", np.linalg.inv(mass_matrices(robot, Q))))
