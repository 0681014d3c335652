"""A safe first motion of an unknown robot: corners of a square in its workspace, found by its kinematics.

A configuration away from limits and singularities is searched, whose tool points down where the arm has the
axes for that, and then directions of the base frame along which the tool can be led from there.
"""

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from ropsim import kinematics
from ropsim.core import frozen_dataclass
from ropsim.kinematics import IkOptions, Method
from ropsim.model import RobotModel
from ropsim.spatial import Array, Pose, frozen

SHARES = (0.2, 0.1, 0.05)
"""Sides of the square that are tried, over the length of the arm."""
_CANDIDATES = 48
_REDUNDANT_CANDIDATES = 12  # arms with more axes than six can choose a posture at each of them
_STEPS = 12  # poses along a side
_MARGIN = 0.05  # of the range of a joint, to each of its limits
_FREE = 6  # axes from which on the orientation of the tool can be chosen
_DOWN = np.array([0.0, 1.0, 0.0, 0.0])  # Rx(π)
_NEAR = 1e-6  # [m, entries of a matrix], so near must a pose be reached
_GRID = 1e-3  # [m], to which corners are rounded, so that they read well


@frozen_dataclass
class FirstWay:
    """A way for a first program.

    Attributes:
        corners: poses X_BT of the tool, one after the other along straight lines; none without a line.
        turns: configurations to go through first [rad | m], each of shape (n,): where many postures reach the
            first corner, that from which the lines can be led; without corners they are all of the way.
    """

    corners: tuple[Pose, ...]
    turns: tuple[Array, ...] = ()


def first_way(robot: RobotModel, X_MT: Pose) -> FirstWay:
    """Return where a robot can go; see `first_ways`."""
    return next(first_ways(robot, X_MT))


def first_ways(robot: RobotModel, X_MT: Pose) -> Iterator[FirstWay]:
    """Yield where a robot can go, the best way first and the way without corners last.

    Args:
        robot: any arm.
        X_MT: tool in the frame of the mechanical interface.
    """
    starts = sorted(_starts(robot, X_MT), key=lambda one: -one[0])
    length = _length(robot, X_MT)
    known = kinematics.solver_of(robot).method is Method.CLOSED_FORM
    for corners_of in (_square, _pair):
        for share in SHARES:
            side = max(round(share * length / _GRID), 1) * _GRID
            for _, q, X_BT in starts:
                corners = corners_of(robot, X_MT, q, X_BT, side)
                if corners:
                    yield FirstWay(corners, () if known else (frozen(q),))
    yield turning(robot)


def turning(robot: RobotModel) -> FirstWay:
    """Return a way without corners, which turns every joint and which any arm can go."""
    middle = 0.5 * (robot.lower_limits + robot.upper_limits)
    reach = np.minimum(0.2 * (robot.upper_limits - robot.lower_limits), 1.0)
    while robot.cuts and reach.any() and not _is_followed(robot, (middle + reach, middle - 0.5 * reach)):
        middle, reach = robot.home, np.where(reach > _GRID, 0.5 * reach, 0.0)
    return FirstWay((), (frozen(middle + reach), frozen(middle - 0.5 * reach)))


def _is_followed(robot: RobotModel, turns: tuple[Array, ...]) -> bool:
    """Return whether closed chains follow an arm from home to configurations and back, within all limits."""
    shares = np.linspace(0.0, 1.0, _STEPS)[:, np.newaxis]
    ends = (robot.home, *turns, robot.home)
    rows = np.concatenate([one + shares * (other - one) for one, other in pairwise(ends)])
    within = (kinematics.follower_limits(robot).excess(rows) == 0.0).all()
    return bool(within) and kinematics.loop_passage(robot, rows).obstacle is None


def _starts(robot: RobotModel, X_MT: Pose) -> Iterator[tuple[float, Array, Pose]]:
    """Yield how good a configuration is, the configuration, and where the tool is then."""
    length = _length(robot, X_MT)
    count = _CANDIDATES if robot.n <= _FREE else _REDUNDANT_CANDIDATES
    for q in (robot.home, *kinematics.configurations(robot, count)):
        X_BT = kinematics.forward(robot, q) @ X_MT
        place = np.round(X_BT.position / _GRID) * _GRID
        directions = [Pose(place, X_BT.orientation)]
        if robot.n >= _FREE:
            directions.insert(0, Pose(place, _DOWN))
        for direction in directions:
            answer = kinematics.inverse(robot, direction @ X_MT.inverse(), IkOptions(near=q))
            if len(answer.solutions):
                found = answer.solutions[0]
                good = _goodness(robot, found, direction, length)
                if good > 0.0:
                    yield good, found, direction
                break


def _goodness(robot: RobotModel, q: Array, X_BT: Pose, length: float) -> float:
    """Return how far a configuration is from limits and singularities, less with the tool low or behind."""
    span = robot.upper_limits - robot.lower_limits
    room = float(np.minimum((q - robot.lower_limits) / span, (robot.upper_limits - q) / span).min())
    J = kinematics.jacobian(robot, q).copy()
    J[:3] /= length
    ease = float(np.linalg.svd(J, compute_uv=False)[min(robot.n, _FREE) - 1])
    x, _, z = X_BT.position.tolist()
    place = (1.0 if x > 0.0 else 0.5) * (1.0 if z > 0.1 * length else 0.1)
    return place * ease * max(min(room, 0.25) - _MARGIN, 0.0)


def _square(robot: RobotModel, X_MT: Pose, q: Array, X_BT: Pose, side: float) -> tuple[Pose, ...]:
    """Return a square that the tool can be led around; empty where there is none."""
    ways = _ways(robot, X_MT, q, X_BT, side)
    for first in ways:
        for second in ways:
            square = [0.0 * first, side * first, side * (first + second), side * second]
            if first @ second == 0.0 and _is_free(robot, X_MT, q, _line(X_BT, [*square, square[0]])):
                return tuple(_shifted(X_BT, one) for one in square)
    return ()


def _pair(robot: RobotModel, X_MT: Pose, q: Array, X_BT: Pose, side: float) -> tuple[Pose, ...]:
    """Return the ends of a line that the tool can be led along; empty where there is none."""
    ways = _ways(robot, X_MT, q, X_BT, side)
    return (X_BT, _shifted(X_BT, side * ways[0])) if ways else ()


def _ways(robot: RobotModel, X_MT: Pose, q: Array, X_BT: Pose, side: float) -> list[Array]:
    """Return the directions of the base frame in which the tool can be led away, unit vectors."""
    axes = [sign * axis for axis in np.eye(3) for sign in (1.0, -1.0)]
    return [axis for axis in axes if _is_free(robot, X_MT, q, _line(X_BT, [0.0 * axis, side * axis]))]


def _line(X_BT: Pose, shifts: list[Array]) -> list[Pose]:
    """Return poses on straight lines from shift to shift."""
    shares = np.linspace(0.0, 1.0, _STEPS, endpoint=False)
    inner = [one + share * (other - one) for one, other in pairwise(shifts) for share in shares]
    return [_shifted(X_BT, shift) for shift in (*inner, shifts[-1])]


def _is_free(robot: RobotModel, X_MT: Pose, q: Array, way: list[Pose]) -> bool:
    """Return whether the tool can be led along poses, with room to the limits of the joints."""
    T = np.array([(pose @ X_MT.inverse()).matrix() for pose in way])
    path = kinematics.inverse_path(robot, T, q)
    if np.isnan(path).any():
        return False
    room = _MARGIN * (robot.upper_limits - robot.lower_limits)
    if (path < robot.lower_limits + room).any() or (path > robot.upper_limits - room).any():
        return False
    return bool(np.abs(kinematics.forward_batch(robot, path) - T).max() < _NEAR)


def _shifted(pose: Pose, shift: Array) -> Pose:
    return Pose(pose.position + shift, pose.orientation)


def _length(robot: RobotModel, X_MT: Pose) -> float:
    """Return the sum of all lengths of the arm and its tool [m]."""
    steps = [joint.placement.position for joint in robot.joints]
    ends = [robot.interface.position, X_MT.position]
    return float(sum(np.linalg.norm(step) for step in (*steps, *ends)))
