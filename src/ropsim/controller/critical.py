"""Which limit sets the time of each move of a plan, seen from its references."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt

from ropsim.controller.critical_kernel import joints_reached
from ropsim.controller.critical_tool import REACHED, critical_of_tool
from ropsim.controller.kept_limits import ArmBounds, arm_bounds
from ropsim.controller.motion_plan import MotionPlan, PlannedMove
from ropsim.flow import CriticalLimit, LimitQuantity
from ropsim.model import Payload, RobotModel
from ropsim.motion import JointBounds, JointMotionLimits

MOST_LOOKS = 64
"""Control ticks of a move that are looked at, evenly spaced: one of 64 is 1.6 % of its time."""

PRESSED = 0.9
"""Share of acceleration or jerk at its peak from which on a joint counts as what slows a bend."""

_QUANTITIES = (LimitQuantity.SPEED, LimitQuantity.ACCELERATION, LimitQuantity.TORQUE, LimitQuantity.JERK)
"""In the order in which they are named where two limits are reached for equally long."""


def critical_limits(
    plan: MotionPlan, robot: RobotModel, payload: Payload
) -> tuple[CriticalLimit | None, ...]:
    """Return for each move of a plan the limit that it is at for longest, None where it reaches none.

    Joints are held against the limits in force for the move: speed |q'|/v, acceleration |q''|/a, jerk by the
    difference of q'' at two control ticks, torque by the dynamics with the payload. On paths of the tool its
    speed, acceleration, jerk and the bends of the path are held against those of the program
    (`critical_tool`), and external axes that go along against the speed that they may have then.

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
    held = _going_along(move, robot, bounds) if move.on_tool_path else limits.joints
    reached = _joints(plan, looks, held, bounds)
    shares = np.add.reduce(reached, axis=1) / len(looks)
    best = int(shares.argmax())
    found, share = divmod(best, robot.n), float(shares.flat[best])
    if move.on_tool_path:
        quantity, longest = critical_of_tool(
            plan, looks, np.logical_or.reduce(reached, axis=(0, 2)), move, robot
        )
        if longest > share:
            whose = _pressed(plan, first, move.last, held, robot) if quantity is LimitQuantity.BEND else ""
            return CriticalLimit(whose, quantity, longest)
    if share == 0.0:
        return None
    return CriticalLimit(robot.axis_joints[found[1]].name, _QUANTITIES[found[0]], share)


def _pressed(
    plan: MotionPlan, first: int, last: int, limits: JointMotionLimits | JointBounds, robot: RobotModel
) -> str:
    """Return the name of the joint for which a bend is slow, empty where it is slow for the tool.

    It is the one that comes nearest to its acceleration or jerk there, if it comes near: a motion is slowed
    around such a place, long before and behind the few ticks at which the limit is reached.
    """
    qdd = plan.reference.qdd[first:last]
    jerks = np.diff(qdd, axis=0) / plan.period
    accelerated, jerked = (np.abs(rows).max(axis=0, initial=0.0) for rows in (qdd, jerks))
    used = np.maximum(accelerated / limits.acceleration, jerked / limits.jerk)
    return robot.axis_joints[int(used.argmax())].name if float(used.max()) >= PRESSED else ""


def _going_along(move: PlannedMove, robot: RobotModel, bounds: ArmBounds) -> JointBounds:
    """Return the bounds of the joints on a path of the tool: external axes keep the override of the cell."""
    if not robot.external or move.limits is None:
        return bounds.joints
    speed, which = bounds.joints.speed.copy(), list(robot.external)
    speed[which] = move.limits.joints.speed[which] / move.move.modal.ptp_speed
    return replace(bounds.joints, speed=speed)


def _joints(
    plan: MotionPlan, looks: npt.NDArray[np.intp], limits: JointMotionLimits | JointBounds, bounds: ArmBounds
) -> npt.NDArray[np.bool_]:
    """Return at which of k looks each joint is at its limits, shape (4, k, n) with rows as `_QUANTITIES`."""
    reference = plan.reference
    most, n = bounds.joints.effort, reference.q.shape[1]
    torque, largest = np.zeros((len(looks), n)), np.ones(n)
    if bounds.effort is not None and most is not None:
        torque = bounds.effort(reference.q[looks], reference.qd[looks], reference.qdd[looks])
        largest = most
    rows = np.array((limits.speed, limits.acceleration, largest, limits.jerk))
    found = np.empty((4, len(looks), n))
    at = np.asarray(looks, dtype=np.float64)
    joints_reached(reference.qd, reference.qdd, at, torque, rows, plan.period, REACHED, found)
    return found > 0.0
