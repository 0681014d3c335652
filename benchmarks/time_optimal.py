"""The least time on the way of a planned motion by toppra: limits of speed and acceleration, none of jerk."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from ropsim.kinematics import forward_batch
from ropsim.model import RobotModel
from ropsim.motion import ToolLimits
from ropsim.planning import MotionPlan
from ropsim.spatial import Array, Pose

_MOST_POINTS = 1500
"""Points of a way, about: with twice as many the least times differ by less than 0.1 %."""
_STANDING = 1e-3
"""Share of the greatest speed below which a tick says nothing about the direction of the way."""
_STEP = 1e-3
"""Step of differences along the way, in seconds at full speed of a joint."""
_STILL = 1e-9
"""Derivative below which a part of the way does not count for speed."""
_SIDES = 48
"""Sides of the polygon around a circle of accelerations: 0.2 % more than the limit at its corners."""


@dataclass(frozen=True)
class Way:
    """Where the joints go, at k points, over the length s of the way, in seconds at full speed.

    Attributes:
        s: of the points, rising from 0, shape (k,).
        q: joint coordinates [rad | m], shape (k, n).
        d1: their first derivatives by s, shape (k, n).
        d2: their second ones.
    """

    s: Array
    q: Array
    d1: Array
    d2: Array


def ways(plan: MotionPlan, robot: RobotModel) -> list[Way]:
    """Return the way of a plan between each two stops."""
    q = np.concatenate((plan.q_start[None], plan.reference.q))
    rest = np.zeros((1, q.shape[1]))
    qd, qdd = (np.concatenate((rest, rows)) for rows in (plan.reference.qd, plan.reference.qdd))
    stops = [0, *(move.last for move in plan.moves if move.zone == 0.0)]
    stops[-1] = len(q) - 1
    found = (
        _way(q[first : last + 1], qd[first : last + 1], qdd[first : last + 1], robot)
        for first, last in pairwise(stops)
        if last > first + 2
    )
    return list(found)


def _way(q: Array, qd: Array, qdd: Array, robot: RobotModel) -> Way:
    v, a = qd / robot.max_speeds, qdd / robot.max_speeds
    speed = np.linalg.norm(v, axis=1)
    steps = np.linalg.norm(np.diff(q / robot.max_speeds, axis=0), axis=1)
    s = np.concatenate(([0.0], np.cumsum(steps)))
    inner = (s > 0.0) & (s < s[-1])
    known = np.flatnonzero(inner & (speed > _STANDING * speed.max()))
    places, last = [int(known[0])], int(known[-1])
    for tick in known.tolist():
        if s[tick] - s[places[-1]] >= s[-1] / _MOST_POINTS:
            places.append(tick)
    if places[-1] != last:
        places[-1] = last
    w, change = speed[places][:, None], np.sum(v * a, axis=1)[places][:, None]
    d1 = qd[places] / w
    d2 = (qdd[places] - qd[places] * change / w**2) / w**2
    points = (s[places], q[places], d1, d2)
    ends = ((0.0, q[0], d1[0], 0.0 * d2[0]), (s[-1], q[-1], d1[-1], 0.0 * d2[-1]))
    whole = (np.concatenate(([a], b, [c])) for a, b, c in zip(ends[0], points, ends[1], strict=True))
    return Way(*whole)


def _of_tool(way: Way, robot: RobotModel, X_MT: Pose) -> tuple[Array, Array, Array, Array]:
    """Return velocity and turning of the tool by s, and their changes by s, shape (k, 3) each."""
    rows = [
        forward_batch(robot, way.q + h * way.d1 + 0.5 * h * h * way.d2) @ X_MT.matrix()
        for h in (-_STEP, 0.0, _STEP)
    ]
    before, here, behind = rows
    p1 = (behind[:, :3, 3] - before[:, :3, 3]) / (2.0 * _STEP)
    p2 = (behind[:, :3, 3] - 2.0 * here[:, :3, 3] + before[:, :3, 3]) / _STEP**2
    on, back = _turn(here, behind), _turn(here, before)
    return p1, p2, (on - back) / (2.0 * _STEP), (on + back) / _STEP**2


def _turn(one: Array, other: Array) -> Array:
    """Return the vectors of small turns [rad] between rotations in matrices, shape (k, 3)."""
    R = other[:, :3, :3] @ one[:, :3, :3].transpose(0, 2, 1)
    skew = np.stack((R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]), axis=1)
    sine = np.linalg.norm(0.5 * skew, axis=1, keepdims=True)
    return np.asarray(0.5 * skew * np.where(sine > 1e-12, np.arcsin(sine) / np.maximum(sine, 1e-300), 1.0))


def _sides(d1: Array, d2: Array, most: float) -> tuple[Array, Array, Array]:
    """Return rows α, β, γ with α·s'' + β·s'² ≤ γ for |d1·s'' + d2·s'²| ≤ most, shape (k, sides) each."""
    size = np.linalg.norm(d1, axis=1, keepdims=True)
    one = d1 / np.maximum(size, 1e-300)
    along = np.sum(one * d2, axis=1, keepdims=True)
    across = np.linalg.norm(d2 - one * along, axis=1, keepdims=True)
    angles = 2.0 * math.pi * np.arange(_SIDES) / _SIDES
    return (
        size * np.cos(angles),
        along * np.cos(angles) + across * np.sin(angles),
        np.full((len(d1), _SIDES), most),
    )


def least_time(plan: MotionPlan, robot: RobotModel, tool: ToolLimits | None) -> float:
    """Return the least time on the way of a plan, stops included [s].

    Args:
        plan: of a motion sequence; its moves have the same limits.
        robot: the arm.
        tool: limits of the tool; None for joint-space moves.
    """
    limits = plan.moves[0].limits
    assert limits is not None
    joints = limits.joints
    if tool is not None:
        speed, acceleration = robot.max_speeds, robot.max_accelerations
    else:
        speed, acceleration = joints.speed, joints.acceleration
    return sum(
        _time(way, robot, plan.moves[0].X_MT, (speed, acceleration), tool) for way in ways(plan, robot)
    )


def _time(way: Way, robot: RobotModel, X_MT: Pose, joints: Sequence[Array], tool: ToolLimits | None) -> float:
    speed, acceleration = joints
    most = ((speed / np.maximum(np.abs(way.d1), _STILL)) ** 2).min(axis=1)
    both = [(way.d1, way.d2, np.broadcast_to(acceleration, way.d1.shape))]
    both.append((-way.d1, -way.d2, both[0][2]))
    if tool is not None:
        p1, p2, turning, bending = _of_tool(way, robot, X_MT)
        for first, size in ((p1, tool.speed), (turning, tool.orientation_speed)):
            most = np.minimum(most, (size / np.maximum(np.linalg.norm(first, axis=1), _STILL)) ** 2)
        both.append(_sides(p1, p2, tool.acceleration))
        both.append(_sides(turning, bending, tool.orientation_acceleration))
    alpha, beta, gamma = (np.concatenate(rows, axis=1) for rows in zip(*both, strict=True))
    speeds = _fastest(way.s, (alpha, beta, gamma), most)
    return float(np.sum(2.0 * np.diff(way.s) / (speeds[1:] + speeds[:-1])))


def _fastest(s: Array, rows: tuple[Array, Array, Array], most: Array) -> Array:
    """Return the greatest speeds s' from rest to rest by toppra, shape (k,).

    Args:
        s: of the points.
        rows: of linear constraints of s'' and s'², shape (k, c) each.
        most: of s'², shape (k,).
    """
    import toppra

    toppra.setup_logging("ERROR")
    k, c = rows[0].shape

    class Straight(toppra.interpolator.AbstractGeometricPath):  # type: ignore[misc]
        """Stands for the way: the constraints know it."""

        dof = 1
        path_interval = (float(s[0]), float(s[-1]))

        def __call__(self, places: Any, order: int = 0) -> Array:
            return np.ones((len(np.atleast_1d(places)), 1)) * (order < 2)

    class Given(toppra.constraint.LinearConstraint):  # type: ignore[misc]
        """Rows that are computed already."""

        def __init__(self) -> None:
            super().__init__()
            self.dof = 1
            self.set_discretization_type(toppra.constraint.DiscretizationType.Collocation)

        def compute_constraint_params(self, *_: Any) -> tuple[Any, ...]:
            alpha, beta, gamma = rows
            eye = np.broadcast_to(np.eye(c), (k, c, c))
            bounds = np.column_stack((np.zeros(k), most))
            return alpha, beta, np.zeros_like(alpha), eye, gamma, None, bounds

    instance = toppra.algorithm.TOPPRA([Given()], Straight(), gridpoints=s, solver_wrapper="seidel")
    found = instance.compute_parameterization(0.0, 0.0)[1]
    assert found is not None, "toppra finds no motion"
    return np.asarray(found)
