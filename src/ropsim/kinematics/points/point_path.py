"""Joint coordinates along a path of the TCP of an arm with few axes, whatever the orientation."""

import numpy as np
import numpy.typing as npt

from ropsim.kinematics.chain.closed_arrays import ClosedArrays
from ropsim.kinematics.chain.forward import frames_batch
from ropsim.kinematics.points.closed_points import closed_followed, closed_rows
from ropsim.kinematics.points.point_arm import PointShape, point_shape
from ropsim.kinematics.points.point_path_kernel import branch_sides, follow_points
from ropsim.kinematics.points.point_rows_kernel import continue_rows, reach_rows
from ropsim.kinematics.points.points_in_arm import of_arm, of_whole, points_in_arm, tcp_of
from ropsim.kinematics.solutions.polish import POSE_SLACK, TASK_SLACK
from ropsim.model import BASE_LINK, RobotModel, held_arm
from ropsim.spatial import Array, Pose

Bools = npt.NDArray[np.bool_]


def followed_points(
    robot: RobotModel, s: Array, points: Array, q_start: Array, X_MT: Pose, tool: Array
) -> tuple[Array, Array] | None:
    """Return joint coordinates (k, n) along a path of the TCP, and their derivatives (2, k, n).

    The branch of the start is kept. Of an arm with joints to spare each joint moves as little as can be: of
    all joint rates those with the least sum of squares, as shares of the greatest speeds of the joints.

    Args:
        robot: for which `chooses_points_only` holds; its external axes stand still.
        s: path parameters, rising, shape (k,).
        points: of the TCP there in the base frame [m], shape (k, 3).
        q_start: joint coordinates at the first of them [rad | m], shape (n,).
        X_MT: the tool.
        tool: first and second derivatives of the TCP by the parameter, of which the first three numbers
            count, shape (2, k, 6).

    Returns:
        None where a point is not reached from the one before it, or is near a singularity.
    """
    shape, goals = point_shape(robot, X_MT.position), points_in_arm(robot, points, q_start)
    if not shape.rank:
        return None
    rates = np.ascontiguousarray(tool[:, :, :3])
    if robot.external and (carrier := held_arm(robot).carrier) != BASE_LINK:
        rates = np.ascontiguousarray(rates @ frames_batch(robot, q_start[np.newaxis])[0, carrier, :3, :3])
    q, out = np.empty((len(s), shape.chain.n)), np.empty((2, len(s), shape.chain.n))
    q[0], result = of_arm(robot, q_start), np.array(allowed(shape))
    if isinstance(shape.chain, ClosedArrays):
        closed = closed_followed(shape, shape.chain, s, goals, rates, q[0], allowed(shape))
        if closed is None:
            return None
        q, out = closed
    else:
        arm, work, room = shape.for_kernels()
        follow_points(arm, s, goals, rates, q, out, work, room, result)
        if result[0] < 0.0:
            return None
    derivatives = np.zeros((2, len(s), len(q_start)))
    derivatives[..., list(held_arm(robot).axes) if robot.external else slice(None)] = out
    return of_whole(robot, q_start, q), derivatives


def points_continued(robot: RobotModel, X_MT: Pose, points: Array, q_start: Array, held: Array) -> Array:
    """Return joint coordinates along a path of the TCP, each found from the one before.

    Args:
        robot: with its external axes; `chooses_points_only` holds.
        X_MT: the tool.
        points: in the base frame [m], shape (k, 3).
        q_start: joint coordinates one step before the first one [rad | m], shape (n,).
        held: coordinates of the axes, of which only the external ones count [rad | m], shape (n,) or (k, n).

    Returns:
        Shape (k, n); NaN from the first point on that is not reached, or only on another branch.
    """
    shape, goals = point_shape(robot, X_MT.position), points_in_arm(robot, points, held)
    q, misses = np.empty((len(points), shape.chain.n)), np.empty((len(points), 2))
    q[0], sides = of_arm(robot, q_start), np.empty(len(points) + 1)
    if shape.rank and isinstance(shape.chain, ClosedArrays):
        rows = np.vstack((q[:1], q))
        goals = np.vstack((tcp_of(shape, q[0]), goals))
        rows, found = closed_rows(shape, shape.chain, goals, rows, continued=True)
        q, misses, sides = rows[1:], found[1:, :2], found[:, 2]
    elif shape.rank:
        arm, work, room = shape.for_kernels()
        continue_rows(arm, goals, q, work, room, misses)
        rows = np.vstack((of_arm(robot, q_start), q))
        branch_sides(arm, rows, work, room, sides)
    else:
        sides[:], q[:] = 0.0, q[0]
        misses[:] = np.linalg.norm(goals - tcp_of(shape, q[0]), axis=1)[:, np.newaxis]
    lost = np.flatnonzero(~reached(shape, misses) | (sides[1:] * sides[0] < 0.0))
    q[lost[0] if len(lost) else len(q) :] = np.nan
    return of_whole(robot, held, q)


def points_near(robot: RobotModel, X_MT: Pose, points: Array, Q: Array) -> Array:
    """Return joint coordinates that bring the TCP to points, each found from a guess.

    Args:
        robot: with its external axes, which are where the guesses have them; `chooses_points_only` holds.
        X_MT: the tool.
        points: in the base frame [m], shape (k, 3).
        Q: guesses [rad | m], shape (k, n).

    Returns:
        Shape (k, n); NaN where a point is not reached.
    """
    shape = point_shape(robot, X_MT.position)
    q, misses = searched(shape, points_in_arm(robot, points, Q), of_arm(robot, Q))
    q[~reached(shape, misses)] = np.nan
    return of_whole(robot, Q, q)


def searched(shape: PointShape, goals: Array, starts: Array) -> tuple[Array, Array]:
    """Return where the search from starts (k, n) for goals (k, 3) ends, and what is left [m], (k, 2)."""
    if shape.rank and isinstance(shape.chain, ClosedArrays):
        q, found = closed_rows(shape, shape.chain, goals, starts, continued=False)
        return q, np.ascontiguousarray(found[:, :2])
    q, misses = np.array(starts), np.empty((len(starts), 2))
    if shape.rank:
        arm, work, room = shape.for_kernels()
        reach_rows(arm, np.ascontiguousarray(goals), q, work, room, misses)
    else:
        misses[:] = np.linalg.norm(goals - tcp_of(shape, q[0]), axis=1)[:, np.newaxis]
    return q, misses


def allowed(shape: PointShape) -> tuple[float, float]:
    """Return how far the TCP may be from a point along the directions in which it moves, and in all [m]."""
    return POSE_SLACK if shape.is_flat else TASK_SLACK, POSE_SLACK if shape.rank == 3 else TASK_SLACK


def reached(shape: PointShape, misses: Array) -> Bools:
    """Return at which rows of `searched` nothing is left, shape (k,); misses [m], shape (k, 2)."""
    along, in_all = allowed(shape)
    there: Bools = (misses[:, 0] <= along) & (misses[:, 1] <= in_all)
    return there
