"""The inertia that each joint axis moves, for many configurations at once and without compiling anything."""

import numpy as np
import numpy.typing as npt

from ropsim.dynamics.drives import reflected_inertia
from ropsim.dynamics.loops.tree_motion import step_ratios
from ropsim.dynamics.mass_check import check_masses, idle_axes, missing_inertia
from ropsim.kinematics import frames_of_steps
from ropsim.model import BASE_LINK, JointType, Linkage, Mechanism, joint_tree
from ropsim.spatial import Array, Pose, cross


def mass_matrices(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return the mass matrices, motor inertia included: the sum of m·JᵥᵀJᵥ + JᵤᵀI·Jᵤ over the links.

    Jᵥ and Jᵤ are the Jacobians of the centre of mass and of the rotation of a link.

    Args:
        robot: the arm, without payload.
        Q: joint coordinates [rad | m], shape (k, n).

    Returns:
        Shape (k, n, n) [kg·m² | kg·m | kg].

    Raises:
        ArrayShapeError: M551, Q has another shape.
        MissingMassError: M590, no link has a mass.
        JointCountError, MechanismError, ModelNumberError: as `check_model`.
    """
    check_masses(robot)
    tree, frames = joint_tree(robot), frames_of_steps(robot, Q)  # (k, m, 4, 4)
    k, n = len(frames), robot.n
    ratios = step_ratios(robot, Q) if robot.cuts else tree.T
    found = np.zeros((k, n, n))
    for i, link in enumerate(robot.links):
        step, X_SL = tree.carriers[i], tree.X_SL[i]
        if step == BASE_LINK:
            continue
        R, p = frames[:, step, :3, :3], frames[:, step, :3, 3]
        if Pose() != X_SL:
            R, p = R @ X_SL.rotation(), p + R @ X_SL.position
        centre = p + R @ link.com
        linear, angular = np.zeros((k, 3, tree.m)), np.zeros((k, 3, tree.m))
        for j in tree.way(i):
            z = frames[:, j, :3, 2]
            if tree.types[j] is JointType.PRISMATIC:
                linear[:, :, j] = z
            else:
                linear[:, :, j] = cross(z, centre - frames[:, j, :3, 3])
                angular[:, :, j] = z
        if not tree.parallel:
            linear, angular = linear @ ratios, angular @ ratios
        about_centre = R @ link.inertia @ R.transpose(0, 2, 1)
        found += (
            link.mass * linear.transpose(0, 2, 1) @ linear
            + angular.transpose(0, 2, 1) @ about_centre @ angular
        )
    return np.asarray(found + rotor_inertias(robot, Q)[:, :, np.newaxis] * np.eye(n))


def rotor_inertias(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return the reflected inertias of the motors at their axes, shape (k, n) [kg·m² | kg]; 0 without drives.

    Args:
        robot: the arm.
        Q: joint coordinates [rad | m], shape (k, n).
    """
    places = np.asarray(Q, np.float64)
    found = np.zeros(places.shape)
    for axis, drive in enumerate(robot.drives):
        if isinstance(drive.transmission, Linkage):
            found[:, axis] = [reflected_inertia(drive, float(q)) for q in places[:, axis]]
        else:
            found[:, axis] = reflected_inertia(drive, 0.0)
    return found


def axis_inertias(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return the inertia that each axis moves while the others stand still, shape (k, n) [kg·m² | kg].

    Arguments and errors as in `mass_matrices`, whose diagonals these are.
    """
    return np.asarray(np.einsum("kii->ki", mass_matrices(robot, Q)))


def free_inertias(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return the inertia that each axis moves while the others are free, shape (k, n) [kg·m² | kg].

    It is 1 / (M⁻¹)ᵢᵢ, the inertia seen by a torque with the other axes free; arguments and errors as in
    `mass_matrices`.

    Raises:
        MissingMassError: M591, an axis moves nothing that has an inertia.
    """
    matrices = mass_matrices(robot, Q)
    try:
        return np.asarray(1.0 / np.einsum("kii->ki", np.linalg.inv(matrices)))
    except np.linalg.LinAlgError:
        raise missing_inertia(robot, idle_axes(matrices[0])) from None
