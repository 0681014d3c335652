"""Which limit sets the time of each move of a plan, seen from its references."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.flow import CriticalLimit, LimitQuantity
from ropsim.model import Payload, RobotModel
from ropsim.motion import JointBounds, JointMotionLimits
from ropsim.planning.joint_limits.arm_limits import ArmBounds, arm_bounds
from ropsim.planning.joint_limits.binding_kernel import Reached, limits_reached, sample_moves
from ropsim.planning.joint_limits.binding_tool import REACHED, TickSamples, binding_of_tools
from ropsim.planning.records.motion_plan import MotionPlan, TimedMove

MOST_SAMPLES = 64
"""Control ticks of a move that are evaluated, evenly spaced: one of 64 is 1.6 % of its time."""

PRESSED = 0.9
"""Share of acceleration or jerk at its peak from which on a joint counts as the limit in a bend."""

_QUANTITIES = (LimitQuantity.SPEED, LimitQuantity.ACCELERATION, LimitQuantity.TORQUE, LimitQuantity.JERK)
"""In the order in which they are named where two limits are reached for equally long."""


def binding_constraints(
    plan: MotionPlan, robot: RobotModel, payload: Payload
) -> tuple[CriticalLimit | None, ...]:
    """Return for each move of a plan the limit that it is at for longest, None where it reaches none.

    Joints are compared with the limits in force for the move: speed |q'|/v, acceleration |q''|/a, jerk by the
    difference of q'' at two control ticks, torque by the dynamics with the payload. On paths of the tool its
    speed, acceleration, jerk and the curvature of the path are compared with the limits of the program
    (`binding_of_tools`), and external axes that move with it with the speed that they may have then.

    Args:
        plan: of a motion sequence.
        robot: the arm.
        payload: tool and part as one body, as used in planning.
    """
    bounds, evaluated, first = arm_bounds(robot, payload), [], 0
    for number, move in enumerate(plan.moves):
        if (limits := move.limits) is not None and move.last - first > 1:
            held = _going_along(move, robot, bounds) if move.on_tool_path else limits.joints
            evaluated.append(_EvaluatedMove(number, move, first, held))
        first = move.last
    found: list[CriticalLimit | None] = [None] * len(plan.moves)
    if not evaluated:
        return tuple(found)
    samples, longest = _joints(plan, evaluated, bounds)
    on_tool = [number for number, one in enumerate(evaluated) if one.move.on_tool_path]
    of_tools = binding_of_tools(plan, [evaluated[one].move for one in on_tool], on_tool, samples, robot)
    of_tool = dict(zip(on_tool, of_tools, strict=True))
    for number, (one, (best, share)) in enumerate(zip(evaluated, longest, strict=True)):
        if number in of_tool and of_tool[number][1] > share:
            quantity, most = of_tool[number]
            whose = _pressed(plan, one, robot) if quantity is LimitQuantity.BEND else ""
            found[one.number] = CriticalLimit(whose, quantity, most)
        elif share > 0.0:
            quantity, axis = _QUANTITIES[int(best) // robot.n], int(best) % robot.n
            found[one.number] = CriticalLimit(robot.axis_joints[axis].name, quantity, share)
    return tuple(found)


@frozen_dataclass
class _EvaluatedMove:
    """A move that is evaluated.

    Attributes:
        number: of the move in its plan.
        move: it.
        first: last control tick before it begins.
        limits: that its joints are held against.
    """

    number: int
    move: TimedMove
    first: int
    limits: JointMotionLimits | JointBounds


def _pressed(plan: MotionPlan, one: _EvaluatedMove, robot: RobotModel) -> str:
    """Return the name of the joint for which a bend is slow, empty where it is slow for the tool.

    It is the one that comes nearest to its acceleration or jerk there, if it comes near: a motion is slowed
    around such a point, long before and behind the few ticks at which the limit is reached.
    """
    limits, qdd = one.limits, plan.reference.qdd[one.first : one.move.last]
    jerks = np.diff(qdd, axis=0) / plan.period
    accelerated, jerked = (np.abs(rows).max(axis=0, initial=0.0) for rows in (qdd, jerks))
    used = np.maximum(accelerated / limits.acceleration, jerked / limits.jerk)
    return robot.axis_joints[int(used.argmax())].name if float(used.max()) >= PRESSED else ""


def _going_along(move: TimedMove, robot: RobotModel, bounds: ArmBounds) -> JointBounds:
    """Return the bounds of the joints on a path of the tool: external axes keep the override of the cell."""
    if not robot.external or move.limits is None:
        return bounds.joints
    speed, which = bounds.joints.speed.copy(), list(robot.external)
    speed[which] = move.limits.joints.speed[which] / move.move.modal.ptp_speed
    return replace(bounds.joints, speed=speed)


def _joints(
    plan: MotionPlan, evaluated: Sequence[_EvaluatedMove], bounds: ArmBounds
) -> tuple[TickSamples, list[list[float]]]:
    """Return the evaluated ticks of moves, and the longest-binding joint limit of each.

    Args:
        plan: of a motion sequence.
        evaluated: the moves.
        bounds: of the arm.

    Returns:
        the samples; for each move the number of the limit, n for each of `_QUANTITIES`, and the share of its
        samples.
    """
    m, n = len(evaluated), plan.reference.q.shape[1]
    q, qd, qdd = map(np.ascontiguousarray, (plan.reference.q, plan.reference.qd, plan.reference.qdd))
    spans, size = (
        np.array([(one.first, one.move.last) for one in evaluated], dtype=np.float64),
        m * MOST_SAMPLES,
    )
    ticks, reached, starts, rows = np.empty(size), np.empty(size), np.empty(m + 1), np.empty((3, size, n))
    sample_moves(q, qd, qdd, spans, MOST_SAMPLES, ticks, starts, rows)
    most, counts, longest = np.empty((m, 4, n)), np.empty((m, 4, n)), np.empty((m, 2))
    largest, count = bounds.joints.effort, int(starts[m])
    if bounds.effort is None or largest is None:
        torque, largest = np.zeros((count, n)), np.ones(n)
    else:
        torque = bounds.effort(rows[0, :count], rows[1, :count], rows[2, :count])
    for number, one in enumerate(evaluated):
        most[number, 0], most[number, 1] = one.limits.speed, one.limits.acceleration
        most[number, 2], most[number, 3] = largest, one.limits.jerk
    out = Reached(counts, longest, reached)
    limits_reached(qd, qdd, ticks, starts, torque, most, plan.period, REACHED, out)
    return TickSamples(ticks, starts, reached), longest.tolist()
