"""Which limit of the tool sets the time of a move on its path: speed, acceleration, jerk, or a bend."""

from collections.abc import Sequence
from functools import lru_cache
from itertools import accumulate

import numpy as np
import numpy.typing as npt

from ropsim.controller.critical_kernel import piece_numbers, put_on, tool_reached
from ropsim.controller.motion_plan import MotionPlan, PlannedMove
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
    if not moves:
        return []
    lengths = [len(looks) for _, looks, _ in moves]
    starts = [0, *accumulate(lengths)]
    places = np.concatenate([np.arange(first, first + len(looks)) for _, looks, first in moves])
    counts, idle = _counts(
        plan, [move for move, _, _ in moves], starts, ticks[places], of_joints[places], robot
    )
    found = []
    for count, reached, first in zip(lengths, counts, starts[:-1], strict=True):
        most, bent = max(reached), 0
        for number in set(idle[first : first + count]):
            path = plan.pieces[int(number)].path if number >= 0.0 else None
            if path is not None and _is_bent(path):
                bent += idle[first : first + count].count(number)
        if bent > most:
            found.append((LimitQuantity.BEND, bent / count))
        else:
            found.append((_QUANTITIES[reached.index(most) % 3], most / count))
    return found


def _counts(
    plan: MotionPlan,
    moves: Sequence[PlannedMove],
    starts: Sequence[int],
    ticks: npt.NDArray[np.intp],
    of_joints: Array,
    robot: RobotModel,
) -> tuple[list[list[float]], list[float]]:
    """Return at how many looks limits are reached, and on which piece each look lies at which none is.

    Args:
        plan: of a stretch.
        moves: on paths of the tool, m of them.
        starts: how many looks come before those at each of them, and k.
        ticks: that are looked at, shape (k,).
        of_joints: 1.0 where a joint is at one of its limits at these, else 0.0, shape (k,).
        robot: the arm.

    Returns:
        the same as `tool_reached` writes.
    """
    rows = plan.reference.q.take((ticks[:, None] + _FOUR).ravel(), axis=0, mode="clip")
    poses, first = forward_batch(robot, rows), np.array(starts, dtype=np.float64)
    tools, least = np.empty((len(moves), 4, 4)), np.full((len(moves), 2, 3), np.inf)
    for number, one in enumerate(moves):
        one.X_MT.write_matrix(tools[number])
        if one.limits is not None:
            least[number] = _least(one.limits.tool, plan.period)
    put_on(poses, first, tools)
    on, idle, counts = np.empty(len(ticks)), np.empty(len(ticks)), np.empty((len(moves), 6))
    pieces = np.array([(one.first, one.last) for one in plan.pieces], dtype=np.float64).reshape(-1, 2)
    piece_numbers(ticks.astype(np.float64), pieces, on)
    for number, piece in enumerate(plan.pieces):
        if piece.frame is not None:
            here = np.repeat(on == number, 4)
            poses[here] = np.linalg.solve(piece.frame.matrices(rows[here]), poses[here])
    tool_reached(poses, first, on, least, of_joints, counts, idle)
    return counts.tolist(), idle.tolist()


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
