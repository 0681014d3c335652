"""Which limit of the tool sets the time of a move on its path: speed, acceleration, jerk, or a bend."""

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from ropsim.controller.motion_plan import MotionPlan, PlannedMove, PlannedPiece
from ropsim.flow import LimitQuantity
from ropsim.kinematics import forward_batch
from ropsim.model import RobotModel
from ropsim.motion import ToolPath
from ropsim.spatial import Array, Pose

REACHED = 0.98
"""Share of a limit from which on it counts as reached: time laws keep a small distance to it."""

_QUANTITIES = (LimitQuantity.SPEED, LimitQuantity.ACCELERATION, LimitQuantity.JERK)
_TURNED = 1e-9
"""Entries of rotations that differ by less are the same, but for rounding."""
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
        R, places = _poses(plan, looks[on], robot, move.X_MT, piece)
        reached = np.zeros((6, len(R)), dtype=bool)
        if tool is not None:
            limits = tool.speed, tool.acceleration, tool.jerk
            reached[:3] = _reached(places[:, 1:] - places[:, :-1], plan.period, limits)
            if not bool((np.abs(R[0, 0] - R[-1, 0]) < _TURNED).all()):
                limits = tool.orientation_speed, tool.orientation_acceleration, tool.orientation_jerk
                reached[3:] = _reached(_turns(R), plan.period, limits)
        counts += np.add.reduce(reached, axis=1)
        free = ~(np.logical_or.reduce(reached) | of_joints[on])
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
    free = np.ones(len(looks), dtype=bool)
    for piece in plan.pieces:
        on = (looks >= piece.first) & (looks < piece.last)
        if on.any():
            yield piece, on
            free &= ~on
    if free.any():
        yield None, free


def _poses(
    plan: MotionPlan, looks: npt.NDArray[np.intp], robot: RobotModel, X_MT: Pose, piece: PlannedPiece | None
) -> tuple[Array, Array]:
    """Return rotations and places of the tool at four ticks, in the frame of a piece.

    Returns:
        of each look and the three ticks behind it, shapes (k, 4, 3, 3) and (k, 4, 3).
    """
    q = plan.reference.q
    rows = q[np.minimum(looks[:, None] + np.arange(4), len(q) - 1).ravel()]
    poses = forward_batch(robot, rows) @ X_MT.matrix()
    if piece is not None and piece.frame is not None:
        poses = np.asarray(np.linalg.solve(piece.frame.matrices(rows), poses), dtype=np.float64)
    poses = poses.reshape(len(looks), 4, 4, 4)
    return poses[..., :3, :3], poses[..., :3, 3]


def _turns(R: Array) -> Array:
    """Return the small turns between successive rotations [rad], shape (k, 3, 3)."""
    turned = np.swapaxes(R[:, :-1], -1, -2) @ R[:, 1:]
    axes = ((2, 1), (0, 2), (1, 0))
    return np.asarray(0.5 * np.stack([turned[..., a, b] - turned[..., b, a] for a, b in axes], axis=-1))


def _reached(steps: Array, T: float, limits: tuple[float, float, float]) -> npt.NDArray[np.bool_]:
    """Return at which looks speed, acceleration and jerk are at their limits, shape (3, k).

    Args:
        steps: between four successive ticks [m | rad], shape (k, 3, 3).
        T: time of a control tick [s].
        limits: of speed, acceleration and jerk.
    """
    first, second, third = steps[:, 0], steps[:, 1], steps[:, 2]
    rates = np.array((first, second - first, third - 2.0 * second + first))
    squares = np.einsum("ikc,ikc->ik", rates, rates)
    least = np.array([REACHED * limit * T**power for power, limit in enumerate(limits, start=1)])
    return np.asarray(squares >= (least**2)[:, None])


def _is_bent(path: ToolPath) -> bool:
    """Return whether a path turns off its way, or its orientation off its turn."""
    points = path.tool(_PLACES * path.length)
    return bool(np.abs(points.d2).max() * path.length > _BENT * np.abs(points.d1).max())
