"""Exact derivatives of the joints along a path of the tool, for arms of up to seven axes."""

from functools import lru_cache

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.arm_arrays import arm_arrays
from ropsim.kinematics.chain.arrays import ChainArrays, chain_arrays, joint_rows, pose_rows
from ropsim.kinematics.chain.closed_arrays import ClosedArrays
from ropsim.kinematics.chain.closed_jacobian_kernel import closed_derivatives_along
from ropsim.kinematics.chain.closure import closed_states
from ropsim.kinematics.chain.linear_loops import without_linear_loops
from ropsim.kinematics.chain.path_derivatives_kernel import DerivativeWork, derivatives_along
from ropsim.kinematics.recognition import solver_of
from ropsim.kinematics.solutions.followed_kernel import FollowedArm, follow_rows
from ropsim.kinematics.solutions.polish import unbounded
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose, frozen

_POSE = 6
_MOST = 7
"""Axes of the arm at most: one more than a pose needs."""


def has_path_derivatives(robot: RobotModel) -> bool:
    """Return whether derivatives along a path can be found for an arm."""
    most = _POSE if robot.cuts and without_linear_loops(robot).cuts else _MOST
    return 0 < robot.n - len(robot.external) <= most


def is_followed(robot: RobotModel) -> bool:
    """Return whether an arm has one axis more than its pose needs, so that `followed` decides its joints."""
    return robot.n - len(robot.external) > _POSE and has_path_derivatives(robot)


def path_derivatives(robot: RobotModel, Q: npt.ArrayLike, X_MT: Pose, tool: Array) -> Array | None:
    """Return first and second derivatives of the joints along a path of the tool, shape (2, k, n).

    J·q' = v' and J·q'' = a' - J'·q'; external axes stand still. Of an arm with a joint more than its pose
    needs they are the least ones (see `followed`).

    Args:
        robot: arm with n joints.
        Q: joint coordinates on the path [rad | m], shape (k, n).
        X_MT: tool frame in the mechanical interface frame.
        tool: v' and a', first and second derivatives of position and angular velocity of the tool by the path
            parameter in the base frame, see `motion.ToolPoints`, shape (2, k, 6).

    Returns:
        the derivatives by the path parameter; None where a row is near a singularity.

    Raises:
        ArrayShapeError: M551, Q has another shape.
    """
    rows = np.ascontiguousarray(joint_rows(robot, Q))
    out, result = np.empty((2, *rows.shape)), np.empty(1)
    position, chain = np.ascontiguousarray(X_MT.position), arm_arrays(robot)
    if isinstance(chain, ClosedArrays):
        room, states = _work(len(chain.steps), chain.n), closed_states(chain, rows)[0]
        closed_derivatives_along(
            chain.arm(), states, _active(robot), position, tool, out, chain.work(), room, result
        )
        return out if result[0] else None
    derivatives_along(
        chain.flat, chain.spread, _active(robot), position, rows, tool, out, _room(chain), result
    )
    return out if result[0] else None


def followed(
    robot: RobotModel, s: Array, T: npt.ArrayLike, q_start: Array, X_MT: Pose, tool: Array
) -> tuple[Array, Array] | None:
    """Return joint coordinates (k, n) along a path, and their derivatives by its parameter (2, k, n).

    Of all joint rates that move the tool those with the least sum of squares; which rows are asked for does
    not count, up to the third power of their distance.

    Args:
        robot: arm with n joints, one more than its pose needs.
        s: path parameters, rising, shape (k,).
        T: poses X_BM there, shape (k, 4, 4).
        q_start: joint coordinates at the first of them [rad | m], shape (n,).
        X_MT: tool frame in the mechanical interface frame.
        tool: derivatives of the tool, as for `path_derivatives`.

    Returns:
        None where a pose is not reached from the one before it, or is near a singularity.

    Raises:
        ArrayShapeError: M551, T has another shape.
    """
    chain, poses, n = chain_arrays(without_linear_loops(robot)), pose_rows(T), len(q_start)
    bounds, active = unbounded(n), _active(robot)
    bounds[:, active == 0.0] = q_start[active == 0.0]
    arm = FollowedArm(
        chain.flat,
        chain.spread,
        active,
        np.ascontiguousarray(X_MT.position),
        bounds,
        np.zeros((n + 12, max(n, _POSE))),
    )
    Q, out, result = np.empty((len(s), n)), np.empty((2, len(s), n)), np.empty(1)
    Q[0] = q_start
    follow_rows(arm, s, poses, tool, Q, out, _room(chain), solver_of(robot).slack, result)
    return (Q, out) if result[0] else None


@lru_cache(maxsize=64)
def _active(robot: RobotModel) -> Array:
    """Return 1.0 for axes of the arm and 0.0 for external ones, shape (n,)."""
    active = np.ones(robot.n)
    active[list(robot.external)] = 0.0
    return frozen(active)


def _room(chain: ChainArrays) -> DerivativeWork:
    return _work(len(chain.slides), chain.n)


def _work(m: int, n: int) -> DerivativeWork:
    return DerivativeWork(
        np.empty((m + 1, 12)),
        np.empty((7, m)),
        np.empty((6, m)),
        np.empty((12, n)),
        np.empty((6, n + _POSE)),
        np.empty((5, max(n, _POSE))),
    )
