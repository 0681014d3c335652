"""Which limit sets the time of each move of a plan, seen from its references."""

import numpy as np
import numpy.typing as npt

from ropsim.controller.kept_limits import arm_bounds
from ropsim.controller.motion_plan import MotionPlan, PlannedMove
from ropsim.flow import CriticalLimit, LimitQuantity
from ropsim.kinematics import forward_batch
from ropsim.model import Payload, RobotModel
from ropsim.spatial import Array

REACHED = 0.98
"""Share of a limit from which on it counts as reached: time laws keep a small distance to it."""

MOST_LOOKS = 64
"""Control ticks of a move that are looked at, evenly spaced: one of 64 is 1.6 % of its time."""

_QUANTITIES = (LimitQuantity.SPEED, LimitQuantity.ACCELERATION, LimitQuantity.TORQUE, LimitQuantity.JERK)
"""In the order in which they are named where two limits are reached for equally long."""


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
    reached = np.vstack([_joints(plan, move, looks, robot, payload), *_tool(plan, move, looks, robot)])
    shares = (reached >= REACHED).mean(axis=1)
    best = int(shares.argmax())
    if shares[best] == 0.0:
        return None
    number, joint = divmod(best, robot.n)
    if number < len(_QUANTITIES):
        return CriticalLimit(robot.axis_joints[joint].name, _QUANTITIES[number], float(shares[best]))
    quantity = list(LimitQuantity)[(best - len(_QUANTITIES) * robot.n) % 3]
    return CriticalLimit("", quantity, float(shares[best]))


def _joints(
    plan: MotionPlan, move: PlannedMove, looks: npt.NDArray[np.intp], robot: RobotModel, payload: Payload
) -> Array:
    """Return the shares of the limits of the joints that are used, shape (4·n, k), quantity by quantity."""
    reference, bounds = plan.reference, arm_bounds(robot, payload)
    assert move.limits is not None
    limits = bounds.joints if move.on_tool_path else move.limits.joints
    q, qd, qdd = (rows[looks] for rows in (reference.q, reference.qd, reference.qdd))
    jerk = (reference.qdd[looks + 1] - qdd) / plan.period
    strains = [np.abs(qd) / limits.speed, np.abs(qdd) / limits.acceleration]
    if bounds.effort is not None and bounds.joints.effort is not None:
        strains.append(np.abs(bounds.effort(q, qd, qdd)) / bounds.joints.effort)
    else:
        strains.append(np.zeros(q.shape))
    strains.append(np.abs(jerk) / limits.jerk)
    return np.vstack([strain.T for strain in strains])


def _tool(
    plan: MotionPlan, move: PlannedMove, looks: npt.NDArray[np.intp], robot: RobotModel
) -> tuple[Array, ...]:
    """Return the shares of the limits of the tool that are used, each of shape (3, k), on its paths only."""
    if move.limits is None or not move.on_tool_path:
        return ()
    tool, T, q = move.limits.tool, plan.period, np.vstack((plan.q_start, plan.reference.q))
    around = np.clip(looks[:, None] + np.arange(4), 0, len(q) - 1)
    X_BT = forward_batch(robot, q[around.ravel()]) @ move.X_MT.matrix()
    poses = X_BT.reshape(len(looks), 4, 4, 4)
    R, speeds = poses[..., :3, :3], np.diff(poses[..., :3, 3], axis=1) / T
    turned = np.swapaxes(R[:, :-1], -1, -2) @ R[:, 1:]
    turns = np.stack(
        [turned[..., a, b] - turned[..., b, a] for a, b in ((2, 1), (0, 2), (1, 0))], axis=-1
    ) / (2.0 * T)
    of_tcp = _shares(speeds, T, (tool.speed, tool.acceleration, tool.jerk))
    of_turn = (tool.orientation_speed, tool.orientation_acceleration, tool.orientation_jerk)
    return of_tcp, _shares(turns, T, of_turn)


def _shares(speeds: Array, T: float, limits: tuple[float, float, float]) -> Array:
    """Return which shares of limits are used, shape (3, k).

    Args:
        speeds: between four successive ticks, as vectors, shape (k, 3, 3).
        T: time of a control tick [s].
        limits: of speed, acceleration and jerk.
    """
    accelerations = np.diff(speeds, axis=1) / T
    jerks = np.diff(accelerations, axis=1) / T
    sizes = [np.linalg.norm(rows[:, 0], axis=1) for rows in (speeds, accelerations, jerks)]
    return np.vstack([size / limit for size, limit in zip(sizes, limits, strict=True)])
