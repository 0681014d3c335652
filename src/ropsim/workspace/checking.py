"""Whether an arm reaches points of a task: with which posture and margin, or by how much not."""

from enum import Enum
from functools import lru_cache

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.kinematics import (
    IkStatus,
    LimitViolation,
    Method,
    inverse,
    inverse_batch,
    nearest,
    posture,
    solver_of,
    turning_axes,
)
from ropsim.model import RobotModel, coupled_limits
from ropsim.spatial import Array, Pose, record
from ropsim.workspace.directions import orientations, sphere
from ropsim.workspace.margins import Margin, manipulability, margin, shares
from ropsim.workspace.position_only import reaching
from ropsim.workspace.ranges import TURN
from ropsim.workspace.task_point import TaskPoint

FEW = 6
"""Axes below which an arm cannot turn its tool in all directions."""
SLACK = 1e-9
"""Rounding of a coordinate that stands on its limit [rad | m]."""
DIRECTIONS, ROLLS = 26, 4
"""Of the tool, that are tried where the orientation of a point is free."""


@record
class Reach:
    """How an arm reaches a point.

    Attributes:
        q: axes of the way that keeps farthest from the limits [rad | m], shape (n,).
        posture: its name, empty if the arm's class has no names.
        margin: to the limits there.
        manipulability: there, see `margins.manipulability`.
        ways: postures that reach it, within limits.
    """

    q: Array
    posture: str
    margin: Margin
    manipulability: float
    ways: int


@frozen_dataclass
class Miss:
    """By how much an arm fails to reach a point.

    Attributes:
        why: in words.
        distance: from it to the nearest place that the arm takes [m].
        angle: between the two orientations [rad]; 0 where any will do.
        violations: joints that would be beyond their limits, with the least violation; the arm then reaches
            the point except for them, and distance and angle are 0.
    """

    why: str
    distance: float
    angle: float
    violations: tuple[LimitViolation, ...] = ()


@frozen_dataclass
class PointCheck:
    """A point and the result of an arm for it.

    Attributes:
        point: in the frame of the task.
        reach: how it is reached; None where it is not.
        miss: why not; None where it is reached.
        directions: how many of `DIRECTIONS` the tool can have there, where the orientation is free, and the
            arm has six axes or more; None otherwise.
    """

    point: TaskPoint
    reach: Reach | None
    miss: Miss | None
    directions: int | None = None


class Look(Enum):
    """Depth of the check of a point: WHY includes the distance missed, WHETHER omits it."""

    WHY = "why"
    WHETHER = "whether"


NOT_LOOKED_FOR = Miss("not reached", 0.0, 0.0)
"""Miss of unreached points checked with `Look.WHETHER`."""


@frozen_dataclass
class Setting:
    """Arm, base and tool with which the points are to be reached.

    Attributes:
        robot: the arm.
        X_WB: where its base stands in the frame W of the task.
        X_MT: tool frame in the frame of the mechanical interface.
        size: reach of the arm, for `margins.manipulability` [m].
    """

    robot: RobotModel
    X_WB: Pose
    X_MT: Pose
    size: float


def checked(setting: Setting, point: TaskPoint, look: Look = Look.WHY) -> PointCheck:
    """Return the result of an arm for a point of a task.

    Args:
        setting: arm, base and tool.
        point: in the frame of the task.
        look: how closely.
    """
    robot, local = setting.robot, point.seen_from(setting.X_WB)
    pose = local.pose()
    if pose is not None:
        X_BM = pose @ setting.X_MT.inverse()
        rows = _answers(robot, X_BM)
        miss = None if len(rows) else NOT_LOOKED_FOR if look is Look.WHETHER else _why(robot, X_BM)
        return PointCheck(point, _best(setting, rows), miss)
    free = robot.n >= FEW and solver_of(robot).method is not Method.NUMERIC
    rows, directions = _any_way(robot, local, setting.X_MT) if free else (np.empty((0, robot.n)), 0)
    miss = None
    if not len(rows) and free and look is Look.WHETHER:
        miss = NOT_LOOKED_FOR
    elif not len(rows):
        rows, distance = reaching(robot, setting.X_MT.position, local.position)
        miss = None if len(rows) else Miss("out of reach in every orientation", distance, 0.0)
    return PointCheck(point, _best(setting, rows), miss, directions if free else None)


def _answers(robot: RobotModel, X_BM: Pose) -> Array:
    """Return all ways to a pose within limits, whole turns included, shape (k, n)."""
    found = inverse(robot, X_BM)
    if found.status is not IkStatus.FOUND:
        return np.empty((0, robot.n))
    return np.concatenate((found.solutions, *found.turns))


def _any_way(robot: RobotModel, local: TaskPoint, X_MT: Pose) -> tuple[Array, int]:
    """Return ways to a place in many orientations, (k, n), and in how many directions there is one."""
    T = np.tile(np.eye(4), (DIRECTIONS * ROLLS, 1, 1))
    T[:, :3, :3], T[:, :3, 3] = _tried(), local.position
    Q = inverse_batch(robot, T @ X_MT.inverse().matrix())
    lower, upper = robot.lower_limits, robot.upper_limits
    with np.errstate(invalid="ignore"):  # an axis without limits has no middle
        middle = np.nan_to_num(0.5 * (lower + upper), posinf=0.0, neginf=0.0)
    Q = Q + TURN * turning_axes(robot) * np.round((middle - Q) / TURN)
    inside = ((lower - SLACK <= Q) & (upper + SLACK >= Q)).all(axis=2)
    inside &= (coupled_limits(robot).excess(Q) == 0.0).all(axis=2)
    reached = inside.reshape(DIRECTIONS, -1).any(axis=1)
    return np.clip(Q[inside], lower, upper), int(reached.sum())


@lru_cache(maxsize=1)
def _tried() -> Array:
    """Return the orientations that are tried, shape (DIRECTIONS·ROLLS, 3, 3)."""
    return orientations(sphere(DIRECTIONS), ROLLS)


def _best(setting: Setting, rows: Array) -> Reach | None:
    """Return the way that keeps farthest from the limits."""
    if not len(rows):
        return None
    robot = setting.robot
    margins = shares(robot, rows)
    k = int(np.argmax(margins.min(axis=1)))
    name = str(posture(robot, rows[k])) if solver_of(robot).parts else ""
    free = manipulability(robot, rows[k], setting.X_MT, setting.size)
    return Reach(rows[k], name, margin(robot, rows[k]), free, len(rows))


def _why(robot: RobotModel, X_BM: Pose) -> Miss:
    """Return why a pose is not reached, and the nearest pose."""
    found = inverse(robot, X_BM)
    if found.violations:
        return Miss(found.status.value, 0.0, 0.0, found.violations)
    beside = nearest(robot, X_BM)
    return Miss(found.status.value, beside.distance, beside.angle)
