"""Motions of all coordinates that move a tree, from those of its axes, and how they stretch springs."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from ropsim.dynamics.fastened import spring_numbers, spring_places
from ropsim.kinematics import frames_of_steps, joint_motion
from ropsim.model import (
    BASE_LINK,
    JointTree,
    JointType,
    Mechanism,
    coordinates,
    first_coordinates,
    joint_tree,
    passive_coordinates,
)
from ropsim.spatial import Array, cross


def tree_motion(
    robot: Mechanism,
    Q: npt.ArrayLike,
    speeds: npt.ArrayLike | None = None,
    accelerations: npt.ArrayLike | None = None,
) -> tuple[Array, Array, Array]:
    """Return coordinates, speeds and accelerations that move a tree, each of shape (k, n + p).

    They are those of the axes, then those that closed chains determine; where a chain cannot reach, those
    that bring it nearest.

    Args:
        robot: n axes.
        Q: coordinates of the axes [rad | m], shape (k, n).
        speeds: of the axes, shape (k, n); None for zero.
        accelerations: of the axes, shape (k, n); None for zero.
    """
    found = joint_motion(robot, Q, speeds, accelerations)
    first = first_coordinates(robot.joints)
    places = [*(first[number] for number in robot.axes), *passive_coordinates(robot)]
    y, yd, ydd = (
        np.ascontiguousarray(one[:, places]) for one in (found.position, found.speed, found.acceleration)
    )
    return y, yd, ydd


def passive_ratios(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return how fast each axis moves each coordinate that closed chains determine, shape (k, p, n).

    Args:
        robot: n axes.
        Q: coordinates of the axes [rad | m], shape (k, n).
    """
    rows, n = np.asarray(Q, np.float64), robot.n
    units = np.tile(np.eye(n), (len(rows), 1))
    _, speeds, _ = tree_motion(robot, np.repeat(rows, n, axis=0), units)
    return speeds[:, n:].reshape(len(rows), n, -1).transpose(0, 2, 1)


def step_ratios(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return how fast each axis moves each step of a mechanism, shape (k, m, n).

    Args:
        robot: n axes and m steps.
        Q: coordinates of the axes [rad | m], shape (k, n).
    """
    tree, rows = joint_tree(robot), np.asarray(Q, np.float64)
    if not tree.P.size:
        return np.broadcast_to(tree.T, (len(rows), *tree.T.shape))
    return np.asarray(tree.T + tree.P @ passive_ratios(robot, rows))


class SpringLengths(NamedTuple):
    """How axes stretch springs: between bodies, then on coordinates, s of them.

    Attributes:
        places: lengths [m], and coordinates [rad | m], shape (k, s).
        slopes: of them by the axes, shape (k, s, n).
    """

    places: Array
    slopes: Array


def spring_lengths(robot: Mechanism, Q: npt.ArrayLike) -> SpringLengths:
    """Return how the axes of a mechanism at Q (k, n) stretch its springs."""
    rows, tree = np.asarray(Q, np.float64), joint_tree(robot)
    ratios, first = step_ratios(robot, rows), len(robot.springs)
    total = first + len(robot.joint_springs)
    places, slopes = np.zeros((len(rows), total)), np.zeros((len(rows), total, robot.n))
    frames = frames_of_steps(robot, rows) if robot.springs else np.empty(0)
    for number, one in enumerate(spring_places(robot)):
        start = _points(frames, len(rows), one.first, one.point_1)
        end = _points(frames, len(rows), one.second, one.point_2)
        lengths = np.sqrt(((end - start) ** 2).sum(axis=1))
        u = (end - start) / np.maximum(lengths, np.finfo(float).tiny)[:, np.newaxis]
        by_steps = _along(tree, frames, one.second, end, u) - _along(tree, frames, one.first, start, u)
        places[:, number] = lengths
        slopes[:, number] = (by_steps[:, np.newaxis] @ ratios)[:, 0]
    if robot.joint_springs:
        numbers = [one.coordinate for one in robot.joint_springs]
        places[:, first:] = joint_motion(robot, rows).position[:, numbers]
        made, n = coordinates(robot), robot.n
        slopes[:, first:] = made.T[numbers]
        if made.P.size:
            units = np.tile(np.eye(n), (len(rows), 1))
            speeds = joint_motion(robot, np.repeat(rows, n, axis=0), units).speed[:, numbers]
            slopes[:, first:] = speeds.reshape(len(rows), n, -1).transpose(0, 2, 1)
    return SpringLengths(places, slopes)


def spring_loads(robot: Mechanism, Q: npt.ArrayLike) -> Array:
    """Return the efforts at the axes that hold still against springs, shape (k, n) [N·m | N]."""
    lengths, numbers = spring_lengths(robot, Q), spring_numbers(robot).reshape(-1, 3)
    stiffness, rest = numbers[:, 0], numbers[:, 1]
    return np.asarray(((lengths.places - rest) * stiffness)[:, np.newaxis] @ lengths.slopes)[:, 0]


def _along(tree: JointTree, frames: Array, step: int, points: Array, u: Array) -> Array:
    """Return how fast steps of a tree move points (k, 3) of one along directions (k, 3), shape (k, m)."""
    found = np.zeros((len(points), tree.m))
    while step != BASE_LINK:
        z = frames[:, step, :3, 2]
        turns = tree.types[step] is not JointType.PRISMATIC
        moved = cross(z, points - frames[:, step, :3, 3]) if turns else z
        found[:, step] = (u * moved).sum(axis=1)
        step = tree.parents[step]
    return found


def _points(frames: Array, count: int, step: int, point: tuple[float, ...]) -> Array:
    """Return a point of a step in the base frame, shape (count, 3)."""
    place = np.array(point)
    if step == BASE_LINK:
        return np.broadcast_to(place, (count, 3))
    return np.asarray(frames[:, step, :3, :3] @ place + frames[:, step, :3, 3])
