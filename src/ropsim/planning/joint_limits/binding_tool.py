"""Which limit of the tool sets the time of a move on its path: speed, acceleration, jerk, or a bend."""

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import LimitQuantity
from ropsim.kinematics import forward_batch
from ropsim.model import RobotModel
from ropsim.motion import ToolLimits, ToolPath, constant_derivatives
from ropsim.planning.joint_limits.binding_kernel import four_in_sequence, tool_on_segments, tool_reached
from ropsim.planning.records.motion_plan import MotionPlan, TimedMove
from ropsim.spatial import Array

REACHED = 0.98
"""Share of a limit from which on it counts as reached: time laws keep a small distance to it."""

_QUANTITIES = (LimitQuantity.SPEED, LimitQuantity.ACCELERATION, LimitQuantity.JERK)
_SHARES = np.linspace(0.0, 1.0, 33)
"""Path parameters at which the bend of a path is evaluated, as shares of its length."""
_BENT = 1e-9
"""Second derivative times length, of the first one, from which on a path is bent."""


@frozen_dataclass
class TickSamples:
    """Control ticks of a plan at which its moves are evaluated; in arrays that may be longer.

    Attributes:
        ticks: their numbers, shape (size,).
        starts: the first of them at each of m moves, and how many there are, k, shape (m + 1,).
        reached: 1.0 where a joint is at one of its limits, else 0.0, shape (size,).
    """

    ticks: Array
    starts: Array
    reached: Array


def binding_of_tools(
    plan: MotionPlan,
    moves: Sequence[TimedMove],
    numbers: Sequence[int],
    samples: TickSamples,
    robot: RobotModel,
) -> list[tuple[LimitQuantity, float]]:
    """Return the limit of the tool that each move is at for longest, and for which share of the samples.

    Rates are expressed in the frame of the path, by differences of the poses at four ticks in a row. Where
    the path is bent and no limit is reached, of the tool or of a joint, the bend sets the time: a bent path
    needs a part of its acceleration and jerk for that, and planning leaves it.

    Args:
        plan: of a sequence.
        moves: on paths of the tool.
        numbers: of these moves among the evaluated ones, rising.
        samples: at the sequence.
        robot: the arm.
    """
    if not moves:
        return []
    starts, longest, idle = _counts(plan, moves, numbers, samples, robot)
    may_bend = [one.path is not None and constant_derivatives(one.path) is None for one in plan.path_segments]
    found = []
    for (first, end), (quantity, most) in zip(pairwise(starts), longest, strict=True):
        bent = _bent_samples(plan, idle[int(first) : int(end)].tolist()) if any(may_bend) else 0
        if bent > most:
            found.append((LimitQuantity.BEND, bent / (end - first)))
        else:
            found.append((_QUANTITIES[int(quantity)], most / (end - first)))
    return found


def _counts(
    plan: MotionPlan,
    moves: Sequence[TimedMove],
    numbers: Sequence[int],
    samples: TickSamples,
    robot: RobotModel,
) -> tuple[list[float], list[list[float]], Array]:
    """Return at how many samples limits are reached, and the path segment of each sample without one.

    Args:
        plan: of a sequence.
        moves: on paths of the tool, t of them.
        numbers: of these moves among the evaluated ones, rising.
        samples: at the sequence.
        robot: the arm.

    Returns:
        the first evaluation of each of these moves, and their number; the rest as `tool_reached` writes it.
    """
    q = np.ascontiguousarray(plan.reference.q)
    t, size = len(moves), len(samples.ticks)
    rows, here, chosen = np.empty((4 * size, q.shape[1])), np.empty((4, size)), np.array(numbers, dtype=float)
    ticks, reached, on, idle = here[0], here[1], here[2], here[3]
    first = np.empty(t + 1)
    four_in_sequence(q, samples.ticks, samples.reached, samples.starts, chosen, rows, ticks, reached, first)
    starts: list[float] = first.tolist()
    count = int(starts[-1])
    poses = forward_batch(robot, rows[: 4 * count])
    tools, least = np.empty((t, 4, 4)), np.full((t, 2, 3), np.inf)
    for number, one in enumerate(moves):
        if number and one.X_MT is moves[number - 1].X_MT:
            tools[number] = tools[number - 1]
        else:
            one.X_MT.write_matrix(tools[number])
        if one.limits is not None:
            least[number] = _least(one.limits.tool, plan.period)
    path_segments = np.array([(one.first, one.last) for one in plan.path_segments], dtype=np.float64).reshape(
        -1, 2
    )
    tool_on_segments(poses, first, tools, ticks, path_segments, on)
    for number, path_segment in enumerate(plan.path_segments):
        if path_segment.frame is not None:
            four = np.repeat(on[:count] == number, 4)
            poses[four] = np.linalg.solve(path_segment.frame.matrices(rows[: 4 * count][four]), poses[four])
    counts, longest = np.empty((t, 6)), np.empty((t, 2))
    tool_reached(poses, first, on, least, reached, counts, longest, idle)
    return starts, longest.tolist(), idle


def _bent_samples(plan: MotionPlan, idle: list[float]) -> int:
    """Return the number of evaluations of a move that lie where its path is bent and no limit is reached.

    Args:
        plan: of a sequence.
        idle: on which path segment each sample lies at which no limit is reached, else -1.0.
    """
    bent = 0
    for number in set(idle):
        path = plan.path_segments[int(number)].path if number >= 0.0 else None
        if path is not None and _is_bent(path):
            bent += idle.count(number)
    return bent


@lru_cache(maxsize=256)
def _least(limits: ToolLimits, T: float) -> Array:
    """Return the steps between ticks of T [s], and their changes, from which on limits count as reached.

    Returns:
        of the position [m] and of the orientation [rad], shape (2, 3).
    """
    speeds = limits.speed, limits.orientation_speed
    accelerations = limits.acceleration, limits.orientation_acceleration
    jerks = limits.jerk, limits.orientation_jerk
    rates = np.array((speeds, accelerations, jerks)).T
    return np.ascontiguousarray(REACHED * rates * np.array((T, T**2, T**3)))


def _is_bent(path: ToolPath) -> bool:
    """Return whether a path is bent, or its orientation leaves its turn."""
    if constant_derivatives(path) is not None:
        return False
    points = path.tool(_SHARES * path.length)
    return bool(np.abs(points.d2).max() * path.length > _BENT * np.abs(points.d1).max())
