"""Arms and places of their bases side by side, for the points of a task."""

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model import RobotModel
from ropsim.spatial import Pose, frozen
from ropsim.workspace.checking import Look, PointCheck, Setting, checked
from ropsim.workspace.point import PointKind, moved_point
from ropsim.workspace.ranges import axis_ranges
from ropsim.workspace.task_point import TaskPoint
from ropsim.workspace.volume.extremes import extremes
from ropsim.workspace.volume.sweep import SweepKind, sweep_of

CLOSELY = 8
"""Number of best candidates that are examined in detail."""


@frozen_dataclass
class Candidate:
    """An arm and where its base stands.

    Attributes:
        robot: the arm.
        X_WB: its base in the frame of the task.
        name: of both, for tables.
    """

    robot: RobotModel
    X_WB: Pose
    name: str


@frozen_dataclass
class Standing:
    """Result of a candidate for the points of a task.

    Attributes:
        candidate: arm and place.
        checks: of the points, in their order.
    """

    candidate: Candidate
    checks: tuple[PointCheck, ...]

    @property
    def reached(self) -> int:
        """Return how many points are reached."""
        return sum(one.reach is not None for one in self.checks)

    @property
    def margin(self) -> float:
        """Return the least margin to limits of the points that are reached, as a share; 0 without any."""
        return min((one.reach.margin.share for one in self.checks if one.reach), default=0.0)

    @property
    def manipulability(self) -> float:
        """Return the least manipulability of the points that are reached; 0 without any."""
        return min((one.reach.manipulability for one in self.checks if one.reach), default=0.0)

    @property
    def farthest(self) -> float:
        """Return by how much the point is missed that is missed most [m]; 0 where all are reached."""
        return max((one.miss.distance for one in self.checks if one.miss), default=0.0)


def compared(
    candidates: Sequence[Candidate], points: Sequence[TaskPoint], X_MT: Pose
) -> tuple[Standing, ...]:
    """Return the results of candidates for the points of a task, the best one first.

    First counts how many points are reached, then the least margin to the limits of the joints, then the
    least manipulability; candidates that are equal keep their order. Distances missed are only computed for
    the first `CLOSELY` ones.

    Args:
        candidates: arms and places of their bases.
        points: of the task.
        X_MT: tool frame in the frame of the mechanical interface, of all arms.
    """
    sizes = {one.robot: size_of(one.robot, X_MT) for one in candidates}
    look = Look.WHY if len(candidates) <= CLOSELY else Look.WHETHER

    def standing(one: Candidate, look: Look) -> Standing:
        setting = Setting(one.robot, one.X_WB, X_MT, sizes[one.robot])
        return Standing(one, tuple(checked(setting, point, look) for point in points))

    found = sorted((standing(one, look) for one in candidates), key=_rank)
    if look is Look.WHETHER:
        closely = sorted((standing(one.candidate, Look.WHY) for one in found[:CLOSELY]), key=_rank)
        found = [*closely, *found[CLOSELY:]]
    return tuple(found)


def _rank(standing: Standing) -> tuple[int, float, float]:
    return -standing.reached, -standing.margin, -standing.manipulability


@lru_cache(maxsize=64)
def size_of(robot: RobotModel, X_MT: Pose) -> float:
    """Return the reach of an arm: the greatest distance of its TCP from the first axis [m].

    Where the first axis does not turn it, half of the diagonal of the section reached by the TCP.
    """
    ranges = axis_ranges(robot)
    point = moved_point(robot, PointKind.TCP, X_MT)
    sweep = sweep_of(robot, point, ranges)
    ends = [one.value for one in extremes(robot, point, sweep, ranges)]
    if sweep.kind is SweepKind.TURN:
        return max(ends[1], 1e-9)
    return max(0.5 * float(np.hypot(ends[1] - ends[0], ends[3] - ends[2])), 1e-9)


def placements(points: Sequence[TaskPoint], reach: float, height: float, across: int) -> tuple[Pose, ...]:
    """Return places for a base around the points of a task, on a square grid, the base upright.

    Args:
        points: of the task.
        reach: of the arm [m]; the grid extends by it to all sides of the middle of the points.
        height: of the base in the frame of the task [m].
        across: places along a side.
    """
    middle = np.mean([one.position for one in points], axis=0)
    offsets = np.linspace(-reach, reach, across)
    return tuple(
        Pose(frozen(np.array([middle[0] + x, middle[1] + y, height]))) for y in offsets for x in offsets
    )
