"""External axes in inverse kinematics: where they are is given, and the arm is solved in its moved base."""

from dataclasses import replace

import numpy as np

from ropsim.kinematics.chain.forward import frames_batch
from ropsim.kinematics.solutions.result import NO_AXIS, IkResult
from ropsim.model import BASE_LINK, HeldArm, RobotModel
from ropsim.spatial import Array


def in_arm_base(robot: RobotModel, held: HeldArm, q: Array, T: Array) -> Array:
    """Return poses in the base frame of the robot as poses in that of its arm, shape (k, 4, 4).

    Args:
        robot: with external axes.
        held: its arm.
        q: coordinates of the axes, only the external ones count [rad | m], shape (n,) for all poses or (k, n)
            for each of them.
        T: poses in the base frame of the robot, shape (k, 4, 4).
    """
    if held.carrier == BASE_LINK:
        return T
    X_BC = frames_batch(robot, np.atleast_2d(q))[:, held.carrier]
    X_CB = np.zeros(X_BC.shape)
    X_CB[:, :3, :3] = X_BC[:, :3, :3].swapaxes(1, 2)
    X_CB[:, :3, 3:] = -X_CB[:, :3, :3] @ X_BC[:, :3, 3:]
    X_CB[:, 3, 3] = 1.0
    return np.asarray(X_CB @ T)


def of_robot(held: HeldArm, q: Array, found: Array) -> Array:
    """Return coordinates of all axes from coordinates of the arm.

    Args:
        held: the arm.
        q: coordinates of all axes, the external ones are kept [rad | m], shape (n,), or (k, n) with a row for
            each of the k rows of `found`.
        found: of the arm, NaN rows stay NaN, shape (..., axes of the arm).
    """
    if q.ndim == 2:
        q = q.reshape(len(q), *(1,) * (found.ndim - 2), -1)
    whole = np.empty((*found.shape[:-1], q.shape[-1]))
    whole[:] = np.where(np.isnan(found[..., :1]), np.nan, q)
    whole[..., list(held.axes)] = found
    return whole


def result_of_robot(held: HeldArm, q: Array, found: IkResult) -> IkResult:
    """Return an answer of the arm as one of the robot; arguments as in `of_robot`."""
    return replace(
        found,
        solutions=of_robot(held, q, found.solutions),
        turns=tuple(of_robot(held, q, turns) for turns in found.turns),
        branches=of_robot(held, q, found.branches),
        violations=tuple(
            replace(one, joint=held.axes[one.joint]) if one.joint != NO_AXIS else one
            for one in found.violations
        ),
    )
