"""Which limit of the tool sets the time of a move on its path: speed, acceleration, jerk, or a bend."""

from bisect import bisect_right
from collections.abc import Sequence
from functools import lru_cache
from itertools import accumulate, islice

import numpy as np
import numpy.typing as npt

from ropsim.controller.critical_kernel import tool_reached
from ropsim.controller.motion_plan import MotionPlan, PlannedMove, PlannedPiece
from ropsim.core import frozen_dataclass
from ropsim.flow import LimitQuantity
from ropsim.kinematics import forward_batch
from ropsim.model import OrientationMode, RobotModel
from ropsim.motion import Line, ToolLimits, ToolPath
from ropsim.spatial import Array

REACHED = 0.98
"""Share of a limit from which on it counts as reached: time laws keep a small distance to it."""

_QUANTITIES = (LimitQuantity.SPEED, LimitQuantity.ACCELERATION, LimitQuantity.JERK)
_PLACES = np.linspace(0.0, 1.0, 33)
"""Of a path at which its bend is looked at, as shares of its length."""
_FOUR = np.arange(4)
_BENT = 1e-9
"""Second derivative times length, of the first one, from which on a path is bent."""


@frozen_dataclass
class _Group:
    """Looks at a move that lie on one piece of the plan, or on none.

    Attributes:
        move: it.
        piece: None where motions overlap.
        looks: numbers of the first one, and behind the last one, of each row of them; among all looks.
    """

    move: PlannedMove
    piece: PlannedPiece | None
    looks: tuple[tuple[int, int], ...]


def critical_of_tools(
    plan: MotionPlan,
    moves: Sequence[tuple[PlannedMove, range, int]],
    ticks: npt.NDArray[np.intp],
    of_joints: Array,
    robot: RobotModel,
) -> list[tuple[LimitQuantity, float]]:
    """Return the limit of the tool that each move is at for longest, and for which share of the looks.

    Rates are those in the frame of the path, by differences of the poses at four ticks in a row. Where the
    path is bent and no limit is reached, of the tool or of a joint, the bend sets the time: a tool that turns
    off its way needs a part of its acceleration and jerk for that, and planning leaves it.

    Args:
        plan: of a stretch.
        moves: on paths of the tool; the ticks of each that are looked at, and the number of the first of
            these looks.
        ticks: of all looks at the stretch, shape (k,).
        of_joints: 1.0 where a joint is at one of its limits at these, else 0.0, shape (k,).
        robot: the arm.
    """
    groups = [_by_piece(plan, *one) for one in moves]
    every = [one for several in groups for one in several]
    if not every:
        return []
    counted = iter(_counts(plan, every, ticks, of_joints, robot))
    found = []
    for (_, looks, _), several in zip(moves, groups, strict=True):
        counts, bent = [0.0] * 6, 0.0
        for group, (*reached, free) in zip(several, islice(counted, len(several)), strict=True):
            counts = [one + other for one, other in zip(counts, reached, strict=True)]
            path = group.piece.path if group.piece is not None else None
            if free and path is not None and _is_bent(path):
                bent += free
        most = max(counts)
        if bent > most:
            found.append((LimitQuantity.BEND, bent / len(looks)))
        else:
            found.append((_QUANTITIES[counts.index(most) % 3], most / len(looks)))
    return found


def _by_piece(plan: MotionPlan, move: PlannedMove, ticks: range, first: int) -> list[_Group]:
    """Return the looks on each piece of the plan; those on none, where motions overlap, come last.

    Args:
        plan: of a stretch.
        move: that is looked at.
        ticks: that are looked at.
        first: number of the first of these looks.
    """
    found, between, begin, come = [], [], ticks[0], 0
    for piece in islice(plan.pieces, bisect_right(plan.pieces, begin, key=lambda one: one.last), None):
        if piece.first > ticks[-1]:
            break
        low = min(max((piece.first - begin + ticks.step - 1) // ticks.step, come), len(ticks))
        high = min((piece.last - begin + ticks.step - 1) // ticks.step, len(ticks))
        if low < high:
            found.append(_Group(move, piece, ((first + low, first + high),)))
            between.append((first + come, first + low))
            come = high
    between.append((first + come, first + len(ticks)))
    free = tuple(one for one in between if one[0] < one[1])
    return [*found, _Group(move, None, free)] if free else found


def _counts(
    plan: MotionPlan,
    groups: Sequence[_Group],
    ticks: npt.NDArray[np.intp],
    of_joints: Array,
    robot: RobotModel,
) -> list[list[float]]:
    """Return at how many looks limits are reached, and at how many none is; see `tool_reached`."""
    looks = np.concatenate([np.arange(*part) for one in groups for part in one.looks])
    rows = plan.reference.q.take((ticks[looks][:, None] + _FOUR).ravel(), axis=0, mode="clip")
    poses = forward_batch(robot, rows)
    starts = [0, *accumulate(sum(last - first for first, last in one.looks) for one in groups)]
    tools, least = np.empty((len(groups), 4, 4)), np.full((len(groups), 2, 3), np.inf)
    for number, one in enumerate(groups):
        one.move.X_MT.write_matrix(tools[number])
        if one.move.limits is not None:
            least[number] = _least(one.move.limits.tool, plan.period)
        if one.piece is not None and one.piece.frame is not None:
            part = slice(4 * starts[number], 4 * starts[number + 1])
            moved = one.piece.frame.matrices(rows[part])
            poses[part], tools[number] = np.linalg.solve(moved, poses[part] @ tools[number]), np.eye(4)
    counts = np.empty((len(groups), 7))
    tool_reached(poses, np.array(starts, dtype=np.float64), tools, least, of_joints[looks], counts)
    found: list[list[float]] = counts.tolist()
    return found


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
    """Return whether a path turns off its way, or its orientation off its turn."""
    if isinstance(path, Line) and path.mode is OrientationMode.FIXED_AXIS:
        return False
    points = path.tool(_PLACES * path.length)
    return bool(np.abs(points.d2).max() * path.length > _BENT * np.abs(points.d1).max())
