"""The inertia that each joint axis moves when the others stand still, for many configurations at once."""

import numpy as np
import numpy.typing as npt

from ropsim.dynamics.drives import reflected_inertia
from ropsim.kinematics import frames_batch
from ropsim.model import JointType, RobotModel
from ropsim.spatial import Array


def axis_inertias(robot: RobotModel, Q: npt.ArrayLike) -> Array:
    """Return the diagonals of the mass matrix, motor inertia included, without compiling anything.

    A revolute axis with direction z through p moves Σ m·|z × (c - p)|² + zᵀ·I·z over the links beyond it
    (Steiner's theorem), a prismatic one Σ m.

    Args:
        robot: the arm, without payload.
        Q: joint coordinates [rad | m], shape (k, n).

    Returns:
        Shape (k, n) [kg·m² | kg].

    Raises:
        ArrayShapeError: M551, Q has another shape.
    """
    frames = frames_batch(robot, Q)  # (k, n + 1, 4, 4)
    inertias = np.zeros((len(frames), robot.n))
    for i, link in enumerate(robot.links):
        R, p = frames[:, i, :3, :3], frames[:, i, :3, 3]
        centre = p + R @ link.com
        about_centre = R @ link.inertia @ R.transpose(0, 2, 1)
        for j, joint in enumerate(robot.joints[: i + 1]):
            if joint.type is JointType.PRISMATIC:
                inertias[:, j] += link.mass
                continue
            z, origin = frames[:, j, :3, 2], frames[:, j, :3, 3]
            arms = np.cross(z, centre - origin)
            inertias[:, j] += link.mass * np.sum(arms * arms, axis=1)
            inertias[:, j] += np.einsum("ka,kab,kb->k", z, about_centre, z)
    rotors = [reflected_inertia(drive) for drive in robot.drives] or [0.0] * robot.n
    return np.asarray(inertias + np.array(rotors))
