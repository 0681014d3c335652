"""Which limit sets the time of each move of a plan, seen from its references."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import accumulate

import numpy as np
import numpy.typing as npt

from ropsim.controller.critical_kernel import joints_reached
from ropsim.controller.critical_tool import REACHED, critical_of_tools
from ropsim.controller.kept_limits import ArmBounds, arm_bounds
from ropsim.controller.motion_plan import MotionPlan, PlannedMove
from ropsim.core import frozen_dataclass
from ropsim.flow import CriticalLimit, LimitQuantity
from ropsim.model import Payload, RobotModel
from ropsim.motion import JointBounds, JointMotionLimits
from ropsim.spatial import Array

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
    bounds = arm_bounds(robot, payload)
    looked = [
        _Looked(
            number, move, first, _going_along(move, robot, bounds) if move.on_tool_path else limits.joints
        )
        for number, (move, first) in enumerate(zip(plan.moves, firsts, strict=True))
        if (limits := move.limits) is not None and move.last - first > 1
    ]
    found: list[CriticalLimit | None] = [None] * len(plan.moves)
    if not looked:
        return tuple(found)
    looks = [one.looks for one in looked]
    ticks = np.concatenate([np.arange(one.start, one.stop, one.step) for one in looks])
    starts = [0, *accumulate(map(len, looks))]
    counts, reached = _joints(plan, ticks, starts, [one.limits for one in looked], bounds)
    on_tool = [number for number, one in enumerate(looked) if one.move.on_tool_path]
    moves = [(looked[number].move, looks[number], starts[number]) for number in on_tool]
    of_tool = dict(zip(on_tool, critical_of_tools(plan, moves, ticks, reached, robot), strict=True))
    for number, one in enumerate(looked):
        best = int(counts[number].argmax())
        share = float(counts[number].flat[best]) / len(looks[number])
        if number in of_tool and of_tool[number][1] > share:
            quantity, longest = of_tool[number]
            whose = _pressed(plan, one, robot) if quantity is LimitQuantity.BEND else ""
            found[one.number] = CriticalLimit(whose, quantity, longest)
        elif share > 0.0:
            quantity, axis = _QUANTITIES[best // robot.n], best % robot.n
            found[one.number] = CriticalLimit(robot.axis_joints[axis].name, quantity, share)
    return tuple(found)


@frozen_dataclass
class _Looked:
    """A move that is looked at.

    Attributes:
        number: of the move in its plan.
        move: it.
        first: last control tick before it begins.
        limits: that its joints are held against.
    """

    number: int
    move: PlannedMove
    first: int
    limits: JointMotionLimits | JointBounds

    @property
    def looks(self) -> range:
        """Return the control ticks that are looked at."""
        count = self.move.last - self.first - 1
        return range(self.first, self.first + count, -(-count // MOST_LOOKS))


def _pressed(plan: MotionPlan, one: _Looked, robot: RobotModel) -> str:
    """Return the name of the joint for which a bend is slow, empty where it is slow for the tool.

    It is the one that comes nearest to its acceleration or jerk there, if it comes near: a motion is slowed
    around such a place, long before and behind the few ticks at which the limit is reached.
    """
    limits, qdd = one.limits, plan.reference.qdd[one.first : one.move.last]
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
    plan: MotionPlan,
    ticks: npt.NDArray[np.intp],
    starts: Sequence[int],
    limits: Sequence[JointMotionLimits | JointBounds],
    bounds: ArmBounds,
) -> tuple[Array, Array]:
    """Return at how many looks joints are at their limits, and at which one is.

    Args:
        plan: of a stretch.
        ticks: that are looked at, k of them.
        starts: how many of them come before those of each of m moves, and k.
        limits: of each move.
        bounds: of the arm.

    Returns:
        rows as `_QUANTITIES`, shape (m, 4, n); 1.0 where a limit is reached, else 0.0, shape (k,).
    """
    reference = plan.reference
    most, n = bounds.joints.effort, reference.q.shape[1]
    torque, largest = np.zeros((len(ticks), n)), np.ones(n)
    if bounds.effort is not None and most is not None:
        torque = bounds.effort(
            *(one.take(ticks, axis=0) for one in (reference.q, reference.qd, reference.qdd))
        )
        largest = most
    each = [row for one in limits for row in (one.speed, one.acceleration, largest, one.jerk)]
    rows = np.concatenate(each).reshape(-1, 4, n)
    counts, reached = np.empty((len(limits), 4, n)), np.empty(len(ticks))
    at, first = ticks.astype(np.float64), np.array(starts, dtype=np.float64)
    joints_reached(
        reference.qd, reference.qdd, at, first, torque, rows, plan.period, REACHED, counts, reached
    )
    return counts, reached
