"""The efforts of gravity and springs at the axes, for many configurations, without compiling anything."""

import numpy as np
import numpy.typing as npt

from ropsim.dynamics.loops.tree_motion import spring_loads, step_ratios
from ropsim.kinematics import frames_of_steps
from ropsim.model import BASE_LINK, JointType, Mechanism, joint_tree
from ropsim.spatial import Array, Pose, cross


def gravity_loads(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return the efforts that hold the arm against gravity and springs: -Σ Jᵥᵀ·m·g over the links.

    Jᵥ is the Jacobian of the centre of mass of a link, m its mass, g the acceleration of free fall.

    Args:
        robot: the arm, without payload.
        Q: joint coordinates [rad | m], shape (k, n).

    Returns:
        Shape (k, n) [N·m | N].
    """
    tree, frames = joint_tree(robot), frames_of_steps(robot, Q)  # (k, m, 4, 4)
    found = np.zeros((len(frames), tree.m))
    for i, link in enumerate(robot.links):
        step, X_SL = tree.carriers[i], tree.X_SL[i]
        if step == BASE_LINK or not link.mass:
            continue
        R, p = frames[:, step, :3, :3], frames[:, step, :3, 3]
        if Pose() != X_SL:
            R, p = R @ X_SL.rotation(), p + R @ X_SL.position
        centre = p + R @ link.com
        for j in tree.way(i):
            z = frames[:, j, :3, 2]
            slides = tree.types[j] is JointType.PRISMATIC
            along = z if slides else cross(z, centre - frames[:, j, :3, 3])
            found[:, j] -= link.mass * (along @ robot.gravity)
    if robot.cuts:
        found = (found[:, np.newaxis] @ step_ratios(robot, Q))[:, 0]
    elif not tree.parallel:
        found = found @ tree.T
    return np.asarray(found + spring_loads(robot, Q) if robot.springs or robot.joint_springs else found)
