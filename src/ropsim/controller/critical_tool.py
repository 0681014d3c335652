"""Which limit of the tool sets the time of a move on its path: speed, acceleration, jerk, or a bend."""

from bisect import bisect_right
from collections.abc import Iterator
from itertools import islice

import numpy as np
import numpy.typing as npt

from ropsim.controller.critical_kernel import tool_reached
from ropsim.controller.motion_plan import MotionPlan, PlannedMove, PlannedPiece
from ropsim.flow import LimitQuantity
from ropsim.kinematics import forward_batch
from ropsim.model import RobotModel
from ropsim.motion import ToolLimits, ToolPath
from ropsim.spatial import Array, Pose

REACHED = 0.98
"""Share of a limit from which on it counts as reached: time laws keep a small distance to it."""

_QUANTITIES = (LimitQuantity.SPEED, LimitQuantity.ACCELERATION, LimitQuantity.JERK)
_PLACES = np.linspace(0.0, 1.0, 33)
"""Of a path at which its bend is looked at, as shares of its length."""
_BENT = 1e-9
"""Second derivative times length, of the first one, from which on a path is bent."""


def critical_of_tool(
    plan: MotionPlan,
    looks: npt.NDArray[np.intp],
    of_joints: npt.NDArray[np.bool_],
    move: PlannedMove,
    robot: RobotModel,
) -> tuple[LimitQuantity, float]:
    """Return the limit of the tool that a move is at for longest, and for which share of the looks.

    Rates are those in the frame of the path, by differences of the poses at four ticks in a row. Where the
    path is bent and no limit is reached, of the tool or of a joint, the bend sets the time: a tool that turns
    off its way needs a part of its acceleration and jerk for that, and planning leaves it.

    Args:
        plan: of a stretch.
        looks: rows of its reference, in order, shape (k,).
        of_joints: whether a joint is at one of its limits there, shape (k,).
        move: on a path of the tool.
        robot: the arm.
    """
    tool = move.limits.tool if move.limits else None
    counts, bent = np.zeros(6), 0
    for piece, on in _by_piece(plan, looks):
        reached = np.zeros((6, int(np.count_nonzero(on))))
        if tool is not None:
            poses = _poses(plan, looks[on], robot, move.X_MT, piece)
            tool_reached(poses, _least(tool, plan.period), reached)
        counts += np.add.reduce(reached, axis=1)
        free = ~(reached.any(axis=0) | of_joints[on])
        if piece is not None and piece.path is not None and free.any() and _is_bent(piece.path):
            bent += int(np.count_nonzero(free))
    best = int(counts.argmax())
    if bent > counts[best]:
        return LimitQuantity.BEND, bent / len(looks)
    return _QUANTITIES[best % 3], float(counts[best]) / len(looks)


def _by_piece(
    plan: MotionPlan, looks: npt.NDArray[np.intp]
) -> Iterator[tuple[PlannedPiece | None, npt.NDArray[np.bool_]]]:
    """Yield which looks are on each piece of the plan; those on none, where motions overlap, come last."""
    free, begin, end = np.ones(len(looks), dtype=bool), int(looks[0]), int(looks[-1])
    for piece in islice(plan.pieces, bisect_right(plan.pieces, begin, key=lambda one: one.last), None):
        if piece.first > end:
            break
        on = (looks >= piece.first) & (looks < piece.last)
        if on.any():
            yield piece, on
            free &= ~on
    if free.any():
        yield None, free


def _poses(
    plan: MotionPlan, looks: npt.NDArray[np.intp], robot: RobotModel, X_MT: Pose, piece: PlannedPiece | None
) -> Array:
    """Return the poses of the tool at each look and the three ticks behind it, in the frame of a piece.

    Returns:
        one behind the other, positions in m, shape (4·k, 4, 4).
    """
    q = plan.reference.q
    rows = q[np.minimum(looks[:, None] + np.arange(4), len(q) - 1).ravel()]
    poses = forward_batch(robot, rows) @ X_MT.matrix()
    if piece is not None and piece.frame is not None:
        poses = np.asarray(np.linalg.solve(piece.frame.matrices(rows), poses), dtype=np.float64)
    return np.ascontiguousarray(poses)


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
    points = path.tool(_PLACES * path.length)
    return bool(np.abs(points.d2).max() * path.length > _BENT * np.abs(points.d1).max())
