"""Which limit sets the time of each move of a plan, seen from its references."""

import numpy as np
import numpy.typing as npt

from ropsim.controller.kept_limits import ArmBounds, arm_bounds
from ropsim.controller.motion_plan import MotionPlan, PlannedMove
from ropsim.flow import CriticalLimit, LimitQuantity
from ropsim.kinematics import forward_batch
from ropsim.model import Payload, RobotModel
from ropsim.motion import JointBounds, JointMotionLimits, ToolLimits
from ropsim.spatial import Array, Pose

REACHED = 0.98
"""Share of a limit from which on it counts as reached: time laws keep a small distance to it."""

MOST_LOOKS = 64
"""Control ticks of a move that are looked at, evenly spaced: one of 64 is 1.6 % of its time."""

_QUANTITIES = (LimitQuantity.SPEED, LimitQuantity.ACCELERATION, LimitQuantity.TORQUE, LimitQuantity.JERK)
"""In the order in which they are named where two limits are reached for equally long."""
_OF_TOOL = (LimitQuantity.SPEED, LimitQuantity.ACCELERATION, LimitQuantity.JERK)

_TURNED = 1e-9
"""Entries of rotations that differ by less are the same, but for rounding."""


def critical_limits(
    plan: MotionPlan, robot: RobotModel, payload: Payload
) -> tuple[CriticalLimit | None, ...]:
    """Return for each move of a plan the limit that it is at for longest, None where it reaches none.

    Joints are held against the limits in force for the move: speed |q'|/v, acceleration |q''|/a, jerk by the
    difference of q'' at two control ticks, torque by the dynamics with the payload. On paths of the tool its
    speed, acceleration and jerk are held against those of the program, by differences of the poses.

    Args:
        plan: of a stretch.
        robot: the arm.
        payload: tool and part as one body, as it was planned with.
    """
    firsts = [0, *(move.last for move in plan.moves[:-1])]
    return tuple(
        _critical(plan, move, first, robot, payload) for move, first in zip(plan.moves, firsts, strict=True)
    )


def _critical(
    plan: MotionPlan, move: PlannedMove, first: int, robot: RobotModel, payload: Payload
) -> CriticalLimit | None:
    count = move.last - first - 1
    if move.limits is None or count < 1:
        return None
    looks = first + np.arange(0, count, -(-count // MOST_LOOKS))
    limits, bounds = move.limits, arm_bounds(robot, payload)
    shares = _joints(plan, looks, bounds.joints if move.on_tool_path else limits.joints, bounds)
    best = int(shares.argmax())
    found, share = divmod(best, robot.n), float(shares.flat[best])
    if move.on_tool_path:
        of_tool = _tool(plan, looks, limits.tool, robot, move.X_MT)
        quickest = int(of_tool.argmax())
        if of_tool[quickest] > share:
            return CriticalLimit("", _OF_TOOL[quickest % 3], float(of_tool[quickest]))
    if share == 0.0:
        return None
    return CriticalLimit(robot.axis_joints[found[1]].name, _QUANTITIES[found[0]], share)


def _joints(
    plan: MotionPlan, looks: npt.NDArray[np.intp], limits: JointMotionLimits | JointBounds, bounds: ArmBounds
) -> Array:
    """Return for which share of the looks each joint is at its limits, shape (4, n) as `_QUANTITIES`."""
    reference = plan.reference
    q, qd, qdd = reference.q[looks], reference.qd[looks], reference.qdd[looks]
    jerk = (reference.qdd[looks + 1] - qdd) / plan.period
    most = bounds.joints.effort
    known = bounds.effort is not None and most is not None
    torque = bounds.effort(q, qd, qdd) if bounds.effort is not None and known else np.zeros(q.shape)
    largest = most if most is not None and known else np.ones(q.shape[1])
    used = np.abs(np.array((qd, qdd, torque, jerk)))
    rows = np.array((limits.speed, limits.acceleration, largest, limits.jerk))
    shares: Array = np.add.reduce(used >= REACHED * rows[:, None], axis=1) / len(looks)
    return shares


def _tool(
    plan: MotionPlan, looks: npt.NDArray[np.intp], tool: ToolLimits, robot: RobotModel, X_MT: Pose
) -> Array:
    """Return for which share of the looks the tool is at its limits, shape (3,) or (6,) where it turns."""
    q, T = plan.reference.q, plan.period
    around = np.minimum(looks[:, None] + np.arange(4), len(q) - 1)
    X_BT = forward_batch(robot, q[around.ravel()]) @ X_MT.matrix()
    poses = X_BT.reshape(len(looks), 4, 4, 4)
    R, places = poses[..., :3, :3], poses[..., :3, 3]
    shares = _reached(places[:, 1:] - places[:, :-1], T, (tool.speed, tool.acceleration, tool.jerk))
    if bool((np.abs(R[0, 0] - R[-1, 0]) < _TURNED).all()):
        return shares
    turned = np.swapaxes(R[:, :-1], -1, -2) @ R[:, 1:]
    axes = ((2, 1), (0, 2), (1, 0))
    turns = 0.5 * np.stack([turned[..., a, b] - turned[..., b, a] for a, b in axes], axis=-1)
    limits = tool.orientation_speed, tool.orientation_acceleration, tool.orientation_jerk
    return np.concatenate((shares, _reached(turns, T, limits)))


def _reached(steps: Array, T: float, limits: tuple[float, float, float]) -> Array:
    """Return for which share of the looks speed, acceleration and jerk are at their limits, shape (3,).

    Args:
        steps: between four successive ticks [m | rad], shape (k, 3, 3).
        T: time of a control tick [s].
        limits: of speed, acceleration and jerk.
    """
    first, second, third = steps[:, 0], steps[:, 1], steps[:, 2]
    rates = np.array((first, second - first, third - 2.0 * second + first))
    squares = np.einsum("ikc,ikc->ik", rates, rates)
    least = np.array([REACHED * limit * T**power for power, limit in enumerate(limits, start=1)])
    shares: Array = np.add.reduce(squares >= (least**2)[:, None], axis=1) / len(steps)
    return shares
