"""All ways to bring the TCP of an arm with few axes to a point, whatever the orientation."""

from math import inf

import numpy as np

from ropsim.kinematics.chain.closed_arrays import ClosedArrays
from ropsim.kinematics.points.closed_points import closed_nearest
from ropsim.kinematics.points.point_arm import Places, PointShape, point_shape
from ropsim.kinematics.points.point_path import reached, searched
from ropsim.kinematics.points.point_rows_kernel import approach_rows
from ropsim.kinematics.points.points_in_arm import of_arm, of_whole, points_in_arm, tcp_of
from ropsim.kinematics.solutions.polish import TASK_SLACK
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose, record

ROUNDS = 200
"""Steps to the nearest of all answers at most, where an arm has joints to spare."""
BEST, AGAIN = 4, 10
"""Where no start leads to a point, the search goes on so often from so many of the nearest places."""
BEYOND = 1e9
"""A distance of places that closed chains do not reach [m]."""
SAME = 1e-6
"""Answers nearer to each other than this are one [rad | m]."""
TURN = 2.0 * np.pi


@record
class PointAnswers:
    """How an arm brings its TCP to a point.

    Attributes:
        branches: joint coordinates [rad | m], shape (m, n), with angles in (-π, π]; of an arm with joints to
            spare those next to where it stands, within its limits where there are such.
        places: where the TCP can be.
        miss: distance of the nearest of these places from the point [m]; 0 where the point is reached.
        beside: distance of the point from plane or line of these places [m]; 0 where they have none.
    """

    branches: Array
    places: Places
    miss: float
    beside: float


def point_answers(robot: RobotModel, X_MT: Pose, point: Array, near: Array) -> PointAnswers:
    """Return all joint coordinates that were found to bring the TCP to a point.

    A point is reached within 1e-9 m in the directions in which the TCP moves and within `TASK_SLACK` beside
    them. The search starts from where the arm stands and from places that fill its range; of an arm whose
    joints all turn all branches are found that way but in rare cases.

    Args:
        robot: with its external axes, which stay; `chooses_points_only` holds.
        X_MT: the tool.
        point: in the base frame [m], shape (3,).
        near: joint coordinates of all axes [rad | m], shape (n,).
    """
    shape, goal = point_shape(robot, X_MT.position), points_in_arm(robot, point[np.newaxis], near)[0]
    own = of_arm(robot, near)
    starts = np.vstack((own, shape.starts))
    if shape.rank == 0:
        away = float(np.linalg.norm(goal - tcp_of(shape, own)))
        rows = own[np.newaxis] if away <= TASK_SLACK else own[np.newaxis][:0]
        return PointAnswers(of_whole(robot, near, rows), shape.places, away, 0.0)
    q, misses = searched(shape, np.tile(goal, (len(starts), 1)), starts)
    if not reached(shape, misses).any():
        q, misses = _nearer(shape, goal, q, misses, own)
    nearest = int(np.argmin(misses[:, 1]))
    off = goal - tcp_of(shape, q[nearest])
    beside = float(np.linalg.norm(off - shape.space.T @ (shape.space @ off))) if shape.is_flat else 0.0
    found = q[reached(shape, misses)]
    miss = 0.0 if len(found) else float(misses[nearest, 1])
    spare = shape.spare > 0 and not isinstance(shape.chain, ClosedArrays)
    if spare and len(found):
        found = _approached(shape, goal, own, found)
    turning = shape.chain.turning
    found = found - TURN * np.ceil((found - np.pi) / TURN) * turning if not spare else found
    return PointAnswers(of_whole(robot, near, _each_once(found, turning)), shape.places, miss, beside)


def _nearer(shape: PointShape, goal: Array, q: Array, misses: Array, own: Array) -> tuple[Array, Array]:
    """Return places nearer to a point than those of a search: the least distance needs more steps."""
    best = np.argsort(misses[:, 1], kind="stable")[:BEST]
    if isinstance(shape.chain, ClosedArrays):
        starts = [*q[best[misses[best, 1] < BEYOND]], own]
        found = [closed_nearest(shape, shape.chain, goal, start) for start in starts]
        return np.array([one for one, _ in found]), np.array([[away, away] for _, away in found])
    q, misses = q[best], misses[best]
    for _ in range(AGAIN):
        q, misses = searched(shape, np.tile(goal, (len(q), 1)), q)
    return q, misses


def _approached(shape: PointShape, goal: Array, near: Array, found: Array) -> Array:
    """Return answers next to `near` (n,): within the limits where there are such, else any."""
    turning, (lower, upper) = shape.chain.turning, shape.limits
    rows = found + TURN * np.round((near - found) / TURN) * turning
    inside = rows + TURN * turning * (
        np.ceil(np.maximum(lower - rows, 0.0) / TURN) - np.ceil(np.maximum(rows - upper, 0.0) / TURN)
    )
    for starts, bounds in ((inside, shape.limits), (rows, np.array([[-inf] * len(near), [inf] * len(near)]))):
        arm, work, room = shape.for_kernels()
        q, misses = np.array(starts), np.empty((len(starts), 2))
        approach_rows(arm, goal, near, bounds, q, work, room, ROUNDS, misses)
        answers = q[reached(shape, misses)]
        if len(answers):
            return np.asarray(answers)
    return rows


def _each_once(rows: Array, turning: Array) -> Array:
    """Return each of rows (m, n) once, whole turns aside."""
    kept = rows[:0]
    for q in rows:
        apart = kept - q
        apart -= TURN * np.round(apart / TURN) * turning
        if not (np.abs(apart).max(axis=1) <= SAME).any():
            kept = np.vstack((kept, q))
    return kept
